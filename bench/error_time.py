#!/usr/bin/env python3
"""Error against CPU time, beside POV-Ray's, on the scenes of bench/error_time/ at a series of settings.

The error is the RMSE (of 8-bit levels) to a converged picture that each program makes by itself; the time is the user's CPU time,
the least of several runs. Writes docs/error_time.md (table) and docs/error_time.svg (curves).

Needs oiiotool.

usage: bench/error_time.py RENDERBOY [-n RUNS] [--povray povray] [--only SCENE]
"""
import argparse
import math
import os
import subprocess
import tempfile

from pictures import ROOT, rmse, srgb, timed

SIZE = (320, 240)
FINER = 5  # times as many pixels along each side
FINEST = ["+A0.0", "+AM1", "+R6"]
EDGES = [["+A0.3", "+R2"], ["+A0.1", "+R3"], ["+A0.03", "+R4"], ["+A0.01", "+R5"], ["+A0.003", "+R6"]]

OWN = [["--error", f"{share}%"] for share in (8, 4, 2, 1, 0.5)]

CONVERGED = ["--error", "0.1%", "--max-samples", "16384"]


def declared(name, *values):
    return [[f"Declare={name}={value}", "-A"] for value in values]


# Settings from rough to fine, and the converged one; None: a finer picture's.
SCENES = {
    "soft_shadows": (declared("Grid", 3, 5, 9, 17), *declared("Grid", 65)),
    "glass": (EDGES, None),
    "glossy": (EDGES, None),
    "depth_of_field": (declared("Samples", 10, 40, 160, 640), ["Declare=Samples=1000", "Declare=Variance=0", "-A"]),
    "fine_texture": (EDGES, None),
    "thin_geometry": (EDGES, None),
    "media": (declared("Samples", 4, 8, 16, 32), *declared("Samples", 100)),
    "caustics": (declared("Count", 5000, 20000, 80000, 320000), *declared("Count", 1000000)),
}


def supersampled(program, scene):
    """The channels of a picture of FINER * FINER * 37 samples a pixel, averaged unclipped."""
    with tempfile.TemporaryDirectory() as folder:
        large, small = os.path.join(folder, "large.exr"), os.path.join(folder, "small.exr")
        command = [program, "+I" + scene, "+O" + large, "+FE", "-D", "-P"] + FINEST
        subprocess.run(command + [f"+W{FINER * SIZE[0]}", f"+H{FINER * SIZE[1]}"],
                       capture_output=True, check=True, cwd=os.path.dirname(scene))
        subprocess.run(["oiiotool", large, "--ch", "R,G,B", "--resize:filter=box", f"{SIZE[0]}x{SIZE[1]}", "-d", "float", "-o", small],
                       check=True)
        pixels = subprocess.run(["oiiotool", "--dumpdata", "-v", small], capture_output=True, check=True, text=True).stdout
    rows = (line.split(":")[1].split() for line in pixels.splitlines() if line.startswith("    Pixel ("))
    return [srgb(float(channel)) for row in rows for channel in row]


def curves_of(renderboy, povray, name, runs):
    """For POV-Ray, RenderBoy with the same settings, and with its own: (words, seconds, error) of each setting."""
    settings, converged = SCENES[name]
    scene = os.path.join(ROOT, "bench", "error_time", name + ".pov")
    series = [(povray, settings, converged), (renderboy, settings, converged or CONVERGED)]
    if settings is EDGES or name == "depth_of_field":
        series.append((renderboy, OWN, CONVERGED))
    curves = []
    for program, words_of_points, converged in series:
        reference = timed(program, scene, SIZE, converged, 1)[0] if converged else supersampled(program, scene)
        points = []
        for words in words_of_points:
            channels, seconds = timed(program, scene, SIZE, words, runs)
            points.append((words, max(seconds, 0.001), 255 * rmse(channels, reference)))
        curves.append(points)
    return curves


