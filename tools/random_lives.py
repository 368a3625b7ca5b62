#!/usr/bin/python3
"""Runs random growing cracks, undisturbed and otherwise, and compares what they leave.

    tools/random_lives.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2]

A life is a coarse specimen that flows, with one crack or two, in one metal or two, and random material, friction, load,
growth, refinement and opening loads; five to seven cycles. It runs undisturbed; stopped again and again after a random
time, and resumed in one process or over MPI; a cycle or two shorter, and made longer; and on two or three fine ranks.
What cycles.csv says is made anew from history.csv (cross_check.py), where that has all increments.
Resumed and made longer the tables are the same to the last digit. On several ranks numbers of `history.csv` agree within
1e-8 of the largest of their column. Runs that end with 2 or 3 do so alike. Exit code 1 where a life does neither.
"""

import csv
import json
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cross_check  # noqa: E402
import random_scenes as scenes  # noqa: E402
import random_trials  # noqa: E402

INTERRUPTED = 130
TABLES = ["history.csv", "cycles.csv", "faces.csv", "closure.csv"]


def material_of(rng):
    stress = rng.uniform(150.0, 400.0)
    hardening = scenes.hardening_of(rng)
    for name, factor in (("YIELD", 1.0), ("HIGHER", 1.1), ("HIGHEST", 1.3)):
        hardening = hardening.replace(name, "%.8g" % (factor * stress))
    return "[material]\nyoung = 200e3\npoisson = %.3g\nyield_stress = %.8g\n%s\n" % (rng.choice([0.0, 0.3, 0.4]), stress, hardening)


def cracks_of(specimen, contact, rng):
    all_points = [scenes.crack_of(specimen, rng)]
    if specimen == "plate" and rng.random() < 0.4:  # another one from the other side
        mouth = rng.choice([rng.uniform(3.0, 5.5), rng.uniform(14.5, 17.0)])
        all_points.append("[[10.0, %.6g], [%.6g, %.6g]]" % (mouth, rng.uniform(6.5, 8.0), mouth + rng.uniform(-0.5, 0.5)))
    return "".join("[[crack]]\npoints = %s\n%s" % (points, contact) for points in all_points)


def loads_of(specimen, rng):
    """Boundaries, and what a unit of the load is."""
    if specimen == "ct":
        pins = (("pin-top", 1), ("pin-bottom", -1))
        return "".join('[[boundary]]\non = "%s"\nforce = [0.0, %d.0]\n' % pin for pin in pins), rng.uniform(60.0, 200.0)
    ends = (("top", 1), ("bottom", -1))
    return "".join('[[boundary]]\non = "%s"\ntraction = [0.0, %d.0]\n' % end for end in ends), rng.uniform(20.0, 90.0)


def growth_of(refine, rng):
    text = "[growth]\nincrement = %.3g\nevery = %d\n" % (rng.uniform(0.2, 1.3) * 0.8 / refine, rng.choice([1, 1, 2]))
    if rng.random() < 0.3:
        text += rng.choice(['driving = "dK"\n', "walker = 0.6\n", 'driving = "dK_full"\n', 'driving = "dK_eff"\n'])
        text += rng.choice(['law = "paris"\nC = 1e-13\nm = 3.0\n', 'law = "paris"\nC = 1e-13\nm = 3.0\nthreshold = %.4g\n' % rng.uniform(50.0, 400.0),
                            'law = "table"\nranges = [63.0, 363.0, 3000.0]\nrates = [6e-12, 9.4e-6, 4e-3]\n'])
    text += 'at = "min"\n' if rng.random() < 0.2 else ""
    return text + ('direction = "straight"\n' if rng.random() < 0.2 else "")


def closure_of(steps, refine, rng):
    text = "[closure]\ndistance = %.3g\n" % (rng.uniform(0.2, 1.0) / refine)
    text += 'definition = "%s"\n' % rng.choice(["contact", "tension", "contact" if steps == '"auto"' else "offset"])
    return text + ("profile = [%.3g, %.3g]\n" % (0.5 / refine + 0.05, 1.0 / refine + 0.1) if rng.random() < 0.4 else "")


def life(rng):
    """A function of the number of cycles that makes the case, and their number."""
    specimen, refine = rng.choice(["plate", "plate", "sent", "mt", "ct"]), rng.choice([1, 2, 4, 8])
    contact = rng.random() < 0.85
    friction = rng.choice([0.0, 0.0, rng.uniform(0.1, 0.9)])
    text = 'title = "random"\nunits = "N-mm-MPa"\n[model]\nplane = "%s"\n' % rng.choice(["strain", "stress"])
    text += '[mesh]\nspecimen = "%s"\nwidth = 10.0\nsize = %.4g\n' % (specimen, 10.0 / rng.randint(10, 14))
    text += "" if specimen == "ct" else "height = %g\n" % (30.0 if specimen == "mt" else 20.0)
    text += material_of(rng) + cracks_of(specimen, "contact = { friction = %.3g }\n" % friction if contact else "", rng)
    boundaries, unit = loads_of(specimen, rng)
    control = "K" if specimen != "ct" and rng.random() < 0.25 else "load"
    unit = rng.uniform(150.0, 400.0) if control == "K" else unit
    steps = rng.choice(['"auto"', '"auto"', str(2 * rng.randint(2, 5))])
    ratio, overload = rng.choice([-1.0, 0.0, 0.3, rng.uniform(-0.8, 0.5)]), rng.random() < 0.3
    text += boundaries + '[load]\nsteps = %s\ncontrol = "%s"\nblocks = [ ' % (steps, control)
    rest = " ]\n[fine]\nradius = %.4g\nrefine = %d\n" % (rng.uniform(1.0, 1.8), refine)
    rest += growth_of(refine, rng) + (closure_of(steps, refine, rng) if contact and rng.random() < 0.7 else "")
    rest += '[output]\nfields = "none"\nfaces = "%s"\n' % rng.choice(["extremes", "all"])
    rest += 'history = "%s"\ncheckpoint_every = %d\n' % (rng.choice(["all", "all", "cycles"]), rng.choice([1, 2, 3]))
    rest += scenes.region_of(rng) if specimen != "ct" and rng.random() < 0.25 else ""
    block = lambda count, factor: "{ cycles = %d, max = %.6g, ratio = %.3g }" % (count, factor * unit, ratio)
    peak = lambda count: ", ".join([block(1, 1.0), block(1, 1.4), block(count - 2, 1.0)])
    return lambda count: text + (peak(count) if overload else block(count, 1.0)) + rest, rng.randint(5, 7)


