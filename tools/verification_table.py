#!/usr/bin/python3
"""Runs the verification cases and prints their results as the Markdown tables of docs/verification.md.

    tools/verification_table.py build/release/bin/stria
    tools/verification_table.py build/release/bin/stria --tests build/release/bin/stria_verification_tests

Takes about two minutes on two cores; --tests adds the contact pressures over random cuts.
"""

import argparse
import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FIRST_EXAMPLE = ROOT / "cases/sent-compression/case.toml"
YOUNG, POISSON = 200e3, 0.3
PLANE_MODULUS = YOUNG / (1.0 - POISSON**2)

# An elastic plate of width 50 with an edge crack at half its height; the variants replace single keys.
ELASTIC = """\
units = "N-mm-MPa"
[mesh]
specimen = "sent"
width = 50.0
height = 100.0
size = 0.8
[material]
young = 200e3
poisson = 0.3
[[crack]]
points = [[0.0, 50.0], [25.0, 50.0]]
[[boundary]]
on = "top"
{top}
[[boundary]]
on = "bottom"
{bottom}
[load]
steps = 2
blocks = [ {{ max = 1.0, ratio = 0.0 }} ]
[output]
faces = "none"
fields = "none"
"""
PULLED = {"top": "traction = [0.0, 1.0]", "bottom": "traction = [0.0, -1.0]"}
GRIPPED = {"top": 'displacement = ["free", 0.01]', "bottom": 'displacement = ["free", 0.0]'}

# Edge crack, a / W, height / (2 W), K / (sigma sqrt(pi a)), source.
PULLED_PLATES = [
    (0.3, 2.0, 1.6551, "handbook, stated accuracy 0.5 %"),
    (0.5, 2.0, 2.8266, "handbook, stated accuracy 0.5 %"),
    (0.3, 1.0, 1.6606, "quadratic finite elements"),
    (0.5, 1.0, 2.8245, "quadratic finite elements"),
    (0.3, 0.5, 1.8471, "quadratic finite elements"),
    (0.5, 0.5, 3.0078, "quadratic finite elements"),
]
GRIPPED_PLATES = [(0.3, 1.0, 1.1797), (0.5, 1.0, 1.2981)]

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

    def elastic(self, boundaries, *settings):
        case = self.folder / "elastic.toml"
        case.write_text(ELASTIC.format(**boundaries), encoding="utf-8")
        return history(self.run(case, *settings))


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


def percent(ours, reference):
    return f"{100.0 * (ours / reference - 1.0):+.2f} %"


def edge_crack(a, height, rows=None):
    """Rows of elements, about 0.8 mm each; an odd number: the crack runs through their middle."""
    rows = rows or {200.0: 251, 100.0: 125, 50.0: 63}[height]
    return [f"mesh.height={height}", f"mesh.size={height / rows:.12f}", f"crack.0.points=[[0.0, {height / 2.0}], [{a}, {height / 2.0}]]"]


def elastic_table(runs):
    heading("case", "reference", "source", "ours", "error")
    for ratio, half_height, factor, source in PULLED_PLATES:
        a = 50.0 * ratio
        row = runs.elastic(PULLED, *edge_crack(a, 100.0 * half_height))[0]
        ours = float(row["K_I"]) / math.sqrt(math.pi * a)
        line(f"edge crack, uniform traction, a/W = {ratio}, height {2 * half_height:g} W", f"F = {factor}", source, f"{ours:.4f}", percent(ours, factor))
    row = runs.elastic(PULLED, *edge_crack(25.0, 100.0, 126))[0]
    ours = float(row["K_I"]) / math.sqrt(math.pi * 25.0)
    line("edge crack, uniform traction, a/W = 0.5, height 2 W, along element edges", "F = 2.8245", "quadratic finite elements", f"{ours:.4f}", percent(ours, 2.8245))
    for ratio, half_height, factor in GRIPPED_PLATES:
        a = 50.0 * ratio
        row = runs.elastic(GRIPPED, *edge_crack(a, 100.0 * half_height))[0]
        ours = float(row["K_I"]) / (float(row["load"]) / 50.0 * math.sqrt(math.pi * a))
        line(f"edge crack, ends moved evenly, a/W = {ratio}, height {2 * half_height:g} W", f"F = {factor}", "quadratic finite elements", f"{ours:.4f}", percent(ours, factor))
    beta, a = math.radians(60.0), 2.5  # between the crack and the load
    x, y = a * math.sin(beta), a * math.cos(beta)
    crack = f"crack.0.points=[[{25.0 - x}, {50.0 - y}], [{25.0 + x}, {50.0 + y}]]"
    row = runs.elastic(PULLED, "mesh.specimen=plate", "mesh.height=100.0", "mesh.size=0.3105590062", crack)[0]
    for name, exact in (("K_I", math.sin(beta) ** 2 * math.sqrt(math.pi * a)), ("K_II", math.sin(beta) * math.cos(beta) * math.sqrt(math.pi * a))):
        ours = abs(float(row[name]))
        line(f"centre crack, 60 degrees to the load, 2a = W/10, size of {name}", f"{exact:.4f}", "infinite plate", f"{ours:.4f}", percent(ours, exact))
    energy = (float(row["K_I"]) ** 2 + float(row["K_II"]) ** 2) / PLANE_MODULUS
    line("the same crack, J against (K_I^2 + K_II^2) / E'", f"{energy:.5e}", "identity", f"{float(row['J']):.5e}", percent(float(row["J"]), energy))


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


def pressure_table(program):
    heading("mesh", "cuts", "mean error", "worst error", "Newton iterations at most")
    output = subprocess.run([program, "--gtest_filter=ContactPressure.*"], check=True, capture_output=True, text=True).stdout
    pattern = r"(\d+ x \d+), (\d+) cuts: pressure error mean ([\d.]+ %), worst ([\d.]+ %), iterations at most (\d+)"
    for found in re.findall(pattern, output):
        line(*found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stria", help="the program")
    parser.add_argument("--tests", help="stria_verification_tests, for the contact pressures")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        runs = Runs(str(Path(options.stria).resolve()), Path(folder))
        print("### Elastic stress intensities\n")
        elastic_table(runs)
        print("\n### The first example: zone radius and mesh\n")
        first_example_table(runs)
        print("\n### The first example: three ways to run\n")
        modes_table(runs)
    if options.tests:
        print("\n### Contact pressure over random cuts\n")
        pressure_table(options.tests)


if __name__ == "__main__":
    main()
