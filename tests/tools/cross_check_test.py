#!/usr/bin/python3
"""tools/cross_check.py and cross_check_fields.py: cycles with an overload, with growth at their minima, by a law of da/dN
and under a displacement are what their increments make them, and fields the state of theirs; cells that are not are found.

    tests/tools/cross_check_test.py build/release/bin
"""

import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import cross_check
import cross_check_fields

CYCLES = "load.blocks=[{cycles=1,max=300.0,ratio=0.1},{cycles=1,max=600.0,ratio=0.05},{cycles=2,max=300.0,ratio=0.1}]"


def change(path, k, column, factor):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    rows[k][column] = repr(factor * float(rows[k][column]))
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


# An edge-cracked plate whose ends are moved apart and together. Its crack is closed where it bears the pressure.
MOVED = """units = "N-mm-MPa"
[model]
plane = "stress"
[mesh]
specimen = "sent"
width = 20.0
height = 30.0
size = 1.0
[material]
young = 200e3
poisson = 0.3
yield_stress = 300.0
kinematic = [ { C = 4000.0 } ]
[[crack]]
points = [[0.0, 15.0], [8.0, 15.0]]
contact = {}
[[boundary]]
on = "top"
displacement = [0.0, 1.0]
[[boundary]]
on = "bottom"
displacement = [0.0, 0.0]
[load]
steps = 40
grading = 1.0
blocks = [ { cycles = 1, max = 0.03, ratio = -0.5 } ]
"""


def run(case, folder, *settings):
    command = [str(PROGRAMS / "stria"), "run", str(case), "-o", str(folder), "--mode", "inprocess", "--quiet", "--no-report"]
    subprocess.run(command + [one for setting in settings for one in ("--set", setting)], check=True)


def run_moved(folder, *settings):
    (folder / "case.toml").write_text(MOVED)
    run(folder / "case.toml", folder / "run", *settings)
    return folder / "run"


class Moved(unittest.TestCase):
    """By how much the boundary is moved is no force, and the crack opens by the compliance of a force."""

    def test_the_compliance_at_the_mouth_is_that_of_the_force(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = run_moved(Path(scratch), "output.fields=none")
            self.assertEqual(cross_check.faults(folder), [])
            (cycle,) = cross_check.table(folder / "cycles.csv")
            self.assertGreater(cycle["K_op_offset"], cycle["K_min"])

    def test_growth_under_a_controlled_displacement(self):
        with tempfile.TemporaryDirectory() as scratch:
            blocks = "load.blocks=[{cycles=2,max=0.03,ratio=0.0}]"
            traction = 'boundary=[{on="top",traction=[0.0,1.0]},{on="bottom",displacement=[0.0,0.0]}]'
            folder = run_moved(Path(scratch), 'load.control="displacement"', blocks, traction, "growth.increment=0.5", "load.steps=8", "output.fields=none")
            self.assertEqual(cross_check.faults(folder), [])

    def test_the_distance_of_closure_is_told(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = run_moved(Path(scratch), "load.steps=4", "output.fields=none")
            (tip,) = json.loads((folder / "summary.json").read_text())["tips"]
            K = cross_check.table(folder / "cycles.csv")[0]["K_max"]
            self.assertAlmostEqual(tip["closure_distance"], 0.1 * numpy.pi / 16.0 * (K / 300.0) ** 2, places=6)

    def test_fields_obey_mechanics_and_are_those_of_the_history(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = run_moved(Path(scratch), "load.steps=4", 'output.format="vtu"', 'output.fields="all"')
            self.assertEqual(cross_check_fields.faults(folder), [])
            path = folder / "fields/step_00004.vtu"
            whole = path.read_bytes()
            for name in ("stress", "plastic_strain", "von_mises", "accumulated_plastic_strain", "displacement"):
                path.write_bytes(whole)
                values = cross_check_fields.read(path)[name]
                others = values.copy()
                others.flat[numpy.abs(values).argmax()] *= 1.01
                path.write_bytes(whole.replace(values.tobytes(), others.tobytes()))
                self.assertNotEqual(cross_check_fields.faults(folder), [], name)


class Life(unittest.TestCase):
    def test_cycles_are_those_of_the_law(self):
        for law in ('law="paris",C=1e-12,m=3.0', 'law="table",ranges=[100.0,300.0,1000.0],rates=[1e-8,1e-6,2e-5]'):
            with self.subTest(law=law), tempfile.TemporaryDirectory() as scratch:
                growth = "growth={%s,increment=0.3,walker=0.6}" % law
                traction = 'boundary=[{on="top",traction=[0.0,1.0]},{on="bottom",traction=[0.0,-1.0]}]'
                blocks = "load.blocks=[{cycles=4,max=60.0,ratio=0.2}]"
                folder = run_moved(Path(scratch), growth, traction, blocks, "load.steps=8", "output.fields=none")
                self.assertEqual(cross_check.faults(folder), [])
                cycles = folder / "cycles.csv"
                dN = cross_check.table(cycles)[2]["dN"]
                change(cycles, 2, "dN", 1.001)
                self.assertIn(f"cycle 3: dN is {1.001 * dN:.9g}", "\n".join(cross_check.faults(folder)))


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
