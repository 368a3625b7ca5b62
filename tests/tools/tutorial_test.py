#!/usr/bin/env python3
"""docs/tutorial.md, typed into an empty folder: every command ends as it should, and says what the page shows.

Fenced blocks of the page:  toml, with the file's name in its first line ("# b.toml < a.toml": appended to a copy);  sh, one
command a line, and the exit code if it is not 0;  gmsh, tried where there is Gmsh;  text, lines that the commands of the block before
have printed. Numbers agree to 0.1 %, seconds are not compared.

    tutorial_test.py FOLDER_OF_PROGRAMS
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop() if len(sys.argv) > 1 else ROOT / "build/release/bin").resolve()

FENCE = re.compile(r"^```(\w*)[ ]?(\d*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
SECONDS = re.compile(r"in \d+\.\d s")
CLOSE = 1e-3


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
        path = f"{PROGRAMS}:{ROOT / 'tools'}:{os.environ['PATH']}"
        self.environment = {**os.environ, "STRIA": str(ROOT), "PATH": path, "PYTHONPATH": str(ROOT / "tools")}

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
        printed = []
        for kind, code, body in blocks((ROOT / "docs/tutorial.md").read_text(encoding="utf-8")):
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
        kinds = [kind for kind, _, _ in blocks((ROOT / "docs/tutorial.md").read_text(encoding="utf-8"))]
        self.assertGreaterEqual(kinds.count("sh"), 8)
        self.assertGreaterEqual(kinds.count("text"), 6)
        self.assertEqual(kinds.count("gmsh"), 1)

    def test_numbers_that_differ_are_seen(self):
        self.assertTrue(agree("done in 6.8 s: life N = 1.23957e+06", "done in 9.1 s: life N = 1.23900e+06 cycles"))
        self.assertFalse(agree("done in 6.8 s: life N = 1.23957e+06", "done in 6.8 s: life N = 1.24957e+06 cycles"))
        self.assertFalse(agree("K_I 108.72  K_II 12.08", "K_I 108.72  K_I 12.08"))


if __name__ == "__main__":
    unittest.main()