def run(programs, case, folder, *more):
    """Its exit code, and the last line of what it has against the case."""
    command = [str(programs / "stria"), "run", str(case), "-o", str(folder), "--quiet", "--no-report", *more]
    result = subprocess.run(command, capture_output=True, text=True, env=scenes.ENVIRONMENT, timeout=900)
    return result.returncode, (result.stderr.strip().splitlines() or [""])[-1]


def table(path):
    if not path.exists():
        return None
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: cell for name, cell in row.items() if name != "wall_s"} for row in csv.DictReader(file)]


def ended_by_growth(folder):
    """Nothing is left to do then. The shorter run has known which cycle was its last, and has both ends of it in faces.csv."""
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))["life"] is not None


def first_difference(folder, undisturbed, tables=TABLES):
    for name in tables:
        one, other = table(folder / name), table(undisturbed / name)
        if one != other:
            rows = [k for k, (a, b) in enumerate(zip(one or [], other or [])) if a != b]
            return "%s differs from row %s on" % (name, rows[0] if rows else "its last")
    return None


def interrupted(programs, case, folder, seconds, rng):
    """Stopped and resumed until it is done."""
    code, said = INTERRUPTED, ""
    for part in range(12):
        mode = rng.choice(["inprocess", "inprocess", "mpi"])
        more = ["--resume"] if part else []
        more += ["--max-seconds", "%.3f" % (seconds + (0.3 if mode == "mpi" else 0.0))] if part < 11 else []
        code, said = run(programs, case, folder, "--mode", mode, *more)
        if code != INTERRUPTED:
            break
    return code, said


def faults(programs, folder, of_cycles, cycles, rng):
    """What is wrong with a life, and how its undisturbed run ended."""
    case, short, tight = (folder / name for name in ("case.toml", "short.toml", "tight.toml"))
    case.write_text(of_cycles(cycles))
    short.write_text(of_cycles(cycles - rng.randint(1, 2)))
    tight.write_text(of_cycles(cycles) + "[solver]\ntolerance = 1e-10\n")
    begin = time.monotonic()
    code, said = run(programs, case, folder / "whole", "--mode", "inprocess")
    seconds = rng.uniform(0.15, 0.6) * (time.monotonic() - begin)
    if code != 0:
        other = run(programs, case, folder / "mpi", "--mode", "mpi")[0]
        return [] if code in (2, 3) and other == code else [f"ends with {code} and {other}"], f"ends with {code}: {said}"
    wrong = cross_check.faults(folder / "whole")[:1] if 'history = "all"' in case.read_text() else []

    def compare(what, ended, name, tables=TABLES):
        found = "%d: %s" % ended if ended[0] != 0 else first_difference(folder / name, folder / "whole", tables)
        if found:
            wrong.append(f"{what}: {found}")

    compare("resumed", interrupted(programs, case, folder / "parts", seconds, rng), "parts")
    ended = run(programs, short, folder / "longer", "--mode", "inprocess")
    over = ended[0] == 0 and ended_by_growth(folder / "longer")
    tables = [name for name in TABLES if name != "faces.csv"] if over else TABLES
    compare("made longer", run(programs, case, folder / "longer", "--mode", "inprocess", "--resume") if ended[0] == 0 else ended, "longer", tables)
    ranks, mode = rng.choice([2, 3]), rng.choice(["inprocess", "mpi"])
    ends = [run(programs, tight, folder / f"of{n}", "--mode", mode, "--fine", str(n))[0] for n in (1, ranks)]
    if ends[0] != ends[1]:
        wrong.append(f"{ranks} ranks: end with {ends[1]}, one with {ends[0]}")
    elif ends[0] == 0:
        worst, where = scenes.difference(*(scenes.numbers(folder / f"of{n}") for n in (1, ranks)))
        if worst >= scenes.SAME:
            wrong.append(f"{ranks} ranks: {worst:.1e} of {where}")
    return wrong, "good"


def judge(arguments, seed):
    rng = random.Random(seed)
    with tempfile.TemporaryDirectory() as scratch:
        wrong, end = faults(arguments.programs, Path(scratch), *life(rng), rng)
        if wrong and arguments.keep:
            shutil.copytree(scratch, arguments.keep / str(seed), dirs_exist_ok=True)
        return seed, wrong, end


def main():
    return random_trials.run(judge, random_trials.arguments_of(__doc__, scenes.ROOT / "build/release/bin", "lives that are wrong"))


if __name__ == "__main__":
    sys.exit(main())
