#!/usr/bin/python3
"""Draws the loops of a crack with friction: the shear that its faces transmit against their slip, in the middle of it.

    tools/plot_slip_loops.py loops.png runs/inclined-compression-study/*/

One loop for each folder that a run with output.faces = "all" has left. Needs matplotlib (Debian: python3-matplotlib).
"""

import argparse
import tomllib
from pathlib import Path

from pictures import drawing, read_table


def loop_of(folder, crack):
    """Slip, micrometres, and shear, MPa, at the station nearest to the middle of a crack, increment by increment."""
    rows = [row for row in read_table(folder / "faces.csv") if int(row["crack"]) == crack]
    places = sorted(float(row["s"]) for row in rows)
    middle = 0.5 * (places[0] + places[-1])
    nearest = min(rows, key=lambda row: abs(float(row["s"]) - middle))["s"]
    here = [row for row in rows if row["s"] == nearest]
    return [1000.0 * float(row["slip"]) for row in here], [float(row["shear"]) for row in here]


def friction_of(folder, crack):
    with open(folder / "case.resolved.toml", "rb") as file:
        return tomllib.load(file)["crack"][crack]["contact"]["friction"]


def draw(picture, folders, crack):
    plt = drawing()
    plt.rcParams.update({"font.size": 9.5, "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})
    figure, axes = plt.subplots(figsize=(6.4, 4.2), constrained_layout=True)
    for friction, folder in sorted((friction_of(folder, crack), folder) for folder in folders):
        slip, shear = loop_of(folder, crack)
        axes.plot([0.0, *slip], [0.0, *shear], lw=1.6, marker="o", ms=2.5, label=f"friction {friction:g}")
    axes.set(xlabel="slip in the middle of the crack, µm", ylabel="shear that the faces transmit, MPa")
    axes.axhline(0.0, color="0.8", lw=0.6, zorder=0)
    axes.legend()
    figure.savefig(picture, dpi=140)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("picture", type=Path, help="file to write, .png or .svg")
    parser.add_argument("folders", type=Path, nargs="+", help="folders that runs have left")
    parser.add_argument("--crack", type=int, default=0)
    options = parser.parse_args()
    draw(options.picture, options.folders, options.crack)


if __name__ == "__main__":
    main()
