"""What random scenes have besides: a controlled displacement, a dead load, an initial stress, chosen increments, and
opening loads that are looked for in more ways."""

import csv
import random
import re

DEAD = "dead"
# About what the loaded boundary moves by per unit load factor, mm: 20 mm of the body of 200 GPa and a crack.
MOVED_BY_UNIT = {"plate": 1.5e-4, "sent": 1.5e-4, "mt": 2e-4, "ct": 2.5e-4}


def blocks_of(rng, size):
    """The first extreme is above zero, zero or below. Each maximum is above its minimum."""
    largest = [rng.choice([1.0, 1.0, 1.0, rng.uniform(0.1, 0.5), 0.0, rng.uniform(-0.5, -0.1)])]
    largest += [rng.uniform(0.2, 1.2) for _ in range(rng.randrange(3))]
    ranges = [rng.uniform(0.3, 1.5) for _ in largest]
    return "blocks = [ %s ]" % ", ".join("{ cycles = %d, max = %.6g, min = %.6g }" % (
        1 if len(largest) > 1 else rng.randint(1, 2), size * most, size * (most - below)) for most, below in zip(largest, ranges))


def dead_load(rng, text, unit):
    """Its boundaries and its factor: along the main load, as a pressure across it, or in shear."""
    boundary = lambda on, what: '[[boundary]]\non = "%s"\n%s\ncase = "%s"\n' % (on, what, DEAD)
    both = lambda ones, key: "".join(boundary(on, "%s = [%g, %g]" % (key, *load)) for on, load in ones.items())
    is_held = lambda on: 'on = "%s"\ndisplacement' % on in text  # a load there would be its support's
    if 'specimen = "ct"' in text:
        loads = both({"pin-top": (0, 1), "pin-bottom": (0, -1)}, "force")
    elif is_held("top") or rng.random() < 0.3:
        loads = boundary("left", "pressure = 1.0") + boundary("right", "pressure = 1.0")
    else:
        along = rng.choice([0.0, 0.0, 0.3])
        ends = {"top": (along, 1), "bottom": (-along, -1)}
        loads = both({on: load for on, load in ends.items() if not is_held(on)}, "traction")
        loads += both({"right": (0, along), "left": (0, -along)}, "traction") if along else ""
    return loads + '[[load_case]]\nname = "%s"\nconstant = %.6g\n' % (DEAD, unit * rng.choice([rng.uniform(0.1, 0.8), rng.uniform(-0.4, -0.1)]))


def with_more(text, seed):
    """The scene `text` of `seed`, half of them as they are. What is chosen here leaves other choices of a seed alone."""
    rng = random.Random(f"more loads of {seed}")
    if rng.random() < 0.5:
        return text
    unit = float(re.search(r"max = ([\d.e+-]+)", text)[1])
    specimen = re.search(r'specimen = "(\w+)"', text)[1]
    driven = re.search(r"(\[\[boundary\]\](.|\n)*)\[load\]", text)[1]
    moves = re.search(r"\ndisplacement = (?!\[0\.0, 0\.0\])", driven)  # then the load factor is the displacement
    if not moves and rng.random() < 0.6:
        blocks = blocks_of(rng, unit * MOVED_BY_UNIT[specimen] * rng.uniform(0.6, 1.4))
        text = re.sub(r"blocks = .*", lambda _: 'control = "displacement"\n' + blocks, text)
    if rng.random() < 0.6:
        text = text.replace("[load]\n", dead_load(rng, text, unit) + "[load]\n")
    if specimen != "ct" and rng.random() < 0.3:
        stress = rng.uniform(-60.0, 60.0)
        text += "[initial_stress]\nsigma_y = { at = [0.0, 5.0, 10.0], stress = [%.6g, %.6g, %.6g] }\n" % (stress, -stress, stress)
    if rng.random() < 0.35 and 'definition = "offset"' not in text:
        text = re.sub(r"\nsteps = \d+", '\nsteps = "auto"', text)
    return text


def with_closure(text, seed):
    """The scene `text` of `seed`; a quarter of them look for tension ahead of their tips, and some at further distances."""
    rng = random.Random(f"closure of {seed}")
    if rng.random() < 0.75:
        return text
    profile = "profile = [%.4g, %.4g]\n" % (rng.uniform(0.3, 0.8), rng.uniform(0.8, 1.5)) if rng.random() < 0.5 else ""
    return text + "[closure]\n%s\n" % rng.choice(["tension = true", 'definition = "tension"']) + profile


def first_way(folder):
    """Displacements from where dead loads and an initial stress leave the boundary to the end of the run's history."""
    with open(folder / "history.csv") as file:
        rows = list(csv.DictReader(file))
    rows = [row for k, row in enumerate(rows) if k == 0 or row["increment"] != rows[k - 1]["increment"]]
    led = 0  # rows without a main load come first
    while led < len(rows) and float(rows[led]["load_factor"]) == 0.0:
        led += 1
    return ([float(rows[led - 1]["displacement"])] if led else [0.0]) + [float(row["displacement"]) for row in rows[led:]]


def strays(way, to, rounding):
    """Whether a way of displacements goes anywhere but straight to `to`, or never gets there."""
    for before, now in zip(way, way[1:]):
        if abs(before - to) <= rounding:
            return False
        if (now - before) * (to - before) <= 0.0 or (to - now) * (to - before) < -rounding * abs(to - before):
            return True
    return abs(way[-1] - to) > rounding


def strays_at_first(folder, text):
    """What is wrong with the way to the first extreme of a controlled displacement, or None."""
    if 'control = "displacement"' not in text:
        return None
    to, least = (float(x) for x in re.search(r"max = ([\d.e+-]+), min = ([\d.e+-]+)", text).groups())
    way = first_way(folder)
    if way[0] == 0.0 and to == 0.0:  # nothing has moved the boundary: the first way goes to the minimum
        to = least
    rounding = 1e-9 * max(abs(x) for x in way)
    return "the displacement goes from %.6g to %.6g by %s" % (way[0], to, way[1:7]) if strays(way, to, rounding) else None
