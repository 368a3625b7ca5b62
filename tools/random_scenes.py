#!/usr/bin/python3
"""Runs random legal scenes in all modes and compares what they leave.

    tools/random_scenes.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2]

A scene is a coarse specimen with a random crack, material, friction, load, growth and refinement. Half of them have besides
a controlled displacement, a dead load, an initial stress or increments that the program chooses, and a quarter look for
tension ahead of their tips (random_loads.py). It runs in one process, in one matrix and over MPI. Numbers of `history.csv`
agree where they differ by less than 1e-8 of the largest of their column (TOLD_FROM has those of closed cracks), or the three
runs end alike with exit code 3 and a sentence. All three warn alike, and of nothing but what the scene explains. What the
first one leaves is lawful, too: pressures push and shear stays in the cone of friction; faces of cracks that do not grow
overlap by no more than the pressure strains an element; nothing gives dissipation back; a controlled displacement goes
straight from where dead loads and an initial stress have moved the boundary to its first extreme; and work balances. Exit
code 1 where a scene does neither.

How far work may be off follows from how it is counted (docs/equations.md). Where all is linear nothing but rounding is
left. Between two steps of growth the work of the loads is a trapezoid per increment, of second order, and of first
order at least where points begin to flow or faces to touch within it. So where these errors add up to more than 1 % of
the work, four times as many increments must leave less than a third of them (first order leaves a quarter). At a step
of growth a parabola stands for the way on which the new faces open. Its beginning and its end are known, and all convex
ways between these release between half of the first step's and half of the last opening's work. So its error is at most
what it says is released. Friction takes the shear at the end of the step for that of all of its sliding, and may be off by
what it says is rubbed off.
"""

import csv
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter
from pathlib import Path

import random_loads
import random_trials

ROOT = Path(__file__).resolve().parent.parent
MODES = ["inprocess", "monolithic", "mpi"]
SAME = 1e-8
COLUMNS = [["load_factor"], ["load"], ["displacement"], ["a"], ["K_I", "K_II"], ["J"], ["CMOD"],
           ["external_work", "stored_energy", "dissipation", "released_energy"]]  # of one scale each
# Of a crack that stays closed K, J and CMOD are rounding. They are told from these parts on: of what they would be if all
# work went into the crack, in a body 10 mm wide, and of the displacement.
TOLD_FROM = {"K_I": lambda work, moved: 1e-4 * (200e3 * work / 10.0) ** 0.5, "J": lambda work, moved: 1e-6 * work / 10.0,
             "CMOD": lambda work, moved: 1e-6 * moved}
# What a run may warn of, and what the scene then has.
EXPLAINED = {r"the largest ring": r"width = 10\.0(.|\n)*\nsize = (0\.[789]|1)|on = \"point\"",  # of a plate that a crack half parts, or beside a point
             r"another crack is": r"\[\[crack\]\](.|\n)*\[\[crack\]\]",
             r"its crack bends": r"points = \[(\[[^]]*\](, )?){3}|\[growth\]",
             r"forward plastic zone|closure is (still )?looked at": r"yield_stress(.|\n)*(contact|\[growth\])|\[growth\](.|\n)*yield_stress|contact(.|\n)*yield_stress",
             r"growth.increment = .* (at a time|of its forward plastic zone)": r"yield_stress(.|\n)*\[growth\]",
             r"nothing yields there": r"contact(.|\n)*\[growth\]",
             r"turns sharply|runs along an element edge": r"\[growth\]",
             r"K_op / K_max goes to and fro": r"contact(.|\n)*\[growth\]|\[growth\](.|\n)*contact",
             r"growth ends here, and not the life": r"\[growth\]",
             r"times as large as fine.refine": r"\nrefine = (.|\n)*\[growth\]",
             r"work balance is open": r"\nsteps = ",  # so few, given or chosen, that trapezoids are off
             r"faces of crack \d+ overlap": r"\[\[crack\]\]\npoints = .*\n(?!contact)",
             r"between it and the notch|starts where its notch ends": r"notch = (.|\n)*contact|contact(.|\n)*notch = ",
             r"softens by more than it hardens": r"Q = -",
             r"metal that flows is taken from one reversal": r"yield_stress(.|\n)*\nsteps = [2-7]\n|\nsteps = [2-7]\n(.|\n)*yield_stress",
             r"ring in its own metal|its outline runs through": r"\[\[region\]\]"}


