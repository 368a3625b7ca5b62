#!/usr/bin/python3
"""Makes the columns of cycles.csv anew from the increments of history.csv, and says where the two differ.

    tools/cross_check.py RESULTS

RESULTS is the folder of a run with output.history = "all" and one history of loads. Made anew are the columns that
docs/notation.md defines by increments or by one another: a, da, ranges, plastic zones, J_max, iterations, U, dK_eff, N,
the opening load by the compliance of the mouth, and the cycles that a law of da/dN takes (cross_check_lives.py); of
history.csv what is left of the balance of work; and the last values in summary.json. Exit code 1 where something differs.
tools/cross_check_fields.py looks at the fields.
"""

import csv
import json
import math
import sys
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cross_check_lives  # noqa: E402

EXACT, WRITTEN = 1e-9, 1e-6  # of a number that is copied; of one that is made of others


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: float(cell) if cell else math.nan for name, cell in row.items()} for row in csv.DictReader(file)]


def same(one, other, tolerance, size=0.0):
    if math.isnan(one) or math.isnan(other):
        return math.isnan(one) and math.isnan(other)
    return abs(one - other) <= tolerance * max(abs(one), abs(other), size) + 1e-12


def largest(rows, column):
    return max((row[column] for row in rows if not math.isnan(row[column])), default=math.nan)


def smallest(rows, column):
    return -largest([{column: -row[column]} for row in rows], column)


def tell_what_drives(case, history):
    """Notes in each row what the history of loads is of: the load factor, or the displacement that is controlled."""
    column = "displacement" if case["load"]["control"] == "displacement" else "load_factor"
    size = max(abs(row[column]) for row in history) or 1.0
    for row in history:
        row["driven"] = round(row[column] / size, 9)


def grows(row, before):
    """Whether a row is of new faces, at the load of the row in front of it."""
    return row["cycle"] == before["cycle"] and row["driven"] == before["driven"]


