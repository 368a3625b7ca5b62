"""A case in other words: what random_twins.py compares. Each function gives the twin of a case and of its mesh, and what
becomes of the number in a column."""

import copy
import math
import re

import random_scenes as scenes
from twins import same

WIDTH = 10.0
# Powers of length and stress.
UNITS = {"mm": (1, 0), "mm/cycle": (1, 0), "MPa": (0, 1), "N/mm": (1, 1), "MPa/mm": (-1, 1), "MPa sqrt(mm)": (0.5, 1), "1/mm": (-1, 0)}
# Columns of one kind each: what they scale with, and how far twins may differ.
COLUMNS = {
    "K": ("K_I K_II K_initial K_max K_min", (0.5, 1), 1e-3),
    "trials": ("K_op K_cl dK_eff K_op_contact K_op_tension K_slip K_slip_unloading", (0.5, 1), 5e-3),
    "J": ("J J_max", (1, 1), 2e-3),
    "load": ("load", (1, 1), 1e-3),  # under control of K it is as exact as K of the unit load
    "factor": ("load_factor", (0, 0), 1e-3),
    "work": ("external_work stored_energy released_energy dissipation frictional_dissipation", (2, 1), 1e-3),
    "place": ("a da", (1, 0), 1e-6),
    "opening": ("CMOD opening opening_range displacement", (1, 0), 1e-3),
    "life": ("dN N", (0, 0), 5e-3),
}
TOLERANCE = {name: tolerance for name, (_, _, tolerance) in COLUMNS.items()}


def kind_of(column):
    return next((kind for kind, (names, _, _) in COLUMNS.items() if column in names.split()), None)


def walked(value, change, path=""):
    """The case with each number as `change` of its key and itself."""
    if isinstance(value, dict):
        return {key: walked(inner, change, f"{path}.{key}" if path else key) for key, inner in value.items()}
    if isinstance(value, list):
        return [walked(inner, change, path) for inner in value]
    return value if isinstance(value, (bool, str)) else change(path, value)


def units_of_keys():
    reference, section, units = (scenes.ROOT / "docs/case-reference.md").read_text(encoding="utf-8"), "", {}
    for line in reference.splitlines():
        section = line[3:].strip("`[] ") if line.startswith("## ") else section
        if found := re.match(r"\| `([^`]+)` \| [^|]* \| ([^|]*?) ?\|", line):
            units[f"{section}.{found[1]}"] = UNITS.get(found[2].strip(), (0, 0))
    return units


def scaled(case, mesh, length, stress):
    control, m = case["load"].get("control", "load"), case.get("growth", {}).get("m", 0.0)
    units = units_of_keys()
    units["growth.C"] = (1 - 0.5 * m, -m)  # Paris' law
    for key in ("load.blocks.max", "load.blocks.min"):
        units[key] = {"K": (0.5, 1), "displacement": (1, 0)}.get(control, (0, 0))
    power = lambda of: length ** of[0] * stress ** of[1]
    twin = walked(case, lambda key, value: value * power(units[key]) if any(units.get(key, (0, 0))) else value)
    mesh = mesh and ([(length * x, length * y) for x, y in mesh[0]], *mesh[1:])
    return twin, mesh, lambda column, value: value * power(COLUMNS[kind_of(column)][1]) if kind_of(column) else value


def turned_tensor(tensor, vector):
    """That of vectors which `vector` turns or mirrors."""
    transposed = lambda rows: [list(row) for row in zip(*rows)]
    return transposed([vector(row) for row in transposed([vector(row) for row in tensor])])


def mapped(case, mesh, point, vector, names=None):
    """Places and vectors elsewhere."""
    twin, names = copy.deepcopy(case), names or {}
    for crack in twin["crack"]:
        crack["points"] = [point(at) for at in crack["points"]]
    for region in twin.get("region", []):
        if "outline" in region:
            region["outline"] = [point(at) for at in region["outline"]]
        if "initial_stress" in region:
            xx, yy, xy = (region["initial_stress"].get(key, 0.0) for key in ("xx", "yy", "xy"))
            (xx, xy), (_, yy) = turned_tensor([[xx, xy], [xy, yy]], vector)
            region["initial_stress"] = {"xx": xx, "yy": yy, "xy": xy}
    for boundary in twin["boundary"]:
        boundary["on"] = names.get(boundary["on"], boundary["on"])
        for key in {"traction", "force", "displacement", "cosine"} & boundary.keys():
            boundary[key] = vector(boundary[key])
        for key in {"at", "centre"} & boundary.keys():
            boundary[key] = point(boundary[key])
        if "traction_gradient" in boundary:
            boundary["origin"] = point(boundary.get("origin", [0.0, 0.0]))
            boundary["traction_gradient"] = turned_tensor(boundary["traction_gradient"], vector)
    return twin, mesh and ([tuple(point(at)) for at in mesh[0]], *mesh[1:])


