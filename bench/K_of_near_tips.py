#!/usr/bin/python3
"""K of tips that are near to each other: a table for docs/verification/elastic.md.

    bench/K_of_near_tips.py build/release/bin/stria [--trials 12] [--seed 1] [--finer 8] [--sets NAME ...]

Inner cracks of 1.5 to 10 elements, straight at any angle and place, their ends also on element edges and nodes; and pairs of edge
cracks whose tips are as far apart, in line or beside each other. A plate of 40 by 40 elements is pulled and sheared. Errors are the
distance of (K_I, K_II) from that of elements a `finer`th as large, over its size; of both tips of each trial, median and largest.
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
mesh = {{ specimen = "plate", width = 40.0, height = 40.0, size = 1.0{grading} }}
material = {{ young = 200e3, poisson = 0.3{metal} }}
boundary = [ {{ on = "top", traction = [0.3, 1.0] }}, {{ on = "bottom", traction = [-0.3, -1.0] }},
             {{ on = "right", traction = [0.0, 0.3] }}, {{ on = "left", traction = [0.0, -0.3] }} ]
load = {{ blocks = [ {{ cycles = 1, max = 1.0, ratio = 0.0 }} ] }}
{cracks}"""
GRADING = ", grading = [ {{ at = [[20.0, 20.0]], size = {}, outer_size = 0.6, radius = 10.0, growth = 0.3 }} ]"
CRACK = "[[crack]]\npoints = {points}{contact}\n"
SETS = {  # what stands at the tips: yield stress, contact, override
    "elastic": ("", "", ""),
    "six": ("", "", "topological"),
    "one": (", yield_stress = 1e6", "", "single"),
    "none": ("", "", "none"),
}
DISTANCES = [1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0]


def place(chance):
    """Near the middle: anywhere, on an edge, or on a node."""
    x = [20.0 + chance.uniform(-0.5, 0.5) for _ in range(2)]
    on = chance.choice([(), (), (0,), (1,), (0, 1)])
    return [round(v) if k in on else v for k, v in enumerate(x)]


def inner(chance, distance):
    start, angle = place(chance), chance.uniform(-0.9, 0.9)
    return [[start, [start[0] + distance * math.cos(angle), start[1] + distance * math.sin(angle)]]]


def pair(chance, distance):
    tip, angle = place(chance), chance.choice([0.0, chance.uniform(-0.9, 0.9)])
    other = [tip[0] + distance * math.cos(angle), tip[1] + distance * math.sin(angle)]
    return [[[0.0, tip[1] + chance.uniform(-2.0, 2.0)], tip], [[40.0, other[1] + chance.uniform(-2.0, 2.0)], other]]


def check(program, folder, cracks, what, finer):
    metal, contact, enrichment = SETS[what]
    case = folder / "case.toml"
    text = "".join(CRACK.format(points=points, contact=contact) for points in cracks)
    grading = GRADING.format(1.0 / finer) if finer > 1 else ""
    case.write_text(CASE.format(grading=grading, metal=metal, cracks=text), encoding="utf-8")
    words = [program, "check", str(case)] + (["--set", f"fine.enrichment={enrichment}"] if enrichment else [])
    said = subprocess.run(words, capture_output=True, text=True, check=False)
    K = [(float(I), float(II)) for I, II in re.findall(r"# tip \d: K_I = (\S+), K_II = (\S+)", said.stdout)]
    return K, any(words in said.stdout + said.stderr for words in ("largest ring", "another crack is"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--trials", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--finer", type=int, default=8)
    parser.add_argument("--sets", nargs="*", default=list(SETS))
    options = parser.parse_args()
    print("| cracks | elements apart | " + " | ".join(options.sets) + " |\n|---|---|" + "---|" * len(options.sets))
    with tempfile.TemporaryDirectory() as name:
        for kind, cracks_of in (("inner", inner), ("pairs", pair)):
            for distance in DISTANCES:
                chance = random.Random(f"{options.seed} {kind} {distance}")
                errors, warned = {what: [] for what in options.sets}, dict.fromkeys(options.sets, 0)
                for _ in range(options.trials):
                    cracks = cracks_of(chance, distance)
                    finest, _ = check(options.program, Path(name), cracks, "elastic", options.finer)
                    for what in options.sets:
                        K, warns = check(options.program, Path(name), cracks, what, 1)
                        if len(K) != len(finest) or not K:
                            continue  # refused
                        warned[what] += warns
                        errors[what] += [math.hypot(I - J, II - JJ) / math.hypot(J, JJ) for (I, II), (J, JJ) in zip(K, finest)]
                cells = [
                    f"{100 * statistics.median(errors[what]):.2f}, {100 * max(errors[what]):.1f}; {warned[what]} of {len(errors[what]) // 2}"
                    if errors[what] else "refused"
                    for what in options.sets
                ]
                print(f"| {kind} | {distance:g} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
