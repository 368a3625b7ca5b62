#!/usr/bin/python3
"""How well `stria check` tells how far K is from converged: random cracks, their K, and K on elements an eighth as large.

    bench/error_of_K.py build/release/bin/stria [--cracks 60] [--seed 1]

Straight edge and inner cracks in a plate of 40 by 60 mm that yields, elements of 0.8 to 2.4 mm, fine.refine of 1, 4 or 16. Prints
a Markdown table: errors of K, what check says that K changes by on elements half as large, and the quotient of both; median and
range. Nothing is timed: it may run beside other work. 60 cracks take two minutes.
"""

import argparse
import math
import random
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

CASE = """
units = "N-mm-MPa"
model = {{ plane = "stress" }}
mesh = {{ specimen = "plate", width = 40.0, height = 60.0, size = {size} }}
material = {{ young = 200e3, poisson = 0.3, yield_stress = 300.0 }}
crack = [ {{ points = {points}, contact = {{}} }} ]
boundary = [ {{ on = "top", traction = [0.0, 1.0] }}, {{ on = "bottom", traction = [0.0, -1.0] }} ]
load = {{ blocks = [ {{ cycles = 1, max = 100.0, ratio = 0.0 }} ] }}
fine = {{ refine = {refine} }}
"""


def points_by_chance(chance, size):
    length, angle = size * chance.uniform(2.0, 8.0), chance.uniform(-0.8, 0.8)
    along = (length * math.cos(angle), length * math.sin(angle))
    if chance.random() < 0.5:
        return [[0.0, 30.03], [along[0], 30.03 + along[1]]]
    return [[20.1 - along[0], 30.03 - along[1]], [20.1 + along[0], 30.03 + along[1]]]


def check(program, folder, **values):
    """K_I and K_II of each tip, by how many percent they change, and whether a tip has little room for its rings."""
    case = folder / "case.toml"
    case.write_text(CASE.format(**values), encoding="utf-8")
    said = subprocess.run([program, "check", str(case)], capture_output=True, text=True, check=False).stdout
    K = [(float(I), float(II)) for I, II in re.findall(r"# tip \d: K_I = (\S+), K_II = (\S+)", said)]
    return K, [float(change) for change in re.findall(r"K changes by (\S+) %", said)][: len(K)], "largest ring" in said


def row(name, tips):
    def spread(values):
        return f"{statistics.median(values):.2f} ({min(values):.2f} to {max(values):.2f})" if values else "-"

    errors, changes = [error for error, _ in tips], [change for _, change in tips]
    return f"| {name} | {len(tips)} | {spread(errors)} | {spread(changes)} | {spread([e / c for e, c in tips])} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--cracks", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    tips = {}
    with tempfile.TemporaryDirectory() as name:
        for _ in range(options.cracks):
            size, refine = chance.choice([0.8, 1.2, 1.6, 2.4]), chance.choice([1, 4, 16])
            points = points_by_chance(chance, size)
            K, changes, little_room = check(options.program, Path(name), size=size, points=points, refine=refine)
            finest, _, _ = check(options.program, Path(name), size=size / 8.0, points=points, refine=refine)
            if len(changes) != len(finest):
                continue  # refused on the larger elements
            for (I, II), (finest_I, finest_II), change in zip(K, finest, changes):
                error = 100.0 * math.hypot(I - finest_I, II - finest_II) / math.hypot(finest_I, finest_II)
                tips.setdefault((little_room, refine), []).append((error, change))
    print("| tips | how many | error of K, % | K changes by, % | error over change |\n|---|---|---|---|---|")
    for (little_room, refine), found in sorted(tips.items()):
        print(row(f"`refine = {refine}`" + (", fewer than three elements in the largest ring" if little_room else ""), found))


if __name__ == "__main__":
    main()
