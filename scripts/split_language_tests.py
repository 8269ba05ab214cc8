#!/usr/bin/env python3
"""Writes each probe, each expression and each bad scene of tests/language as a file of its own: seeds for the fuzzers.

usage: scripts/split_language_tests.py FOLDER
"""
import re
import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parent.parent / "tests" / "language"


def scenes():
    for name in ("probes.txt", "bad_scenes.txt"):
        if not (TESTS / name).exists():
            continue
        head, *parts = re.split(r"^--- .*\n", (TESTS / name).read_text(), flags=re.M)
        for part in parts:
            yield head + re.sub(r"^=[>!] .*\n", "", part, flags=re.M)
    lines = (TESTS / "expressions.txt").read_text().splitlines()
    for line in lines:
        if line.startswith("#declare F"):
            yield line
        elif "\t" in line:
            yield "#debug " + line.partition("\t")[0]


for number, scene in enumerate(scenes()):
    Path(sys.argv[1], f"language_{number}.pov").write_text(scene)
