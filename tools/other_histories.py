"""The same loads told otherwise: another spelling of a history, another control, shares of a load. Each function gives
the twin of a case (twins.py), or None where it has none."""

import copy

from other_bodies import WORK, control_of, elastic, has_initial_stress, is_moved
from twins import Twin, history, rows_of, turning, turns, until_last_cycle

NORMAL = {"top": (0.0, 1.0), "bottom": (0.0, -1.0), "left": (-1.0, 0.0), "right": (1.0, 0.0)}


def extremes_of(case):
    return [(block["max"], block["min"] if "min" in block else block["max"] * block["ratio"])
            for block in case["load"]["blocks"] for _ in range(block.get("cycles", 1))]


def are_turns(pairs):
    """Whether each extreme lies beyond those beside it, and the first is above zero."""
    rise_again = all(low < later for (_, low), (later, _) in zip(pairs, pairs[1:]))
    return pairs[0][0] > 0.0 and all(high > low for high, low in pairs) and rise_again


def with_extremes(case, values, control):
    """None where they are no cycles."""
    pairs = list(zip(values[0::2], values[1::2]))
    if not are_turns(pairs):
        return None
    twin = copy.deepcopy(case)
    twin["load"].update(control=control, blocks=[{"cycles": 1, "max": high, "min": low} for high, low in pairs])
    return twin


def told(folder, column):
    """A column at the extremes that a run has had: at a maximum, at a minimum and so on."""
    extremes = {}
    for increment in turning(rows_of(folder)):
        row = increment[0]
        if not extremes or list(extremes.values())[-1][0] != row["load_factor"]:
            extremes[row["increment"]] = (row["load_factor"], row[column])
    return [value for _, value in extremes.values()]


def repeated(case, _rng):
    """Blocks written out, or a sequence that repeats."""
    base = copy.deepcopy(case)
    block = dict(base["load"]["blocks"][0], cycles=1)
    once = [block, {"cycles": 1, "max": 0.7 * block["max"], "ratio": 0.2}]
    base["load"]["blocks"] = once * 2
    twin = copy.deepcopy(base)
    twin["load"].update(blocks=once, repeat=2)
    return Twin(twin, base=base)


def by_turning_points(case, _rng):
    pairs = extremes_of(case)
    if not are_turns(pairs):
        return None
    twin = copy.deepcopy(case)
    del twin["load"]["blocks"]
    twin["load"]["spectrum"] = "turning.csv"
    lines = "".join(f"{point!r}\n" for pair in pairs for point in pair)
    return Twin(twin, files={"turning.csv": "turning_point\n" + lines}, digits=True)


def K_as_a_load(case, _rng):
    """The load factors that a K has asked for. A law hears the K that is asked for, and a refined mesh goes by the
    largest K of the history, which a growing crack makes another one."""
    if control_of(case) != "K":
        return None
    base = copy.deepcopy(case)
    base["load"].update(steps=8, grading=1.0, blocks=[dict(case["load"]["blocks"][0], cycles=3)])
    base.get("fine", {}).pop("refine", None)
    view = until_last_cycle
    if "growth" in base:
        base["growth"] = {"increment": case["growth"]["increment"]}
        view = lambda tables: history(until_last_cycle(tables))
    return Twin(lambda folder: with_extremes(base, told(folder, "load_factor"), "load"), base=base, of_base=view, of_twin=view)


def in_the_other_control(case, _rng):
    """The loads that controlled displacements have asked for, or the other way about: elastic, at the extremes."""
    control = {"load": "displacement", "displacement": "load"}.get(control_of(case))
    first = case["boundary"][0]
    if not control or "displacement" in first or first["on"] == "point" or any("constant" not in of for of in case.get("load_case", [])):
        return None
    base = elastic(case)
    base.pop("growth", None)
    column = "displacement" if control == "displacement" else "load_factor"
    return Twin(lambda folder: with_extremes(base, told(folder, column), control) if are_turns(extremes_of(base)) else None,
                base=base, of_base=turns, of_twin=turns, without=WORK)


def with_any_increments(case, _rng):
    """An elastic body without friction does not know how it got where it is."""
    base = elastic(case)
    base["load"]["steps"] = 8
    twin = copy.deepcopy(base)
    twin["load"]["steps"] = 2
    return Twin(twin, base=base, of_base=turns, of_twin=turns, without=WORK)


