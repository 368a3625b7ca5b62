#!/usr/bin/python3
"""What `stria check` says that a run takes, against what it does.

    bench/error_of_estimate.py build/release/bin/stria [--only NAME] [--repeat 2]

The shipped cases, some of them under other loads, with other metals or finer, and others that are written here: many
cracks, an elastic spectrum, and a part of 75 000 elements where the program gmsh is installed. One process, no page.
Prints a Markdown table: seconds of a processor and megabytes as announced and as taken (the best of the repeats; the
largest resident memory), their ratios, and of both the increments, iterations of each and points.
"""

import argparse
import json
import random
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import long_spectrum

ROOT = Path(__file__).resolve().parent.parent
SHORT_BLOCK = "load.blocks=[{cycles=8,max=501.0,ratio=-1.0}]"
GROWING = ROOT / "bench/growing_cycle/case.toml"
RUNS = {
    "sent-compression": [],
    "sent-compression to 100 MPa": ["load.blocks=[{cycles=1,max=100.0,ratio=-1.0}]"],
    "sent-closure": [],
    "sent-closure, R = -1": [SHORT_BLOCK],
    "ct-closure": [],
    "overload": [],
    "paris-life": [],
    "weld": [],
    "dead-load": [],
    "rolling-contact": [],
    "inclined-compression": [],
    "plate-hole": [],
    "three-holes": [],
    "t-joint": [],
    "lug": [],
    "growing_cycle": ["load.blocks=[{cycles=12,max=50.0,ratio=0.0}]"],
    "growing_cycle, R = -1, perfectly plastic": [
        "load.blocks=[{cycles=12,max=50.0,ratio=-1.0}]", "material.kinematic=[]"],
    "growing_cycle, plane stress, K = 501": [
        "model.plane='stress'", "load.control='K'", "load.blocks=[{cycles=12,max=501.0,ratio=0.0}]"],
}
CT_GROWS = ["fine.refine=16", "growth.increment=0.1", "mesh.size=0.8",
            "load.blocks=[{cycles=40,max=700.0,ratio=0.0}]"]
RUNS |= {
    "ct-closure, plane stress, refine = 16": ["model.plane='stress'", *CT_GROWS],
    "ct-closure, plane strain, refine = 16": CT_GROWS,
    "ct-closure, plane stress, 100 cycles": ["model.plane='stress'", "load.blocks=[{cycles=100,max=440.0,ratio=0.1}]"],
    "ct-pins": [],
    "lug, plastic": ["material.yield_stress=250.0", "material.kinematic=[{C=4000.0}]", "fine.refine=8"],
    "six cracks": [],
    "six cracks, elastic, 40 growths": [
        "material={young=200e3,poisson=0.3}", "fine.refine=1", "load.steps=2",
        "load.blocks=[{cycles=40,max=80.0,ratio=0.0}]"],
    "spectrum": [],
    "spectrum of two load cases": [],
    "two holes": [],
    "two holes, elastic": ["material={young=200e3,poisson=0.3}", "fine.refine=1", "load.steps=2",
                           "load.blocks=[{cycles=30,max=70.0,ratio=0.0}]", "growth.driving='dK'"],
}
SIX_CRACKS = """
units = "N-mm-MPa"
mesh = { specimen = "plate", width = 120.0, height = 120.0, size = 1.0 }
material = { young = 200e3, poisson = 0.3, yield_stress = 300.0, kinematic = [ { C = 4000.0 } ] }
crack = [
    { points = [[0.0, 30.3], [10.0, 30.3]], contact = {} }, { points = [[120.0, 60.3], [108.0, 60.3]], contact = {} },
    { points = [[0.0, 90.3], [11.0, 90.3]], contact = {} }, { points = [[40.0, 60.3], [52.0, 63.0]], contact = {} },
    { points = [[60.0, 90.3], [72.0, 88.3]], contact = {} }, { points = [[55.0, 25.3], [66.0, 25.3]], contact = {} } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
growth = { law = "paris", C = 3e-13, m = 3.0, increment = 0.1 }
fine = { refine = 8 }
load = { blocks = [ { cycles = 12, max = 80.0, ratio = 0.0 } ] }
"""
SPECTRUM = long_spectrum.CASE % (500, 20)
TWO_HOLES = """
units = "N-mm-MPa"
mesh = { file = "two-holes.msh" }
material = { young = 200e3, poisson = 0.3, yield_stress = 300.0, kinematic = [ { C = 30e3, gamma = 150.0 }, { C = 3e3 } ] }
model = { plane = "stress" }
crack = [ { points = [[9.0, 0.013], [12.5, 0.513]], contact = { friction = 0.2 } },
          { points = [[-9.0, 0.013], [-13.0, 0.013]], contact = {} } ]
boundary = [ { on = "top", traction = [0.0, 1.0] }, { on = "bottom", traction = [0.0, -1.0] } ]
growth = { law = "paris", driving = "dK_eff", C = 3e-13, m = 3.0, increment = 0.08 }
fine = { refine = 16 }
load = { blocks = [ { cycles = 30, max = 70.0, ratio = 0.0 } ] }
"""
# 75 000 elements of 0.5 to 1.5 mm.
TWO_HOLES_GEO = """
SetFactory("OpenCASCADE");
Rectangle(1) = {-100, -150, 0, 200, 300};
Disk(2) = {0, 0, 0, 10};
Disk(3) = {55, 30, 0, 8};
BooleanDifference(10) = { Surface{1}; Delete; }{ Surface{2, 3}; Delete; };
Mesh.Algorithm = 6;
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 1;
Field[1] = Box;
Field[1].VIn = 0.5; Field[1].VOut = 1.5; Field[1].Thickness = 40;
Field[1].XMin = -60; Field[1].XMax = 60; Field[1].YMin = -20; Field[1].YMax = 40;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0; Mesh.MeshSizeFromCurvature = 0;
Physical Surface("plate") = {10};
t() = Curve In BoundingBox {-101, 149.9, -1, 101, 150.1, 1}; Physical Curve("top") = t();
b() = Curve In BoundingBox {-101, -150.1, -1, 101, -149.9, 1}; Physical Curve("bottom") = b();
"""
TWO_LOAD_CASES = SPECTRUM.replace("spectrum.csv", "cases.csv").replace(
    "boundary = [", 'load_case = [ { name = "side" } ]\nboundary = [ { on = "right", case = "side", traction = [1.0, 0.0] },').replace(
    '["free", 0.0]', "[0.0, 0.0]")
