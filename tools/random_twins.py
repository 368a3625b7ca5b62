#!/usr/bin/python3
"""Runs random cases and twins of each, which say the same in other words, and compares what they leave.

    tools/random_twins.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2] [--only PATTERN]

A case is one of random_scenes.py or random_lives.py, with load cases, residual stress and more of hardening added, or a
controlled displacement, a dead load and chosen increments (random_loads.py); or a body from a mesh file, of crooked
quadrilaterals. Its twins:

    scaled     lengths times 1000 and stresses times 1e-6: every number of its unit, by the units that the reference of
               the case file declares
    mirrored   about the horizontal, or the vertical, middle: K_II, slip and shear change their signs
    louder     loads 100 times as large, and the load factor so much smaller, be it given or found
    spelled    cycles one by one, min for ratio, from a spectrum, with load.scale; a linear law as a table; a back stress
               in two halves
    pointed    one more point in the middle of a straight stretch of a crack: the same to the last digit
    reversed   the points of each crack in reversed order: the mouth of an edge crack is its last point
    renumbered nodes and elements of the mesh file in another order, elements from another of their nodes, the body moved
    turned     the mesh file's body, cracks and loads turned by an angle

and of these, or of --only those named, two in five: what other_bodies.py and other_histories.py tell. A body turned by
a right angle, from a file, in regions of one metal, a half by symmetry, with a larger zone, under a stress that is let
go or held; faces that cannot touch or rub; an elastic crack grown at once. Sequences that repeat, turning points, a K
or a displacement as the load that it asks for, other increments of an elastic body, loads in shares, as pressures and
as load cases, small cycles ahead, laws of growth in other words; what is written. Some compare another case than that
of the seed: one without flow, or with given increments.

Scaled by powers of two numbers kept ten digits in the cases looked at. Others change the rounding, and rounding
decides: the diagonal along which a rectangle beside a tip is cut into triangles, with an error of the quadrature of
3e-4 of the T stress in elements as coarse as these; which points have begun to flow, in zones that end at them, where
a cycle comes back to the yield stress; and the trials for opening loads end within 0.2 % of the largest load. So
numbers may differ by the bounds of TOLERANCE, relative to the largest of their kind. Runs that end with 2 or 3 do so
alike. Exit code 1 where twins do neither.
"""

import csv
import json
import math
import random
import re
import shutil
import sys
import tempfile
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import other_bodies  # noqa: E402
import other_histories  # noqa: E402
import other_words  # noqa: E402
import random_lives as lives  # noqa: E402
import random_loads  # noqa: E402
import random_scenes as scenes  # noqa: E402
import random_trials  # noqa: E402
from other_words import TOLERANCE, WIDTH, kind_of  # noqa: E402
from twins import Twin, same  # noqa: E402

TABLES = ["history.csv", "cycles.csv", "closure.csv"]


def toml(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value) if isinstance(value, (bool, str)) else repr(value)


def case_text(case):
    """A line for each key of a section."""
    lines = [f"{key} = {toml(value)}" for key, value in case.items() if not isinstance(value, (dict, list))]
    for name, value in case.items():
        for section in value if isinstance(value, list) else [value] if isinstance(value, dict) else []:
            lines.append(f"[[{name}]]" if isinstance(value, list) else f"[{name}]")
            lines += [f"{key} = {toml(inner)}" for key, inner in section.items()]
    return "\n".join(lines + [""])


def crooked_mesh(rng):
    """Nodes, quadrilaterals and boundary edges of a plate, 10 mm by 20 mm."""
    across, up = rng.randint(9, 12), rng.randint(17, 22)
    node = lambda i, j: j * (across + 1) + i
    shift = lambda k, end, step: 0.0 if k in (0, end) else rng.uniform(-0.15, 0.15) * step
    nodes = [(WIDTH * i / across + shift(i, across, WIDTH / across), 20.0 * j / up + shift(j, up, 20.0 / up))
             for j in range(up + 1) for i in range(across + 1)]
    quads = [[node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)] for j in range(up) for i in range(across)]
    edges = [(name, node(i, j), node(i + 1, j)) for name, j in (("bottom", 0), ("top", up)) for i in range(across)]
    edges += [(name, node(i, j), node(i, j + 1)) for name, i in (("left", 0), ("right", across)) for j in range(up)]
    return nodes, quads, edges