def share_of(boundary, share):
    """A boundary with a part of its loads."""
    part = copy.deepcopy(boundary)
    for key in ("traction", "force"):
        if key in part:
            part[key] = [share * x for x in part[key]]
    if "traction_gradient" in part:
        part["traction_gradient"] = [[share * x for x in row] for row in part["traction_gradient"]]
    if "pressure" in part:
        part["pressure"] *= share
    return part


def in_two_tractions(case, _rng):
    """Each edge listed twice, with shares of its load."""
    twin = copy.deepcopy(case)
    is_even = lambda boundary: {"traction", "pressure"} & boundary.keys()
    twin["boundary"] = [part for boundary in case["boundary"]
                        for part in ([share_of(boundary, 0.3), share_of(boundary, 0.7)] if is_even(boundary) else [boundary])]
    return Twin(twin) if len(twin["boundary"]) > len(case["boundary"]) else None


def as_pressures(case, _rng):
    """The normal part of each traction as a pressure, or as that of a flat pin."""
    twin, parts = copy.deepcopy(case), []
    for k, boundary in enumerate(case["boundary"]):
        normal = NORMAL.get(boundary["on"])
        if normal is None or "traction" not in boundary or "traction_gradient" in boundary:
            parts.append(boundary)
            continue
        pull = sum(n * t for n, t in zip(normal, boundary["traction"]))
        rest = [t - pull * n for n, t in zip(normal, boundary["traction"])]
        of_case = {"case": boundary["case"]} if "case" in boundary else {}
        pin = {"cosine": [-n for n in normal]} if k % 2 else {}
        parts += [{"on": boundary["on"], "pressure": -pull, **pin, **of_case}] if pull else []
        parts += [{"on": boundary["on"], "traction": rest, **of_case}] if any(rest) else []
    twin["boundary"] = parts
    return Twin(twin) if parts != case["boundary"] else None


def in_two_cases(case, _rng):
    """A part of the loads in a load case that goes with them. Beside load cases no mesh awaits that a crack turns
    (refined_scene)."""
    if control_of(case) != "load" or "load_case" in case or is_moved(case):
        return None
    base = copy.deepcopy(case)
    base["load"].setdefault("grading", 0.7)
    if "growth" in base:
        base["growth"]["direction"] = "straight"
    twin = copy.deepcopy(base)
    twin["boundary"] = [share_of(boundary, 0.6) for boundary in case["boundary"]]
    twin["boundary"] += [dict(share_of(boundary, 0.4), case="beside") for boundary in case["boundary"]]
    twin["load_case"] = [{"name": "beside", "factor": 1.0}]
    return Twin(twin, base=base, without={"load", "displacement"})


def cases_by_blocks(case, _rng):
    """A load case that goes with the load, by its factors at the extremes."""
    driven = [boundary for boundary in case["boundary"] if "displacement" not in boundary]
    if "load_case" in case or control_of(case) != "load" or not driven:
        return None
    base = copy.deepcopy(case)
    base["load"].setdefault("grading", 0.7)
    base["boundary"] += [dict(boundary, case="beside") for boundary in copy.deepcopy(driven)]
    twin = copy.deepcopy(base)
    base["load_case"] = [{"name": "beside", "factor": 0.3}]
    twin["load_case"] = [{"name": "beside", "blocks": [{"at_max": 0.3 * high, "at_min": 0.3 * low} for high, low in extremes_of(case)]}]
    return Twin(twin, base=base)


def on_a_dead_load(case, _rng):
    """What is added to all extremes as a load that stays: elastic, at the extremes."""
    if control_of(case) != "load" or "load_case" in case or is_moved(case):
        return None
    base = elastic(case)
    twin = copy.deepcopy(base)
    shift = 0.3 * case["load"]["blocks"][0]["max"]
    base["load"]["blocks"] = [{"cycles": 1, "max": high + shift, "min": low + shift} for high, low in extremes_of(case)]
    twin["boundary"] += [dict(boundary, case="dead") for boundary in copy.deepcopy(case["boundary"])]
    twin["load_case"] = [{"name": "dead", "constant": shift}]
    return Twin(twin, base=base, of_base=turns, of_twin=turns, without=WORK | {"load", "displacement", "load_factor"})


