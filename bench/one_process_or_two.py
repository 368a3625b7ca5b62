#!/usr/bin/python3
"""Wall time and processor time of one coarse and one fine rank beside those of one process.

    bench/one_process_or_two.py build/release/bin/stria [ANOTHER/stria ...] [--cases overload ...] [--repeat 5]
                                [--full]

The shipped closure cases, shortened unless --full. The runs take turns, and the best and the median of each count. Under other work
`chrt -f 10` before the command gives the runs the cores that they would find on a quiet machine.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CASES = {
    "overload": "[{cycles=12,max=300.0,ratio=0.1}]",
    "paris-life": "[{cycles=8,max=50.0,ratio=0.1}]",
    "ct-closure": "[{cycles=12,max=440.0,ratio=0.1}]",
    "sent-closure": "[{cycles=10,max=501.0,ratio=0.0}]",
}


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds(program, mode, case, full):
    """By the clock and of a processor."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", str(ROOT / "cases" / case / "case.toml"), "-o", folder + "/out", "--mode", mode,
                   "--quiet", "--no-report", "--set", "output.fields=none"]
        if not full:
            command += ["--set", "load.blocks=" + CASES[case]]
        wall, used = time.monotonic(), processor_time()
        subprocess.run(command, check=True)
        return time.monotonic() - wall, processor_time() - used


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES))
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--full", action="store_true")
    options = parser.parse_args()
    sides = [(options.programs[0], "inprocess")] + [(program, "mpi") for program in options.programs]
    print("| case | program | mode | wall, best | median | ratio | CPU, best | median | ratio |\n|" + "---|" * 9)
    for case in options.cases:
        found = {side: [] for side in sides}
        for turn in range(options.repeat):
            for side in sides if turn % 2 == 0 else reversed(sides):
                found[side].append(seconds(*side, case, options.full))
        one = [min(column) for column in zip(*found[sides[0]])]
        for side in sides:
            cells = [case, os.path.dirname(side[0]), side[1]]
            for k, column in enumerate(zip(*found[side])):
                best = min(column)
                cells += [f"{best:.2f}", f"{statistics.median(column):.2f}", f"{best / one[k]:.2f}"]
            print("| " + " | ".join(cells) + " |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
