#!/usr/bin/python3
"""What chosen increments are off by on random plates: opening ranges and K_op against 120 increments a cycle.

    bench/error_of_chosen_increments.py build/release/bin/stria [OLD/stria] [--plates 24] [--seed 1] [--ratio -1.0 -0.5]
        [--inclined] [--reference 120]

Each plate is that of bench/growing_cycle with a plane state, a K_max, a metal and a crack by chance; it grows by an element in
each of nine cycles. With --inclined the crack rises at a slope of 0.4, and half of them rub. Prints a Markdown table, one row for
each program and ratio: increments, iterations, and errors of the opening range at closure.distance in the last cycle and in the
worst one, of K_op / K_max in the worst one; median and largest. All is counted, not timed: it may run beside other work. 24 plates
take ten minutes.
"""

import argparse
import csv
import json
import math
import random
import statistics
import subprocess
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parent / "growing_cycle" / "case.toml"
SIZE, YIELD = 1.6, 300.0  # of the case
METALS = ["[{C=4000.0}]", "[{C=30000.0,gamma=150.0},{C=3000.0}]", "[{C=50000.0,gamma=400.0}]"]


def plate(chance, ratio, inclined):
    plane, K_max = chance.choice(["strain", "stress"]), chance.uniform(450.0, 900.0)
    zone = (K_max / YIELD) ** 2 / math.pi * (1.0 if plane == "stress" else 0.08)
    refine = min(64, 2 ** math.ceil(math.log2(10.0 * SIZE / zone)))
    slope = ["crack.0.points=[[0.0,43.25],[20.0,51.25]]", 'growth.direction="straight"'] if inclined else []
    friction = [f"crack.0.contact.friction={chance.choice([0.0, 0.4])}"] if inclined else []
    return slope + friction + [
        f'model.plane="{plane}"',
        f"material.kinematic={chance.choice(METALS)}",
        'load.control="K"',
        f"load.blocks=[{{cycles=9,max={K_max},ratio={ratio}}}]",
        f"growth.increment={SIZE / refine}",
        f"fine.refine={refine}",
        'output.fields="none"',
        "output.checkpoint_every=0",
    ]


def run(program, settings, folder):
    command = [program, "run", str(CASE), "-o", str(folder), "--mode", "inprocess", "--quiet", "--no-report", "--force"]
    subprocess.run(command + [part for setting in settings for part in ("--set", setting)], check=True)
    with open(folder / "cycles.csv", newline="", encoding="utf-8") as file:
        cycles = list(csv.DictReader(file))
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        increments = sum(1 for _ in file) - 1
    return cycles, increments, json.loads((folder / "summary.json").read_text(encoding="utf-8"))["newton_iterations"]


def errors(found, reference):
    number = lambda row, name: float(row[name] or "nan")
    pairs = list(zip(found, reference))
    ranges = [100.0 * abs(number(a, "opening_range") / number(b, "opening_range") - 1.0) for a, b in pairs]
    K_op = [abs(number(a, "K_op") - number(b, "K_op")) / number(b, "K_max") for a, b in pairs]
    return ranges[-1], max(ranges), max([error for error in K_op if not math.isnan(error)], default=0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", nargs="+")
    parser.add_argument("--plates", type=int, default=24)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--inclined", action="store_true")
    parser.add_argument("--reference", type=int, default=120)
    parser.add_argument("--ratio", type=float, nargs="*", default=[-1.0, -0.5])
    chosen = parser.parse_args()
    reference_load = [f"load.steps={chosen.reference}", "load.grading=0.7", "solver.tolerance=1e-9"]
    print("| program | R | increments | iterations | range, %: last cycle | worst | K_op / K_max |\n|---|---|---|---|---|---|---|")
    for ratio in chosen.ratio:
        chance = random.Random(chosen.seed)
        rows = {program: [] for program in chosen.program}
        with tempfile.TemporaryDirectory() as name:
            for _ in range(chosen.plates // len(chosen.ratio)):
                settings = plate(chance, ratio, chosen.inclined)
                reference, _, _ = run(chosen.program[0], settings + reference_load, Path(name) / "reference")
                for program in chosen.program:
                    cycles, increments, iterations = run(program, settings, Path(name) / "chosen")
                    rows[program].append((increments, iterations, *errors(cycles, reference)))
        for k, program in enumerate(chosen.program):
            increments, iterations, last, worst, K_op = zip(*rows[program])
            spread = lambda values, form: f"{statistics.median(values):{form}}, {max(values):{form}}"
            print(f"| {'now' if k == 0 else 'before'} | {ratio:g} | {statistics.fmean(increments):.0f} | {statistics.fmean(iterations):.0f} "
                  f"| {spread(last, '.2f')} | {spread(worst, '.2f')} | {spread(K_op, '.4f')} |", flush=True)


if __name__ == "__main__":
    main()
