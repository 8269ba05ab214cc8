"""Pictures that the benches measure: rendered by either program, as numbers, with the time that it took."""
import math
import os
import resource
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def picture(program, scene, size, gamma, words):
    """Channels of all pixels, 0..1, and what the program said."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out.ppm")
        command = [program, "+I" + scene, "+O" + out, f"+W{size[0]}", f"+H{size[1]}", "+FP16", "-D", "-P", "+WT1", f"File_Gamma={gamma}"]
        run = subprocess.run(command + words, capture_output=True, text=True, cwd=os.path.dirname(scene))
        if run.returncode != 0:
            raise SystemExit(run.stderr)
        with open(out, "rb") as file:
            data = file.read()
    values = data[-size[0] * size[1] * 6:]
    return [(values[i] << 8 | values[i + 1]) / 65535 for i in range(0, len(values), 2)], run.stderr


def timed(program, scene, size, words, runs):
    """The picture's channels, and the least user seconds."""
    least = math.inf
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        channels, _ = picture(program, scene, size, "srgb", words)
        least = min(least, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
    return channels, least


def srgb(linear):
    linear = min(max(linear, 0.0), 1.0)
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


def rmse(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b, strict=True)) / len(a))
