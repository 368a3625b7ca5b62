#!/usr/bin/python3
"""Error against run time of three ways to resolve the plastic zone: a mesh that is fine everywhere, the paper's scheme on a
graded mesh, and the refined zone. All in one go on one machine; prints a Markdown table for each load, and draws a chart of
them (with python3-matplotlib).

    bench/error_against_time.py build/release/bin/stria [cases/sent-compression/case.toml] [--max 50 30] [--chart PICTURE]
"""

import argparse
import csv
import json
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def grading(size):
    return f"mesh.grading=[{{at=[[20.0,100.0]],size={size},outer_size={2 * size},radius=3.0,growth=0.25}}]"


def ladders():
    """Name of each way, and its settings from coarse to fine."""
    uniform = [["mesh.grading=[]", f"mesh.size={size}"] for size in (2.5, 1.25, 0.625, 0.3125, 0.15625)]
    paper = [[grading(size)] for size in (0.8, 0.4, 0.2, 0.1)]
    refined = [["mesh.size=5.0", grading(size), f"fine.refine={refine}", "fine.growth=0.25"] for size, refine in ((1.6, 4), (0.8, 8), (0.8, 16), (0.4, 16))]
    return {"fine everywhere": uniform, "the paper's scheme": paper, "refined zone": refined}


REFERENCE = [grading(0.025), "fine.beta=1"]


def run(program, case, settings, folder):
    command = [program, "run", case, "-o", str(folder), "--mode", "inprocess", "--quiet", "--set", "output.fields=none"]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True)
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        history = list(csv.DictReader(file))
    with open(folder / "faces.csv", newline="", encoding="utf-8") as file:
        faces = list(csv.DictReader(file))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    top = max(history, key=lambda row: float(row["load_factor"]))
    bottom = min(history, key=lambda row: float(row["load_factor"]))
    tip = float(top["a"])
    last = [(float(f["s"]), float(f["opening"])) for f in faces if f["increment"] == history[-1]["increment"]]
    closed = [float(f["s"]) for f in faces if f["increment"] == bottom["increment"] and f["status"] != "0"]
    return {
        "J": float(top["J"]),
        "CTOD": float(top["CTOD"]),
        "opening .2 mm behind the tip": at(last, tip - 0.2),
        "opening 1 mm behind the tip": at(last, tip - 1.0),
        "contact edge": tip - max(closed, default=float("nan")),
        "points": summary["fine_points"],
        "s": summary["timing"]["total"],
    }


def at(profile, s):
    profile = sorted(profile)
    for (s0, w0), (s1, w1) in zip(profile, profile[1:]):
        if s0 <= s <= s1:
            return w0 + (w1 - w0) * (s - s0) / (s1 - s0)
    return float("nan")


def measure(program, case, load):
    """Prints the table of a load; errors in percent by measure and way: lists of (seconds, error)."""
    curves = {}
    with tempfile.TemporaryDirectory() as folder:
        reference = run(program, case, load + REFERENCE, Path(folder) / "reference")
        results = [name for name in reference if name not in ("points", "s")]
        print("| mesh | points | s | " + " | ".join(f"{name}, %" for name in results) + " |")
        print("|" + "---|" * (3 + len(results)))
        print(f"| reference | {reference['points']} | {reference['s']:.1f} | " + " | ".join(f"{reference[name]:.5g}" for name in results) + " |")
        for way, ladder in ladders().items():
            for number, settings in enumerate(ladder):
                found = run(program, case, load + settings, Path(folder) / f"{way}{number}")
                errors = {name: 100.0 * (found[name] / reference[name] - 1.0) for name in results}
                print(f"| {way} {number + 1} | {found['points']} | {found['s']:.2f} | " + " | ".join(f"{errors[name]:+.2f}" for name in results) + " |", flush=True)
                for name in results:
                    curves.setdefault(name, {}).setdefault(way, []).append((found["s"], abs(errors[name])))
    return curves


def draw(picture, charts):
    """One row of axes a load, one axes a measure, one curve a way."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    columns = len(next(iter(charts.values())))
    figure, rows = pyplot.subplots(len(charts), columns, figsize=(3.2 * columns, 3.0 * len(charts)), squeeze=False)
    for row, (title, curves) in zip(rows, charts.items()):
        for axes, (name, ways) in zip(row, curves.items()):
            for way, points in ways.items():
                axes.loglog([s for s, _ in points], [max(error, 1e-3) for _, error in points], "o-", label=way)
            axes.axhline(1.0, color="grey", linewidth=0.5)
            axes.set_title(f"{name}, {title}", fontsize="small")
            axes.grid(alpha=0.3)
        row[0].set_ylabel("error, %")
    for axes in rows[-1]:
        axes.set_xlabel("run time, s")
    rows[0][0].legend(fontsize="x-small")
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stria")
    parser.add_argument("case", nargs="?", default=str(ROOT / "cases/sent-compression/case.toml"))
    parser.add_argument("--max", type=float, nargs="+", default=[50.0], help="largest load factors of the one cycle, R = -1")
    parser.add_argument("--chart", help="file of a picture")
    options = parser.parse_args()
    program = str(Path(options.stria).resolve())
    charts = {}
    for largest in options.max:
        print(f"\nLargest stress {largest:g} MPa:\n")
        charts[f"{largest:g} MPa"] = measure(program, options.case, [f"load.blocks=[{{cycles=1,max={largest},ratio=-1.0}}]"])
    if options.chart:
        draw(options.chart, charts)


if __name__ == "__main__":
    main()