def after_small_cycles(case, _rng):
    """Two cycles in which nothing flows, before all others."""
    if control_of(case) != "load" or "growth" in case or "load_case" in case or has_initial_stress(case) or not are_turns(extremes_of(case)):
        return None
    base = copy.deepcopy(case)
    base["load"].update(steps=10, grading=1.0)
    base.pop("closure", None)
    for crack in base["crack"]:
        crack.get("contact", {}).pop("friction", None)
    twin = copy.deepcopy(base)
    twin["load"]["blocks"].insert(0, {"cycles": 2, "max": 1e-4 * extremes_of(case)[0][0], "min": 0.0})
    ahead = 4  # extremes
    behind = lambda tables: {"history.csv": [dict(row, increment=row["increment"] - ahead) for row in turns(tables)["history.csv"]
                                             if row["increment"] >= ahead]}
    return Twin(twin, base=base, of_base=turns, of_twin=behind)


def rates_by_a_table(case, rng):
    """Paris' law is a straight line of logarithms."""
    if "growth" not in case:
        return None
    base, m = copy.deepcopy(case), rng.uniform(2.0, 4.0)
    base["growth"] = {"law": "paris", "C": 1e-13, "m": m, "increment": case["growth"]["increment"], "threshold": 30.0}
    twin = copy.deepcopy(base)
    twin["growth"] = {"law": "table", "ranges": [30.0, 600.0], "rates": [1e-13 * K**m for K in (30.0, 600.0)],
                      "increment": case["growth"]["increment"]}
    return Twin(twin, base=base)


def by_walker(case, rng):
    """At one load ratio Walker's exponent is a factor of C."""
    if "growth" not in case or "load_case" in case or control_of(case) == "displacement" or has_initial_stress(case):
        return None
    base, w, ratio = copy.deepcopy(case), rng.uniform(0.3, 0.9), rng.choice([0.0, 0.3, 0.5])
    base["load"]["blocks"] = [{"cycles": 3, "max": case["load"]["blocks"][0]["max"], "ratio": ratio}]
    base["growth"] = {"law": "paris", "C": 1e-13, "m": 3.0, "increment": case["growth"]["increment"]}
    twin = copy.deepcopy(base)
    base["growth"]["C"] *= (1.0 - ratio)**(3.0 * (w - 1.0))
    twin["growth"]["walker"] = w
    return Twin(twin, base=base)


def looked_at_from_elsewhere(case, rng):
    """The opening loads at a distance of closure.profile are those of a crack that is looked at there."""
    if not any("contact" in crack for crack in case["crack"]):
        return None
    base = copy.deepcopy(case)
    base["load"]["steps"] = 8
    if "growth" in base:
        base["growth"] = {"increment": case["growth"]["increment"]}
    near, far = rng.uniform(0.1, 0.6), rng.uniform(0.7, 1.2)
    twin = copy.deepcopy(base)
    base["closure"], twin["closure"] = {"distance": near, "profile": [far]}, {"distance": far, "profile": [near]}
    view = lambda tables, rows: {"history.csv": tables["history.csv"], "closure": [{"K_op": K_op, "K_cl": row["K_cl"]} for row, K_op in rows]}
    of_far = lambda tables: view(tables, [(row, row["K_op"]) for row in tables["closure.csv"][1::2]])  # behind the one that is near
    of_cycles = lambda tables: view(tables, [(row, row["K_op_contact"]) for row in tables["cycles.csv"]])
    return Twin(twin, base=base, of_base=of_far, of_twin=of_cycles, without={"opening"})


def written_otherwise(case, rng):
    twin = copy.deepcopy(case)
    twin["coupling"] = {"state": rng.choice(["increment", "newton"])}
    twin["output"] = {"fields": rng.choice(["all", "cycles"]), "faces": rng.choice(["all", "none"]),
                      "format": rng.choice(["vtu", "vtkhdf"]), "checkpoint_every": 1}
    return Twin(twin, digits=True)


def written_less(case, _rng):
    """All increments that it passes over are computed all the same, but for K of the real body."""
    twin = copy.deepcopy(case)
    twin["output"] = dict(case["output"], history="cycles")
    cycles = lambda tables: {name: rows for name, rows in tables.items() if name != "history.csv"}
    return Twin(twin, of_base=cycles, of_twin=cycles)


RELATIONS = [repeated, by_turning_points, K_as_a_load, in_the_other_control, with_any_increments, in_two_tractions, as_pressures,
             in_two_cases, cases_by_blocks, on_a_dead_load, after_small_cycles, rates_by_a_table, by_walker, looked_at_from_elsewhere,
             written_otherwise, written_less]
