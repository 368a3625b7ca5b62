#!/usr/bin/python3
"""Draws opening loads against the load ratio, beside formulas and models from the literature.

    tools/plot_closure_trend.py LABEL=RUN,RUN,... [LABEL=...] picture.png

Each RUN holds cycles.csv: its point is the mean of K_op / K_max over its last six cycles; a run without contact there is
drawn at K_min / K_max, hollow. Needs python3-matplotlib.
"""

import math
import sys
from pathlib import Path

from pictures import finish, new_figure, read_table

# Budiansky and Hutchinson, J. Appl. Mech. 45 (1978) 267: strip yielding, small-scale, steady growth; R, K_op / K_max.
BUDIANSKY_HUTCHINSON = [(0.0, 0.5567), (0.0848, 0.5592), (0.239, 0.5774), (0.364, 0.6060), (0.4838, 0.6465), (0.6024, 0.7005), (0.6918, 0.7514)]


def newman(R, alpha, stress):
    """S_op / S_max, Newman, Int. J. Fracture 24 (1984) R131; alpha 1: plane stress, 3: plane strain; stress: S_max / flow stress."""
    A0 = (0.825 - 0.34 * alpha + 0.05 * alpha**2) * math.cos(math.pi * stress / 2.0) ** (1.0 / alpha)
    A1 = (0.415 - 0.071 * alpha) * stress
    if R < 0.0:
        return A0 + A1 * R
    A3 = 2.0 * A0 + A1 - 1.0
    A2 = 1.0 - A0 - A1 - A3
    return max(R, A0 + A1 * R + A2 * R**2 + A3 * R**3)


def elber(R):
    """K_op / K_max from U = 0.5 + 0.4 R, 2024-T3, -0.1 < R < 0.7."""
    return 1.0 - (0.5 + 0.4 * R) * (1.0 - R)


def point(run):
    """Load ratio, K_op / K_max, whether there was contact."""
    rows = read_table(run / "cycles.csv")[-6:]
    mean = {name: sum(float(row[name]) for row in rows) / len(rows) for name in ("K_op", "K_min", "K_max")}
    ratio = mean["K_min"] / mean["K_max"]
    return ratio, mean["K_op"] / mean["K_max"], mean["K_op"] > mean["K_min"] + 1e-6 * mean["K_max"]


def main():
    *curves, picture = sys.argv[1:]
    figure, axes = new_figure(7.0, 4.6)
    grid = [-1.0 + 0.02 * k for k in range(86)]
    for alpha, name in ((1.0, "plane stress"), (3.0, "plane strain")):
        for stress, style in ((0.01, "-"), (0.2, "--")):
            axes.plot(grid, [newman(R, alpha, stress) for R in grid], style, color=f"C{int(alpha)}", lw=1.0, label=f"Newman 1984, {name}, S = {stress:g} flow stress")
    positive = [R for R in grid if -0.1 <= R <= 0.7]
    axes.plot(positive, [elber(R) for R in positive], ":", color="gray", label="Elber, 2024-T3")
    axes.plot(*zip(*BUDIANSKY_HUTCHINSON), "-.", color="black", lw=1.0, label="Budiansky and Hutchinson 1978")
    for number, curve in enumerate(curves):
        label, runs = curve.split("=", 1)
        points = sorted(point(Path(run)) for run in runs.split(","))
        colour = f"C{4 + number}"
        axes.plot([p[0] for p in points], [p[1] for p in points], color=colour, lw=0.8)
        for closes, fill in ((True, colour), (False, "white")):
            chosen = [p for p in points if p[2] == closes]
            axes.plot([p[0] for p in chosen], [p[1] for p in chosen], "o", color=colour, markerfacecolor=fill, label=f"{label}{'' if closes else ', open'}" if chosen else None)
    axes.plot([0.0, 0.8], [0.0, 0.8], color="lightgray", lw=0.8)
    axes.set_xlabel("load ratio R")
    axes.set_xlim(-1.05, 0.8)
    axes.set_ylim(-0.1, 1.0)
    finish(figure, axes, picture, "x-small")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
