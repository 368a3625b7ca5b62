#!/usr/bin/python3
"""Draws opening loads against crack length: one curve a run.

    tools/plot_closure.py RUN [RUN ...] picture.png

RUN holds cycles.csv; the names of the folders are the names of the curves. Needs python3-matplotlib.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def main():
    *runs, picture = sys.argv[1:]
    figure, axes = pyplot.subplots(figsize=(7.0, 4.0))
    for run in map(Path, runs):
        with open(run / "cycles.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        axes.plot([float(row["a"]) for row in rows], [float(row["K_op"]) / float(row["K_max"]) for row in rows], marker=".", label=run.name)
    axes.set_xlabel("crack length a, mm")
    axes.set_ylabel("$K_{op} / K_{max}$")
    axes.set_ylim(0.0, 1.0)
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