def crack_of(specimen, rng):
    if specimen == "ct":
        return "[[-2.5, 0.0], [%.6g, %.6g]]" % (rng.uniform(4.0, 6.0), rng.uniform(-0.3, 0.3))
    if specimen == "mt":
        half = rng.uniform(1.5, 3.0)
        return "[[%.6g, 15.1], [%.6g, 15.1]]" % (5.0 - half, 5.0 + half)
    mouth, length = rng.uniform(8.0, 12.0), rng.uniform(2.0, 5.0)
    points = [(0.0, mouth), (length, mouth + rng.uniform(-0.4, 0.4) * length)]
    if rng.random() < 0.3:
        points.append((length + 1.5, points[1][1] + rng.uniform(-0.5, 0.5)))
    return "[" + ", ".join("[%.6g, %.6g]" % point for point in points) + "]"


def hardening_of(rng):
    lines = []
    law = rng.choice(["linear", "linear", "voce", "power", "table"])
    lines.append({"linear": 'isotropic = {{ law = "linear", modulus = {:.4g} }}'.format(rng.choice([0.0, 1000.0, 5000.0])),
                  "voce": 'isotropic = {{ law = "voce", Q = {:.4g}, b = {:.4g} }}'.format(rng.uniform(-80, 150), rng.uniform(2, 50)),
                  "power": 'isotropic = {{ law = "power", n = {:.4g}, alpha = {:.4g} }}'.format(rng.uniform(3, 12), rng.uniform(0.1, 1)),
                  "table": "isotropic = { law = \"table\", plastic_strain = [0.0, 0.01, 0.1], stress = [YIELD, HIGHER, HIGHEST] }"}[law])
    terms = [(rng.uniform(1e3, 4e4), rng.choice([0.0, rng.uniform(10.0, 400.0)])) for _ in range(rng.randrange(3))]
    if terms:
        lines.append("kinematic = [" + ", ".join("{ C = %.5g, gamma = %.4g }" % term for term in terms) + "]")
    return "\n".join(lines)


def region_of(rng):
    """Another metal beside the crack or ahead of it, with an upright or an inclined edge."""
    text, at = "", rng.uniform(3.0, 8.0)
    edge = rng.choice(["[%.6g, -1.0], [20.0, -1.0], [20.0, 31.0], [%.6g, 31.0]" % (at, at),
                       "[%.6g, -1.0], [20.0, -1.0], [20.0, 31.0], [%.6g, 31.0]" % (at + 2.0, at - 2.0),
                       "[-1.0, %.6g], [11.0, %.6g], [11.0, 31.0], [-1.0, 31.0]" % (8.0 + at, 8.0 + at)])
    text += "[[region]]\noutline = [%s]\n" % edge
    if rng.random() < 0.3:
        text += "initial_stress = { xx = %.4g, yy = %.4g }\n" % (rng.uniform(-30.0, 30.0), rng.uniform(-30.0, 30.0))
    material = "young = %g, poisson = %g" % (rng.choice([70e3, 200e3, 400e3]), rng.choice([0.0, 0.3]))
    if rng.random() < 0.7:
        material += ", yield_stress = %.6g, isotropic = { modulus = 2000.0 }" % rng.uniform(150.0, 400.0)
    return text + "material = { %s }\n" % material


