#!/usr/bin/python3
"""Several fine ranks on cracks that grow in every cycle: beta by ranks, and what a second rank gains.

    bench/growing_ranks.py build/release/bin/stria [--cycles 5] [--repeat 3] [--only beta|gain]

The plate of bench/growing_cycle, 90 MPa, refine = 32, for beta from 0.5 to 8; the same with smaller elements and
beta = 8 (58 000 points); and four cracks (bench/growing_ranks, 69 000 points). Each on one rank and on two, in mode
mpi; numbers of ranks take turns. Prints a Markdown table: seconds per cycle by the clock from the third cycle on (ranks
share the zone out anew when the first has shown where it flows), the fastest run of each; processor seconds per such
cycle of the coarse process, in which one of two ranks lives, and of the fine ones; Newton iterations, moves of history
and kB per iteration of all the run. The gain by processors compares the seconds that both processes of one rank take,
for they wait for each other, with those of the process that takes most of two: other work on the machine spoils it
less.
"""

import argparse
import csv
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ONE_CRACK, FOUR_CRACKS = HERE / "growing_cycle" / "case.toml", HERE / "growing_ranks" / "four_cracks.toml"
TICK = os.sysconf("SC_CLK_TCK")
UNMEASURED = 2  # cycles


def processes_under(pid):
    yield pid
    try:
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
    except OSError:
        return
    for child in children:
        yield from processes_under(int(child))


def processor_seconds(pid):
    """Of all processes that a run has started, by id: (program, seconds)."""
    seconds = {}
    for each in processes_under(pid):
        try:
            text = Path(f"/proc/{each}/stat").read_text()
        except OSError:
            continue
        fields = text[text.rindex(")") + 2:].split()
        seconds[each] = (text[text.index("(") + 1:text.rindex(")")], (int(fields[11]) + int(fields[12])) / TICK)
    return seconds


def follow(process, table, unmeasured):
    """The same until the process ends, less what it had taken after so many cycles."""
    before, seconds = {}, {}
    while process.poll() is None:
        seconds.update(processor_seconds(process.pid))
        if not before and table.exists() and table.read_text().rstrip().split("\n")[-1].startswith(f"{unmeasured},"):
            before = dict(seconds)
        time.sleep(0.02)
    return [(program, s - before[pid][1]) for pid, (program, s) in seconds.items() if pid in before]


def run(program, case, ranks, settings):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "out"
        command = [program, "run", str(case), "-o", str(folder), "--mode", "mpi", "--fine", str(ranks), "--quiet"]
        for setting in settings:
            command += ["--set", setting]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        seconds = follow(process, folder / "cycles.csv", UNMEASURED)
        if process.returncode != 0:
            raise SystemExit(f"failed: {' '.join(command)}")
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        with open(folder / "cycles.csv", newline="", encoding="utf-8") as file:
            cycles = {row["cycle"]: float(row["wall_s"]) for row in csv.DictReader(file)}
    later = list(cycles.values())[UNMEASURED:]
    return {
        "wall": sum(later) / len(later),
        "coarse": sum(s for program, s in seconds if program == "stria-coarse") / len(later),
        "fine": sorted(s / len(later) for program, s in seconds if program == "stria-fine"),
        "summary": summary,
    }


def fastest(program, case, settings, cycles, stress, repeat):
    """By number of ranks."""
    blocks = f"load.blocks=[{{cycles={cycles},max={stress},ratio=0.0}}]"
    best = {}
    for _ in range(repeat):
        for ranks in (1, 2):
            now = run(program, case, ranks, [blocks] + settings)
            if ranks not in best or now["wall"] < best[ranks]["wall"]:
                best[ranks] = now
    return best


def longest(of):
    """One rank and the structure take turns; two ranks work at a time, one of them in the structure's process."""
    one, two = of[1], of[2]
    return one["coarse"] + one["fine"][0], max(two["coarse"], two["fine"][0])


def print_row(name, of):
    both = [of[ranks] for ranks in (1, 2)]
    with_one, with_two = longest(of)

    def pair(value):
        return ", ".join(value(result, result["summary"]) for result in both)

    cells = [
        name,
        str(both[0]["summary"]["fine_points"]),
        pair(lambda r, _: f"{r['wall']:.2f}"),
        f"{both[0]['wall'] / both[1]['wall']:.2f}",
        pair(lambda r, _: f"{r['coarse']:.2f}"),
        pair(lambda r, _: " + ".join(f"{s:.2f}" for s in r["fine"])),
        f"{with_one / with_two:.2f}",
        pair(lambda _, s: str(s["newton_iterations"])),
        str(both[1]["summary"]["history_moves"]),
        pair(lambda _, s: f"{s['bytes'] / s['newton_iterations'] / 1e3:.0f}"),
    ]
    print("| " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--cycles", type=int, default=5)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--only", choices=["beta", "gain"])
    chosen = parser.parse_args()
    print("| case | points | s per cycle with 1, 2 ranks | gain | of the coarse processor | of the fine ones | "
          "gain by processors | iterations | moves of history | kB per iteration |")
    print("|---|---|---|---|---|---|---|---|---|---|")

    def measure(name, case, settings, stress):
        print_row(name, fastest(chosen.program, case, settings, chosen.cycles, stress, chosen.repeat))

    if chosen.only != "gain":
        for beta in (0.5, 1, 2, 4, 8):
            measure(f"beta = {beta}", ONE_CRACK, [f"fine.beta={beta}", "fine.guard=warn"], 90.0)
    if chosen.only != "beta":
        measure("one crack", ONE_CRACK, ["fine.beta=8", "fine.refine=64", "fine.growth=0.11"], 90.0)
        measure("four cracks", FOUR_CRACKS, ["fine.refine=64"], 60.0)


if __name__ == "__main__":
    main()
