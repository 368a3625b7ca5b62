#!/usr/bin/python3
"""Checks docs/equations.md: every equation that the sources cite has a row, and every file:name and test of it exists; and every
file:name of docs/theory.md and docs/architecture.md."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TABLE = "docs/equations.md"
CHAINS = ("docs/theory.md", "docs/architecture.md")
SOURCES = ("app", "common", "coupling", "coarse", "fine", "tests", "bench")

# "eq. (3)", "Eq. (1), (2)", "equation 2", and each further number in its chain.
CITATION = re.compile(r"\b(?:eqs?\.|equations?)\s*((?:\(\d+\)|\d+\b)(?:\s*(?:,|and|to)\s*\(\d+\))*)", re.IGNORECASE)
ROW = re.compile(r"^\|\s*eq\. \((\d+)\)\s*\|")
PLACE = re.compile(r"`([\w/.-]+\.[hc]pp):(~?\w+)`")
TEST = re.compile(r"`(?:unit|verification|coupling|end_to_end)\.([\w*]+)\.?([\w*]*)`")


def tests():
    """Suite.Name of every test in the sources."""
    found = []
    for file in (ROOT / "tests").rglob("*_test.cpp"):
        found += [f"{suite}.{name}" for suite, name in re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", file.read_text(encoding="utf-8"), re.MULTILINE)]
    return found


def citations():
    for folder in SOURCES:
        for file in sorted((ROOT / folder).rglob("*.[hc]pp")):
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                for chain in CITATION.findall(line):
                    for equation in re.findall(r"\d+", chain):
                        yield file.relative_to(ROOT).as_posix(), number, equation


def complaint(path, name):
    """What is wrong with a place of the table, or nothing. A function that is only declared there does not count."""
    file = ROOT / path
    if not file.is_file():
        return f"there is no {path}"
    text = file.read_text(encoding="utf-8")
    is_type = rf"\b(?:class|struct|enum)\s+{name}\b"
    # The name and its parameters, then a body; a call ends in a semicolon or stands inside an expression.
    is_function = rf"\b{name}\s*\([^;{{}}]*\)\s*(?:const|noexcept|override|\s)*\{{"
    if not re.search(f"{is_type}|{is_function}", text):
        return f"{path} defines no {name}"
    return None


def main():
    found = 0

    def report(text):
        nonlocal found
        found += 1
        print(text)

    lines = (ROOT / TABLE).read_text(encoding="utf-8").splitlines()
    rows = {row.group(1) for row in map(ROW.match, lines) if row}
    known_tests = tests()
    places = 0
    for page in (TABLE, *CHAINS):
        for number, line in enumerate((ROOT / page).read_text(encoding="utf-8").splitlines(), 1):
            for path, name in PLACE.findall(line):
                places += 1
                if problem := complaint(path, name):
                    report(f"{page}:{number}: {problem}")
    for number, line in enumerate(lines, 1):
        for suite, name in TEST.findall(line):
            pattern = re.compile(f"{suite}.{name}".replace(".", r"\.").replace("*", ".*"))
            hits = pattern.match if "*" in suite + name else pattern.fullmatch
            if not any(map(hits, known_tests)):
                report(f"{TABLE}:{number}: there is no test {suite}.{name}")
    if not rows or not places:
        report(f"{TABLE}: no table of equations found")
    for path, number, equation in citations():
        if equation not in rows:
            report(f"{path}:{number}: eq. ({equation}) has no row in {TABLE}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