class Cycle:
    """The rows of a tip in a cycle. What grows at a maximum belongs to the cycle that begins there."""

    def __init__(self, rows, number):
        growth = [k > 0 and grows(rows[k], rows[k - 1]) for k in range(len(rows))]
        within = [k for k, row in enumerate(rows) if row["cycle"] == number]
        while growth[within[-1]]:
            within.pop()
        begin = within[0]
        while begin > 0 and growth[begin - 1]:
            begin -= 1
        self.before = rows[max(begin - 1, 0)]  # a first maximum of zero has no increment
        self.grown = rows[begin : within[0]]
        self.start = self.grown[-1] if self.grown else self.before
        own = [rows[k] for k in within]
        turn = min(range(len(own)), key=lambda k: own[k]["driven"])
        at_turn = [k for k in range(turn, len(own)) if own[k]["driven"] == own[turn]["driven"]]
        self.unloading, self.loading = own[: at_turn[-1] + 1], own[at_turn[-1] + 1 :]
        self.last = own[-1]
        # Where a crack grows at the minimum, loading begins with the longer one, at tips that stand too.
        self.at_growth = own[at_turn[-1]] if len(at_turn) > 1 else None
        self.of_range = own[at_turn[-1] :] if self.at_growth else [self.start] + own

    def least_opening(self, asked):
        """`asked`: the load factor of the minimum, where another one is asked of the longer crack; else NaN."""
        if self.at_growth is None or math.isnan(asked):
            return smallest(self.of_range, "opening")
        grown, following = self.at_growth, self.loading[0]
        way = following["load_factor"] - grown["load_factor"]
        part = (asked - grown["load_factor"]) / way
        there = grown["opening"] + part * (following["opening"] - grown["opening"])
        if grown["contact_length"] > 0.0:
            there = max(there, min(grown["opening"], 0.0))
        return min(there, smallest(self.loading, "opening"))

    def opened_by_offset(self, force):
        """The load factor at which the compliance at the mouth is 2 % below that of the open crack; NaN: nobody tells."""
        down = [self.start] + self.unloading
        up = self.unloading[-1:] + self.loading
        top, bottom = down[0][force], down[-1][force]
        upper = top - 0.25 * (top - bottom)
        k = next((k for k, row in enumerate(down) if k > 0 and row[force] <= upper), None)
        if k is None or not down[0]["CMOD"] - down[-1]["CMOD"] >= 1e-10:
            return math.nan
        part = (down[k - 1][force] - upper) / (down[k - 1][force] - down[k][force])
        there = down[k - 1]["CMOD"] + part * (down[k]["CMOD"] - down[k - 1]["CMOD"])
        of_open = (down[0]["CMOD"] - there) / (top - upper)
        longest = 0.1 * (up[-1][force] - up[0][force]) * (1.0 + 1e-9)
        above = None
        for row, before in zip(up[:0:-1], up[-2::-1]):
            segment = row[force] - before[force]
            if not (of_open > 0.0 and 0.0 < segment <= longest):
                return math.nan
            middle = 0.5 * (row["load_factor"] + before["load_factor"])
            offset = 1.0 - (row["CMOD"] - before["CMOD"]) / segment / of_open
            if offset >= 0.02:
                return middle + (above[0] - middle) * (offset - 0.02) / (offset - above[1]) if above else math.nan
            above = middle, offset
        return up[0]["load_factor"]

    def way(self, da):
        """From tip to tip or, where it turns on its way, what its crack grows by: what `da` is nearer to."""
        straight = math.hypot(self.last["x"] - self.before["x"], self.last["y"] - self.before["y"])
        return min(straight, self.last["a"] - self.before["a"], key=lambda way: abs(way - da))

    def columns(self, asked, da):
        rising = self.grown + self.loading
        everything = rising + self.unloading
        return {
            "a": (self.last["a"], EXACT),
            "da": (self.way(da), WRITTEN),
            "newton_iterations": (sum(row["newton_iterations"] for row in everything), EXACT),
            "forward_zone": (largest(rising, "plastic_zone"), WRITTEN),
            "cyclic_zone": (largest(self.unloading, "plastic_zone"), WRITTEN),
            "J_max": (largest(self.loading, "J"), WRITTEN),
            "opening_range": (largest(self.loading, "opening") - self.least_opening(asked), WRITTEN),
            "CTOD_range": (largest(self.loading, "CTOD") - smallest(self.of_range, "CTOD"), WRITTEN),
        }


def of_opening(row):
    """Of K_op; what U and dK_eff should be."""
    opened, whole = row["K_max"] - row["K_op"], row["K_max"] - row["K_min"]
    return {"U": opened / whole, "dK_eff": opened} if whole > 0.0 and not math.isnan(opened) else {}


def K_of_unit_load(row, end):
    """By `row` of a cycle and the increment at its `end`."""
    return (row["K_max"] - row["K_initial"]) / end["load_factor"]


def load_asked(row, end):
    """At the minimum of a cycle under control of K, by `row` of its first tip and the increment at its `end`."""
    return (row["K_min"] - row["K_initial"]) / K_of_unit_load(row, end)


def K_op_offset(case, row, cycle, unit):
    """Where only [load] makes K; else the one that is in the row. `unit`: K of unit load."""
    moves = any(x not in ("free", 0.0) for one in case["boundary"] if "case" not in one for x in one.get("displacement", []))
    if case.get("load_case") or not any("contact" in crack for crack in case["crack"]):
        return row["K_op_offset"]
    opened = cycle.opened_by_offset("load" if moves else "load_factor")
    return row["K_initial"] + unit * opened


