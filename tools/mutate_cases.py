#!/usr/bin/python3
"""Checks and runs cases with random mistakes in them, and reports those that do not end as the README says.

    tools/mutate_cases.py SEED COUNT [--programs build/release/bin] [--keep DIR]

A mutant is a shipped case, coarse and short, with one to three changes of its text: a number becomes huge, tiny,
negative, NaN or no number at all, a line goes or comes twice, a letter is another one, a key has the value of another.
One half is checked, the other half run in one process. Reported is a mutant that ends by a signal, with a code that the
README has not or that means a defect, after more than 2 s of a processor, or with more than 1 GiB; then the exit code
is 1.

A change may also leave a lawful case with more to do. It is not judged by its time, and it is not forgiven either. It
is asked to stop after its 2 s and has to end with 130 within two minutes of a processor, for nothing cuts an iteration
short (a check just ends). Then it is judged with less to do: again as short as the shipped cases were made, without smaller elements
about the tips, and where that is not enough with elements three and nine times as large. What still takes more is
reported; a mesh from a file stays as it is. All that needed this are listed and counted apart.
"""

import argparse
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
GOOD_CODES = {0, 2, 3, 5}
INTERRUPTED = 130
MOST_SECONDS = 2.0
MOST_SECONDS_ASLEEP = 60.0  # by the clock: others may have the processor for a while
MOST_SECONDS_TO_STOP = 120.0  # an iteration of a zone of 400 000 elements is not cut short
MOST_BYTES = 1 << 30
NUMBER = re.compile(r"(?<![\w.\"])-?\d+\.?\d*(?:e[+-]?\d+)?(?![\w.\"])")
VALUES = [
    "0", "-1", "1", "0.5", "1e-9", "1e-308", "5e-324", "1e9", "1e30", "1e308", "nan", "inf", "-inf", "2147483648",
    "1000000000", "65536", "4096", '"text"', "true", "[]", "[1.0]", "{}", "[[0.0, 0.0], [1.0, 1.0]]", "2020-01-01",
]
FACTORS = [-1.0, 1e-3, 0.1, 0.5, 1.001, 2.0, 10.0]


def change_number(lines, rng):
    places = [(k, found) for k, line in enumerate(lines) for found in NUMBER.finditer(line.split("#")[0])]
    if not places:
        return
    k, found = rng.choice(places)
    lawful = [repr(factor * float(found.group())) for factor in FACTORS]  # or nearly so: these get farther
    value = rng.choice(lawful if rng.random() < 0.5 else VALUES)
    lines[k] = lines[k][: found.start()] + value + lines[k][found.end() :]


def remove_line(lines, rng):
    del lines[rng.randrange(len(lines))]


def double_line(lines, rng):
    lines.insert(rng.randrange(len(lines)), rng.choice(lines))


def change_letter(lines, rng):
    k = rng.randrange(len(lines))
    at = rng.randrange(len(lines[k]) + 1)
    lines[k] = lines[k][:at] + rng.choice(["", "x", "=", '"', "[", ".", "\0", "\u00e9"]) + lines[k][at + 1 :]


def take_value_of_another(lines, rng):
    keys = [k for k, line in enumerate(lines) if " = " in line]
    to, other = rng.choice(keys), rng.choice(keys)
    lines[to] = lines[to].split(" = ")[0] + " = " + lines[other].split(" = ", 1)[1]


CHANGES = [change_number] * 6 + [remove_line, double_line, change_letter, take_value_of_another]


def coarse_and_short(text):
    """What takes long after that hangs, or asks for too much."""
    text = re.sub(r"\bsize = 0\.\d+, outer_size = [\d.]+", "size = 0.5, outer_size = 1.0", text)
    text = re.sub(r"\bcycles = \d+", "cycles = 1", text)
    text = re.sub(r"^repeat = \d+", "repeat = 1", text, flags=re.M)
    text = re.sub(r"^refine = \d+", "refine = 2", text, flags=re.M)
    return re.sub(r"^steps = \d+", "steps = 4", text, flags=re.M)


def larger_elements(text, times):
    """The sizes of elements, in [mesh] and in a grading."""
    size = re.compile(r"\b((?:outer_)?size = )(\d+\.?\d*(?:e[+-]?\d+)?)(?![\w.\"-])")
    return size.sub(lambda found: found.group(1) + repr(times * float(found.group(2))), text)


def less_to_do(text):
    """The same mutant with less and less to do."""
    text = re.sub(r"\b((?:far_)?subcells) = \d+", r"\1 = 2", coarse_and_short(text))
    text = re.sub(r"^refine = \d+", "refine = 1", text, flags=re.M)
    for times in (1.0, 3.0, 9.0):
        yield larger_elements(text, times)


