#!/usr/bin/python3
"""What stands at a growing tip: one singular function, frozen or kept when the tip moves on, or none.

    tools/compare_growing_tips.py build/release/bin/stria

`cases/sent-closure` shortened to 14 cycles, by plane state, size of the elements at the tip, growth per cycle and
function. Prints a Markdown table: K_op / K_max by contact beyond fixed distances in the last cycle, how far it swings
from cycle to cycle about its trend, the faces of the wake behind the tip, the energy released, Newton iterations and
seconds.

Saw-tooth: root mean square of the opening at the last maximum about a straight line fitted over an element's
length, over the mean opening. Overlap: the largest one at the last minimum, over the largest opening at the maximum. Pressed and open:
the share of stations under pressure that are open by more than a hundredth of the mean opening.
"""

import argparse
import csv
import json
import math
import statistics
import subprocess
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parent.parent / "cases" / "sent-closure" / "case.toml"
CYCLES, FIRST_TIP = 14, 20.0
SCENE = {"load.blocks": f"[{{cycles={CYCLES}, max=501.0, ratio=0.0}}]", "output.faces": '"all"'}
FUNCTIONS = {
    "one, frozen": {"fine.enrichment": '"single"'},
    "one, retained": {"fine.enrichment": '"single"', "growth.retain": '"all"'},
    "none": {"fine.enrichment": '"none"'},
}
PLANES = {  # refinement by size at the tip; distances of opening
    "stress": ({0.1: 16, 0.05: 32, 0.025: 64}, (0.1, 0.2, 0.4)),
    "strain": ({0.05: 32, 0.025: 64, 0.0125: 128}, (0.05, 0.1, 0.2)),
}


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def faces_at(rows, increment, tip):
    """Stations of the wake, an element behind the tip and farther: arc length, opening (mm), pressure (MPa)."""
    wake = [row for row in rows if row["increment"] == increment and FIRST_TIP < float(row["s"]) < tip]
    return sorted(tuple(float(row[name]) for name in ("s", "opening", "pressure")) for row in wake)


def saw_tooth(stations, size):
    rest = []
    for s, opening, _ in stations:
        near = [(x - s, y) for x, y, _ in stations if abs(x - s) <= 0.5 * size]
        if len(near) > 2 and stations[0][0] <= s - 0.5 * size and s + 0.5 * size <= stations[-1][0]:
            rest.append(opening - statistics.linear_regression(*zip(*near)).intercept)
    return math.sqrt(statistics.fmean(x * x for x in rest)) if rest else float("nan")


def swing(values):
    """Largest distance of a value from the mean of its neighbours, of the last six cycles."""
    return max(abs(b - (a + c) / 2) for a, b, c in zip(values[-7:], values[-6:], values[-5:]))


def run(program, folder, settings, size, distances):
    command = [program, "run", str(CASE), "-o", str(folder), "--mode", "inprocess", "--quiet", "--force"]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return [done.stderr.strip().splitlines()[-1]]
    cycles, history, faces = (table(folder / f"{name}.csv") for name in ("cycles", "history", "faces"))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    last = [row for row in history if int(row["cycle"]) == CYCLES]
    load = lambda row: float(row["load_factor"])
    maximum, minimum = max(last, key=load), min(last, key=load)
    tip = float(maximum["a"]) - size
    opened, closed = (faces_at(faces, row["increment"], tip) for row in (maximum, minimum))
    mean = statistics.fmean(opening for _, opening, _ in opened)
    most = max(pressure for _, _, pressure in closed)
    pressed = [opening for _, opening, pressure in closed if pressure > 1e-3 * most]
    contact = [float(row["K_op"] or 0.0) / float(row["K_max"]) for row in cycles]
    profile = {float(row["distance"]): row for row in table(folder / "closure.csv") if int(row["cycle"]) == CYCLES}
    at = [float(profile[d]["K_op"] or 0.0) / float(cycles[-1]["K_max"]) for d in distances]
    return [f"{value:.3f}" for value in at] + [
        f"{swing(contact):.3f}",
        f"{100 * saw_tooth(opened, size) / mean:.2f} %",
        f"{100 * max(0.0, -min(y for _, y, _ in closed)) / max(y for _, y, _ in opened):.2f} %",
        f"{100 * sum(y > 0.01 * mean for y in pressed) / max(1, len(pressed)):.0f} %",
        f"{1e3 * float(history[-1]['released_energy']):.3f}",
        str(summary["newton_iterations"]),
        f"{summary['timing']['total']:.0f}",
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--plane", choices=PLANES, nargs="*", default=list(PLANES))
    chosen = parser.parse_args()
    for plane in chosen.plane:
        sizes, distances = PLANES[plane]
        print(f"\nPlane {plane}:\n")
        print("| size, mm | growth, mm | function |" + "".join(f" K_op beyond {d} mm |" for d in distances)
              + " swing | saw-tooth | overlap | pressed and open | released, mN | iterations | s |")
        print("|" + "---|" * (10 + len(distances)))
        for size, refine in sizes.items():
            for growth in (0.05, 0.037):
                for name, functions in FUNCTIONS.items():
                    settings = SCENE | functions | {
                        "model.plane": f'"{plane}"', "fine.refine": refine, "growth.increment": growth,
                        "closure.distance": distances[0], "closure.profile": list(distances[1:])}
                    with tempfile.TemporaryDirectory() as folder:
                        cells = run(chosen.program, Path(folder), settings, size, distances)
                    print(f"| {size} | {growth} | {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
