#!/usr/bin/python3
"""Makes the table of docs/verification.md: what the verification tests compare with references, and how near they come.

    tools/verification_table.py build/release/bin/stria_verification_tests [--long] [--filter PATTERN] [--write]
        [--resume FILE]

Runs the tests and prints a row for each comparison that they assert; a row that fails says so. `--long` runs the long
tests, too. `--write` puts the table into docs/verification.md, in place of the one there. `--resume` keeps what each test
has written in a file: another call with it runs only the tests that are not in it yet. Needs only Python's standard
library. Exit code 1 where a test fails.
"""

import argparse
import csv
import json
import math
import os
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

DOCUMENT = Path(__file__).resolve().parent.parent / "docs/verification.md"
TESTS = Path(__file__).resolve().parent.parent / "tests/verification"
BEGIN, END = "<!-- table: made by tools/verification_table.py -->\n", "<!-- end of the table -->\n"
NAMES = ["case", "source", "quantity", "reference", "ours", "error", "mesh", "s"]
FIELDS = ["case", "source", "quantity", "reference", "ours", "error", "within", "mesh", "seconds", "verdict", "test"]


def suites():
    """Of the sources that compare anything with a reference, as a filter."""
    texts = (file.read_text(encoding="utf-8") for file in sorted(TESTS.rglob("*_test.cpp")))
    found = {name for text in texts if re.search(r"\b(verify|rows_of)\(", text) for name in re.findall(r"^TEST(?:_\w)?\((\w+),", text, re.M)}
    return ":".join(f"{name}.*:*/{name}.*" for name in sorted(found))


def names_of(program, tests):
    """One by one."""
    listed = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={tests}"], check=True, capture_output=True, text=True).stdout
    names, suite = [], ""
    for text in listed.splitlines():
        if re.match(r"\S+\.(\s|$)", text):
            suite = text.split()[0]
        elif text.startswith("  "):
            names.append(suite + text.split()[0])
    return names


def result_of(program, test):
    """The rows that a test writes, whether it fails, and its seconds of CPU time, which other programs leave as they are."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "rows.csv"
        file.touch()
        environment = dict(os.environ, STRIA_VERIFICATION=str(file), OPENBLAS_NUM_THREADS="1")
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        process = subprocess.run([program, f"--gtest_filter={test}"], env=environment, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if "[==========]" not in process.stdout:
            sys.exit(f"{test}: {process.stdout[-2000:]}{process.stderr[-2000:]}")
        with open(file, newline="", encoding="utf-8") as rows:
            return {"rows": list(csv.reader(rows)), "fails": process.returncode != 0, "seconds": seconds}


def results_of(program, tests, kept):
    """By test, in the order of the program; `kept`: a file of earlier results, or None."""
    found = json.loads(kept.read_text(encoding="utf-8")) if kept and kept.exists() else {}
    names = names_of(program, tests)
    for name in names:
        if name not in found:
            found[name] = result_of(program, name)
            if kept:
                kept.write_text(json.dumps(found), encoding="utf-8")
    return {name: found[name] for name in names}


def entry(row):
    """Number of the entry of docs/references.md, which orders the table; what has none comes last."""
    found = re.search(r"\((\d+)\.(\d+)\)", row["source"])
    return (int(found[1]), int(found[2])) if found else (99, 0)


def worst_of_alike(rows):
    """Two tips, or two signs, of one case are one row: the worse."""
    kept = {}
    for row in rows:
        key = (row["case"], row["quantity"], row["mesh"], row["reference"])
        if key not in kept or abs(float(row["error"])) > abs(float(kept[key]["error"])):
            kept[key] = row
    return list(kept.values())


def figure(text, digits):
    number = float(text)
    if number != 0.0 and (abs(number) < 1e-4 or abs(number) >= 1e6):
        return f"{number:.{digits - 1}e}"
    return f"{number:.{digits}g}"


def error_of(row):
    error, within = float(row["error"]), float(row["within"])
    if not math.isfinite(error):
        return "**FAILS**"
    text = f"{100.0 * error:+.2g} %" if abs(error) >= 1e-5 else f"{error:+.0e}" if error else "0"
    return text if row["verdict"] == "passes" else f"**FAILS** {text}, allowed {100.0 * within:.2g} %"


def line(row):
    cells = [row["case"], row["source"], row["quantity"], figure(row["reference"], 7), figure(row["ours"], 7), error_of(row), row["mesh"],
             f"{float(row['seconds']):.1f}"]
    return "| " + " | ".join(cells) + " |\n"


def table(rows, failed, minutes):
    ordered = sorted(worst_of_alike(rows), key=entry)
    failing = sum(row["verdict"] != "passes" for row in ordered)
    text = f"{len(ordered)} rows, of which {failing or 'none'} fail{'s' if failing == 1 else ''}; made in {minutes:.0f} minutes of one core.\n"
    if failed:
        text += "\nTests that fail: " + ", ".join(f"`{test}`" for test in failed) + ".\n"
    text += "\n| " + " | ".join(NAMES) + " |\n" + "|---" * len(NAMES) + "|\n"
    return text + "".join(line(row) for row in ordered)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tests", help="the program stria_verification_tests")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--filter", help="of the tests, as in --gtest_filter; all that compare unless told")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--resume", type=Path, metavar="FILE", help="where the results of each test are kept")
    options = parser.parse_args()
    results = results_of(options.tests, (options.filter or suites()) + ("" if options.long else ":-*Long:*Long/*"), options.resume)
    rows = [dict(zip(FIELDS, row, strict=True)) for result in results.values() for row in result["rows"]]
    failed = [test for test, result in results.items() if result["fails"]]
    text = table(rows, failed, sum(result["seconds"] for result in results.values()) / 60.0)
    if options.write:
        before, rest = DOCUMENT.read_text(encoding="utf-8").split(BEGIN)
        DOCUMENT.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1], encoding="utf-8")
    else:
        print(text, end="")
    return 1 if failed or any(row["verdict"] != "passes" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
