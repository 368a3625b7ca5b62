"""The cycles that a growth takes, by the rates of da/dN before and behind it (tools/cross_check.py).

Made anew where the load is one sequence of equal cycles, nothing lags, and no tip turns: the rate of a tip that has just
turned is in no table.
"""

import math

WRITTEN = 1e-6
TURNS = 0.01  # K_II over K_I: beyond it a tip may turn sharply


def driving_range(growth, row):
    """What drives a law of dK, MPa sqrt(mm)."""
    if growth["driving"] == "dK_eff":
        return row["K_max"] - row["K_op"]
    if growth["driving"] == "dK_full":
        return row["K_max"] - row["K_min"]
    R = row["K_min"] / row["K_max"] if row["K_min"] > 0.0 else 0.0
    return max(row["K_max"], 0.0) * (1.0 - R) ** growth.get("walker", 1.0)


def rate(growth, row):
    """da/dN, mm per cycle."""
    if growth["law"] == "ctod":
        return growth["C"] * row["opening_range"] ** growth["m"]
    dK = driving_range(growth, row)
    if not dK > 0.0:
        return 0.0
    if growth["law"] == "paris":
        return growth["C"] * dK ** growth["m"] if dK >= growth.get("threshold", 0.0) else 0.0
    ranges, rates = growth["ranges"], growth["rates"]
    if dK < ranges[0]:
        return 0.0
    k = min(max(k for k, one in enumerate(ranges) if one <= dK), len(ranges) - 2)
    slope = math.log(rates[k + 1] / rates[k]) / math.log(ranges[k + 1] / ranges[k])
    return rates[k] * (dK / ranges[k]) ** slope


def is_one_sequence(case):
    load, growth = case["load"], case.get("growth")
    if growth is None or growth["law"] == "prescribed" or growth["every"] != 1 or case.get("load_case"):
        return False
    return len({(block["max"], block["min"]) for block in load["blocks"]}) == 1


def faults(case, history, cycles):
    """Lines that say which dN is none of the law's."""
    if not is_one_sequence(case):
        return []
    turning = {row["cycle"] for row in history if abs(row["K_II"]) > TURNS * abs(row["K_I"])}
    by_cycle = {}
    for row in cycles:
        by_cycle.setdefault(row["cycle"], []).append(row)
    wrong, counted = [], True
    for cycle, rows in sorted(by_cycle.items()):
        before, fastest = by_cycle.get(cycle - 1), max(range(len(rows)), key=lambda t: rows[t]["da"])
        row = rows[fastest]
        if before is None or not row["da"] > 0.0:
            continue
        rates = [rate(case["growth"], one[fastest]) for one in (before, rows)]
        waits, counted = not counted, row["dN"] > 0.0  # behind a sharp turn growth is counted later
        if waits or not counted or not min(rates) > 0.0 or turning & {cycle - 1, cycle}:
            continue
        dN = 0.5 * row["da"] * (1.0 / rates[0] + 1.0 / rates[1])
        if abs(dN - row["dN"]) > WRITTEN * dN:
            wrong.append(f"cycle {cycle:g}: dN is {row['dN']:.9g}, by the rates {dN:.9g}")
    return wrong
