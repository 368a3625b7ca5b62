#!/usr/bin/python3
"""What `stria check` says that a run takes, against what it does.

    bench/error_of_estimate.py build/release/bin/stria [--only NAME] [--repeat 2]

The shipped cases, and some of them under other loads, with other metals or finer. One process, no page. Prints a
Markdown table: seconds of a processor and megabytes as announced and as taken (the best of the repeats; the largest
resident memory), their ratios, and of both the increments, iterations of each and points.
"""

import argparse
import json
import re
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SHORT_BLOCK = "load.blocks=[{cycles=8,max=501.0,ratio=-1.0}]"
GROWING = ROOT / "bench/growing_cycle/case.toml"
RUNS = {
    "sent-compression": [],
    "sent-compression to 100 MPa": ["load.blocks=[{cycles=1,max=100.0,ratio=-1.0}]"],
    "sent-closure": [],
    "sent-closure, R = -1": [SHORT_BLOCK],
    "ct-closure": [],
    "overload": [],
    "paris-life": [],
    "weld": [],
    "dead-load": [],
    "rolling-contact": [],
    "inclined-compression": [],
    "plate-hole": [],
    "three-holes": [],
    "t-joint": [],
    "lug": [],
    "growing_cycle": ["load.blocks=[{cycles=12,max=50.0,ratio=0.0}]"],
    "growing_cycle, R = -1, perfectly plastic": [
        "load.blocks=[{cycles=12,max=50.0,ratio=-1.0}]", "material.kinematic=[]"],
    "growing_cycle, plane stress, K = 501": [
        "model.plane='stress'", "load.control='K'", "load.blocks=[{cycles=12,max=501.0,ratio=0.0}]"],
}
SAID = re.compile(r"estimate of the run: (\d+) increments, at most (\S+) of (\S+) points flow; "
                  r"about (\S+) s of a processor and (\S+) MB")


def case_of(name):
    first = name.split(",")[0].split(" to ")[0]
    return GROWING if first == "growing_cycle" else ROOT / "cases" / first / "case.toml"


def settings_of(name):
    return [word for setting in RUNS[name] for word in ("--set", setting)]


def said(program, name):
    words = [program, "check", str(case_of(name)), *settings_of(name)]
    found = SAID.search(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return [float(figure) for figure in found.groups()]


def taken(program, name, folder):
    words = [program, "run", str(case_of(name)), "-o", folder, "--mode", "inprocess", "--quiet", "--no-report",
             "--force", *settings_of(name)]
    run = subprocess.run(["/usr/bin/time", "-f", "%U %S %M", *words], check=True, capture_output=True, text=True)
    user, system, kilobytes = (float(figure) for figure in run.stderr.split("\n")[-2].split())
    return user + system, kilobytes / 1024.0, json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only")
    parser.add_argument("--repeat", type=int, default=2)
    chosen = parser.parse_args()
    print("| case | s said, taken | ratio | MB said, taken | ratio | increments said, done | iterations of each "
          "| points said, done; that flow |")
    print("|---|---|---|---|---|---|---|---|")
    for name in RUNS:
        if chosen.only and chosen.only not in name:
            continue
        increments, flow, points, seconds, megabytes = said(chosen.program, name)
        with tempfile.TemporaryDirectory() as folder:
            runs = [taken(chosen.program, name, folder) for _ in range(chosen.repeat)]
            with open(Path(folder) / "history.csv", encoding="utf-8") as file:
                done = int(file.read().splitlines()[-1].split(",")[0])
        took, resident, summary = min(runs, key=lambda run: run[0])
        print(f"| {name} | {seconds:.2g}, {took:.2g} | {seconds / took:.1f} | {megabytes:.0f}, {resident:.0f} "
              f"| {megabytes / resident:.1f} | {increments:.0f}, {done} | {summary['newton_iterations'] / done:.1f} "
              f"| {points:.0f}, {summary['fine_points']}; {flow:.0f} |", flush=True)


if __name__ == "__main__":
    main()
