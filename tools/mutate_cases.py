#!/usr/bin/python3
"""Checks and runs cases with random mistakes in them, and reports those that do not end as the README says.

    tools/mutate_cases.py SEED COUNT [--programs build/release/bin] [--keep DIR]

A mutant is a shipped case, coarse and short, with one to three changes of its text: a number becomes huge, tiny,
negative, NaN or no number at all, a line goes or comes twice, a letter is another one, a key has the value of another.
One half is checked, the other half run in one process. Exit code 1 where a mutant ends by a signal, with a code that
the README has not or that means a defect, after more than 2 s of a processor, or with more than 1 GiB. A legal mutant
may ask for much. So 2 s and 1 GiB are for 100 000 elements, and more where `check` says that the mesh has more. A run
that is still at work then is asked to stop, and ends with 130 after the increment it is at.
"""

import argparse
import os
import random
import re
import resource
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
    value = rng.choice(VALUES + [repr(factor * float(found.group())) for factor in FACTORS])
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


def mutant(cases, rng):
    lines = coarse_and_short(rng.choice(cases).read_text()).splitlines()
    for _ in range(rng.randint(1, 3)):
        rng.choice(CHANGES)(lines, rng)
    return "\n".join(lines) + "\n"


def set_limits():
    resource.setrlimit(resource.RLIMIT_AS, (4 * MOST_BYTES, 4 * MOST_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Ending:
    """Exit code (negative: the signal; None: no end), seconds of a processor, bytes; whether it was asked to stop."""

    def __init__(self, command, log, seconds):
        with open(log, "w") as said:
            process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, preexec_fn=set_limits)
        self.code, self.seconds, self.bytes, self.asked = None, 0.0, 0, False
        last = time.time() + 30.0 * seconds
        while time.time() < last:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                self.code, self.bytes = os.waitstatus_to_exitcode(status), 1024 * usage.ru_maxrss
                self.seconds = usage.ru_utime + usage.ru_stime
                return
            if not self.asked and command[1] == "run" and seconds_of(process.pid) > seconds:
                process.send_signal(signal.SIGTERM)
                self.asked = True
            time.sleep(0.002)
        process.kill()
        process.wait()

    def complaint(self, seconds, size):
        if self.code is None:
            return "no end"
        if self.code not in GOOD_CODES and not (self.asked and self.code == INTERRUPTED):
            return f"signal {-self.code}" if self.code < 0 else f"exit code {self.code}"
        if not self.asked and self.seconds > seconds:
            return f"{self.seconds:.1f} s"
        return f"{self.bytes / (1 << 30):.1f} GiB" if self.bytes > size else ""


def seconds_of(pid):
    try:
        fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def size_of_mesh(program, case, log):
    """By what its mesh exceeds 100 000 elements; 1 where it does not, or where there is none."""
    with open(log, "w") as said:
        subprocess.run([program, "check", str(case)], stdout=said, stderr=subprocess.DEVNULL, preexec_fn=set_limits)
    found = re.search(r"^# mesh: .* (\d+) elements", log.read_text(errors="replace"), re.M)
    return max(1.0, int(found.group(1)) / 1e5) if found else 1.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/bin")
    parser.add_argument("--keep", type=Path, help="where the mutants that are reported go")
    options = parser.parse_args()
    rng = random.Random(options.seed)
    cases = sorted(ROOT.glob("cases/*/case.toml"))
    codes, reported = {}, 0
    with tempfile.TemporaryDirectory() as folder:
        case, log = Path(folder) / "mutant.toml", Path(folder) / "log"
        for k in range(options.count):
            text = mutant(cases, rng)
            case.write_text(text)
            command = [str(options.programs / "stria"), "check" if k % 2 == 0 else "run", str(case)]
            if command[1] == "run":
                command += ["-o", folder + "/out", "--mode", "inprocess", "--force", "--quiet"]
            ending = Ending(command, log, MOST_SECONDS)
            codes[ending.code] = codes.get(ending.code, 0) + 1
            said = log.read_text(errors="replace").strip().splitlines()
            what = ending.complaint(MOST_SECONDS, MOST_BYTES)
            if what:
                times = size_of_mesh(command[0], case, log)
                if times > 1.0:
                    what = Ending(command, log, times * MOST_SECONDS).complaint(times * MOST_SECONDS, times * MOST_BYTES)
            if not what:
                continue
            reported += 1
            print(f"mutant {k} ({command[1]}): {what}: {said[-1] if said else ''}", flush=True)
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"mutant-{options.seed}-{k}.toml").write_text(text)
    counts = ", ".join(f"{count} with code {code}" for code, count in sorted(codes.items(), key=str))
    print(f"{options.count} mutants: {counts}; {reported} reported")
    return 1 if reported else 0


if __name__ == "__main__":
    sys.exit(main())
