#!/usr/bin/python3
"""Draws opening loads against crack length: one curve per run.

    tools/plot_closure.py RUN [RUN ...] picture.png

RUN holds cycles.csv; the names of the folders are the names of the curves. Needs python3-matplotlib.
"""

import sys
from pathlib import Path

from pictures import finish, new_figure, read_table


def main():
    *runs, picture = sys.argv[1:]
    figure, axes = new_figure(7.0, 4.0)
    for run in map(Path, runs):
        rows = read_table(run / "cycles.csv")
        axes.plot([float(row["a"]) for row in rows], [float(row["K_op"]) / float(row["K_max"]) for row in rows], marker=".", label=run.name)
    axes.set_xlabel("crack length a, mm")
    axes.set_ylim(0.0, 1.0)
    finish(figure, axes, picture, "small")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
