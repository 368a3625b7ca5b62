#!/usr/bin/python3
"""Checks and runs cases with random mistakes in them, and reports those that do not end as the README says.

    tools/mutate_cases.py SEED COUNT [--programs build/release/bin] [--keep DIR]

A mutant is a shipped case, coarse and short, with one to three changes of its text: a number becomes huge, tiny,
negative, NaN or no number at all, a line goes or comes twice, a letter is another one, a key has the value of another.
One half is checked, the other half run in one process. Reported is a mutant that ends by a signal, or with a code that
the README has not or that means a defect; then the exit code is 1.

Reported is also one that takes more than 2 s of a processor or 1 GiB, unless it was announced: a change may leave a
lawful case with more to do, and then `stria check` says so. It tells what the elastic body takes before it solves it
("# estimate of the elastic body", and likewise of the one that it refines and of the one with elements half as large),
and what a run would take ("# estimate of the run"). Both are good to a factor of three or so, for no one knows how
often increments will be halved. A check may take 10 times the seconds and 4 times the bytes that it has announced of
the body, a run as many times what a check of the same case announces of it. A run that is announced to take more than
30 s is asked to stop after 2 s, and has to end with 130 within 60 s of a processor: nothing cuts an iteration short.
What took more than the limits and was announced is listed with both figures, and counted. An estimate that announces
everything would not pass: every tenth other run is asked for its estimate too, and those that are announced above the
limits but stay within a tenth of the announced seconds are counted.
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
MOST_BYTES = 1 << 30
TIMES_ANNOUNCED, TIMES_BYTES = 10.0, 4.0
LONG = 30.0  # announced seconds: not waited for
MOST_SECONDS_TO_STOP = 60.0
MOST_SECONDS_ASLEEP = 60.0  # by the clock: others may have the processor for a while
MEMORY_LIMIT = 8 << 30
ESTIMATE = re.compile(r"# estimate of the (elastic body|run)(?: before it is refined| on elements half as large)?:.*about (\S+) s of a processor and (\S+) MB")
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


def mutant(case, rng):
    lines = coarse_and_short(case.read_text()).splitlines()
    for _ in range(rng.randint(1, 3)):
        rng.choice(CHANGES)(lines, rng)
    return "\n".join(lines) + "\n"


def set_limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Announced:
    """What a check says that a body, or its run, takes: seconds of a processor, bytes."""

    def __init__(self, log, what):
        found = [(float(line[2]), 1e6 * float(line[3])) for line in ESTIMATE.finditer(log) if line[1] == what]
        self.seconds = sum(seconds for seconds, _ in found)
        self.bytes = max((size for _, size in found), default=0.0)

    def allows(self, seconds, bytes_taken):
        return (seconds <= max(MOST_SECONDS, TIMES_ANNOUNCED * self.seconds)
                and bytes_taken <= max(MOST_BYTES, TIMES_BYTES * self.bytes))

    def __str__(self):
        return f"announced {self.seconds:.2g} s, {self.bytes / (1 << 30):.2g} GiB"


class Ending:
    """Exit code (negative: the signal; None: it had to be killed), seconds of a processor, bytes. `most`: seconds; then
    it is asked to stop, if `stops`, and killed after some more."""

    def __init__(self, command, log, most, stops):
        with open(log, "w") as said:
            process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, preexec_fn=set_limits)
        self.code, self.seconds, self.bytes, self.asked = None, 0.0, 0, False
        moved, seconds = time.time(), 0.0
        killed_at = most + (MOST_SECONDS_TO_STOP if stops else 0.0)
        while time.time() - moved < MOST_SECONDS_ASLEEP and seconds <= killed_at:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                self.code, self.bytes = os.waitstatus_to_exitcode(status), 1024 * usage.ru_maxrss
                self.seconds = usage.ru_utime + usage.ru_stime
                return
            if (now := seconds_of(process.pid)) > seconds:
                moved, seconds = time.time(), now
            if stops and not self.asked and seconds > most:
                process.send_signal(signal.SIGTERM)
                self.asked = True
            time.sleep(0.002)
        self.seconds = seconds
        process.kill()
        process.wait()

    def complaint(self):
        """Of how it ended, whatever it took."""
        if self.code is None:
            return f"no end after {self.seconds:.1f} s"
        if self.code in GOOD_CODES or (self.asked and self.code == INTERRUPTED):
            return ""
        return f"signal {-self.code}" if self.code < 0 else f"exit code {self.code}"

    def __str__(self):
        return f"{self.seconds:.1f} s{' and asked to stop' if self.asked else ''}, {self.bytes / (1 << 30):.2g} GiB"


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

    def check(self, text, case, most):
        """Its ending, and what it has said."""
        place = self.place_of(case)
        place.write_text(text)
        ending = Ending([self.program, "check", str(place)], self.log, most, stops=False)
        return ending, self.log.read_text(errors="replace")

    def run(self, text, case, most, stops):
        place = self.place_of(case)
        place.write_text(text)
        command = [self.program, "run", str(place), "-o", self.folder + "/out", "--mode", "inprocess"]
        command += ["--force", "--quiet"]
        return Ending(command, self.log, most, stops)

    def last_words(self):
        return (self.log.read_text(errors="replace").strip().splitlines() or [""])[-1]

    def judge_check(self, text, case):
        """Its ending, what was announced, and whether that was kept."""
        ending, said = self.check(text, case, MOST_SECONDS_TO_STOP)
        announced = Announced(said, "elastic body")
        return ending, announced, announced.allows(ending.seconds, ending.bytes)

    def judge_run(self, text, case):
        """Likewise. A run that goes beyond the limits is checked, and run again for as long as it was announced."""
        ending = self.run(text, case, MOST_SECONDS, stops=True)
        if not ending.asked and ending.bytes <= MOST_BYTES:
            return ending, None, True
        announced = Announced(self.check(text, case, MOST_SECONDS_TO_STOP)[1], "run")
        if announced.seconds <= LONG and ending.asked:
            most = max(MOST_SECONDS, TIMES_ANNOUNCED * announced.seconds)
            ending = self.run(text, case, most, stops=False)
        return ending, announced, announced.allows(ending.seconds, ending.bytes)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--keep", type=Path, help="where the mutants that are reported go")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    cases = sorted(ROOT.glob("cases/*/case.toml"))
    codes, reported, more, asked, loud = {}, 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.programs, folder)
        for k in range(options.count):
            case, is_run = rng.choice(cases), k % 2 == 1
            text = mutant(case, rng)
            ending, announced, kept = (bench.judge_run if is_run else bench.judge_check)(text, case)
            codes[ending.code] = codes.get(ending.code, 0) + 1
            what, words = ending.complaint(), bench.last_words()
            if not what and not kept:
                what = f"not announced: {ending}, {announced}"
            reported += bool(what)
            beyond = kept and (ending.seconds > MOST_SECONDS or ending.bytes > MOST_BYTES)
            more += beyond
            if is_run and ending.code == 0 and not beyond and k % 10 == 1:
                asked += 1
                estimate = Announced(bench.check(text, case, MOST_SECONDS_TO_STOP)[1], "run")
                loud += estimate.seconds > max(MOST_SECONDS, TIMES_ANNOUNCED * ending.seconds)
            if not what and not beyond:
                continue
            name = f"mutant {k} ({'run' if is_run else 'check'})"
            print(f"{name}: {what or f'more to do: {ending}; {announced}'}: {words}", flush=True)
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"mutant-{options.seed}-{k}.toml").write_text(text)
    counts = ", ".join(f"{count} with code {code}" for code, count in sorted(codes.items(), key=str))
    print(f"{options.count} mutants: {counts}; {more} with more to do, as announced; {loud} of {asked} others "
          f"announced above the limits and ten times too high; {reported} reported")
    return 1 if reported else 0


if __name__ == "__main__":
    sys.exit(main())
