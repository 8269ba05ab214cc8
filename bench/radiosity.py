#!/usr/bin/env python3
"""Error and time of radiosity on the scenes of scenes/radiosity/, beside POV-Ray's.

The error is the RMSE (of 255, gamma-encoded) to the mean of several brute gathers, taken in linear light, since the
mean of noisy encoded values is too dark. They come in two halves: the mean product of the differences from both is free
of their own noise. Seconds are user CPU time, the least of several runs, on one thread.

usage: bench/radiosity.py RENDERBOY [-n RUNS] [--fine] [--povray povray] [--only SCENE ...] [--references FOLDER] [--with "WORDS" ...]
"""
import argparse
import array
import math
import os

from pictures import ROOT, picture, srgb, timed

SCENES = ["cornell_box", "sunlit_room", "sky_dome", "colored_corner", "thin_walls", "many_objects"]
HALF = 8
SIZE = (160, 120)


def path_of(scene):
    return os.path.join(ROOT, "scenes", "radiosity", scene + ".pov")


def gathered(renderboy, scene, seeds):
    """The encoded mean of brute gathers of 48 rays, and 24 from each place that they meet."""
    sum_of = [0.0] * (3 * SIZE[0] * SIZE[1])
    for seed in seeds:
        one, _ = picture(renderboy, path_of(scene), SIZE, 1.0, ["-A", "--gi", "brute", "Declare=Rays=32", f"--seed={seed}"])
        sum_of = [s + v / len(seeds) for s, v in zip(sum_of, one)]
    return [srgb(s) for s in sum_of]


def references(renderboy, scene, folder):
    """Two independent pictures, kept in the folder if there is one."""
    halves = []
    for half in range(2):
        kept = os.path.join(folder, f"{scene}.{half}") if folder else None
        if kept and os.path.exists(kept):
            halves.append(array.array("d", open(kept, "rb").read()))
            continue
        halves.append(array.array("d", gathered(renderboy, scene, range(1 + half * HALF, 1 + (half + 1) * HALF))))
        if kept:
            with open(kept, "wb") as file:
                halves[-1].tofile(file)
    return halves


def error(channels, halves):
    return 255 * math.sqrt(max(0.0, sum((c - a) * (c - b) for c, a, b in zip(channels, *halves)) / len(channels)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("renderboy")
    parser.add_argument("-n", "--runs", type=int, default=3)
    parser.add_argument("--povray", default="povray", help="none: leave it out")
    parser.add_argument("--only", nargs="+", default=SCENES)
    parser.add_argument("--references", help="folder where they are kept")
    parser.add_argument("--fine", action="store_true", help="count 1000, error_bound 0.1 instead of 200, 0.5")
    parser.add_argument("--with", dest="words", action="append", help="words of RenderBoy's command line; may be given several times")
    options = parser.parse_args()
    renderboy = os.path.abspath(options.renderboy)
    if options.references:
        os.makedirs(options.references, exist_ok=True)
    series = [] if options.povray == "none" else [(options.povray, "")]
    series += [(renderboy, words) for words in options.words or ["--gi points", "--gi cache"]]
    print("| scene | program | RMSE | s |\n|---|---|---|---|")
    for scene in options.only:
        halves = references(renderboy, scene, options.references)
        for program, words in series:
            channels, seconds = timed(program, path_of(scene), SIZE, ["-A"] + ["Declare=Fine=1"] * options.fine + words.split(), options.runs)
            name = f"`{words}`" if program == renderboy else "POV-Ray"
            print(f"| {scene} | {name} | {error(channels, halves):.2f} | {seconds:.2f} |", flush=True)


if __name__ == "__main__":
    main()
