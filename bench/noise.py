#!/usr/bin/env python3
"""What noise costs: area lights with jitter against POV-Ray's, and antialiasing methods against converged pictures.

usage: bench/noise.py RENDERBOY [--povray povray]
"""
import argparse
import os
import re

from pictures import ROOT, picture, rmse


def mean_difference(a, b):
    return sum(x - y for x, y in zip(a, b)) / len(a)


def count(text, pattern):
    return int(re.search(pattern, text).group(1))


def area_lights(renderboy, povray):
    print("light            | rmse (mean error): POV-Ray, RenderBoy    | shadow rays: POV-Ray, RenderBoy")
    scene = os.path.join(ROOT, "bench", "noise.pov")
    size = (160, 120)
    for places, adaptive in ((4, -1), (8, 1), (17, 1), (17, 2)):
        words = [f"Declare=N={places}", f"Declare=AD={adaptive}", "-A"]
        pictures = 24
        exact = [0.0] * (3 * size[0] * size[1])
        for seed in range(pictures):
            one, _ = picture(renderboy, scene, size, 1.0, words[:1] + ["Declare=AD=-1", "-A", f"--seed={seed + 1}"])
            exact = [e + v / pictures for e, v in zip(exact, one)]
        ours, our_text = picture(renderboy, scene, size, 1.0, words + ["--stats", "json"])
        theirs, their_text = picture(povray, scene, size, 1.0, words)
        name = f"{places} x {places}" + (f" adaptive {adaptive}" if adaptive >= 0 else "")
        print(f"{name:16} | {rmse(theirs, exact):.4f} ({mean_difference(theirs, exact):+.4f}) "
              f"{rmse(ours, exact):.4f} ({mean_difference(ours, exact):+.4f})"
              f" | {count(their_text, r'Shadow Ray Tests: *([0-9]+)')} {count(our_text, r'.shadow.: ([0-9]+)')}")


def antialiasing(renderboy):
    size = (120, 90)
    methods = ["--error 2%", "--error 1%", "--error 0.5%", "--error 0.25%", "+A0.3 +AM1", "+A0.1 +AM1 +R5", "+A0.05 +AM1 +R9",
               "+A0.1 +AM2 +R4", "+A0.1 +AM3 +R4", "+A0.03 +AM3 +R5"]
    for name in ("gallery/still_life", "transparency/adc_bailout"):
        print(name)
        scene = os.path.join(ROOT, "scenes", name + ".pov")
        exact, _ = picture(renderboy, scene, size, 2.5, ["--error", "0.0001%", "--max-samples", "2048", "--seed", "77"])
        for method in methods:
            seen, text = picture(renderboy, scene, size, 2.5, method.split() + ["--stats", "json"])
            samples = count(text, r".camera.: ([0-9]+)") / (size[0] * size[1])
            print(f"{method:16} rmse {100 * rmse(seen, exact):.3f} %, {samples:.1f} samples a pixel")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("renderboy")
    parser.add_argument("--povray", default="povray")
    options = parser.parse_args()
    area_lights(os.path.abspath(options.renderboy), options.povray)
    antialiasing(os.path.abspath(options.renderboy))


if __name__ == "__main__":
    main()
