"""The same body told otherwise: turned, from a file, in regions, as a half, its parts in another order. Each function
gives the twin of a case (twins.py), or None where it has none."""

import copy
import itertools
import math

from other_words import mapped
from twins import Twin, history, last_increment, rows_of, same, turns, without_rows

WORK = {"external_work", "stored_energy", "released_energy", "dissipation", "frictional_dissipation"}
EVERYWHERE = [[-60.0, -90.0], [70.0, -91.0], [5.0, 190.0]]  # along no line of nodes


def materials_of(case):
    return [case["material"]] + [region["material"] for region in case.get("region", [])]


def is_elastic(case):
    return not any("yield_stress" in material for material in materials_of(case))


def has_contact(case):
    return any("contact" in crack for crack in case["crack"])


def has_initial_stress(case):
    return any("initial_stress" in part for part in [case] + case.get("region", []))


def is_moved(case):
    return any("displacement" in boundary for boundary in case["boundary"])


def control_of(case):
    return case["load"].get("control", "load")


def height_of(case):
    return case["mesh"].get("height", 20.0)


def is_plate(case):
    return case["mesh"].get("specimen") in ("plate", "sent", "mt")


def length_of(crack):
    return sum(math.dist(a, b) for a, b in zip(crack["points"], crack["points"][1:]))


def elastic(case, contact=True):
    """The same without flow and friction, and without contact where it is not wanted."""
    twin = copy.deepcopy(case)
    for material in materials_of(twin):
        for key in ("yield_stress", "isotropic", "kinematic"):
            material.pop(key, None)
    for key in ("refine", "substeps", "radius", "subcells"):
        twin.get("fine", {}).pop(key, None)
    for crack in twin["crack"]:
        crack.get("contact", {}).pop("friction", None)
        if not contact:
            crack.pop("contact", None)
    twin.pop("closure", None)
    return twin


def turned_by_a_right_angle(case, _rng):
    """To the left: (x, y) goes to (height - y, x)."""
    if not is_plate(case):
        return None
    high, ends = height_of(case), {"right": "top", "top": "left", "left": "bottom", "bottom": "right"}
    turn = lambda v: [v[1] if v[1] == "free" else -v[1], v[0]]
    twin, _ = mapped(case, None, lambda at: [high - at[1], at[0]], turn, ends)
    twin["mesh"].update({"specimen": "plate", "width": high, "height": case["mesh"]["width"]})
    if "initial_stress" in twin:
        twin["initial_stress"] = {"sigma_x": twin["initial_stress"]["sigma_y"]}
    return Twin(twin)


def grid(width, height, size):
    """A specimen's mesh, as that of a file: nodes, quadrilaterals and boundary edges."""
    across, up = max(1, round(width / size)), max(1, round(height / size))
    node = lambda i, j: j * (across + 1) + i
    nodes = [(width * i / across, height * j / up) for j in range(up + 1) for i in range(across + 1)]
    quads = [[node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)] for j in range(up) for i in range(across)]
    edges = [(name, node(i, j), node(i + 1, j)) for name, j in (("bottom", 0), ("top", up)) for i in range(across)]
    edges += [(name, node(i, j), node(i, j + 1)) for name, i in (("left", 0), ("right", across)) for j in range(up)]
    return nodes, quads, edges


def from_a_file(case, _rng):
    """A specimen as its mesh; where an outline or a point has made node lines this grid is another one."""
    if not is_plate(case) or "region" in case or any("at" in boundary for boundary in case["boundary"]):
        return None
    twin = copy.deepcopy(case)
    twin["mesh"] = {"file": "body.msh"}
    return Twin(twin, grid(case["mesh"]["width"], height_of(case), case["mesh"]["size"]))


def from_abaqus(case, mesh):
    """A mesh file in the other format."""
    nodes, cells, edges, *groups = mesh
    lines = ["*NODE"] + [f"{k + 1}, {x!r}, {y!r}" for k, (x, y) in enumerate(nodes)]
    for corners, of in itertools.groupby(enumerate(cells), lambda of: len(of[1])):
        lines += [f"*ELEMENT, TYPE=CPE{corners}"] + [f"{k + 1}, " + ", ".join(str(n + 1) for n in cell) for k, cell in of]
    side = {frozenset((cell[k], cell[k - 1])): (e + 1, (k - 1) % len(cell) + 1) for e, cell in enumerate(cells) for k in range(len(cell))}
    for name in sorted({name for name, _, _ in edges}):
        lines += [f"*SURFACE, NAME={name}, TYPE=ELEMENT"]
        lines += ["%d, S%d" % side[frozenset((a, b))] for of, a, b in edges if of == name]
    for name in sorted(set(groups[0])) if groups else ():
        lines += [f"*ELSET, ELSET={name}"] + [str(k + 1) for k, of in enumerate(groups[0]) if of == name]
    twin = copy.deepcopy(case)
    twin["mesh"] = {"file": "body.inp"}
    return Twin(twin, mesh, files={"body.inp": "\n".join(lines + [""])}, digits=True)


