"""The command line that programs of random trials share: seeds are judged side by side, and what is wrong is said."""

import argparse
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def arguments_of(description, programs, kept, only=None):
    """`kept`: what --keep keeps a folder of. `only`: what --only takes a pattern of."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--programs", type=Path, default=programs)
    parser.add_argument("--keep", type=Path, help=f"folder for the {kept}")
    parser.add_argument("--jobs", type=int, default=2)
    if only:
        parser.add_argument("--only", default="", help=f"pattern of the {only}")
    return parser.parse_args()


def verdicts(judge, arguments):
    """What `judge(arguments, seed)` says of each seed, in their order."""
    with ThreadPoolExecutor(arguments.jobs) as pool:
        yield from pool.map(lambda k: judge(arguments, arguments.seed + k), range(arguments.count))


def run(judge, arguments):
    """Of a judge that gives the seed, what is wrong, and "good" or how all have ended. Returns the exit code."""
    good = ended = bad = 0
    for seed, wrong, end in verdicts(judge, arguments):
        good, ended, bad = good + (end == "good" and not wrong), ended + (end != "good" and not wrong), bad + bool(wrong)
        if wrong or end != "good":
            print(f"{seed}: {'WRONG: ' + '; '.join(wrong) if wrong else end}", flush=True)
    print(f"{good} good, {ended} ended alike with 2 or 3, {bad} wrong")
    return 1 if bad else 0
