#!/usr/bin/python3
"""Draws the crack faces of a run: amplified at the largest and the smallest load, pressure and opening at the smallest.

    tools/plot_faces.py runs/sent-compression figure4.png

Needs matplotlib (Debian: python3-matplotlib), as every picture does.
"""

import argparse
from pathlib import Path

from pictures import drawing, read_table


def increments_by_load(folder):
    """Increment numbers with face rows, by load factor; of equal load factors the last one counts."""
    written = {int(row["increment"]) for row in read_table(folder / "faces.csv")}
    factors = {int(row["increment"]): float(row["load_factor"]) for row in read_table(folder / "history.csv")}
    return {factors[increment]: increment for increment in sorted(written)}


def faces_at(folder, increment, crack):
    rows = [row for row in read_table(folder / "faces.csv") if int(row["increment"]) == increment and int(row["crack"]) == crack]
    columns = {name: [float(row[name]) for row in rows] for name in ("s", "opening", "pressure")}
    return columns["s"], columns["opening"], columns["pressure"]


def draw_faces(axes, s, opening, amplification, colour, label):
    upper = [amplification * value / 2.0 for value in opening]
    axes.plot(s + s[::-1], upper + [-value for value in upper[::-1]], color=colour, lw=1.6, label=label)


def draw(folder, picture, crack, amplification, zoom):
    plt = drawing()
    plt.rcParams.update({"font.size": 9.5, "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})
    blue, red = "#20639b", "#c1403d"
    by_load = increments_by_load(folder)
    largest, smallest = max(by_load), min(by_load)
    s_max, opening_max, _ = faces_at(folder, by_load[largest], crack)
    s_min, opening_min, pressure = faces_at(folder, by_load[smallest], crack)
    tip = s_min[-1]
    # Behind a machined notch faces are written, and drawn, from its end on.
    mouth = s_min[0] if s_min[0] > 0.1 * tip else 0.0
    zoom = min(zoom, 0.5 * (tip - mouth))

    figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 3.7), constrained_layout=True)
    draw_faces(left, s_max, opening_max, amplification, blue, f"largest load ({largest:g})")
    draw_faces(left, s_min, opening_min, amplification, red, f"smallest load ({smallest:g})")
    top = amplification * max(opening_max) / 2.0
    left.set(xlim=(mouth, tip + 0.28 * (tip - mouth)), ylim=(-2.35 * top, 1.7 * top), xlabel="arc length from the mouth, mm", yticks=[])
    left.set_title(f"crack faces, opening x {amplification:g}", fontsize=10)
    left.spines["left"].set_visible(False)
    left.legend(loc="upper left")
    inset = left.inset_axes([0.34, 0.07, 0.62, 0.27])
    micrometres = [1000.0 * value for value in opening_min]
    draw_faces(inset, s_min, micrometres, 1.0, red, None)
    inset.set(xlim=(tip - zoom, tip + 0.12 * zoom), ylim=(-1.25, 1.25), xlabel="", ylabel="µm")
    inset.tick_params(labelsize=8)
    inset.set_title("tip at the smallest load", fontsize=8.5, color=red, pad=3)
    inset.axhline(0.0, color="0.8", lw=0.6, zorder=0)

    right.plot(s_min, pressure, color=red, lw=1.8)
    right.set(xlim=(mouth, tip), ylim=(-0.03 * max(pressure), 1.15 * max(pressure)), xlabel="arc length from the mouth, mm")
    right.set_ylabel("contact pressure, MPa", color=red)
    right.tick_params(axis="y", colors=red)
    right.set_title(f"smallest load ({smallest:g})", fontsize=10)
    opened = right.twinx()
    opened.plot(s_min, micrometres, color=blue, lw=1.8)
    opened.set(ylim=(-0.03 * 1.6 / 1.15 * max(micrometres), 1.6 * max(micrometres)))
    opened.set_ylabel("opening, µm", color=blue)
    opened.tick_params(axis="y", colors=blue)
    opened.spines["right"].set_visible(True)
    edge = max((s for s, p in zip(s_min, pressure) if p > 0.0), default=None)
    if edge is not None:
        right.axvline(edge, color="0.6", lw=0.9, ls=(0, (4, 3)))
        right.text(edge - 0.0125 * (tip - mouth), 0.05 * max(pressure), f"closed up to {edge:.2f} mm", ha="right", color="0.35")
    figure.savefig(picture, dpi=140)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="folder that a run has left")
    parser.add_argument("picture", type=Path, help="file to write, .png or .svg")
    parser.add_argument("--crack", type=int, default=0)
    parser.add_argument("--amplification", type=float, default=60.0)
    parser.add_argument("--zoom", type=float, default=2.0, help="length behind the tip in the inset, mm")
    options = parser.parse_args()
    draw(options.folder, options.picture, options.crack, options.amplification, options.zoom)


if __name__ == "__main__":
    main()
