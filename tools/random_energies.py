#!/usr/bin/python3
"""Holds K and J of random elastic bodies against each other, and against the energy that growing cracks release.

    tools/random_energies.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2]

A plate of one or two metals has one to three cracks: edge and inner ones, inclined or bent, with faces that are free or may
touch without friction. It bears tractions, bending, pressures, forces, moved and held edges or a pressure that travels, half
of them beside a dead load or an initial stress, and all tips grow three times straight on. In each increment J = (K_I^2 +
K_II^2) / E', and a step releases the integral of that over all tips, K being linear between its two ends. What is off by
more than 2 % of the largest J, or 5 % of what a step releases, must be so no longer, or by less than seven tenths of it, on
elements a quarter and by increments half as large. Small steps near K = 0 count by a fifth of the largest. No friction: its
shear is taken at the end of a step. Not crossed by a tip: the border of a metal. Exit code 1 where a body does not hold.
"""

import csv
import random
import shutil
import sys
import tempfile
from pathlib import Path

import random_scenes
import random_trials

ROOT = Path(__file__).resolve().parent.parent
WIDTH, YOUNG = 10.0, 200e3
OFF = {"J": 0.02, "released energy": 0.05}


def boundary(on, case="", **keys):
    of_case = f'case = "{case}"\n' if case else ""
    return f'[[boundary]]\non = "{on}"\n' + "".join(f"{key} = {value}\n" for key, value in keys.items()) + of_case


def ends(traction, gradient=0.0, **more):
    return "".join(boundary(on, traction=[sign * x for x in traction], traction_gradient=[[0.0, 0.0], [-sign * gradient, 0.0]], **more)
                   for on, sign in (("top", 1.0), ("bottom", -1.0)))


def loads(rng, height):
    held, x = boundary("bottom", displacement="[0.0, 0.0]"), rng.uniform(1.0, 9.0)
    wheel = '{ profile = "hertz", p0 = 100.0, half_width = 1.0, friction = 0.2, from = %g, to = %g }' % (0.3 * height, 0.6 * height)
    return rng.choice([
        ends([0.0, 1.0]), ends([0.0, 1.0], 0.1), boundary("top", traction="[0.2, 1.0]") + held,
        ends([0.3, 1.0]) + boundary("right", traction="[0.0, 0.3]") + boundary("left", traction="[0.0, -0.3]"),
        boundary("top", displacement='["free", 1e-4]') + held, boundary("top", displacement="[5e-5, 1e-4]") + held,
        boundary("top", displacement='["free", 1e-4]') + held + boundary("right", pressure=0.3),
        "".join(boundary(on, pressure=p) for on, p in (("top", -1), ("bottom", -1), ("left", 0.5), ("right", 0.5))),
        boundary("point", at=[x, height - 0.7], force="[0.0, 8.0]") + boundary("point", at=[x, 0.7], force="[0.0, -8.0]"),
        held + boundary("top", traction="[0.0, 1.0]") + boundary("right", travelling=wheel)])


def crack(rng, y, most):
    length, slope = rng.uniform(2.0, most), rng.uniform(-0.4, 0.4)
    kind = rng.choice(["left", "right", "inner", "bent"])
    start = {"right": WIDTH, "inner": rng.uniform(2.0, 8.0 - length)}.get(kind, 0.0)
    points = [[start, y], [start + (-length if kind == "right" else length), y + slope * length]]
    return points + [[length + 1.0, points[1][1] + rng.uniform(-0.7, 0.7)]] if kind == "bent" else points


