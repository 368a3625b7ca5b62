#!/usr/bin/python3
"""Runs random scenes with other keys, in one process and in one matrix.

    tools/random_keys.py SEED COUNT [--programs build/release/bin] [--keep DIR] [--jobs 2]

A scene of random_scenes.py gets two to five keys that it has not: of closure, of the zone and its functions, of laws of
growth, of what is written, of notches and smooth faces. Most of them no other random trial sets, and seldom two at once. Both
modes end alike; their history.csv agrees to 1e-8 as in random_scenes.py; and the columns of cycles.csv are what history.csv
makes them (cross_check.py). Exit code 1 where a scene does not.
"""

import random
import re
import shutil
import sys
import tempfile
from pathlib import Path

import cross_check
import random_loads
import random_scenes
import random_trials

ROOT = Path(__file__).resolve().parent.parent
MODES = ["inprocess", "monolithic"]
PARIS = "law = \"paris\"\nC = 1e-12\nm = 3.0"
KEYS = {
    "closure": ["tension = true", 'definition = "tension"', 'definition = "offset"', "profile = [0.4, 0.9]", "profile = [8.0]",
                "distance = 0.6", "distance = 5.0"],
    "fine": ['enrichment = "%s"' % which for which in ("none", "single", "topological", "geometrical")] +
            ["subcells = 1", "subcells = 3", "substeps = 1", 'guard = "warn"', "beta = 0.5", "enrichment_n = 4.0",
             "enrichment_radius = 1.5", "growth = 0.05", "refine = 8"],
    "output": ['history = "cycles"', 'faces = "all"', 'faces = "cycles"', 'faces = "none"', 'fields = "all"'],
    "coupling": ['state = "newton"', 'state = "increment"'],
    "growth": ['retain = "all"', 'at = "min"', "every = 2", 'direction = "straight"', "until = 5.0", "toughness = 900.0", PARIS,
               PARIS + '\ndriving = "dK_eff"', PARIS + '\ndriving = "dK_full"', PARIS + "\nwalker = 0.4",
               'law = "ctod"\nC = 1e-2\nm = 1.0'],
    "load": ["grading = 0.4", "grading = 1.0", "repeat = 2", 'steps = "auto"'],
}
FACES = {"notch = 1.3\n": (r"(\[\[crack\]\]\npoints = .*\n)", r"\1notch = 1.3\n"),
         "smooth": (r"contact = \{ (friction = [\d.]*[1-9][\d.]*) \}", r"contact = { \1, smooth = [0.5, 1.5] }")}


def with_key(text, section, line):
    """The case `text` with a key of a section, in place of the one that it has."""
    name = line.split(" = ")[0]
    head = re.search(r"(^|\n)\[%s\]\n" % section, text)
    if head is None:
        return text + f"[{section}]\n{line}\n"
    end = text.find("\n[", head.end())
    own = text[head.end() : end + 1 if end >= 0 else len(text)]
    rest = text[head.end() + len(own) :]
    return text[: head.end()] + line + "\n" + re.sub(r"(?m)^%s = .*\n" % name, "", own) + rest


def with_other_keys(text, rng):
    """The case, and what it got."""
    chosen = []
    for _ in range(rng.randint(2, 5)):
        section = rng.choice(sorted(KEYS) + ["crack"])
        if section == "growth" and "[growth]" not in text:
            continue
        what = rng.choice(sorted(FACES) if section == "crack" else KEYS[section])
        if section == "crack":
            text = text if "notch = " in text and "notch" in what else re.sub(*FACES[what], text)
        else:
            for line in what.split("\n"):
                text = with_key(text, section, line)
        chosen.append(f"{section}: {what.strip()}".replace("\n", ", "))
    return text, chosen


def faults(folder, text):
    """What is wrong with two runs that have ended well."""
    worst, where = random_scenes.difference(*(random_scenes.numbers(folder / mode) for mode in MODES))
    wrong = [f"modes differ by {worst:.1e} of {where}"] if worst > random_scenes.SAME else []
    if 'history = "cycles"' not in text and (folder / MODES[0] / "cycles.csv").exists():
        wrong += cross_check.faults(folder / MODES[0])[:2]
    return wrong


def judge(arguments, seed):
    rng = random.Random(f"keys of {seed}")
    text, chosen = with_other_keys(random_loads.with_more(random_scenes.scene(random.Random(seed)), seed), rng)
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        (folder / "case.toml").write_text(text)
        ends = [random_scenes.run(arguments.programs, folder / "case.toml", folder / mode, mode) for mode in MODES]
        codes = {code for code, _, _ in ends}
        if codes == {0}:
            wrong = faults(folder, text)
        else:
            wrong = [] if codes in ({2}, {3}) else [f"ends with {[end[:2] for end in ends]}"]
        if wrong and arguments.keep:
            shutil.copytree(folder, arguments.keep / str(seed), dirs_exist_ok=True)
        end = "good" if codes == {0} else f"ends with {codes}: {ends[0][1]}"
        return seed, wrong + chosen if wrong else [], end


def main():
    return random_trials.run(judge, random_trials.arguments_of(__doc__, ROOT / "build/release/bin", "scenes that are wrong"))


if __name__ == "__main__":
    sys.exit(main())
