#!/usr/bin/python3
"""Draws the pressure on a closed crack by both kinds of multipliers (crack.contact.multipliers) beside the exact one.

    tools/plot_multipliers.py build/release/bin/stria docs/pictures/multipliers.png

A crack of 20 mm lies askew in a plate of 40 x 40 mm under a state of stress that is linear along it and has no shear on
it: the plate is as if it were whole. Prints the error of the pressure in the mean square. One multiplier at each Gauss
point meets no tighter tolerance than the second one. Needs matplotlib (Debian: python3-matplotlib), which nothing else
in the project does.
"""

import argparse
import math
import subprocess
import tempfile
from pathlib import Path

from pictures import new_figure, read_table

CENTRE, ANGLE, HALF = (20.2, 19.1), math.radians(22.0), 10.0
ALONG, ACROSS = (math.cos(ANGLE), math.sin(ANGLE)), (-math.sin(ANGLE), math.cos(ANGLE))
MEAN, SLOPE = 10.0, 0.6  # of the pressure, MPa, and MPa/mm along the crack from its middle
SIDES = {"top": (0.0, 1.0), "bottom": (0.0, -1.0), "left": (-1.0, 0.0), "right": (1.0, 0.0)}
CURVES = [  # multipliers, solver.tolerance, colour
    ("gauss", 1e-5, "#e8a09e"),
    ("gauss", 1e-4, "#c1403d"),
    ("stable", 1e-8, "#20639b"),
]


def boundary(side, outward):
    """Traction -p (n . m) n on a side whose outward normal is m, n across the crack."""
    share = ACROSS[0] * outward[0] + ACROSS[1] * outward[1]
    traction = [-MEAN * share * n for n in ACROSS]
    gradient = [[-SLOPE * share * n * t for t in ALONG] for n in ACROSS]
    return f'[[boundary]]\non = "{side}"\ntraction = {traction}\ntraction_gradient = {gradient}\norigin = {list(CENTRE)}\n'


def case(kind, tolerance, size):
    ends = [[c + sign * HALF * a for c, a in zip(CENTRE, ALONG)] for sign in (-1.0, 1.0)]
    return "\n".join([
        f'units = "N-mm-MPa"\n\n[mesh]\nspecimen = "plate"\nwidth = 40.0\nheight = 40.0\nsize = {size}\n',
        "[material]\nyoung = 200e3\npoisson = 0.3\n",
        f'[[crack]]\npoints = {ends}\ncontact = {{ multipliers = "{kind}" }}\n',
        *[boundary(side, outward) for side, outward in SIDES.items()],
        '[load]\nsteps = 2\nblocks = [ { cycles = 1, max = 1.0, min = 0.5 } ]\n',
        f"[solver]\ntolerance = {tolerance}\nmax_iterations = 60\n",
        '[output]\nfaces = "all"\nfields = "none"\n',
    ])


def pressures(program, kind, tolerance, size):
    """Distances from the middle of the crack, mm, and pressures, MPa, at the last increment of a run."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        file.write_text(case(kind, tolerance, size), encoding="utf-8")
        subprocess.run([program, "run", file, "-o", Path(folder) / "out", "--mode", "inprocess", "--quiet"], check=True)
        rows = read_table(Path(folder) / "out" / "faces.csv")
    last = [row for row in rows if row["increment"] == rows[-1]["increment"]]
    return [float(row["s"]) - HALF for row in last], [float(row["pressure"]) for row in last]


def error(place, pressure):
    """Relative, in the mean square over the stations."""
    exact = [MEAN + SLOPE * s for s in place]
    return math.sqrt(sum((p - e) ** 2 for p, e in zip(pressure, exact)) / sum(e**2 for e in exact))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="build/release/bin/stria")
    parser.add_argument("picture", type=Path, help="file to write, .png or .svg")
    parser.add_argument("--size", type=float, default=1.0, help="of an element, mm")
    options = parser.parse_args()
    figure, axes = new_figure(7.6, 3.9)
    for kind, tolerance, colour in CURVES:
        place, pressure = pressures(options.program, kind, tolerance, options.size)
        name = f"{kind}, residual {tolerance:g}: {100.0 * error(place, pressure):.2g} % off"
        print(f"{name}, {len(place)} stations")
        axes.plot(place, pressure, color=colour, lw=0.9, marker="o", ms=2.2, label=name)
    ends = (-HALF, HALF)
    axes.plot(ends, [MEAN + SLOPE * s for s in ends], color="black", lw=1.0, ls="--", label="exact")
    axes.set(xlabel="distance from the middle of the crack, mm", ylabel="contact pressure, MPa")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=9)
    figure.tight_layout()
    figure.savefig(options.picture, dpi=110)


if __name__ == "__main__":
    main()