class Body:
    """`finer`: by how much elements are smaller. Increments are by half as much, for what the place of a tip in its element
    moves of a step is less the more elements the step crosses."""

    def __init__(self, seed, finer=1):
        parts = max(1, finer // 2)
        rng = random.Random(seed)
        height, count, element = rng.choice([10.0, 20.0]), rng.choice([1, 1, 2, 2, 3]), WIDTH / rng.randint(24, 44)
        self.poisson, self.is_strain = rng.choice([0.0, 0.3, 0.45]), rng.random() < 0.5
        self.border, self.other = height * 0.08, rng.choice([70e3, 400e3])
        text = f'units = "N-mm-MPa"\n[model]\nplane = "{"strain" if self.is_strain else "stress"}"\n[mesh]\nspecimen = "plate"\n'
        text += f"width = {WIDTH}\nheight = {height}\nsize = {element / finer:.6g}\n"
        text += f"[material]\nyoung = {YOUNG}\npoisson = {self.poisson}\n"
        contact = rng.choice(["", "contact = {}\n"])
        for k in range(count):
            points = crack(rng, height * (k + 1) / (count + 1) + rng.uniform(-0.3, 0.3), 5.0 if count == 1 else 4.0)
            text += f"[[crack]]\npoints = {points}\n{contact}"
        text += loads(rng, height)
        besides = rng.choice(["", "dead", "initial", "metal"])
        size = rng.uniform(30.0, 90.0) * (-1.0 if contact and rng.random() < 0.3 else 1.0)
        if besides == "dead":
            text += boundary("left", "dead", pressure=1.0) + '[[load_case]]\nname = "dead"\nconstant = %.5g\n' % (rng.uniform(-0.8, 0.8) * size)
        text += f"[load]\nsteps = 4\nblocks = [{{ cycles = {3 * parts}, max = {max(size, 0.5 * size)}, min = {min(size, 0.5 * size)} }}]\n"
        if besides == "initial":
            text += f"[initial_stress]\nsigma_y = {{ at = [0.0, 5.0, 10.0], stress = [{size}, {-size}, {size}] }}\n"
        self.has_border = besides == "metal"
        if self.has_border:
            text += f"[[region]]\noutline = [[-1.0, -1.0], [11.0, {self.border}]]\nmaterial = {{ young = {self.other}, poisson = {self.poisson} }}\n"
        text += f'[growth]\nincrement = {element * rng.choice([0.5, 1.0, 1.3]) / parts:.6g}\ndirection = "straight"\n'
        self.text = text + '[solver]\ntolerance = 1e-11\n[output]\nfields = "none"\nfaces = "none"\ncheckpoint_every = 0\n'

    def modulus(self, row):
        young = self.other if self.has_border and row["y"] < self.border else YOUNG
        return young / (1.0 - self.poisson**2) if self.is_strain else young


def by_increment(folder):
    with open(folder / "history.csv", encoding="utf-8") as file:
        rows = [{name: float(cell or "nan") for name, cell in row.items()} for row in csv.DictReader(file)]
    increments = {}
    for row in rows:
        increments.setdefault(row["increment"], []).append(row)
    return [increments[k] for k in sorted(increments)]


def worst(body, increments):
    """Of J and of the released energy, how far the worst is off."""
    G = lambda row: (row["K_I"] ** 2 + row["K_II"] ** 2) / body.modulus(row)
    most, off = max(G(row) for rows in increments for row in rows), {"J": 0.0, "released energy": 0.0}
    for rows in increments:
        off["J"] = max([off["J"]] + [abs(row["J"] - G(row)) / most for row in rows if row["J"] == row["J"]])
    for before, now in zip(increments, increments[1:]):
        ways = [((b["x"] - a["x"]) ** 2 + (b["y"] - a["y"]) ** 2) ** 0.5 for a, b in zip(before, now)]
        if sum(ways) == 0.0 or any(body.modulus(a) != body.modulus(b) for a, b in zip(before, now)):
            continue
        mean = lambda a, b: sum(a[K] ** 2 + a[K] * b[K] + b[K] ** 2 for K in ("K_I", "K_II")) / 3.0 / body.modulus(a)
        expected = sum(way * mean(a, b) for way, a, b in zip(ways, before, now))
        released = now[0]["released_energy"] - before[0]["released_energy"]
        off["released energy"] = max(off["released energy"], abs(released - expected) / max(expected, 0.2 * most * sum(ways)))
    return off


def judge(arguments, seed):
    offs = []
    with tempfile.TemporaryDirectory() as scratch:
        for finer in (1, 4):
            body, case, folder = Body(seed, finer), Path(scratch) / f"{finer}.toml", Path(scratch) / str(finer)
            case.write_text(body.text, encoding="utf-8")
            code, said, warnings = random_scenes.run(arguments.programs, case, folder, "inprocess")
            if code != 0 or any("largest ring" in warning or "bends" in warning for warning in warnings):
                return seed, [] if code in (0, 2, 3) else [said], said or "no room about a tip"
            offs.append(worst(body, by_increment(folder)))
            if all(offs[-1][name] <= OFF[name] for name in OFF):
                return seed, [], "good"
        wrong = [f"{name} is off by {offs[0][name]:.1%}, finer by {offs[1][name]:.1%}"
                 for name in OFF if offs[1][name] > max(OFF[name], 0.7 * offs[0][name])]
        if wrong and arguments.keep:
            shutil.copytree(scratch, arguments.keep / str(seed), dirs_exist_ok=True)
        return seed, wrong, "good"


def main():
    return random_trials.run(judge, random_trials.arguments_of(__doc__, ROOT / "build/release/bin", "bodies that do not hold"))


if __name__ == "__main__":
    sys.exit(main())