OWN = {"six cracks": SIX_CRACKS, "spectrum": SPECTRUM, "spectrum of two load cases": TWO_LOAD_CASES,
       "two holes": TWO_HOLES}
SAID = re.compile(r"estimate of the run: (\d+) increments, at most (\S+) of (\S+) points flow; "
                  r"about (\S+) s of a processor and (\S+) MB")


def write_spectra(folder):
    chance = random.Random(1)
    main, both = ["max,min"], ["turning_point,side"]
    for _ in range(500):
        most, least = chance.uniform(30.0, 50.0), chance.uniform(-5.0, 20.0)
        main.append(f"{most:.3f},{least:.3f}")
        both += [f"{most:.3f},{chance.uniform(0.0, 20.0):.3f}", f"{least:.3f},{chance.uniform(0.0, 20.0):.3f}"]
    (folder / "spectrum.csv").write_text("\n".join(main + [""]), encoding="utf-8")
    (folder / "cases.csv").write_text("\n".join(both + [""]), encoding="utf-8")


def case_of(name, folder):
    """Path of the case file, written into the folder where it is one of these here; none where its mesh wants gmsh."""
    first = name.split(",")[0].split(" to ")[0]
    if first not in OWN:
        return GROWING if first == "growing_cycle" else ROOT / "cases" / first / "case.toml"
    (folder / "case.toml").write_text(OWN[first], encoding="utf-8")
    if first.startswith("spectrum"):
        write_spectra(folder)
    if first == "two holes":
        if not shutil.which("gmsh"):
            return None
        (folder / "two-holes.geo").write_text(TWO_HOLES_GEO, encoding="utf-8")
        subprocess.run(["gmsh", "-2", "-v", "0", "two-holes.geo"], check=True, cwd=folder)
    return folder / "case.toml"


def settings_of(name):
    return [word for setting in RUNS[name] for word in ("--set", setting)]


def said(program, case, name):
    words = [program, "check", str(case), *settings_of(name)]
    found = SAID.search(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return [float(figure) for figure in found.groups()]


def taken(program, case, name, folder):
    words = [program, "run", str(case), "-o", folder, "--mode", "inprocess", "--quiet", "--no-report",
             "--force", *settings_of(name)]
    run = subprocess.run(["/usr/bin/time", "-f", "%U %S %M", *words], check=True, capture_output=True, text=True)
    user, system, kilobytes = (float(figure) for figure in run.stderr.split("\n")[-2].split())
    return user + system, kilobytes / 1024.0, json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only")
    parser.add_argument("--repeat", type=int, default=2)
    chosen = parser.parse_args()
    print("| case | s said, taken | ratio | MB said, taken | ratio | increments said, done | iterations of each "
          "| points said, done; that flow |")
    print("|---|---|---|---|---|---|---|---|")
    for name in RUNS:
        if chosen.only and chosen.only not in name:
            continue
        with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as folder:
            case = case_of(name, Path(place))
            if not case:
                continue
            increments, flow, points, seconds, megabytes = said(chosen.program, case, name)
            runs = [taken(chosen.program, case, name, folder) for _ in range(chosen.repeat)]
            with open(Path(folder) / "history.csv", encoding="utf-8") as file:
                done = int(file.read().splitlines()[-1].split(",")[0])
        took, resident, summary = min(runs, key=lambda run: run[0])
        print(f"| {name} | {seconds:.2g}, {took:.2g} | {seconds / took:.1f} | {megabytes:.0f}, {resident:.0f} "
              f"| {megabytes / resident:.1f} | {increments:.0f}, {done} | {summary['newton_iterations'] / done:.1f} "
              f"| {points:.0f}, {summary['fine_points']}; {flow:.0f} |", flush=True)


if __name__ == "__main__":
    main()
