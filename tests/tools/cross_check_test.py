#!/usr/bin/python3
"""tools/cross_check.py: cycles with an overload and with growth at their minima are what their increments make them;
cells that are not are found.

    tests/tools/cross_check_test.py build/release/bin
"""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import cross_check

CYCLES = "load.blocks=[{cycles=1,max=300.0,ratio=0.1},{cycles=1,max=600.0,ratio=0.05},{cycles=2,max=300.0,ratio=0.1}]"


def change(path, k, column, factor):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    rows[k][column] = repr(factor * float(rows[k][column]))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


class Overload(unittest.TestCase):
    def run_cycles(self, folder, at, cycles=CYCLES, distance=0.05):
        case = ROOT / "cases/overload/case.toml"
        settings = ["--set", cycles, "--set", f"growth.at={at}", "--set", f"closure.distance={distance}", "--set", "output.fields=none"]
        command = [str(PROGRAMS / "stria"), "run", str(case), "-o", str(folder), "--mode", "inprocess", "--quiet", *settings]
        subprocess.run(command, check=True)

    def test_cycles_are_what_their_increments_make_them(self):
        for at in ("max", "min"):
            with self.subTest(at=at), tempfile.TemporaryDirectory() as scratch:
                self.run_cycles(Path(scratch) / at, at)
                self.assertEqual(cross_check.faults(Path(scratch) / at), [])

    def test_openings_begin_at_the_load_that_is_asked_of_the_longer_crack(self):
        with tempfile.TemporaryDirectory() as scratch:
            self.run_cycles(Path(scratch) / "run", "min", "load.blocks=[{cycles=3,max=300.0,ratio=0.4}]", 0.3)
            self.assertEqual(cross_check.faults(Path(scratch) / "run"), [])

    def test_a_cell_that_is_another_is_found(self):
        columns = ["a", "da", "dN", "K_op", "J_max", "forward_zone", "cyclic_zone", "opening_range", "newton_iterations"]
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch) / "run"
            self.run_cycles(folder, "max")
            for column in columns:
                whole = (folder / "cycles.csv").read_bytes()
                change(folder / "cycles.csv", 1, column, 1.001)
                self.assertNotEqual(cross_check.faults(folder), [], column)
                (folder / "cycles.csv").write_bytes(whole)
            change(folder / "history.csv", 20, "dissipation", 1.001)
            self.assertNotEqual(cross_check.faults(folder), [])


if __name__ == "__main__":
    PROGRAMS = Path(sys.argv.pop(1))
    unittest.main()
