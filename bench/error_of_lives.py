#!/usr/bin/python3
"""What lives with growth.increment = "auto" are off by on random plates: against elements half as large.

    bench/error_of_lives.py build/release/bin/stria [--plates 16] [--seed 1] [--coarser 2] [--set KEY=VALUE ...]

Each plate is that of bench/growing_cycle with a plane state, a load, a ratio and an exponent by chance, on elements that opening
loads want (`stria check`). It lives by Paris' law of dK or dK_eff until it has grown by half to twice what flows straight ahead.
Prints a Markdown table, one row for each plane state and drive: median and range of what the life differs by, in percent; the same
against the limit that both lead to by the first power of the size, twice the finer life less this one; computed cycles.
`--coarser` makes the elements of both runs so many times as large; `--set` goes to the first of both. Nothing is timed. 16 plates
take ten minutes.
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
SIZE, YIELD, CRACK = 1.6, 300.0, 20.0  # of the case


def plate(chance):
    plane, drive = chance.choice(["strain", "stress"]), chance.choice(["dK_eff", "dK_eff", "dK"])
    largest = chance.uniform(35.0, 80.0) if plane == "strain" else chance.uniform(25.0, 60.0)
    K = 2.1 * largest * math.sqrt(math.pi * CRACK)
    flow = (K / YIELD) ** 2
    zone, element = (flow / math.pi, 0.015 * flow) if plane == "stress" else (0.04 * flow, 0.008 * flow)  # straight ahead
    refine = min(64, 2 ** math.ceil(math.log2(SIZE / element)))
    settings = [
        f'model.plane="{plane}"',
        f"load.blocks=[{{cycles=1000,max={largest},ratio={chance.choice([-1.0, -0.5, 0.0, 0.1, 0.3])}}}]",
        'growth.law="paris"',
        "growth.C=1e-13",
        f"growth.m={chance.choice([2.5, 3.0, 4.0])}",
        f'growth.driving="{drive}"',
        'growth.increment="auto"',
        f"growth.until={CRACK + chance.uniform(0.5, 2.0) * zone}",
        'output.fields="none"',
        'output.faces="none"',
        "output.checkpoint_every=0",
    ]
    return plane, drive, refine, settings


def run(program, settings, folder):
    """Cycles of the life, and how many of them were computed."""
    command = [program, "run", str(CASE), "-o", str(folder), "--mode", "inprocess", "--quiet", "--no-report", "--force"]
    command += [part for setting in settings for part in ("--set", setting)]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    with open(folder / "cycles.csv", newline="", encoding="utf-8") as file:
        cycles = list(csv.DictReader(file))
    return float(cycles[-1]["N"]), len(cycles)


def spread(ratios):
    """Median and range, percent."""
    off = [100.0 * (ratio - 1.0) for ratio in ratios]
    return f"{statistics.median(off):.1f} ({min(off):.1f} to {max(off):.1f})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--plates", type=int, default=16)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--coarser", type=int, default=1, choices=[1, 2, 4])
    parser.add_argument("--set", action="append", default=[])
    chosen = parser.parse_args()
    chance, rows = random.Random(chosen.seed), {}
    with tempfile.TemporaryDirectory() as name:
        for _ in range(chosen.plates):
            plane, drive, refine, settings = plate(chance)
            refine = max(1, refine // chosen.coarser)
            life, cycles = run(chosen.program, settings + [f"fine.refine={refine}"] + chosen.set, Path(name) / "life")
            finer, _ = run(chosen.program, settings + [f"fine.refine={2 * refine}"], Path(name) / "finer")
            limit = 2.0 * finer - life
            rows.setdefault((plane, drive), []).append((life / finer, life / limit, cycles))
    print("| plane | by | plates | life, % longer than on elements half as large | than the limit | computed cycles |")
    print("|---|---|---|---|---|---|")
    for (plane, drive), found in sorted(rows.items()):
        of_half, of_limit, cycles = zip(*found)
        spreads = f"{spread(of_half)} | {spread(of_limit)}"
        print(f"| {plane} | {drive} | {len(found)} | {spreads} | {statistics.mean(cycles):.0f} |")


if __name__ == "__main__":
    main()