def write_mesh(path, mesh):
    """`mesh`: nodes, cells, boundary edges, and where elements have groups that of each."""
    nodes, cells, edges, *groups = mesh
    groups = groups[0] if groups else ["body"] * len(cells)
    names = sorted({name for name, _, _ in edges}) + sorted(set(groups))
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names))]
    lines += [f'{2 if name in groups else 1} {k + 1} "{name}"' for k, name in enumerate(names)]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
    lines += [f"{k + 1} {x!r} {y!r} 0" for k, (x, y) in enumerate(nodes)]
    lines += ["$EndNodes", "$Elements", str(len(edges) + len(cells))]
    number = {name: f"2 {k + 1} {k + 1}" for k, name in enumerate(names)}
    lines += [f"{k + 1} 1 {number[name]} {a + 1} {b + 1}" for k, (name, a, b) in enumerate(edges)]
    lines += [f"{len(edges) + k + 1} {len(cell) - 1} {number[group]} " + " ".join(str(n + 1) for n in cell)
              for k, (cell, group) in enumerate(zip(cells, groups))]
    path.write_text("\n".join(lines + ["$EndElements", ""]))


def case_of(rng, seed):
    """A case and its mesh, None of a specimen."""
    if rng.random() < 0.6:
        of_cycles, _ = lives.life(rng)
        text = of_cycles(3)
    else:
        text = scenes.scene(rng)
    has_K = 'control = "K"' in text
    more = text if has_K else random_loads.with_more(text.replace('control = "load"\n', ""), seed)
    case = tomllib.loads(more)
    case["solver"] = {"tolerance": 1e-10}
    case["output"] = {"fields": "none", "checkpoint_every": 0}
    if "distance" in case.get("closure", {}):  # no multiple of an increment: faces part as a root at a former tip
        case["closure"]["distance"] *= 1.0 + 0.01 * math.pi
    specimen, material = case["mesh"]["specimen"], case["material"]
    for crack in case["crack"]:  # along no line of nodes, so that sides are no matter of order
        for k, point in enumerate(crack["points"]):
            point[1] += 0.0137 + 0.0291 * k
    if specimen != "ct" and not {"initial_stress", "load_case"} & case.keys() and case["load"].get("control") != "displacement":
        more_loads(case, rng)
    if "kinematic" in material and rng.random() < 0.4:
        term = material["kinematic"][0]
        term.update({"threshold": True} if term["gamma"] > 0.0 else {"C_start": 1.2 * term["C"], "C_rate": 0.0})
    if specimen != "plate" or rng.random() < 0.5 or any("at" in boundary for boundary in case["boundary"]):
        return case, None
    case["mesh"] = {"file": "body.msh"}
    return case, crooked_mesh(rng)


def more_loads(case, rng):
    stress = rng.uniform(-60.0, 60.0)
    if rng.random() < 0.25:
        case["initial_stress"] = {"sigma_y": {"at": [0.0, 5.0, WIDTH], "stress": [stress, -stress, stress]}}
    if case["load"].get("control") == "K" or rng.random() < 0.75:
        return
    tractions = {"top": [0.3, 0.4], "bottom": [-0.3, -0.4], "right": [0.0, 0.3], "left": [0.0, -0.3]}
    case["boundary"] += [{"on": on, "traction": traction, "case": "other"} for on, traction in tractions.items()]
    how = rng.choice([{"constant": 0.3 * case["load"]["blocks"][0]["max"]}, {"factor": 0.3, "phase": 90.0}, {"factor": 0.3}])
    case["load_case"] = [{"name": "other", **how}]


def run(programs, folder, name, case, mesh):
    if "file" in case["mesh"]:
        write_mesh(folder / "body.msh", mesh)
    path = folder / f"{name.replace(' ', '-')}.toml"
    path.write_text(case_text(case))
    return lives.run(programs, path, path.with_suffix(""), "--mode", "inprocess"), path.with_suffix("")


def numbers(folder, change):
    """Of each table its rows, in the order of tips."""
    tables = {}
    for name in TABLES:
        if not (folder / name).exists():
            continue
        with open(folder / name, newline="", encoding="utf-8") as file:
            rows = [{key: float(cell or "nan") for key, cell in row.items()} for row in csv.DictReader(file)]
        rows = [{key: change(key, cell) for key, cell in row.items() if kind_of(key) or key in ("cycle", "increment", "tip")}
                for row in rows]
        tables[name] = sorted(rows, key=lambda row: (row.get("increment", row["cycle"]), row["tip"]))
    return tables


def told_from(folder):
    """Of a crack that stays closed K and J are of the mesh: they are told from the J on that it would have if the work in
    a row of elements, a hundredth of all, went into it, and from the K of that."""
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        J = 1e-2 * max(abs(float(row["external_work"])) for row in csv.DictReader(file)) / WIDTH
    return {"K_I": (200e3 * J) ** 0.5, "J": J}