def other_loads(rng):
    """Of a plate, in place of tractions on its ends: edges that are held or moved, bending, pressures, and points."""
    boundary = lambda on, **keys: '[[boundary]]\non = "%s"\n' % on + "".join("%s = %s\n" % item for item in keys.items())
    per_stress = 20.0 / 200e3  # mm of the whole height
    x, up, down = rng.uniform(1.0, 9.0), rng.uniform(14.0, 19.0), rng.uniform(1.0, 6.0)
    points = lambda key, size: "".join(boundary("point", at="[%.6g, %.6g]" % (x, y), **{key: "[0.0, %.6g]" % (sign * size)})
                                       for y, sign in ((up, 1.0), (down, -1.0)))
    gradient = lambda sign: "[[0.0, 0.0], [%.6g, 0.0]]" % (-0.1 * sign)
    return rng.choice([
        boundary("top", traction="[0.1, 1.0]") + boundary("bottom", displacement="[0.0, 0.0]"),
        boundary("top", displacement='["free", %.6g]' % per_stress) + boundary("bottom", displacement="[0.0, 0.0]"),
        boundary("top", displacement="[0.0, %.6g]" % per_stress) + boundary("bottom", displacement="[0.0, 0.0]"),
        "".join(boundary(on, traction="[0.0, %g]" % sign, traction_gradient=gradient(sign)) for on, sign in (("top", 1.0), ("bottom", -1.0))),
        boundary("top", pressure=-1.0) + boundary("bottom", pressure=-1.0) + boundary("right", pressure=0.3) + boundary("left", pressure=0.3),
        points("force", 6.0), points("displacement", per_stress)])


def scene(rng):
    specimen = rng.choice(["plate", "plate", "sent", "mt", "ct"])
    plane, plastic = rng.choice(["strain", "stress"]), rng.random() < 0.75
    contact, growing = rng.random() < 0.7, rng.random() < 0.5
    friction = rng.choice([0.0, 0.0, rng.uniform(0.1, 0.9)])
    text = 'title = "random"\nunits = "N-mm-MPa"\n[model]\nplane = "%s"\n[mesh]\nspecimen = "%s"\nwidth = 10.0\n' % (plane, specimen)
    text += "" if specimen == "ct" else "height = %g\n" % (30.0 if specimen == "mt" else 20.0)
    text += "size = %.4g\n" % (10.0 / rng.randint(9, 13))
    text += "[material]\nyoung = 200e3\npoisson = %.3g\n" % rng.choice([0.0, 0.3, 0.4])
    if plastic:
        stress = rng.uniform(150.0, 400.0)
        text += "yield_stress = %.8g\n" % stress + hardening_of(rng).replace("YIELD", "%.8g" % stress).replace(
            "HIGHER", "%.8g" % (1.1 * stress)).replace("HIGHEST", "%.8g" % (1.3 * stress)) + "\n"
    text += "[[crack]]\npoints = %s\n" % crack_of(specimen, rng)
    if contact:
        text += "contact = { friction = %.3g }\n" % friction
    before_loads = len(text)
    if specimen == "ct":
        for pin, sign in (("pin-top", 1), ("pin-bottom", -1)):
            text += '[[boundary]]\non = "%s"\nforce = [0.0, %d.0]\n' % (pin, sign)
        unit = rng.uniform(60.0, 200.0)
    else:
        shear = rng.choice([0.0, rng.uniform(-0.3, 0.3)]) if specimen == "plate" else 0.0
        for edge, sign in (("top", 1.0), ("bottom", -1.0)):
            text += '[[boundary]]\non = "%s"\ntraction = [%.6g, %.6g]\n' % (edge, sign * shear, sign)
        if shear != 0.0:
            for edge, sign in (("right", 1.0), ("left", -1.0)):
                text += '[[boundary]]\non = "%s"\ntraction = [0.0, %.6g]\n' % (edge, sign * shear)
        unit = rng.uniform(20.0, 90.0)
    behind_loads = len(text)
    text += "[load]\nsteps = %d\nblocks = [ { cycles = 2, max = %.6g, ratio = %.3g } ]\n" % (
        2 * rng.randint(2, 5), unit, rng.choice([-1.0, 0.0, 0.3, rng.uniform(-0.8, 0.5)]))
    text += "[fine]\n" + ("radius = %.4g\n" % rng.uniform(1.2, 2.0) if plastic else "")
    if plastic and rng.random() < 0.4:
        text += "refine = %d\n" % rng.choice([2, 4])
    if plastic and rng.random() < 0.2:
        text += "substeps = 3\n"
    if growing:
        text += "[growth]\nincrement = %.3g\n" % rng.uniform(0.2, 0.6)
    text += region_of(rng) if specimen != "ct" and rng.random() < 0.25 else ""
    if specimen == "plate" and rng.random() < 0.5:
        text = text[:before_loads] + other_loads(rng) + text[behind_loads:]
    return text + '[solver]\ntolerance = 1e-12\n[output]\nfields = "none"\ncheckpoint_every = 0\n'


ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OPENBLAS_NUM_THREADS="1")