def gain(theirs, seconds, error):
    """How many times longer POV-Ray takes to the same error, between its settings by powers."""
    roughest, finest = theirs[0], theirs[-1]
    # With the same settings the pictures are the same, but not quite the converged ones.
    error = next((p[2] for p in theirs if abs(error - p[2]) < 0.02 * p[2]), error)
    if error > roughest[2]:
        return "rougher than all of POV-Ray's"
    if error < min(p[2] for p in theirs):
        return f"more than {finest[1] / seconds:.1f}"
    for (_, t0, e0), (_, t1, e1) in zip(theirs, theirs[1:]):
        if e1 <= error <= e0:
            share = math.log(e0 / error) / math.log(e0 / e1) if e0 > e1 else 0
            return f"{t0 * (t1 / t0) ** share / seconds:.1f}"
    return "-"


def table(name, curves):
    theirs = curves[0]
    for k, points in enumerate(curves):
        for words, seconds, error in points:
            yield (f"| {name} | {'RenderBoy' if k else 'POV-Ray'} | `{' '.join(words)}` | {seconds:.2f} | {error:.2f} | "
                   f"{gain(theirs, seconds, error) if k else ''} |")


def plot(curves):
    """Small panels, both axes logarithmic over the same spans."""
    width, height, columns = 230, 190, 4
    every = [p[1:] for pair in curves.values() for points in pair for p in points]
    spans = [(math.log(min(p[k] for p in every)), math.log(max(p[k] for p in every))) for k in (0, 1)]
    rows = -(-len(curves) // columns)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{columns * width}" height="{rows * height + 20}" '
           'font-family="sans-serif" font-size="11">', '<rect width="100%" height="100%" fill="white"/>']

    def place(point, left, top):
        x, y = ((math.log(v) - low) / (high - low) for v, (low, high) in zip(point, spans))
        return left + 12 + x * (width - 30), top + height - 25 - y * (height - 60)

    for i, (name, pair) in enumerate(curves.items()):
        left, top = i % columns * width, i // columns * height
        out.append(f'<rect x="{left + 5}" y="{top + 22}" width="{width - 15}" height="{height - 40}" fill="none" stroke="#999"/>')
        out.append(f'<text x="{left + 8}" y="{top + 16}">{name.replace("_", " ")}</text>')
        for points, color in zip(pair, ("#c33", "#26c", "#2a4")):
            places = [place(p[1:], left, top) for p in points]
            out.append(f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}" fill="none" stroke="{color}"/>')
            out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{color}"/>' for x, y in places]
    out.append(f'<text x="8" y="{rows * height + 12}">across: seconds, {math.exp(spans[0][0]):.2g} to {math.exp(spans[0][1]):.2g}; '
               f'up: error, {math.exp(spans[1][0]):.2g} to {math.exp(spans[1][1]):.2g} of 255; both logarithmic. '
               'Red: POV-Ray, blue: RenderBoy, green: its --error</text></svg>')
    return "\n".join(out) + "\n"


def write_docs(curves):
    with open(os.path.join(ROOT, "docs", "error_time.svg"), "w") as file:
        file.write(plot(curves))
    with open(os.path.join(ROOT, "docs", "error_time.md"), "w") as file:
        file.write("\n".join([
            "# Error against time", "",
            f"Written by `bench/error_time.py`: the scenes of `bench/error_time/` at {SIZE[0]}x{SIZE[1]} on one thread, at settings from rough to fine.",
            "Seconds are user CPU time; the error is the RMSE (of 255) to a converged picture of the same program: for antialiasing",
            f"{37 * FINER * FINER} samples in each pixel of POV-Ray's, and `{' '.join(CONVERGED)}`. *Gain*: POV-Ray's time to the",
            "same error, between its own settings, over RenderBoy's; *more than*: none of POV-Ray's settings comes there.", "",
            "![curves](error_time.svg)", "",
            "| scene | program | setting | s | error | gain |", "|---|---|---|---|---|---|"]
            + [line for name, series in curves.items() for line in table(name, series)]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("renderboy")
    parser.add_argument("-n", "--runs", type=int, default=3)
    parser.add_argument("--povray", default="povray")
    parser.add_argument("--only", help="one scene, and nothing is written")
    options = parser.parse_args()
    curves = {}
    for name in [options.only] if options.only else SCENES:
        curves[name] = curves_of(os.path.abspath(options.renderboy), options.povray, name, options.runs)
        print("\n".join(table(name, curves[name])), flush=True)
    if not options.only:
        write_docs(curves)


if __name__ == "__main__":
    main()