def first_difference(one, other, without, least):
    """`least`: what numbers of a kind are told from."""
    largest_K = max((abs(row[key]) for rows in one.values() for row in rows for key in row
                     if kind_of(key) == "K" and row[key] == row[key]), default=0.0)
    for name, rows in one.items():
        if len(rows) != len(other.get(name, [])):
            return f"{name}: {len(rows)} rows and {len(other.get(name, []))}"
        size = dict(least)
        for key in rows[0] if rows else ():
            size[kind_of(key)] = max([size.get(kind_of(key), 0.0)] + [abs(row[key]) for row in rows if row[key] == row[key]])
        size["trials"] = max(size.get("trials", 0.0), largest_K)
        for k, (a, b) in enumerate(zip(rows, other[name])):
            for key in a.keys() - without:
                kind = kind_of(key)
                if kind and ((a[key] != a[key]) != (b[key] != b[key]) or abs(a[key] - b[key]) > TOLERANCE[kind] * size[kind]):
                    return f"{name}, row {k}, {key}: {a[key]:.9g} and {b[key]:.9g}, of up to {size[kind]:.4g}"
    return None


def digits(path):
    """The rows of a table as they are written, but for times."""
    if not path.exists():
        return None
    with open(path, newline="", encoding="utf-8") as file:
        return [{key: cell for key, cell in row.items() if key != "wall_s"} for row in csv.DictReader(file)]


def twins_of(case, mesh, folder, seed, only):
    """Of the case, by what they are called."""
    twins = {name: Twin(*told) for name, told in other_words.twins_of(case, mesh, folder, random.Random(f"words {seed}")).items()}
    twins["pointed"].digits = True
    for relation in other_bodies.RELATIONS + other_histories.RELATIONS:
        rng = random.Random(f"{relation.__name__} {seed}")
        twin = relation(case, rng) if only or rng.random() < 0.4 else None
        if twin:
            twin.mesh = twin.mesh or mesh
            twins[relation.__name__.replace("_", " ")] = twin
    if mesh:
        twins["from Abaqus"] = other_bodies.from_abaqus(case, mesh)
    return {name: twin for name, twin in twins.items() if re.search(only, name)}


def difference(name, one, other, case, twin):
    """Of two runs that have come to their ends, or None."""
    if twin.digits:
        return next((table for table in TABLES if digits(one / table) != digits(other / table)), None)
    inner = case["mesh"].get("specimen") == "mt"
    without = twin.without | ({"CMOD"} if name == "reversed" and inner else set())  # of the crack's first point
    if case.get("growth", {}).get("law", "prescribed") != "prescribed":
        without |= {"a", "da"}  # of a slower tip as exact as its K_op
    least = {kind_of(key): abs(twin.change(key, value)) for key, value in told_from(one).items()}
    return first_difference(twin.of_base(numbers(one, twin.change)), twin.of_twin(numbers(other, same)), without, least)


def fault(programs, folder, name, twin, itself):
    """What is wrong with a twin, or None. `itself`: how the case that it is the twin of has ended, and its folder."""
    (code, said), of = itself
    told = twin.case(of) if callable(twin.case) and code == 0 else None if callable(twin.case) else twin.case
    if told is None:
        return None
    for file, text in twin.files.items():
        (folder / file).write_text(text)
    (its_code, it_says), its_folder = run(programs, folder, name, told, twin.mesh)
    if its_code != code or code not in (0, 2, 3):
        return f"{its_code} {it_says}, itself {code} {said}"
    return difference(name, of, its_folder, twin.base, twin) if code == 0 else None


def judge(arguments, seed):
    case, mesh = case_of(random.Random(seed), seed)
    wrong = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        itself = run(arguments.programs, folder, "itself", case, mesh)
        for name, twin in twins_of(case, mesh, folder, seed, arguments.only).items():
            its_own = run(arguments.programs, folder, f"{name} itself", twin.base, mesh) if twin.base else itself
            twin.base = twin.base or case
            found = fault(arguments.programs, folder, name, twin, its_own)
            wrong += [f"{name}: {found}"] if found else []
        if wrong and arguments.keep:
            shutil.copytree(scratch, arguments.keep / str(seed), dirs_exist_ok=True)
    code, said = itself[0]
    return seed, wrong, "good" if code == 0 else f"all end with {code}: {said}"


def main():
    return random_trials.run(judge, random_trials.arguments_of(__doc__, scenes.ROOT / "build/release/bin", "cases whose twins differ", only="names of twins"))


if __name__ == "__main__":
    sys.exit(main())