def in_regions(case, rng):
    """A part of the same metal, or all of it."""
    if "region" in case:
        return None
    part = [[-30.0, rng.uniform(-5.0, 15.0)], [40.0, rng.uniform(-5.0, 15.0)], [5.0, 90.0]]
    twin = copy.deepcopy(case)
    outline = EVERYWHERE if case["mesh"].get("specimen") == "ct" else rng.choice([part, part, EVERYWHERE])
    twin["region"] = [{"outline": outline, "material": copy.deepcopy(case["material"])}]
    return Twin(twin)


def in_another_order(case, rng):
    """But for the first boundary, which `load` and `displacement` are of, and the first of cracks that K is asked of."""
    count = len(case["crack"])
    if count > 2 or count == 2 and control_of(case) == "K":
        return None
    twin = copy.deepcopy(case)
    for parts in [of.get("kinematic", []) for of in materials_of(twin)] + [twin.get(name, []) for name in ("crack", "region", "load_case")]:
        parts.reverse()
    first, *others = twin["boundary"]
    twin["boundary"] = [first] + rng.sample(others, len(others))
    return Twin(twin, change=(lambda column, value: 1 - value if column == "tip" else value) if count == 2 else same)


def half(case, _rng):
    """A plate whose left edge is a line of symmetry, and the whole one. Nominal K may differ: its functions reach as far
    as there is room for them, and a half has another boundary."""
    crack, width = case["crack"][0], case["mesh"].get("width")
    if case["mesh"].get("specimen") not in ("plate", "sent") or len(case["crack"]) + len(crack["points"]) > 3 or control_of(case) == "K":
        return None
    if has_initial_stress(case) or "region" in case or crack.get("contact", {}).get("friction"):
        return None
    is_along_y = lambda boundary: boundary["on"] in ("top", "bottom") and {"on", "case", "traction", "pressure"} >= boundary.keys()
    if not all(is_along_y(boundary) and boundary.get("traction", [0.0])[0] == 0.0 for boundary in case["boundary"]):
        return None
    base = copy.deepcopy(case)
    tip = base["crack"][0]["points"][1]
    base["crack"][0]["points"][0][1] = tip[1]  # at a right angle to the edge
    base.get("growth", {})["direction"] = "straight"
    twin = copy.deepcopy(base)
    base["boundary"].append({"on": "left", "displacement": [0.0, "free"]})
    twin["mesh"].update({"specimen": "plate", "width": 2 * width, "height": height_of(case)})
    twin["crack"][0]["points"] = [[width - tip[0], tip[1]], [width + tip[0], tip[1]]]
    change = lambda column, value: 2 * value if column in WORK | {"load"} else 1 if column == "tip" else value
    of_one_tip = without_rows(lambda row: row["tip"] == 0)
    return Twin(twin, base=base, change=change, of_base=history, of_twin=lambda tables: history(of_one_tip(tables)), without={"CMOD"})


def larger_zone(case, rng):
    """A zone larger than what flows and touches (docs/method.md, section 8). A new crack finds points where a zone has
    been, and their weights are fitted: so none that grows."""
    if "growth" in case or is_elastic(case) and not has_contact(case):
        return None
    base = copy.deepcopy(case)
    base.setdefault("fine", {})["subcells"] = 1
    base["fine"].pop("refine", None)
    twin = copy.deepcopy(base)
    twin["fine"]["radius"] = base["fine"].get("radius", 1.0) * rng.uniform(1.3, 4.0)
    return Twin(twin, base=base)


def stressed_and_let_go(case, rng):
    """A uniform stress that nothing holds is gone when it has come to equilibrium. Increments are given: a K of nothing
    is above zero or below, and with it whether a load goes on into compression."""
    if has_initial_stress(case) or "region" in case or is_moved(case) or control_of(case) == "displacement":
        return None
    base = copy.deepcopy(case)
    base["load"]["steps"] = 8
    twin = copy.deepcopy(base)
    stress = {key: rng.uniform(-40.0, 40.0) for key in ("xx", "yy", "xy")}
    twin["region"] = [{"outline": EVERYWHERE, "material": case["material"], "initial_stress": stress}]
    settles = lambda row: "load_factor" in row and row["increment"] == 1
    return Twin(twin, base=base, of_base=without_rows(lambda row: False), of_twin=without_rows(settles), without=WORK | {"displacement"})


