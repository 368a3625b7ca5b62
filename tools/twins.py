"""What a twin is, and the views of a run's tables in which two runs must agree (random_twins.py)."""

import csv
from dataclasses import dataclass, field


def same(_column, value):
    return value


def all_rows(tables):
    return tables


@dataclass
class Twin:
    """A case told otherwise. `case` may be a function of the folder of the run that it is the twin of; it gives None
    where that run has no such twin."""

    case: object
    mesh: object = None
    change: object = same  # what becomes of a number of the other run, by its column
    base: object = None  # the case that it is the twin of, where that is not the one of the seed
    of_base: object = all_rows  # the view of the other run's tables
    of_twin: object = all_rows
    without: set = field(default_factory=set)  # columns that may differ
    digits: bool = False  # the same to the last digit
    files: dict = field(default_factory=dict)  # name and content of what the case refers to


def rows_of(folder):
    """history.csv as it is written."""
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        return [{key: float(cell or "nan") for key, cell in row.items()} for row in csv.DictReader(file)]


def per_increment(rows):
    """Rows of history.csv as lists of those of one increment each."""
    found = []
    for row in rows:
        if found and found[-1][0]["increment"] == row["increment"]:
            found[-1].append(row)
        else:
            found.append([row])
    return found


def counted_anew(increments):
    return [dict(row, increment=k) for k, increment in enumerate(increments) for row in increment]


def turning(rows):
    """Of history.csv the increments at which the load factor turns: growth at an extreme among them."""
    increments = per_increment(rows)
    factors = [increment[0]["load_factor"] for increment in increments]
    kept, way = [], 0.0
    for k, increment in enumerate(increments):
        way = factors[k] if k == 0 else factors[k] - factors[k - 1] or way
        ahead = next((factor - factors[k] for factor in factors[k + 1:] if factor != factors[k]), 0.0)
        if way != 0.0 and way * ahead <= 0.0:
            kept.append(increment)
    return kept


def turns(tables):
    """Of history.csv alone, where the load turns."""
    return {"history.csv": counted_anew(turning(tables["history.csv"]))}


def history(tables):
    return {"history.csv": tables["history.csv"]}


def last_increment(tables):
    return {"history.csv": counted_anew(per_increment(tables["history.csv"])[-1:])}


def without_rows(is_left_out):
    def view(tables):
        kept = {name: [row for row in rows if not is_left_out(row)] for name, rows in tables.items()}
        kept["history.csv"] = counted_anew(per_increment(kept["history.csv"]))
        return kept
    return view


def until_last_cycle(tables):
    """Not the last cycle, which returns to its own maximum."""
    last = max(row["cycle"] for row in tables["history.csv"])
    return {name: [row for row in rows if row["cycle"] < last] for name, rows in tables.items()}
