#!/usr/bin/python3
"""Makes the columns of cycles.csv anew from the increments of history.csv, and says where the two differ.

    tools/cross_check.py RESULTS

RESULTS is the folder of a run with output.history = "all" and one history of loads. Made anew are the columns that
docs/notation.md defines by increments or by one another: a, da, ranges, plastic zones, J_max, iterations, U, dK_eff, N;
and of history.csv what is left of the balance of work. Exit code 1 where something differs.
"""

import csv
import math
import sys
from pathlib import Path

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


def grows(row, before):
    """Whether a row is of new faces, at the load of the row in front of it."""
    return row["cycle"] == before["cycle"] and row["load_factor"] == before["load_factor"]


class Cycle:
    """The rows of a tip in a cycle. What grows at a maximum belongs to the cycle that begins there."""

    def __init__(self, rows, number):
        growth = [k > 0 and grows(rows[k], rows[k - 1]) for k in range(len(rows))]
        within = [k for k, row in enumerate(rows) if row["cycle"] == number]
        while growth[within[-1]]:
            within.pop()
        begin = within[0]
        while growth[begin - 1]:
            begin -= 1
        self.before = rows[begin - 1]
        self.grown = rows[begin : within[0]]
        own = [rows[k] for k in within]
        turn = min(range(len(own)), key=lambda k: own[k]["load_factor"])
        at_turn = [k for k in range(turn, len(own)) if own[k]["load_factor"] == own[turn]["load_factor"]]
        self.unloading, self.loading = own[: at_turn[-1] + 1], own[at_turn[-1] + 1 :]
        self.last = own[-1]
        # Where a crack grows at the minimum, loading begins with the longer one, at tips that stand too.
        self.at_growth = own[at_turn[-1]] if len(at_turn) > 1 else None
        self.of_range = own[at_turn[-1] :] if self.at_growth else own

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


def load_asked(row, end):
    """At the minimum of a cycle under control of K, by `row` of its first tip and the increment at its `end`."""
    K_of_unit_load = (row["K_max"] - row["K_initial"]) / end["load_factor"]
    return (row["K_min"] - row["K_initial"]) / K_of_unit_load


def faults(folder):
    """Lines that say what differs."""
    controls_K = 'control = "K"' in (folder / "case.resolved.toml").read_text(encoding="utf-8")
    history, cycles = table(folder / "history.csv"), table(folder / "cycles.csv")
    wrong, N = [], 0.0
    for row in cycles:
        name = f"cycle {row['cycle']:g}, tip {row['tip']:g}"
        size = abs(row["K_max"])
        cycle = Cycle([one for one in history if one["tip"] == row["tip"]], row["cycle"])
        if row["tip"] == cycles[0]["tip"]:
            asked = load_asked(row, cycle.last) if controls_K else math.nan
        expected = cycle.columns(asked, row["da"])
        if row["J_max"] < expected["J_max"][0]:  # without contact pressed faces overlap, and do not count
            expected["J_max"] = largest([one for one in cycle.loading if one["load_factor"] >= 0.0], "J"), WRITTEN
        expected |= {column: (value, WRITTEN) for column, value in of_opening(row).items()}
        if row["tip"] == cycles[0]["tip"]:
            N += row["dN"]
        expected["N"] = N, WRITTEN
        for column, (value, tolerance) in expected.items():
            if not same(row[column], value, tolerance, size if column == "dK_eff" else 0.0):
                wrong.append(f"{name}: {column} is {row[column]:.9g}, by increments {value:.9g}")
        if row["K_op"] > row["K_max"] + WRITTEN * size or row["K_op"] < row["K_min"] - WRITTEN * size:
            wrong.append(f"{name}: K_op {row['K_op']:.9g} is outside {row['K_min']:.9g} to {row['K_max']:.9g}")
    return wrong + unbalanced(history)


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
