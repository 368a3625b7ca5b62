#!/usr/bin/python3
"""Compares two CSV tables of a run column by column: largest difference over the largest value of the column.

    tools/compare_tables.py BEFORE.csv AFTER.csv
"""

import csv
import sys


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(cell):
    return float(cell) if cell else 0.0


def difference(before, after, column):
    pairs = [(number(one[column]), number(other[column])) for one, other in zip(before, after)]
    largest = max(abs(one) for one, _ in pairs)
    return max(abs(other - one) for one, other in pairs) / (largest or 1.0)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    before, after = read(sys.argv[1]), read(sys.argv[2])
    if len(before) != len(after):
        sys.exit(f"{len(before)} rows before, {len(after)} after")
    if not before:
        return
    for column in before[0]:
        print(f"{column:24s} {difference(before, after, column):.2g}" if column in after[0] else f"{column:24s} gone")
    for column in after[0]:
        if column not in before[0]:
            print(f"{column:24s} new")


if __name__ == "__main__":
    main()
