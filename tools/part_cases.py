"""Random cases of random parts: metals, supports, loads, what touches and what grows (random_parts.py)."""

import math
import tomllib

import random_lives as lives
from part_outlines import halves_of, mouth_of
from part_shapes import group_at

YOUNG = 200e3


def metal_of(rng, plastic):
    if plastic:
        return tomllib.loads(lives.material_of(rng))["material"]
    return {"young": YOUNG, "poisson": rng.choice([0.0, 0.3, 0.45])}


def other_metal(rng, plastic):
    metal = {"young": rng.choice([70e3, 120e3, 400e3]), "poisson": rng.choice([0.0, 0.3])}
    if plastic and rng.random() < 0.6:
        metal.update({"yield_stress": rng.uniform(150.0, 400.0), "isotropic": {"modulus": 2000.0}})
    return metal


def regions_of(part, plastic, rng):
    group = "insert" if part.insert else rng.choice(["half0", "half1"]) if part.chord else None
    if group is None:
        return []
    region = {"group": group, "material": other_metal(rng, plastic)}
    if rng.random() < 0.3:
        region["initial_stress"] = {key: rng.uniform(-40.0, 40.0) for key in ("xx", "yy", "xy")}
    return [region]


def outward(part, side):
    return [-x for x in mouth_of(part, side, 0.5)[2]]


def along(direction, size, turn=0.0):
    c, s = size * math.cos(turn), size * math.sin(turn)
    return [c * direction[0] - s * direction[1], s * direction[0] + c * direction[1]]


def corners_of(part, mesh):
    """Nodes at vertices that are sharp, but for those of the ends."""
    of_ends = {(side + k) % len(part.vertices) for side in part.ends for k in (0, 1)}
    sharp = [v for k, v in enumerate(part.vertices) if v[2] == 0 and k not in of_ends]
    return [node for node in mesh[0] if any(math.dist(node, v[:2]) < 1e-9 for v in sharp)]


def edge_names(mesh):
    return sorted({name for name, _, _ in mesh[2]})


def is_named_all_round(mesh):
    count = {}
    for cell in mesh[1]:
        for k, a in enumerate(cell):
            key = frozenset((a, cell[k - 1]))
            count[key] = count.get(key, 0) + 1
    return sum(n == 1 for n in count.values()) == len(mesh[2])


def loads_of(part, mesh, rng):
    """Boundaries that hold and load the part."""
    held, pulled = part.ends
    end = lambda: {"on": f"side{held}", "displacement": [0.0, 0.0]}
    pull, stretch = outward(part, pulled), along(outward(part, pulled), 1e-4, rng.uniform(-0.5, 0.5))
    on = f"side{pulled}"
    hole = rng.randrange(len(part.holes)) if part.holes else None
    kinds = ["traction", "traction", "moved", "moved", "pressure", "gradient", "around"]
    kinds += ["hole", "held hole", "pin", "pin", "both ends"] if part.holes else []
    kinds += ["point", "bar"] if corners_of(part, mesh) else []
    kind = rng.choice(kinds)
    if kind == "traction":
        return [{"on": on, "traction": along(pull, 1.0, rng.choice([0.0, rng.uniform(-1.2, 1.2)]))}, end()]
    if kind == "moved":
        more = [{"on": on, "displacement": stretch}, end()]
        are_neighbours = abs(held - pulled) in (1, len(part.vertices) - 1)
        return more if rng.random() < 0.6 or are_neighbours else more[:1] + [{"on": f"side{held}", "displacement": [-x for x in stretch]}]
    if kind == "pressure":
        return [{"on": on, "pressure": -1.0}, end()]
    if kind == "gradient":
        tensor = [[rng.uniform(-0.2, 0.2) for _ in range(2)] for _ in range(2)]
        return [{"on": on, "traction": pull, "traction_gradient": tensor, "origin": mouth_of(part, pulled, 0.5)[0]}, end()]
    if kind == "around":  # nothing is held
        names = edge_names(mesh) + ([] if is_named_all_round(mesh) else ["unnamed"])
        return [{"on": name, "pressure": -1.0} for name in names]
    if kind == "hole":
        return [{"on": f"hole{hole}", "pressure": 1.0}]
    if kind == "held hole":
        return [{"on": on, "traction": along(pull, 1.0, rng.uniform(-1.0, 1.0))}, {"on": f"hole{hole}", "displacement": [0.0, 0.0]}]
    if kind == "pin":
        x, y, _ = part.holes[hole]
        more = {"centre": [x, y]} if rng.random() < 0.7 else {}
        return [{"on": f"hole{hole}", "pressure": 1.0, "cosine": along(pull, 1.0, rng.uniform(-1.0, 1.0)), **more}, end()]
    if kind == "both ends":
        return [{"on": f"hole{hole}", "pressure": 0.7}, {"on": on, "traction": pull}, end()]
    corner = list(rng.choice(corners_of(part, mesh)))
    if kind == "point":
        return [{"on": "point", "at": corner, "force": along(pull, 4.0, rng.uniform(-1.0, 1.0))}, end()]
    return [{"on": on, "traction": pull}, end(), {"on": "point", "at": corner, "displacement": along(pull, 2e-5)}]


