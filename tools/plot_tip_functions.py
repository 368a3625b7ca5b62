#!/usr/bin/python3
"""What the functions at a stationary tip are worth in a power-law metal: runs bench_power_law_tip, prints the tables of
docs/enrichment.md, and draws errors of J and of the stress ahead of the tip against CPU time.

    tools/plot_tip_functions.py build/release/bin/bench_power_law_tip docs/pictures/tip-functions.png [--n 3 5 10]

`--keep FOLDER` writes what the program has printed there, and takes it from there where it stands already. Needs
matplotlib (Debian: python3-matplotlib).
"""

import argparse
import io
import csv
import os
import subprocess
import tempfile
from pathlib import Path

from pictures import drawing

PLANES = ("strain", "stress")
FUNCTIONS = {  # number of the program: name, colour
    "0": ("none", "#7f7f7f"),
    "1": ("one, r^(1/2)", "#c1403d"),
    "11": ("one, r^(1/(n+1))", "#20639b"),
    "6": ("six, r^(1/2)", "#e8a09e"),
    "16": ("six, r^(1/(n+1))", "#8cb8d9"),
}
ACROSS, SIZES, FINEST = 16, ("4", "8", "16"), "128"
# sqrt(sum of squares / count) over both places of the tip. The finest mesh with one function r^(1/2) is the reference.
RESULTS = {"J": "J", "opening_4": "opening 1/16 W behind", "stress_1": "stress 1/64 to 1/32 W ahead"}


def measured(program, plane, n, keep):
    """Rows of one material, as dictionaries."""
    file = keep / f"{plane}-{n:g}.csv"
    if not file.exists():
        trials = [f"{ACROSS}:{FINEST}:1"] + [f"{ACROSS}:{size}:{f}" for size in SIZES for f in FUNCTIONS]
        command = [program, str(PLANES.index(plane)), f"{n:g}", *trials]
        environment = dict(os.environ, OPENBLAS_NUM_THREADS="1")
        file.write_text(subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout)
    return list(csv.DictReader(io.StringIO(file.read_text(encoding="utf-8"))))


def errors(rows, size, function, load):
    """Per result its error in percent, then CPU seconds, iterations and condition numbers, the worse of both places."""
    found = {name: [] for name in RESULTS}
    beside = []
    for tip in ("edge", "inside"):
        at = {(r["refine"], r["function"]): r for r in rows if r["tip"] == tip and float(r["load"]) == load}
        own, reference = at[size, function], at[FINEST, "1"]
        for name in RESULTS:
            found[name].append(100.0 * (float(own[name]) / float(reference[name]) - 1.0))
        beside.append([float(own[key]) for key in ("seconds", "iterations", "condition", "condition_of_tangent")])
    mean = {name: (sum(e * e for e in values) / len(values)) ** 0.5 for name, values in found.items()}
    return mean, [max(values) for values in zip(*beside)]


def print_table(plane, n, rows):
    print(f"\nPlane {plane}, n = {n:g}:\n")
    print("| W / h | functions | " + " | ".join(f"{name}, half / limit load, %" for name in RESULTS.values())
          + " | iterations | s | condition | of the tangent |")
    print("|" + "---|" * (len(RESULTS) + 6))
    for size in SIZES:
        for function, (name, _) in FUNCTIONS.items():
            (half, _), (limit, beside) = (errors(rows, size, function, load) for load in (0.5, 1.0))
            seconds, iterations, condition, tangent = beside
            cells = [f"{half[key]:.2f} / {limit[key]:.2f}" for key in RESULTS]
            print(f"| {ACROSS * int(size)} | {name} | " + " | ".join(cells)
                  + f" | {iterations:.0f} | {seconds:.1f} | {condition:.1e} | {tangent:.1e} |")


def draw(picture, tables):
    pyplot = drawing()
    shown = ("J", "stress_1")
    figure, rows = pyplot.subplots(len(shown), len(tables), figsize=(2.3 * len(tables), 5.2), sharey="row",
                                   squeeze=False)
    for column, ((plane, n), table) in enumerate(tables.items()):
        for axes, result in zip(rows[:, column], shown):
            for function, (name, colour) in FUNCTIONS.items():
                points = [errors(table, size, function, 1.0) for size in SIZES]
                axes.semilogy([beside[0] for _, beside in points], [max(1e-2, mean[result]) for mean, _ in points], "o-",
                            color=colour, ms=3.5, lw=1.2, label=name)
            axes.grid(alpha=0.3)
        rows[0][column].set_title(f"plane {plane}, n = {n:g}", fontsize="small")
        rows[-1][column].set_xlabel("CPU time, s", fontsize="small")
    for axes, result in zip(rows[:, 0], shown):
        axes.set_ylabel(f"error, %: {RESULTS[result]}", fontsize="small")
    rows[0][0].legend(fontsize="xx-small")
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("picture", type=Path)
    parser.add_argument("--n", type=float, nargs="+", default=[3.0, 5.0, 10.0])
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        keep = options.keep or Path(scratch)
        keep.mkdir(parents=True, exist_ok=True)
        tables = {(plane, n): measured(options.program, plane, n, keep) for plane in PLANES for n in options.n}
    for (plane, n), rows in tables.items():
        print_table(plane, n, rows)
    draw(options.picture, tables)


if __name__ == "__main__":
    main()
