#!/usr/bin/python3
"""Cost of a growing cycle with its opening loads, in units of tools/machine_unit.py.

    bench/growing_cycle.py build/release/bin/stria [ANOTHER/stria ...] [--cycles 12] [--repeat 3] [--angle 0]
                           [--set KEY=VALUE ...]

The plate of the first example with a uniform mesh (50 x 102.5 mm, size 1.6), refine = 32: 0.05 mm at the tip; 50 MPa,
R = 0, growth of 0.05 mm per cycle. Only mesh, loads, growth and refinement are given. `--angle`: degrees from the lines
of the mesh, along which the crack runs and grows otherwise. Programs take turns. Prints a Markdown table: seconds and
units per cycle from the second on, CPU over wall, iterations, points evaluated and fronts factored per cycle, K_op /
K_max of the last cycle.
"""

import argparse
import csv
import json
import math
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tools"))
from machine_unit import machine_unit  # noqa: E402

CASE = Path(__file__).resolve().parent / "growing_cycle" / "case.toml"


def at_angle(degrees):
    """Settings of a crack across the mesh, through the middle of that along it, and off its lines."""
    rise = 10.0 * math.tan(math.radians(degrees))
    return [f"crack.0.points=[[0.0, {51.263 - rise}], [20.0, {51.263 + rise}]]", 'growth.direction="straight"']


def run(program, mode, cycles, settings):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        blocks = f"load.blocks=[{{cycles={cycles},max=50.0,ratio=0.0}}]"
        command = [program, "run", str(CASE), "-o", str(folder / "out"), "--mode", mode, "--quiet", "--set", blocks]
        for setting in settings:
            command += ["--set", setting]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        summary = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
        with open(folder / "out" / "cycles.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    wall = sum(float(row["wall_s"]) for row in rows[1:]) / (len(rows) - 1)
    return {"wall": wall, "cpu": cpu / summary["timing"]["total"], "summary": summary, "last": rows[-1], "cycles": cycles}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--cycles", type=int, default=12)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--angle", type=float, default=0.0)
    parser.add_argument("--set", action="append", default=[])
    chosen = parser.parse_args()
    settings = (at_angle(chosen.angle) if chosen.angle != 0.0 else []) + chosen.set
    best, unit = {}, machine_unit()
    for _ in range(chosen.repeat):
        for program in chosen.programs:
            for mode in ("inprocess", "mpi"):
                now = run(program, mode, chosen.cycles, settings)
                if (program, mode) not in best or now["wall"] < best[program, mode]["wall"]:
                    best[program, mode] = now
        unit = min(unit, machine_unit())
    print(f"Unit: {unit:.4f} s\n")
    print("| program | mode | s per cycle | units | CPU / wall | iterations | points | fronts | K_op / K_max |")
    print("|---|---|---|---|---|---|---|---|---|")
    for (program, mode), result in best.items():
        counts, cycles = result["summary"], result["cycles"]
        opened = float(result["last"]["K_op"]) / float(result["last"]["K_max"])
        print(f"| {program} | {mode} | {result['wall']:.3f} | {result['wall'] / unit:.1f} | {result['cpu']:.2f} | "
              f"{counts['newton_iterations'] / cycles:.0f} | {counts['points_evaluated'] / cycles:.0f} | "
              f"{counts['fronts_refactored'] / cycles:.0f} | {opened:.3f} |")


if __name__ == "__main__":
    main()