def dead_loads(part, case, rng):
    """A dead load, or one that lags, on the first boundary or in a hole."""
    name = rng.choice(["dead", "lagging"])
    how = {"constant": rng.choice([-0.3, 0.4])} if name == "dead" else {"factor": 0.3, "phase": rng.choice([0.0, 90.0])}
    boundary = dict(case["boundary"][0], case=name)
    if part.holes and rng.random() < 0.4 and case["boundary"][0]["on"] != "hole0" and not any(b["on"] == "hole0" for b in case["boundary"]):
        boundary = {"on": "hole0", "pressure": 0.5, "case": name}
    if "displacement" in boundary or boundary["on"] == "point":
        return
    is_free = not any("displacement" in b for b in case["boundary"])  # then its pressures balance, all together
    more = [dict(b, case=name) for b in case["boundary"]] if is_free and boundary["on"] == case["boundary"][0]["on"] else [boundary]
    case["boundary"] += more
    case["load_case"] = [{"name": name, **how}]


def history_of(size, rng):
    steps = rng.choice(["auto", 4, 4, 6, 8])
    ratio = rng.choice([-1.0, 0.0, 0.3, rng.uniform(-0.8, 0.5)])
    block = lambda count, factor: {"cycles": count, "max": factor * size, "ratio": ratio}
    blocks = [block(1, 1.0), block(1, 1.3), block(1, 1.0)] if rng.random() < 0.25 else [block(rng.randint(1, 3), 1.0)]
    return {"steps": steps, "blocks": blocks}


def with_growth(case, element, rng):
    growth = tomllib.loads(lives.growth_of(1, rng))["growth"]
    growth["increment"] = element * rng.uniform(0.3, 1.4)
    case["growth"] = growth


def case_of(part, mesh, cracks, element, rng):
    """The case, but for how large its loads are, which are those of the factor 1."""
    plastic, contact = rng.random() < 0.6, rng.random() < 0.6
    friction = rng.choice([0.0, 0.0, rng.uniform(0.1, 0.9)])
    case = {"title": "a part", "units": "N-mm-MPa", "model": {"plane": rng.choice(["strain", "stress"])}, "mesh": {"file": "body.msh"},
            "material": metal_of(rng, plastic), "region": regions_of(part, plastic, rng), "crack": [{"points": points} for points in cracks],
            "boundary": loads_of(part, mesh, rng), "load": history_of(1.0, rng), "solver": {"tolerance": 1e-11},
            "output": {"fields": "none", "checkpoint_every": rng.choice([0, 1, 2])}}
    for crack in case["crack"] if contact else ():
        crack["contact"] = {"friction": friction} if friction else {}
    if rng.random() < 0.25:
        dead_loads(part, case, rng)
    refine = rng.choice([1, 1, 2, 4])
    fine = {"refine": refine} if refine > 1 else {}
    if plastic or refine > 1:
        fine["radius"] = rng.uniform(1.0, 1.6)
    if rng.random() < 0.15:
        fine["enrichment"] = rng.choice(["none", "single", "topological"])
    case["fine"] = fine
    if rng.random() < 0.5:
        with_growth(case, element / refine, rng)
    if contact and rng.random() < 0.3:
        case["closure"] = tomllib.loads(lives.closure_of('"auto"' if case["load"]["steps"] == "auto" else "8", refine, rng))["closure"]
    return {key: value for key, value in case.items() if value != [] and value != {}}


def sized(case, times):
    for block in case["load"]["blocks"]:
        block["max"] *= times
    for load_case in case.get("load_case", []):
        load_case.update({"constant": load_case["constant"] * times} if "constant" in load_case else {})


def modulus_at(part, case, at):
    """E' there."""
    halves = halves_of(part) if part.chord else []
    of = next((region["material"] for region in case.get("region", []) if region["group"] == group_at(part, at, halves)), case["material"])
    return of["young"] / (1.0 - of["poisson"] ** 2) if case["model"]["plane"] == "strain" else of["young"]