def run(programs, case, folder, mode):
    """Its exit code, the last line of what it has against the case, and its warnings."""
    command = [str(programs / "stria"), "run", str(case), "-o", str(folder), "--mode", mode]
    result = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT, timeout=600)
    warnings = re.findall(r"^warning: (.*)$", result.stdout, re.M)
    return result.returncode, (result.stderr.strip().splitlines() or [""])[-1], warnings


def numbers(folder):
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name] or "nan") for row in rows] for names in COLUMNS for name in names}


def largest(columns, name):
    return max((abs(x) for x in columns[name] if x == x), default=0.0)


def difference(one, other):
    worst, where = 0.0, ""
    for names in COLUMNS:
        scale = max(largest(one, name) for name in names)
        if names[0] in TOLD_FROM:
            scale = max(scale, TOLD_FROM[names[0]](largest(one, "external_work"), largest(one, "displacement")))
        for name in names:
            if len(one[name]) != len(other[name]):
                return 1.0, "rows"
            for a, b in zip(one[name], other[name]):
                if (a != a) != (b != b):
                    return 1.0, name
                if a == a and scale > 0.0 and abs(a - b) / scale > worst:
                    worst, where = abs(a - b) / scale, name
    return worst, where


def increments_of(folder):
    """The rows of history.csv that belong to the first tip."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    return [row for k, row in enumerate(rows) if k == 0 or row["increment"] != rows[k - 1]["increment"]]


def out_of_balance(rows):
    """Errors of the work, of its largest size: those between steps of growth, added up, and by which the error at a step
    of growth, or at a part of one, exceeds what this releases and rubs off. Where nobody knows what is released there is neither."""
    size = max(abs(float(row["external_work"])) for row in rows)
    steady, beyond = 0.0, 0.0
    for before, now in zip([None] + rows, rows):
        of = lambda name: float(now[name] or "nan") - (float(before[name] or "nan") if before else 0.0)
        error, released = abs(of("balance_error")) / size, (of("released_energy") + of("frictional_dissipation")) / size
        if before is None or all(now[name] == before[name] for name in ("a", "released_energy")):
            steady += error if error == error else 0.0
        elif error == error:
            beyond = max(beyond, error - released)
    return steady, beyond


def splits_of(folder):
    return json.loads((folder / "summary.json").read_text())["mesh_splits"]


def with_more_increments(text, times, rows):
    """`rows`: of its run. Increments that the program has chosen are as many as in the cycle that has most."""
    chosen = max(Counter(row["cycle"] for row in rows).values())
    text = text.replace('\nsteps = "auto"', "\nsteps = %d" % (chosen + chosen % 2))
    return re.sub(r"steps = (\d+)", lambda found: "steps = %d" % (times * int(found[1])), text)


def broken_balance(programs, folder, text):
    """What is wrong with the work of the run in `folder`, or None."""
    steady, beyond = out_of_balance(increments_of(folder))
    linear = not any(word in text for word in ("yield_stress", "[growth]", "contact"))
    if linear and steady > 1e-9:
        return "linear work is off by %.1e" % steady
    if beyond > 1e-9:
        return "a step of growth is off by %.1e of the work beyond what it releases" % beyond
    if steady <= 0.01 or (steady <= 0.05 and splits_of(folder)):  # what is split gives up energy (docs/equations.md)
        return None
    finer = folder.parent / "finer.toml"
    finer.write_text(with_more_increments(text, 4, increments_of(folder)))
    code, said, _ = run(programs, finer, folder.parent / "finer", "inprocess")
    if code != 0:
        return "work is off by %.1e, and with more increments: %s" % (steady, said)
    left = out_of_balance(increments_of(folder.parent / "finer"))[0]
    return "work is off by %.1e, with four times the increments by %.1e" % (steady, left) if left > steady / 3.0 else None


def unlawful(folder, text, size=None):
    """What a run breaks but for its balance of work, or None. `size`: of its elements, if the case does not say it."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    work = max(abs(float(row["external_work"])) for row in rows)
    for name in ("dissipation", "frictional_dissipation"):
        values = [float(row[name]) for row in rows if row[name]]
        if any(after < before - 1e-10 * work for before, after in zip(values, values[1:])):
            return f"{name} falls"
    with open(folder / "faces.csv") as file:
        faces = list(csv.DictReader(file))
    friction = float((re.search(r"friction = ([\d.]+)", text) or [0, 0.0])[1])
    most = max((float(face["pressure"]) for face in faces), default=0.0)
    # Faces meet in the mean about each multiplier. Between the tips of a crack across three elements are two of them: scene
    # 61021 overlaps by 4.1 % of the largest opening there, by 0.3 % across four elements and not across eight.
    size = size or float(re.search(r"\nsize = ([\d.]+)", text)[1])
    overlap = size * most / 200e3 + (0.05 if has_two_tips_within(3.2 * size, text) else 0.01) * max((float(face["opening"]) for face in faces), default=0.0)
    for face in faces:
        pressure, shear = float(face["pressure"]), abs(float(face["shear"] or 0.0))
        if pressure < -1e-9 * most or (face["status"] == "0" and pressure > 1e-9 * most):
            return "a pressure that pulls, or without contact"
        if shear > friction * pressure + 1e-8 * most:
            return "shear outside the cone"
        if "contact" in text and "[growth]" not in text and -float(face["opening"]) > overlap:
            return "faces overlap"
    return None


