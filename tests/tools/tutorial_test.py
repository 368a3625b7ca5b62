#!/usr/bin/env python3
"""docs/tutorial.md, typed into an empty folder: every command ends as it should, and says what the page shows.

Fenced blocks of the page:  toml, with the file's name in its first line ("# b.toml < a.toml": appended to a copy);  sh, one
command a line, and the exit code if it is not 0;  gmsh, tried where there is Gmsh;  text, lines that the commands of the block before
have printed. Numbers agree to 0.1 %, seconds are not compared.
The table of the page has what each step takes: seconds of one core as measured here, whatever else it does, and minutes to read and type
it.

    tutorial_test.py FOLDER_OF_PROGRAMS
"""

import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/tutorial.md"
PROGRAMS = Path(sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build/release/bin").resolve()

EXPORT = re.compile(r"^export (\w+)=(.*)$", re.MULTILINE)
FENCE = re.compile(r"^```(\w*)[ ]?(\d*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
SECONDS = re.compile(r"in \d+\.\d s")
CLOSE = 1e-3
ROW = re.compile(r"^\| (\d)\. .*?\| ([\d.]+) \| ([\d.]+) \|$", re.MULTILINE)
WORDS, LETTERS = 200.0, 200.0  # read and typed in a minute
SLOWER, MORE = 3.0, 5.0        # than on the machine of the table: times, and seconds of starting


def steps(page):
    """The sections "## 1. ..." by their numbers."""
    return {int(section[0]): section for section in re.split(r"^## ", page, flags=re.MULTILINE) if section[0].isdigit()}


def seconds_of_programs():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def minutes_of_reader(section):
    typed = sum(len(body) for kind, _, body in blocks(section) if kind in ("toml", "sh", "gmsh"))
    shown = sum(len(body.split()) for kind, _, body in blocks(section) if kind == "text")
    return (len(FENCE.sub("", section).split()) + shown) / WORDS + typed / LETTERS


def environment_of_page():
    """What the page has a reader export and nothing else, for this copy of Stria and for these programs."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    environment["STRIA"] = str(ROOT)
    for name, value in EXPORT.findall(PAGE.read_text(encoding="utf-8")):
        if name != "STRIA":
            environment[name] = re.sub(r"\$(\w+)", lambda match: environment.get(match[1], ""), value)
    environment["PATH"] = f"{PROGRAMS}:{environment['PATH']}"
    return environment


def blocks(page):
    return [(kind, int(code or 0), body) for kind, code, body in FENCE.findall(page)]


def numbers(line):
    return [float(number) for number in NUMBER.findall(line)]


def agree(shown, printed):
    """The words are the same, and the numbers nearly."""
    shown, printed = SECONDS.sub("", shown), SECONDS.sub("", printed)
    if NUMBER.sub("#", shown.strip()) not in NUMBER.sub("#", printed):
        return False
    wanted, found = numbers(shown), numbers(printed)
    offsets = range(len(found) - len(wanted) + 1)
    return any(all(abs(w - f) <= CLOSE * abs(w) for w, f in zip(wanted, found[k:])) for k in offsets)


class Page(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        self.environment = environment_of_page()

    def type_in(self, line):
        done = subprocess.run(["bash", "-c", line], cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def save(self, body):
        name, _, base = body.splitlines()[0].removeprefix("# ").partition(" < ")
        before = (self.folder / base).read_text(encoding="utf-8") if base else ""
        (self.folder / name).write_text(before + body, encoding="utf-8")

    def mesh_elsewhere(self, body):
        """What Gmsh makes now need not be the mesh of the figures, but it must be one that Stria reads."""
        if shutil.which("gmsh") is None:
            return
        code, said = self.type_in(body)
        self.assertEqual(code, 0, said)
        self.assertIn("weld", (self.folder / "t-joint.msh").read_text(encoding="utf-8"))

    def test_every_command_does_what_the_page_says(self):
        page = PAGE.read_text(encoding="utf-8")
        table = {int(number): (float(seconds), float(minutes)) for number, seconds, minutes in ROW.findall(page)}
        self.assertEqual(set(table), set(steps(page)))
        for number, section in steps(page).items():
            before = seconds_of_programs()
            self.follow(section)
            measured, read = seconds_of_programs() - before, minutes_of_reader(section)
            print(f"step {number}: {measured:.1f} s of one core, {read:.1f} minutes to read and type")
            with self.subTest(f"table, step {number}"):
                self.assertLess(measured, SLOWER * table[number][0] + MORE)
                self.assertAlmostEqual(table[number][1], read, delta=0.1)
        self.assertLess(sum(seconds / 60.0 + minutes for seconds, minutes in table.values()), 15.0)

    def follow(self, section):
        printed = []
        for kind, code, body in blocks(section):
            if kind == "toml":
                self.save(body)
            elif kind == "gmsh":
                self.mesh_elsewhere(body)
            elif kind == "sh":
                printed = []
                for line in body.splitlines():
                    with self.subTest(line):
                        ended, said = self.type_in(line)
                        self.assertEqual(ended, code, said)
                        printed += said.splitlines()
            elif kind == "text":
                for line in body.splitlines():
                    with self.subTest(line):
                        self.assertTrue(any(agree(line, other) for other in printed), "\n".join(printed[-12:]))

    def test_the_page_has_what_it_is_read_for(self):
        kinds = [kind for kind, _, _ in blocks(PAGE.read_text(encoding="utf-8"))]
        self.assertGreaterEqual(kinds.count("sh"), 8)
        self.assertGreaterEqual(kinds.count("text"), 6)
        self.assertEqual(kinds.count("gmsh"), 1)

    def test_numbers_that_differ_are_seen(self):
        self.assertTrue(agree("done in 6.8 s: life N = 1.23957e+06", "done in 9.1 s: life N = 1.23900e+06 cycles"))
        self.assertFalse(agree("done in 6.8 s: life N = 1.23957e+06", "done in 6.8 s: life N = 1.24957e+06 cycles"))
        self.assertFalse(agree("K_I 108.72  K_II 12.08", "K_I 108.72  K_I 12.08"))


if __name__ == "__main__":
    unittest.main()
