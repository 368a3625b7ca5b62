#!/usr/bin/python3
"""What opening loads are good to: plates that grow by an element a cycle, on meshes from coarse to fine, against the finest.

    bench/error_of_opening_loads.py build/release/bin/stria [--plates 16] [--seed 1]

Each plate is that of bench/growing_cycle with a plane state, a K_max, a ratio and a metal by chance; it grows by four fifths of
its plastic zone. Closure is looked at at its default distance, and at twice that. Prints a Markdown table by how many elements
lie between the tip and that distance: errors of K_op / K_max, of the opening range and of J_max in the last quarter of the cycles,
their median and the largest. All is counted, not timed: it may run beside other work. 16 plates take a quarter of an hour.
"""

import argparse
import csv
import math
import random
import statistics
import subprocess
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parent / "growing_cycle" / "case.toml"
SIZE, YIELD = 1.6, 300.0  # of the case
METALS = ["[{C=4000.0}]", "[{C=30000.0,gamma=150.0},{C=3000.0}]", "[{C=50000.0,gamma=400.0}]"]
BINS = [0.0, 0.5, 0.8, 1.2, 1.6, 2.2, 3.2, 6.5]  # elements to the distance
MOST_REFINED = 256


class Plate:
    def __init__(self, chance):
        self.plane = chance.choice(["strain", "stress"])
        self.K_max = chance.uniform(450.0, 1000.0)
        self.ratio = chance.choice([-1.0, -0.5, 0.0, 0.0, 0.3])
        self.metal = chance.choice(METALS)
        flow = (self.K_max / YIELD) ** 2
        self.zone = flow / math.pi * (1.0 if self.plane == "stress" else 0.3)
        self.default_distance = 0.1 * math.pi / 16.0 * flow

    def refinements(self):
        coarsest = 2 ** math.ceil(math.log2(4.0 * SIZE / self.zone))
        return [refine for refine in (coarsest * 2**level for level in range(4)) if refine <= MOST_REFINED]

    def run(self, program, refine, distance, folder):
        element = SIZE / refine
        cycles = max(4, round(0.8 * self.zone / element))
        settings = [
            f'model.plane="{self.plane}"',
            f"material.kinematic={self.metal}",
            'load.control="K"',
            f"load.blocks=[{{cycles={cycles},max={self.K_max},ratio={self.ratio}}}]",
            f"growth.increment={element}",
            f"fine.refine={refine}",
            f"closure.distance={distance}",
            'output.fields="none"',
            'output.history="cycles"',
        ]
        command = [program, "run", str(CASE), "-o", str(folder), "--mode", "inprocess", "--quiet", "--no-report"]
        subprocess.run(command + [part for setting in settings for part in ("--set", setting)], check=True)
        with open(folder / "cycles.csv", newline="", encoding="utf-8") as file:
            last = list(csv.DictReader(file))[-max(1, cycles // 4) :]
        mean = lambda value: statistics.fmean(value(row) for row in last)
        return {
            "K_op / K_max": mean(lambda row: float(row["K_op"]) / float(row["K_max"])),
            "opening range": mean(lambda row: float(row["opening_range"])),
            "J_max": mean(lambda row: float(row["J_max"])),
        }


def errors_of(plate, program):
    """Pairs: elements to the distance, and errors by name."""
    found = []
    for distance in (plate.default_distance, 2.0 * plate.default_distance):
        with tempfile.TemporaryDirectory() as folder:
            runs = {refine: plate.run(program, refine, distance, Path(folder) / str(refine)) for refine in plate.refinements()}
        *coarser, finest = runs
        exact = runs[finest]
        for refine in coarser:
            run = runs[refine]
            errors = {name: run[name] / exact[name] - 1.0 for name in ("opening range", "J_max")}
            errors["K_op / K_max"] = run["K_op / K_max"] - exact["K_op / K_max"]
            found.append((distance * refine / SIZE, errors))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stria")
    parser.add_argument("--plates", type=int, default=16)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    all_errors = {"strain": [], "stress": []}
    for _ in range(options.plates):
        plate = Plate(chance)
        all_errors[plate.plane] += errors_of(plate, str(Path(options.stria).resolve()))
    print("| plane | elements to the distance | runs | K_op / K_max | opening range, % | J_max, % |\n|---|---|---|---|---|---|")
    for plane, found in all_errors.items():
        for low, high in zip(BINS, BINS[1:]):
            within = [errors for elements, errors in found if low <= elements < high]
            if not within:
                continue
            cells = []
            for name, scale, digits in (("K_op / K_max", 1.0, 3), ("opening range", 100.0, 0), ("J_max", 100.0, 1)):
                sizes = [scale * abs(errors[name]) for errors in within]
                cells.append(f"{statistics.median(sizes):.{digits}f}, {max(sizes):.{digits}f}")
            print(f"| {plane} | {low:g} to {high:g} | {len(within)} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
