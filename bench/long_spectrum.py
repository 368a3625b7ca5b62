#!/usr/bin/python3
"""A long spectrum on an elastic edge crack that grows once per passage: what its cycles and its checkpoints take.

    bench/long_spectrum.py build/release/bin/stria [ANOTHER/stria ...] [--cycles 5000] [--passages 1]

The programs take turns. One row each: seconds of a processor, seconds of `timing.total` and `timing.checkpoint` of
summary.json, and the size of checkpoint.h5.
"""

import argparse
import json
import random
import resource
import subprocess
import tempfile
from pathlib import Path

CASE = """
units = "N-mm-MPa"
mesh = { specimen = "sent", width = 50.0, height = 200.0, size = 1.0 }
material = { young = 200e3, poisson = 0.3 }
crack = [ { points = [[0.0, 100.3], [10.0, 100.3]] } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", displacement = ["free", 0.0] } ]
growth = { law = "paris", C = 3e-13, m = 3.0, increment = 0.5, every = %d }
load = { steps = 2, spectrum = "spectrum.csv", repeat = %d }
"""


def write(folder, cycles, passages):
    chance = random.Random(1)
    rows = ["max,min"]
    for _ in range(cycles):
        most = chance.uniform(20.0, 50.0)
        rows.append(f"{most:.3f},{most * chance.uniform(-0.2, 0.6):.3f}")
    (folder / "spectrum.csv").write_text("\n".join(rows + [""]), encoding="utf-8")
    (folder / "case.toml").write_text(CASE % (cycles, passages), encoding="utf-8")


def row_of(program, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", str(folder / "case.toml"), "-o", str(folder / "out"), "--mode", "inprocess", "--quiet",
                    "--no-report", "--force"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    timing = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))["timing"]
    size = (folder / "out" / "checkpoint.h5").stat().st_size
    return [program, f"{after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.1f}", f"{timing['total']:.1f}",
            f"{timing['checkpoint']:.2f}", f"{1e-6 * size:.2f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--cycles", type=int, default=5000)
    parser.add_argument("--passages", type=int, default=1)
    options = parser.parse_args()
    print("| program | processor, s | total, s | checkpoints, s | checkpoint.h5, MB |\n|" + "---|" * 5)
    with tempfile.TemporaryDirectory() as folder:
        write(Path(folder), options.cycles, options.passages)
        for program in options.programs:
            print("| " + " | ".join(row_of(program, Path(folder))) + " |", flush=True)


if __name__ == "__main__":
    main()
