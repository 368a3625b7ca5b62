#!/usr/bin/python3
"""Increments that the program chooses (load.steps = "auto") beside given numbers of them: what they cost and how near they come.

    bench/chosen_increments.py build/release/bin/stria [--steps 8 12 24] [--reference 96] [--scene NAME ...]

Runs each case with the numbers chosen, with each of the given ones, graded alike, and with the reference. Prints a Markdown
table: increments of the last cycle, Newton iterations of the run, and errors of the opening range and of K_op / K_max: those of
the last cycle, and the largest after the first one. All is counted, not timed: it may run beside other work.
"""

import argparse
import csv
import json
import os
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SENT = ROOT / "cases/sent-closure/case.toml"
SCENES = {  # case, and settings beside it
    "growing_cycle": (ROOT / "bench/growing_cycle/case.toml", []),
    "sent-closure": (SENT, []),
    "sent-closure, plane strain": (SENT, ["model.plane=strain"]),
    "sent-closure, R = -1": (SENT, ["load.blocks.0.ratio=-1.0"]),
    "sent-closure, R = -1, plane strain": (SENT, ["load.blocks.0.ratio=-1.0", "model.plane=strain"]),
} | {name: (ROOT / f"cases/{name}/case.toml", []) for name in ("ct-closure", "overload", "paris-life")}


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as rows:
        return [row for row in csv.DictReader(rows) if row["tip"] == "0"]


def run(program, case, settings):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        command = [program, "run", str(case), "-o", str(folder / "out"), "--mode", "inprocess", "--quiet", "--set", "output.fields=none"]
        for setting in settings:
            command += ["--set", setting]
        subprocess.run(command, check=True, env=dict(os.environ, OPENBLAS_NUM_THREADS="1"))
        cycles = rows_of(folder / "out" / "cycles.csv")
        last = cycles[-1]["cycle"]
        increments = sum(row["cycle"] == last for row in rows_of(folder / "out" / "history.csv"))
        summary = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
    return {"cycles": cycles, "increments": increments, "iterations": summary["newton_iterations"]}


def number(row, name):
    return float(row[name] or "nan")


def of(errors, form):
    """The last one, and the largest of them."""
    known = [error for error in errors if error == error]
    return f"{form % known[-1]}, {form % max(map(abs, known))}" if known else "-, -"


def line(scene, name, result, reference):
    pairs = list(zip(result["cycles"], reference["cycles"]))[1:]
    opened = [number(a, "K_op") / number(a, "K_max") - number(b, "K_op") / number(b, "K_max") for a, b in pairs]
    ranges = [100.0 * (number(a, "opening_range") / number(b, "opening_range") - 1.0) for a, b in pairs if number(b, "opening_range") > 0.0]
    return f"| {scene} | {name} | {result['increments']} | {result['iterations']} | {of(ranges, '%.2f')} | {of(opened, '%.4f')} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--steps", type=int, nargs="*", default=[8, 12, 24])
    parser.add_argument("--reference", type=int, default=96)
    parser.add_argument("--scene", nargs="*", default=list(SCENES), choices=SCENES)
    chosen = parser.parse_args()
    given = lambda steps: [f"load.steps={steps}", "load.grading=0.4"]  # noqa: E731
    print("| case | increments | in the last cycle | iterations | range, %: last cycle, largest | K_op / K_max |")
    print("|---|---|---|---|---|---|")
    for scene in chosen.scene:
        case, settings = SCENES[scene]
        reference = run(chosen.program, case, settings + given(chosen.reference))
        print(line(scene, "**chosen**", run(chosen.program, case, settings), reference), flush=True)
        for steps in chosen.steps:
            print(line(scene, str(steps), run(chosen.program, case, settings + given(steps)), reference), flush=True)


if __name__ == "__main__":
    main()