def has_two_tips_within(length, text):
    points = tomllib.loads(text)["crack"][0]["points"]
    return 'specimen = "mt"' in text and math.dist(points[0], points[-1]) < length


def unexplained(warnings, text):
    """The first warning for which the scene has no reason, or None."""
    known = lambda warning: any(re.search(kind, warning) and re.search(reason, text) for kind, reason in EXPLAINED.items())
    return next((warning for warning in warnings if not known(warning)), None)


def judge(arguments, seed):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        case = folder / "case.toml"
        text = random_loads.with_closure(random_loads.with_more(scene(rng), seed), seed)
        case.write_text(text)
        ends = {mode: run(arguments.programs, case, folder / mode, mode) for mode in MODES}
        codes = {code for code, _, _ in ends.values()}
        warnings = ends[MODES[0]][2]
        if codes == {0}:
            one = numbers(folder / MODES[0])
            worst, where = max(difference(one, numbers(folder / mode)) for mode in MODES[1:])
            verdict = "agrees" if worst < SAME else "DIFFERS", "%.1e of %s" % (worst, where)
            if worst < SAME:
                first = folder / MODES[0]
                broken = unlawful(first, text) or random_loads.strays_at_first(first, text) or broken_balance(arguments.programs, first, text)
                verdict = ("IS UNLAWFUL", broken) if broken else verdict
        elif codes in ({2}, {3}):  # 2: no legal case, and a sentence says so
            verdict = "ends with %d" % codes.pop(), ends[MODES[0]][1]
        else:
            verdict = "ENDS DIFFERENTLY", str(ends)
        if any(said != warnings for _, _, said in ends.values()):
            verdict = "WARNS OTHERWISE", str([said for _, _, said in ends.values()])
        elif (strange := unexplained(warnings, text)) is not None:
            verdict = "WARNS WITHOUT A REASON", strange
        if verdict[0].isupper() and arguments.keep:
            shutil.copytree(folder, arguments.keep / str(seed), dirs_exist_ok=True)
        return seed, *verdict


def main():
    arguments = random_trials.arguments_of(__doc__, ROOT / "build/release/bin", "scenes that do not agree")
    counts, wrong = {}, 0
    for seed, verdict, detail in random_trials.verdicts(judge, arguments):
        counts[verdict] = counts.get(verdict, 0) + 1
        if not verdict.startswith("agrees"):
            print(f"{seed}: {verdict}: {detail}", flush=True)
        wrong += verdict.isupper()
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
