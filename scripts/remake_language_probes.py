#!/usr/bin/env python3
"""Measures tests/language/probes.txt with povray: the line that begins with "=> " behind each probe is what #debug said, lines
joined by " | ", or "refused: " and povray's message. A line "=! " behind it is ours where it differs on purpose.

usage: scripts/remake_language_probes.py [povray]
"""
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FILE = Path(__file__).resolve().parent.parent / "tests" / "language" / "probes.txt"


def measure(povray, head, probe):
    bare = probe.startswith("[bare]")
    text = probe.removeprefix("[bare]") if bare else head + probe
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "p.pov").write_text(text + '\n#debug "\\n" sphere { 0, 1 }\n')
        done = subprocess.run([povray, "+Ip.pov", "-D", "+W160", "+H120", "+SR120", "+SC160", "-F", "+GDdebug.txt"], cwd=folder,
                              capture_output=True, text=True, timeout=60)
        if done.returncode == 0:
            lines = Path(folder, "debug.txt").read_text().split("\n")
            return " | ".join(line.strip() for line in lines if line.strip()) or "(nothing)"
        error = re.search(r"Parse\s+Error:\s+(.*?)\s*(?:Fatal|====)", done.stderr, re.S)
        return "refused: " + " ".join((error[1] if error else done.stderr[-200:]).split())


def main():
    povray = sys.argv[1] if len(sys.argv) > 1 else "povray"
    head, *probes = re.split(r"^--- (.*)\n", FILE.read_text(), flags=re.M)
    titles, bodies = probes[0::2], probes[1::2]
    ours = ["".join(re.findall(r"^=! .*\n", body, flags=re.M)) for body in bodies]
    texts = [re.sub(r"^=[>!] .*\n", "", body, flags=re.M).rstrip("\n") for body in bodies]
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda text: measure(povray, head, text), texts))
    FILE.write_text(head + "".join(f"--- {title}\n{text}\n=> {answer}\n{our}" for title, text, answer, our in zip(titles, texts, answers, ours)))


main()
