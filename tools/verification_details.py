#!/usr/bin/python3
"""Runs the verification cases and prints the Markdown tables that stand in the pages of docs/verification/.

    tools/verification_details.py build/release/bin/stria
    tools/verification_details.py build/release/bin/stria --tests build/release/bin/stria_verification_tests

Takes about two minutes on two cores; --tests adds those that the tests print, another five minutes.
"""

import argparse
import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FIRST_EXAMPLE = ROOT / "cases/sent-compression/case.toml"
HALVED = ["mesh.size=2.5", "mesh.grading.0.size=0.05", "mesh.grading.0.outer_size=0.1", "mesh.grading.0.growth=0.125"]


class Runs:
    def __init__(self, program, folder):
        self.program, self.folder, self.count = program, folder, 0

    def run(self, case, *settings, mode="mpi"):
        """Folder of a finished run."""
        self.count += 1
        result = self.folder / f"run{self.count}"
        command = [self.program, "run", str(case), "-o", str(result), "--quiet", "--mode", mode]
        for setting in settings:
            command += ["--set", setting]
        print("running", " ".join(command[1:]), file=sys.stderr)
        subprocess.run(command, check=True)
        return result


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def history(folder):
    return table(folder / "history.csv")


def heading(*names):
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names))


def line(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def at_extremes(folder):
    """J, CMOD, plastic zone at the first maximum; contact edge and mouth pressure at the minimum."""
    rows = history(folder)
    maximum = max(rows, key=lambda row: float(row["load_factor"]))
    minimum = min(rows, key=lambda row: float(row["load_factor"]))
    closed = [face for face in table(folder / "faces.csv") if face["increment"] == minimum["increment"] and face["status"] != "0"]
    return {
        "J": float(maximum["J"]),
        "CMOD": float(maximum["CMOD"]),
        "CTOD": float(maximum["CTOD"]),
        "plastic_zone": float(maximum["plastic_zone"]),
        "edge": float(closed[-1]["s"]),
        "pressure": float(closed[0]["pressure"]),
    }


def first_example_table(runs):
    heading("run", "points", "extensions", "J, N/mm", "CMOD, mm", "plastic zone, mm", "contact edge, mm", "mouth pressure, MPa", "CTOD, mm")

    def show(name, *settings):
        folder = runs.run(FIRST_EXAMPLE, *settings)
        ours, summary = at_extremes(folder), json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        line(name, summary["fine_points"], summary["zone_extensions"], f"{ours['J']:.6f}", f"{ours['CMOD']:.6f}", f"{ours['plastic_zone']:.3f}", f"{ours['edge']:.3f}",
             f"{ours['pressure']:.2f}", f"{ours['CTOD']:.2e}")

    for beta in (0.3, 1, 2, 4):
        show(f"beta = {beta}", f"fine.beta={beta}")
    show("beta = 0.3, guard = warn", "fine.beta=0.3", "fine.guard=warn")
    show("all elements halved", *HALVED)
    show("plane stress", "model.plane=stress")
    show("plane stress, all elements halved", "model.plane=stress", *HALVED)


def modes_table(runs):
    heading("column", "inprocess against mpi", "monolithic against mpi")
    mpi, inprocess, monolithic = (runs.run(FIRST_EXAMPLE, "solver.tolerance=1e-12", mode=mode) for mode in ("mpi", "inprocess", "monolithic"))

    def difference(file, column, other):
        pairs = [(float(a[column]), float(b[column])) for a, b in zip(table(mpi / file), table(other / file), strict=True)]
        return max(abs(a - b) for a, b in pairs) / max(abs(a) for a, _ in pairs)

    for file, columns in (("history.csv", ("displacement", "K_I", "J", "CMOD", "CTOD", "contact_length", "plastic_zone", "dissipation")),
                          ("faces.csv", ("opening", "pressure"))):
        for column in columns:
            line(f"`{column}` ({file})", f"{difference(file, column, inprocess):.0e}", f"{difference(file, column, monolithic):.0e}")


PERCENT = r"([-+][\d.]+) %"
BENT = "largest ring [\\d.]+, ([\\d.]+) h"

# Title, filter of the tests, heading, what of their output is a row: a pattern whose groups are the cells.
PRINTED = [
    ("Edge crack, ends free to turn", "Specimens.EdgeCrackFreeToTurn", ("a/W", "mesh", "elements across", "K_I, %", "by J, %"),
     rf"sent a/W ([\d.]+), (\w[\w ]*\w) +(\d+) across: K_I {PERCENT}, by J {PERCENT}"),
    ("Edge crack, gripped ends", "Specimens.EdgeCrackWithGrippedEnds", ("a/W", "half height / W", "ends", "elements across", "K_I, %", "by J, %"),
     rf"sent a/W ([\d.]+) H/W ([\d.]+) (\w+) +(\d+) across: K_I {PERCENT}, by J {PERCENT}"),
    ("Middle crack", "Specimens.MiddleCrack", ("2a/W", "elements across", "K_I, %", "by J, %"),
     rf"mt 2a/W ([\d.]+), graded +(\d+) across: K_I {PERCENT}, by J {PERCENT}"),
    ("Compact specimen", "Specimens.CompactTension", ("a/W", "elements across", "K_I, %", "by J, %", "load line, %", "front face, %"),
     rf"ct a/W ([\d.]+), graded +(\d+) across: K_I {PERCENT}, by J {PERCENT}\n.*? {PERCENT}\n.*? {PERCENT}"),
    ("Inclined centre crack", "InclinedCrack.*", ("degrees to the load", "a/W", "elements across", "K_I, %", "K_II, %", "by J, %"),
     rf"inclined ([\d.]+) degrees, a/W ([\d.]+), (\d+) across: K_I {PERCENT}, K_II {PERCENT}, by J {PERCENT}"),
    ("Bent cracks", "*BentCrack*", ("crack", "elements across", "K_I, %", "K_II, %", "by J, %", "rate", "largest ring / h"),
     rf"(\w[\w ,]*?) +(\d+) across: K_I {PERCENT}, K_II {PERCENT}, by J {PERCENT}, rate ([\d.-]+); {BENT}"),
    ("Rates on uniform meshes", "*UniformMeshes*", ("specimen", "elements across", "K_I, %", "by J, %", "rate"),
     rf"uniform (\w+ \w+/W [\d.]+), +(\d+) across: K_I {PERCENT}, by J {PERCENT}, rate ([\d.-]+)"),
    ("Exact fields", "*ConvergesLikePlainElements*:*ReachesTheRatesOfPlainElementsLong*",
     ("radius", "mode", "crack through elements or along edges", "n", "energy", "rate", "K, %", "rate"),
     r"gathered radius ([\d.]+) mode (\d) (\w+) n +(\d+): energy ([\d.]+) rate ([\d.-]+), K ([\d.]+) % rate ([\d.-]+)"),
    ("Condition numbers", "FixedRadius.IsAsWellConditionedAsPlainElements", ("tip functions", "n", "condition number", "rate"),
     r"(gathered|nodal) n +(\d+): condition number ([\d.e+]+), rate ([\d.-]+)"),
    ("A crack moved through one element", "SliverSweep.*Long", ("moved", "K_I varies by, %", "K_II, %", "condition number, largest / smallest"),
     r"sweep (.*): K_I .* varies by ([\d.]+) %; K_II by ([\d.]+) %; .* ratio ([\d.]+)"),
    ("Contact pressure over random cuts", "ContactPressure.*:SlidingTractions.*-*Long", ("mesh", "cuts", "friction", "slip, mm", "mean error of the pressure", "worst", "worst of the shear", "Newton iterations at most"),
     r"(\d+ x \d+), (\d+) cuts, friction ([\d.]+), slip ([\d.]+): pressure error mean ([\d.]+ %), worst ([\d.]+ %), shear worst ([\d.]+ %), iterations at most (\d+)"),
]


def printed_tables(program):
    """What the tests print, as tables."""
    for title, tests, names, pattern in PRINTED:
        print("running", tests, file=sys.stderr)
        output = subprocess.run([program, f"--gtest_filter={tests}"], check=True, capture_output=True, text=True).stdout
        print(f"\n### {title}\n")
        heading(*names)
        for found in dict.fromkeys(re.findall(pattern, output)):  # two tips may say the same
            line(*found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stria", help="the program")
    parser.add_argument("--tests", help="stria_verification_tests, for the tables of the elastic structure and of the contact pressures")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(str(Path(options.stria).resolve()), Path(folder))
        print("### The first example: zone radius and mesh\n")
        first_example_table(runs)
        print("\n### The first example: three ways to run\n")
        modes_table(runs)
    if options.tests:
        printed_tables(options.tests)


if __name__ == "__main__":
    main()