def held(case, rng):
    """The misfit of a body that smooth plates hold against the way by which they would pull it as much."""
    if not is_plate(case) or has_initial_stress(case) or "region" in case:
        return None
    base = elastic(case)
    for key in ("growth", "load_case"):
        base.pop(key, None)
    base["model"] = {"plane": "stress"}  # where it contracts freely across
    base["boundary"] = [{"on": "right", "traction": [0.0, 0.1]}, {"on": "left", "traction": [0.0, -0.1]},
                        {"on": "top", "displacement": ["free", 0.0]}, {"on": "bottom", "displacement": ["free", 0.0]}]
    base["load"] = {"steps": 4, "blocks": [{"cycles": 1, "max": 50.0, "ratio": rng.choice([0.0, -1.0])}]}
    twin = copy.deepcopy(base)
    stress = rng.uniform(20.0, 60.0)
    base["boundary"][2] = {"on": "top", "displacement": ["free", stress / base["material"]["young"] * height_of(case)], "case": "plates"}
    base["load_case"] = [{"name": "plates", "constant": 1.0}]
    twin["region"] = [{"outline": EVERYWHERE, "material": base["material"], "initial_stress": {"yy": stress}}]
    return Twin(twin, base=base, of_base=turns, of_twin=turns, without=WORK | {"displacement"})


def machined_all_along(case, _rng):
    """Faces that cannot touch because they are a notch. Where they overlap K_op and J_max are other ones by name."""
    if "growth" in case or is_elastic(case):
        return None
    base, twin = copy.deepcopy(case), copy.deepcopy(case)
    for of in (base, twin):
        of.pop("closure", None)
    for crack in base["crack"]:
        crack.pop("contact", None)
    for crack in twin["crack"]:
        crack.update(contact={}, notch=length_of(crack) * 0.9999999)
    return Twin(twin, base=base, of_base=history, of_twin=history)


def smooth_all_along(case, _rng):
    """Friction that acts nowhere."""
    if not has_contact(case) or "growth" in case:
        return None
    base = copy.deepcopy(case)
    base["load"].setdefault("grading", 0.8)
    base.setdefault("closure", {}).setdefault("distance", 0.31)
    twin = copy.deepcopy(base)
    for crack, other in zip(base["crack"], twin["crack"]):
        if "contact" in crack:
            crack["contact"] = {}
            other["contact"] = {"friction": 0.4, "smooth": [0.0, 1.0001 * length_of(other)]}
    return Twin(twin, base=base)


def open_all_the_time(case, _rng):
    """Faces that may touch, and have not."""
    if "growth" in case or is_elastic(case):
        return None
    base = copy.deepcopy(case)
    base.pop("closure", None)
    for crack in base["crack"]:
        crack["contact"] = {}
    twin = copy.deepcopy(base)
    for crack in twin["crack"]:
        del crack["contact"]
    touches = lambda folder: any(row["contact_length"] > 0.0 for row in rows_of(folder))
    return Twin(lambda folder: None if touches(folder) else twin, base=base, of_base=history, of_twin=history)


def thick(case, _rng):
    twin = copy.deepcopy(case)
    twin.setdefault("model", {})["thickness"] = 7.0
    return Twin(twin, digits=True)


def grown_at_once(case, _rng):
    """An elastic crack without friction that has grown is the crack of its last points."""
    if len(case["crack"]) > 1 or case["mesh"].get("specimen") == "mt" or control_of(case) != "load":
        return None
    base = elastic(case)
    base["growth"] = {"increment": case.get("growth", {"increment": 0.4})["increment"]}

    def grown(folder):
        twin = copy.deepcopy(base)
        del twin["growth"]
        points = twin["crack"][0]["points"]
        for row in rows_of(folder):
            if math.dist([row["x"], row["y"]], points[-1]) > 1e-9:
                points.append([row["x"], row["y"]])
        return twin

    return Twin(grown, base=base, of_base=last_increment, of_twin=last_increment, without=WORK)


RELATIONS = [turned_by_a_right_angle, from_a_file, in_regions, in_another_order, half, larger_zone, stressed_and_let_go, held,
             machined_all_along, smooth_all_along, open_all_the_time, thick, grown_at_once]