def mirrored(case, mesh, axis):
    specimen, pins = case["mesh"].get("specimen"), {"pin-top": "pin-bottom", "pin-bottom": "pin-top"}
    ends = [{"left": "right", "right": "left"}, {"top": "bottom", "bottom": "top", **pins}][axis]
    twice = WIDTH if axis == 0 else 0.0 if specimen == "ct" else case["mesh"].get("height", 20.0)
    flip = lambda at, middle: [middle - x if k == axis and x != "free" else x for k, x in enumerate(at)]
    twin, mesh = mapped(case, mesh, lambda at: flip(at, twice), lambda v: flip(v, 0.0), ends)
    if mesh:
        mesh = mesh[0], [quad[::-1] for quad in mesh[1]], [(ends.get(name, name), a, b) for name, a, b in mesh[2]]
    return twin, mesh, lambda column, value: -value if column.startswith("K_II") else value


def reversed_cracks(case, mesh):
    twin = copy.deepcopy(case)
    for crack in twin["crack"]:
        crack["points"].reverse()
    inner = case["mesh"].get("specimen") == "mt"  # its tips change places, and with them who asks for a K
    return twin, mesh, lambda column, value: 1 - value if inner and column == "tip" else value


def turned(case, mesh, angle, shift):
    c, s = math.cos(angle), math.sin(angle)
    turn = lambda v: [c * v[0] - s * v[1], s * v[0] + c * v[1]]
    return *mapped(case, mesh, lambda at: [x + d for x, d in zip(turn(at), shift)], turn), same


def renumbered(case, mesh, rng):
    twin, (nodes, quads, edges, *groups) = mapped(case, mesh, lambda at: [at[0] + 3.7, at[1] - 41.3], list)
    order = rng.sample(range(len(nodes)), len(nodes))  # new number of each
    moved = [nodes[old] for old in sorted(range(len(nodes)), key=order.__getitem__)]
    first = lambda quad, k: quad[k:] + quad[:k]
    shuffled = rng.sample(range(len(quads)), len(quads))
    quads = [first([order[n] for n in quads[k]], rng.randrange(4)) for k in shuffled]
    groups = [[group[k] for k in shuffled] for group in groups]
    return twin, (moved, quads, [(name, order[b], order[a]) for name, a, b in edges], *groups), same


def louder(case, mesh, times):
    twin = copy.deepcopy(case)
    for boundary in twin["boundary"]:
        of_load = {"traction", "force", "displacement", "pressure", "traction_gradient"} & boundary.keys()
        for key in of_load if "case" not in boundary else ():
            boundary[key] = walked(boundary[key], lambda _key, value: times * value)
    for block in twin["load"]["blocks"] if twin["load"].get("control", "load") == "load" else ():
        block.update({key: block[key] / times for key in ("max", "min") if key in block})
    for load_case in twin.get("load_case", []):
        load_case.update({"factor": times * load_case["factor"]} if "factor" in load_case else {})
    return twin, mesh, lambda column, value: value / times if column == "load_factor" else value


def spelled(case, mesh, folder):
    twin = copy.deepcopy(case)
    load, material = twin["load"], twin["material"]
    rows = [(block["max"], block["min"] if "min" in block else block["max"] * block["ratio"]) for block in load.pop("blocks") for _ in range(block["cycles"])]
    (folder / "spectrum.csv").write_text("max,min\n" + "".join(f"{high / 2.5!r},{low / 2.5!r}\n" for high, low in rows))
    load.update({"spectrum": "spectrum.csv", "scale": 2.5})
    law, stress = material.get("isotropic", {}), material.get("yield_stress")
    if law.get("law") == "linear":
        farthest = 100.0  # near a tip strains pass 1, and behind its last point a table is flat
        top = stress + farthest * law.get("modulus", 0.0)
        material["isotropic"] = {"law": "table", "plastic_strain": [0.0, farthest], "stress": [stress, top]}
    if "kinematic" in material and "threshold" not in material["kinematic"][0]:
        half = {key: value / 2 if key in ("C", "C_start") else value for key, value in material["kinematic"].pop(0).items()}
        material["kinematic"] += [half, dict(half)]
    return twin, mesh, same


def pointed(case, mesh, rng):
    twin = copy.deepcopy(case)
    for crack in twin["crack"]:
        at, way = rng.randrange(len(crack["points"]) - 1), rng.uniform(0.3, 0.7)
        a, b = crack["points"][at:at + 2]
        crack["points"].insert(at + 1, [x + way * (y - x) for x, y in zip(a, b)])
    return twin, mesh, same


def twins_of(case, mesh, folder, rng):
    twins = {"scaled": scaled(case, mesh, 1e3, 1e-6), "scaled by powers of two": scaled(case, mesh, 4.0**-5, 2.0**20),
             "mirrored": mirrored(case, mesh, 1), "louder": louder(case, mesh, 100.0),
             "spelled": spelled(case, mesh, folder), "pointed": pointed(case, mesh, rng)}
    specimen = case["mesh"].get("specimen")
    if specimen != "ct" and specimen != "sent":
        twins["mirrored left to right"] = mirrored(case, mesh, 0)
    if specimen != "mt" or case["load"].get("control") != "K":
        twins["reversed"] = reversed_cracks(case, mesh)
    if mesh and not any("initial_stress" in part for part in [case] + case.get("region", [])):
        twins["renumbered"] = renumbered(case, mesh, rng)
    if "renumbered" in twins and not any("free" in boundary.get("displacement", []) for boundary in case["boundary"]):
        twins["turned"] = turned(case, mesh, rng.uniform(-3.0, 3.0), [rng.uniform(-50.0, 50.0) for _ in range(2)])
    return twins
