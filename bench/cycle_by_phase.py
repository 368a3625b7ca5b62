#!/usr/bin/python3
"""What a fatigue cycle costs, by phase and as a whole: a case is run with few cycles and with many, so that set-up and the
extensions of the zone cancel. Prints Markdown tables; `--profile` adds the shares that `perf` sees, of all but the set-up.

    bench/cycle_by_phase.py build/release/bin/stria [bench/cycle/case.toml] [--max 50] [--cycles 10 40] [--profile]
"""

import argparse
import csv
import json
import re
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

PHASES = {
    "fine_constitutive": "strains, return mapping, forces and tangents of the zone",
    "fine_factor": "fronts with the multipliers in them, tangent on Gamma",
    "fine_contact": "gaps and statuses",
    "exchange": "from question to answer: the lines above, and in process also what the coarse side does meanwhile",
    "coarse_solve": "Gamma, near structure, guard, rings",
    "output": "tables",
}

# A sample belongs to the innermost of its functions that stands here.
PARTS = {
    "return mapping": r"fine::(J2|J2PlaneStress|Elastic)::update",
    "strains, forces and tangents of points": r"fine::(Bulk|PointHistory|RestingElements)::",
    "contact": r"fine::ContactInterface::",
    "fronts: factor": r"FrontTree::factor",
    "fronts: solve": r"FrontTree::(reduce|expand)",
    "Gamma: factor": r"BorderedSystem::factor",
    "Gamma: solve": r"CondensedEquilibrium::(solve|linearise)",
    "near structure: solve": r"Structure::expand",
    "rings": r"RingForms|ring_integrals|RingSums|fine::add_to",
    "guard": r"YieldGuard|near_elements_beyond",
    "exchange": r"Transport|pack<|unpack<",
    "reports of the zone": r"fine::(ZoneSystem|FineModel)::(commit|measure)",
    "structure condensed anew, where the zone extends": r"CrackedBody::condense_onto|TwoScaleModel::couple",
}


def command(program, case, load, cycles, folder):
    blocks = f"load.blocks=[{{cycles={cycles},max={load},ratio=0.0}}]"
    return [program, "run", case, "-o", str(folder), "--mode", "inprocess", "--quiet", "--force", "--set", blocks]


def run(program, case, load, cycles):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command(program, case, load, cycles, folder), check=True)
        with open(Path(folder) / "cycles.csv", newline="", encoding="utf-8") as file:
            wall = [float(row["wall_s"]) for row in csv.DictReader(file)]
        return json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8")), wall


def print_phases(few, many, cycles):
    def gained(value):
        return (value(many) - value(few)) / cycles

    iterations = gained(lambda s: s["newton_iterations"])
    total = gained(lambda s: s["timing"]["exchange"] + s["timing"]["coarse_solve"] + s["timing"]["output"])
    print("| phase | ms a cycle | ms an iteration | share | what |\n|---|---|---|---|---|")
    for phase, text in PHASES.items():
        seconds = gained(lambda s: s["timing"][phase])
        print(f"| `{phase}` | {1e3 * seconds:.2f} | {1e3 * seconds / iterations:.3f} | {100 * seconds / total:.0f} % | {text} |")
    print(f"| all | {1e3 * total:.2f} | {1e3 * total / iterations:.3f} | | {iterations:.1f} iterations a cycle |\n")
    print("| counter | a cycle |\n|---|---|")
    for name, value in many.items():
        if isinstance(value, int) and value > few[name]:
            print(f"| `{name}` | {(value - few[name]) / cycles:.1f} |")


def profile(program, case, load, cycles):
    with tempfile.TemporaryDirectory() as folder:
        data = str(Path(folder) / "perf.data")
        record = ["perf", "record", "-q", "-F", "499", "--call-graph", "dwarf,16384", "-o", data]
        subprocess.run(record + command(program, case, load, cycles, Path(folder) / "out"), check=True)
        text = subprocess.run(["perf", "script", "-i", data], check=True, capture_output=True, text=True).stdout
    shares, named = Counter(), [(part, re.compile(pattern)) for part, pattern in PARTS.items()]
    for sample in text.split("\n\n"):
        if "FatigueAnalysis::run" not in sample:
            continue
        functions = sample.split("\n")[1:]
        shares[next((part for f in functions for part, pattern in named if pattern.search(f)), "rest")] += 1
    print(f"\n| part | share of {shares.total()} samples |\n|---|---|")
    for part, count in shares.most_common():
        print(f"| {part} | {100 * count / shares.total():.1f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("case", nargs="?", default=str(ROOT / "bench/cycle/case.toml"))
    parser.add_argument("--max", type=float, default=50.0, help="largest load factor")
    parser.add_argument("--cycles", type=int, nargs=2, default=(10, 40))
    parser.add_argument("--profile", action="store_true")
    options = parser.parse_args()
    few, _ = run(options.program, options.case, options.max, options.cycles[0])
    many, wall = run(options.program, options.case, options.max, options.cycles[1])
    print_phases(few, many, options.cycles[1] - options.cycles[0])
    late = sorted(wall[options.cycles[0] :])
    print(f"\nWall time of a cycle, from the {options.cycles[0] + 1}th on: fastest {late[0]:.3f} s, median {late[len(late) // 2]:.3f} s")
    if options.profile:
        profile(options.program, options.case, options.max, options.cycles[1])


if __name__ == "__main__":
    main()
