#!/usr/bin/env python3
"""The pages of a run and of a study in a headless Chromium: nothing complains or is fetched, sliders move, numbers are those of the tables.

    browser_test.py FOLDER_OF_PROGRAMS

Skipped where there is no chromium (Debian's package of that name).
"""

import csv
import io
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from closing_plate import closing_plate

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build/release/bin").resolve()
sys.path.insert(0, str(ROOT / "tools"))

import browser  # noqa: E402

SHOWN = """[...document.querySelectorAll('.slides')].map(figure => ({
  at: figure.querySelector('input').value, name: figure.querySelector('span.shown').textContent,
  charts: [...figure.querySelectorAll('svg')].map(svg => [...svg.querySelectorAll('.frame')]
    .filter(frame => getComputedStyle(frame).display != 'none').map(frame => frame.dataset.k))}))[0]"""
TABLES = "Object.fromEntries([...document.querySelectorAll('a.csv')].map(a => [a.download, decodeURIComponent(a.href.split(',').slice(1).join(','))]))"
# Of the chart with that title: what the pointer shows at each marker, "a: 1, 2".
POINTS = """[...document.querySelectorAll('svg')].filter(svg => svg.querySelector('title')?.textContent == '%s')
  .flatMap(svg => [...svg.querySelectorAll('title')].slice(1).map(title => title.textContent))"""


def rows_of(text):
    return list(csv.DictReader(io.StringIO(text)))


def run(*words):
    subprocess.run([PROGRAMS / "stria", *words], check=True, capture_output=True)


@unittest.skipUnless(browser.PROGRAM, "there is no chromium (Debian's package)")
class InABrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = Path(holder.name)
        case = cls.folder / "case.toml"
        case.write_text(closing_plate(0.4, 0.8), encoding="utf-8")
        cls.run_folder = cls.folder / "run"
        run("run", case, "-o", cls.run_folder, "--mode", "inprocess", "--quiet")
        run("study", case, "-o", cls.folder / "study", "--over", "crack.0.contact.friction=0,0.3", "--set", "load.steps=8")
        cls.browser = browser.Browser()
        cls.addClassCleanup(cls.browser.__exit__)
        cls.report = cls.browser.open(cls.run_folder / "report.html", 1280)

    def table(self, name):
        return rows_of((self.run_folder / name).read_text(encoding="utf-8"))

    def test_pages_say_nothing_and_ask_for_nothing(self):
        for path in (self.run_folder / "report.html", self.folder / "study/study.html"):
            page = self.browser.open(path, 1280)
            self.assertEqual(page.complaints(), [])
            self.assertEqual(page.requests(), [path.as_uri()])
            self.assertGreater(page.value("document.querySelectorAll('svg').length"), 2)
            page.close()

    def test_a_complaint_would_be_heard(self):
        path = self.folder / "bad.html"
        path.write_text("<p>x</p><img src='none.png'><script>console.error('heard'); nothing();</script>", encoding="utf-8")
        page = self.browser.open(path, 1280)
        self.assertGreaterEqual(len(page.complaints()), 2)
        self.assertEqual(len(page.requests()), 2)
        page.close()

    def test_the_slider_moves_every_chart_and_the_name(self):
        page, last = self.report, int(self.report.value("document.querySelector('.slides input').max"))
        increments = sorted({int(row["increment"]) for row in self.table("faces.csv")})
        self.assertEqual(last, len(increments) - 1)
        page.value("document.querySelector('.slides input').focus()")
        for key, wanted in (("Home", 0), ("ArrowRight", 1), ("ArrowRight", 2), ("End", last), ("ArrowLeft", last - 1)):
            page.press(key)
            shown = page.value(SHOWN)
            self.assertEqual(shown["at"], str(wanted))
            self.assertEqual(shown["name"].split(":")[0], f"increment {increments[wanted]}")
            self.assertGreaterEqual(len(shown["charts"]), 3)  # faces, pressure, shear
            for frames in shown["charts"]:
                self.assertEqual(set(frames), {str(wanted)})

    def test_tables_behind_the_links_are_those_of_the_run(self):
        tables = {name: rows_of(text) for name, text in self.report.value(TABLES).items()}
        self.assertTrue({"faces-0.csv", "a-N-tip-0.csv", "opening-loads-tip-0.csv", "load-CMOD.csv", "fracture.csv", "work.csv"} <= set(tables))
        for name, file, key, columns in (("a-N-tip-0.csv", "cycles.csv", "N", ("a",)), ("opening-loads-tip-0.csv", "cycles.csv", "a", ("K_op",)),
                                         ("fracture.csv", "history.csv", "increment", ("K_I", "J")), ("load-CMOD.csv", "history.csv", "increment", ("load", "CMOD"))):
            wanted = {float(row[key]): row for row in self.table(file)}
            self.assertGreater(len(tables[name]), 2, name)
            for found in tables[name]:
                for column in columns:
                    self.assertEqual(found[column], wanted[float(found[key])][column], (name, column))

    def test_points_and_facts_on_the_page_are_the_numbers_of_the_tables(self):
        cycles = self.table("cycles.csv")
        shown = [text.split(": ")[1].split(", ") for text in self.report.value(POINTS % "Crack length a, mm")]
        self.assertEqual(len(shown), len(cycles))
        for (N, a), row in zip(shown, cycles):
            self.assertTrue(math.isclose(float(N), float(row["N"]), rel_tol=1e-5) and math.isclose(float(a), float(row["a"]), rel_tol=1e-5))
        facts = self.report.value("Object.fromEntries([...document.querySelectorAll('.facts li')].map(li => [li.firstChild.data, li.querySelector('b').textContent]))")
        self.assertEqual(float(facts["K_max"].split()[0]), float(f"{float(cycles[-1]['K_max']):.6g}"))
        self.assertEqual(float(facts["U"]), float(f"{float(cycles[-1]['U']):.6g}"))

    def test_fits_a_phone_and_the_night(self):
        for dark in (False, True):
            page = self.browser.open(self.run_folder / "report.html", 390, dark=dark)
            self.assertLessEqual(page.value("document.documentElement.scrollWidth"), 390)
            ground = page.value("getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)")
            self.assertEqual(max(ground) < 60, dark)
            self.assertEqual(page.complaints(), [])
            page.close()

    def test_paints_within_a_second(self):
        self.assertLess(self.report.first_paint(), 1000.0)


if __name__ == "__main__":
    unittest.main(verbosity=2)  # says what is skipped
