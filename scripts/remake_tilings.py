#!/usr/bin/env python3
"""Measures values of `tiling` and `pavement` with povray and writes tests/shade/tilings.txt."""
import random
import re
import subprocess
import tempfile
from pathlib import Path

TARGET = Path(__file__).parent.parent / "tests/shade/tilings.txt"
POINTS = 12
PAVEMENTS = {3: [1, 1, 1, 3, 4, 12], 4: [1, 1, 2, 5, 12, 35], 6: [1, 1, 3, 7, 22]}

draw = random.Random(3)


def patterns():
    for number in range(1, 28):
        yield f"tiling {number}"
    for sides, counts in PAVEMENTS.items():
        for tiles, count in enumerate(counts, 1):
            for pattern in range(1, count + 1):
                # Those of one tile run through all ways to draw corners, the others draw two of them.
                forms = 4 if sides == 4 else 3
                ways = [(e, i, f) for e in range(3) for i in range(3) for f in range(forms)]
                for exterior, interior, form in ways if count > 10 and pattern == 8 else draw.sample(ways, 2):
                    yield (f"pavement number_of_sides {sides} number_of_tiles {tiles} pattern {pattern} "
                           f"exterior {exterior} interior {interior} form {form}")


def measure(rows):
    scene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
    for pattern, points in rows:
        scene += f"#ifdef (F) #undef F #end #declare F = function {{ pigment {{ {pattern} }} }}\n#debug \"\\n>>\"\n"
        for x, z in points:
            scene += f"#debug concat(\" \", str(F({x}, 0.5, {z}).red, 0, 9))\n"
    scene += '#debug "\\n"\n'
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "tilings.pov"
        file.write_text(scene)
        command = ["povray", f"+I{file}", "-F", "-D", "+W1", "+H1"]
        output = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    return [line.split()[1:] if line.startswith(">> ") else line[2:].split()
            for line in re.sub(r"\n(?= |\d)", "", output).splitlines() if line.startswith(">>")]


def main():
    rows = []
    for pattern in patterns():
        points = [(round(draw.uniform(-9, 9), 3), round(draw.uniform(-9, 9), 3)) for _ in range(POINTS - 1)]
        points.append((round(draw.uniform(-500, 500), 2), round(draw.uniform(-500, 500), 2)))
        rows.append((pattern, points))
    values = measure(rows)
    assert len(values) == len(rows), (len(values), len(rows))
    with TARGET.open("w") as out:
        out.write("# Values measured from POV-Ray 3.7.0.10 by scripts/remake_tilings.py: pattern : x z value, ...\n")
        for (pattern, points), row in zip(rows, values):
            assert len(row) == POINTS, row
            out.write(f"{pattern} : {', '.join(f'{x} {z} {v}' for (x, z), v in zip(points, row))}\n")
    print(len(rows), "rows")


if __name__ == "__main__":
    main()
