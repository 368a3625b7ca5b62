#!/usr/bin/env python3
"""Fields and faces of a short run in ParaView: time in cycles, crack open, wake, zone, faces as lines with contact and friction.

    paraview_test.py FOLDER_OF_PROGRAMS

Skipped where there is no pvpython: Debian's package paraview brings 107 others with 757 MB.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from closing_plate import closing_plate

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build/release/bin").resolve()


@unittest.skipUnless(shutil.which("pvpython"), "there is no pvpython (Debian's package paraview)")
class InParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        folder = Path(cls.holder.name)
        (folder / "case.toml").write_text(closing_plate(0.2, 0.5), encoding="utf-8")
        cls.run_folder = folder / "run"
        words = [PROGRAMS / "stria", "run", folder / "case.toml", "-o", cls.run_folder, "--mode", "inprocess", "--quiet"]
        subprocess.run(words, check=True)
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        found = subprocess.run(["pvpython", ROOT / "tests/tools/paraview_facts.py", cls.run_folder], env=environment,
                               capture_output=True, text=True, check=True)
        cls.facts = json.loads(found.stdout.splitlines()[-1])
        with open(cls.run_folder / "faces.csv", encoding="utf-8", newline="") as file:
            cls.faces = list(csv.DictReader(file))
        with open(cls.run_folder / "history.csv", encoding="utf-8", newline="") as file:
            cls.history = {int(row["increment"]): row for row in csv.DictReader(file)}

    def faces_at(self, increment):
        return sorted((row for row in self.faces if int(row["increment"]) == increment), key=lambda row: float(row["s"]))

    def test_time_is_that_of_the_cycles(self):
        times = self.facts[0]["times"]
        self.assertEqual(times, sorted(set(times)))
        self.assertEqual([time for time in times if time == int(time)], [0.0, 1.0, 2.0, 3.0])  # maxima
        self.assertTrue({0.5, 1.5, 2.5} <= set(times))  # minima
        for facts, time in zip(self.facts, times):
            self.assertEqual(facts["cycle"], float(self.history[int(facts["increment"])]["cycle"]))
            self.assertLessEqual(facts["cycle"] - 1.0, time)
            self.assertLessEqual(time, facts["cycle"])

    def test_the_crack_is_open_as_its_faces_are(self):
        for facts in self.facts:
            opening = float(self.history[int(facts["increment"])]["CMOD"])
            self.assertAlmostEqual(facts["jump at the mouth"], opening, delta=1e-6)
        self.assertGreater(self.facts[0]["jump at the mouth"], 0.02)

    def test_what_has_flowed_is_left_behind_as_a_wake(self):
        tip = float(self.history[max(self.history)]["x"])
        self.assertGreater(tip, 15.7)
        self.assertLess(self.facts[-1]["flowed from"], 15.2)
        self.assertGreater(self.facts[-1]["cells in the zone"], 20)

    def test_faces_are_a_line_with_contact_and_friction(self):
        for facts in self.facts:
            rows = self.faces_at(facts["increment"])
            self.assertEqual((facts["lines"], facts["stations"]), (1, len(rows)))
            for name in ("pressure", "shear", "slip", "status"):
                self.assertEqual(facts[name], [float(row[name]) for row in rows], name)
        self.assertGreater(max(value for facts in self.facts for value in facts["pressure"]), 10.0)
        self.assertGreater(max(abs(value) for facts in self.facts for value in facts["slip"]), 1e-5)
        self.assertGreater(len({value for facts in self.facts for value in facts["status"]}), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)  # says what is skipped