def faults(folder):
    """Lines that say what differs."""
    case = tomllib.loads((folder / "case.resolved.toml").read_text(encoding="utf-8"))
    history, cycles = table(folder / "history.csv"), table(folder / "cycles.csv")
    tell_what_drives(case, history)
    by_load = folder / "load-cases.csv"
    units = {(row["cycle"], row["tip"]): row["K_I"] for row in table(by_load)} if by_load.exists() else {}
    wrong, N, fell = [], 0.0, {}
    for row in cycles:
        name = f"cycle {row['cycle']:g}, tip {row['tip']:g}"
        size = abs(row["K_max"])
        cycle = Cycle([one for one in history if one["tip"] == row["tip"]], row["cycle"])
        falls_on = fell.get(row["tip"], False)  # a cycle whose own maximum is below its minimum, and the one behind it
        fell[row["tip"]] = not cycle.loading
        known = units.get((row["cycle"], row["tip"]), math.nan)
        unit = known if units else K_of_unit_load(row, cycle.last) if cycle.last["load_factor"] != 0.0 else math.nan
        if falls_on or not cycle.loading or unit <= 0.0:  # or a tip that closes as the load rises
            N += row["dN"] if row["tip"] == cycles[0]["tip"] else 0.0
            continue
        if row["tip"] == cycles[0]["tip"]:
            asked = load_asked(row, cycle.last) if case["load"]["control"] == "K" else math.nan
        expected = cycle.columns(asked, row["da"])
        if math.isnan(row["J_max"]) and "contact" not in str(case["crack"]):
            del expected["J_max"]  # faces that are pressed overlap all the way
        elif row["J_max"] < expected["J_max"][0]:  # without contact pressed faces overlap, and do not count
            open_ones = [one for one in cycle.loading if row["K_max"] >= unit * (cycle.last["load_factor"] - one["load_factor"])]
            expected["J_max"] = largest(open_ones, "J"), WRITTEN
        expected |= {column: (value, WRITTEN) for column, value in of_opening(row).items()}
        if row["tip"] == cycles[0]["tip"]:
            N += row["dN"]
        expected["N"] = N, WRITTEN
        expected["K_op_offset"] = K_op_offset(case, row, cycle, unit), WRITTEN
        for column, (value, tolerance) in expected.items():
            if not same(row[column], value, tolerance, size if column in ("dK_eff", "K_op_offset") else 0.0):
                wrong.append(f"{name}: {column} is {row[column]:.9g}, by increments {value:.9g}")
        if row["K_op"] > row["K_max"] + WRITTEN * size or row["K_op"] < row["K_min"] - WRITTEN * size:
            wrong.append(f"{name}: K_op {row['K_op']:.9g} is outside {row['K_min']:.9g} to {row['K_max']:.9g}")
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return wrong + cross_check_lives.faults(case, history, cycles) + unbalanced(history) + other_ends(summary, history, cycles)


def other_ends(summary, history, cycles):
    """Last values in summary.json that are not those of the tables."""
    wrong = []
    for tip in summary["tips"]:
        last = [row for row in history if row["tip"] == tip["tip"]][-1]
        wrong += [f"summary.json: {name} of tip {tip['tip']} is {value}, in history.csv {last[name]:.9g}"
                  for name, value in tip.items() if name in last and not same(math.nan if value is None else value, last[name], EXACT)]
    if cycles and summary["N"] is not None and not same(summary["N"], cycles[-1]["N"], EXACT):
        wrong.append(f"summary.json: N is {summary['N']}, in cycles.csv {cycles[-1]['N']:.9g}")
    return wrong


def unbalanced(history):
    """Increments whose balance_error is not what the other columns leave, but for a constant: an initial stress."""
    left = [
        row["external_work"] - row["stored_energy"] - row["dissipation"] - row["released_energy"] - row["balance_error"]
        for row in history
    ]
    rounding = WRITTEN * max(abs(row["external_work"]) for row in history)
    return [
        f"increment {row['increment']:g}: balance_error is {value - left[0]:.3g} off"
        for row, value in zip(history, left)
        if abs(value - left[0]) > rounding
    ]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.split("\n\n")[1].strip())
    wrong = faults(Path(sys.argv[1]))
    print("\n".join(wrong) if wrong else "cycles.csv is what history.csv makes it")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
