#!/usr/bin/python3
"""Functions of tips that have moved on: frozen, or unknowns still (growth.retain), both against elements half and a quarter as large.

    tools/compare_old_functions.py build/release/bin/stria

An edge crack in plane stress, R = 0, grows by 0.05 mm a cycle. Prints a Markdown table: the opening behind the tip at the
last maximum, the opening load of the last cycle, what growth released, unknowns of the zone and Newton iterations.
"""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parent.parent / "cases" / "sent-compression" / "case.toml"
SCENE = {
    "model.plane": '"stress"',
    "mesh.grading": "[]",
    "mesh.height": "102.5",
    "mesh.size": "2.5",
    "crack.0.points": "[[0.0, 51.25], [20.0, 51.25]]",
    "crack.0.notch": "19.0",
    "load.blocks": "[{cycles=6, max=30.0, ratio=0.0}]",
    "load.steps": "20",
    "growth.increment": "0.05",
    "closure.distance": "0.1",
    "output.faces": '"all"',
    "output.fields": '"none"',
}
VARIANTS = {  # elements of 0.08 mm at the tip, of 0.04 and of 0.02 mm
    "frozen": {"fine.refine": "32"},
    "retained": {"fine.refine": "32", "growth.retain": '"all"'},
    "frozen, elements half as large": {"fine.refine": "64"},
    "retained, elements half as large": {"fine.refine": "64", "growth.retain": '"all"'},
    "frozen, a quarter": {"fine.refine": "128"},
    "retained, a quarter": {"fine.refine": "128", "growth.retain": '"all"'},
}
BEHIND = (0.05, 0.1, 0.2, 0.4)  # mm


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def opening(faces, tip, distance):
    """Interpolated between the stations on either side, um."""
    stations = sorted((float(row["s"]), float(row["opening"])) for row in faces)
    wanted = tip - distance
    for (s, g), (next_s, next_g) in zip(stations, stations[1:]):
        if s <= wanted <= next_s:
            return 1e3 * (g + (wanted - s) / (next_s - s) * (next_g - g))
    return float("nan")


def run(program, settings, folder):
    command = [program, "run", str(CASE), "-o", str(folder), "--mode", "inprocess", "--quiet"]
    for key, value in {**SCENE, **settings}.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    history = table(folder / "history.csv")
    cycles = table(folder / "cycles.csv")
    at_maximum = max(history, key=lambda row: (float(row["load_factor"]), int(row["increment"])))
    faces = [row for row in table(folder / "faces.csv") if row["increment"] == at_maximum["increment"]]
    cells = [f"{opening(faces, float(at_maximum['a']), distance):.3f}" for distance in BEHIND]
    last = cycles[-1]
    opened = float(last["K_op"]) / float(last["K_max"]) if last["K_op"] else float("nan")
    iterations = sum(int(row["newton_iterations"]) for row in history)
    cells += [f"{opened:.3f}", f"{1e3 * float(history[-1]['released_energy']):.3f}", last["fine_unknowns"], str(iterations)]
    if done.returncode != 0:
        cells.append(f"stopped in cycle {history[-1]['cycle']}: {done.stderr.strip().splitlines()[-1]}")
    return cells


def main():
    (program,) = sys.argv[1:]
    print("| old functions |" + "".join(f" {d} mm behind the tip, um |" for d in BEHIND) + " K_op / K_max | released, N um/mm | unknowns | iterations |")
    print("|" + "---|" * (5 + len(BEHIND)))
    with tempfile.TemporaryDirectory() as folder:
        for number, (name, settings) in enumerate(VARIANTS.items()):
            print(f"| {name} | " + " | ".join(run(program, settings, Path(folder) / str(number))) + " |", flush=True)


if __name__ == "__main__":
    main()