def mutant(case, rng):
    lines = coarse_and_short(case.read_text()).splitlines()
    for _ in range(rng.randint(1, 3)):
        rng.choice(CHANGES)(lines, rng)
    return "\n".join(lines) + "\n"


def set_limits():
    resource.setrlimit(resource.RLIMIT_AS, (4 * MOST_BYTES, 4 * MOST_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Ending:
    """Exit code (negative: the signal; None: it had to be killed), seconds of a processor, bytes; whether it was asked to
    stop because it had been at work for too long."""

    def __init__(self, command, log):
        with open(log, "w") as said:
            process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, preexec_fn=set_limits)
        self.code, self.seconds, self.bytes, self.asked = None, 0.0, 0, False
        moved, seconds = time.time(), 0.0
        while time.time() - moved < MOST_SECONDS_ASLEEP and seconds < MOST_SECONDS + MOST_SECONDS_TO_STOP:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                self.code, self.bytes = os.waitstatus_to_exitcode(status), 1024 * usage.ru_maxrss
                self.seconds = usage.ru_utime + usage.ru_stime
                return
            if (now := seconds_of(process.pid)) > seconds:
                moved, seconds = time.time(), now
            if not self.asked and seconds > MOST_SECONDS:
                process.send_signal(signal.SIGTERM)
                self.asked = True
            time.sleep(0.002)
        process.kill()
        process.wait()

    def has_much_to_do(self, is_run):
        """It stopped as a lawful case does, or took too much memory."""
        stopped = self.code == (INTERRUPTED if is_run else -signal.SIGTERM)
        return (self.asked and (stopped or self.code in GOOD_CODES)) or (self.code in GOOD_CODES and self.complaint())

    def complaint(self):
        if self.code is None:
            return "no end"
        if self.asked:
            return f"over {MOST_SECONDS:.0f} s"
        if self.code not in GOOD_CODES:
            return f"signal {-self.code}" if self.code < 0 else f"exit code {self.code}"
        if self.seconds > MOST_SECONDS:
            return f"{self.seconds:.1f} s"
        return f"{self.bytes / (1 << 30):.1f} GiB" if self.bytes > MOST_BYTES else ""


def seconds_of(pid):
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Bench:
    """Where mutants are checked or run."""

    def __init__(self, programs, folder):
        self.program, self.folder = str(programs / "stria"), folder
        self.log = Path(folder) / "log"
        shutil.copytree(ROOT / "cases", folder + "/cases")  # with the files that they name

    def place_of(self, case):
        """Where a mutant of a case stands."""
        return Path(self.folder) / "cases" / case.parent.name / "mutant.toml"

    def ending(self, text, case, is_run):
        place = self.place_of(case)
        place.write_text(text)
        command = [self.program, "run" if is_run else "check", str(place)]
        if is_run:
            command += ["-o", self.folder + "/out", "--mode", "inprocess", "--force", "--quiet"]
        return Ending(command, self.log)

    def last_words(self):
        return (self.log.read_text(errors="replace").strip().splitlines() or [""])[-1]

    def judge(self, text, case, is_run):
        """Its ending, what is wrong with it, and whether it was judged with less to do."""
        first = self.ending(text, case, is_run)
        if not first.has_much_to_do(is_run):
            return first, first.complaint(), False
        for less in less_to_do(text):
            ending = self.ending(less, case, is_run)
            if not ending.has_much_to_do(is_run):
                return first, ending.complaint(), True
        return first, first.complaint() + ", and so with less to do", True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--keep", type=Path, help="where the mutants that are reported go")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    cases = sorted(ROOT.glob("cases/*/case.toml"))
    codes, reported, lightened = {}, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.programs, folder)
        for k in range(options.count):
            case, is_run = rng.choice(cases), k % 2 == 1
            text = mutant(case, rng)
            ending, what, lighter = bench.judge(text, case, is_run)
            codes[ending.code] = codes.get(ending.code, 0) + 1
            lightened += lighter
            reported += bool(what)
            if not what and not lighter:
                continue
            name = f"mutant {k} ({'run' if is_run else 'check'})"
            print(f"{name}: {what or 'much to do, passes with less'}: {bench.last_words()}", flush=True)
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"mutant-{options.seed}-{k}.toml").write_text(text)
    counts = ", ".join(f"{count} with code {code}" for code, count in sorted(codes.items(), key=str))
    print(f"{options.count} mutants: {counts}; {lightened} judged with less to do; {reported} reported")
    return 1 if reported else 0


if __name__ == "__main__":
    sys.exit(main())
