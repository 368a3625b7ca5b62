#!/usr/bin/python3
"""Looks whether the fields of a run obey mechanics, and whether they are the state that history.csv tells of.

    tools/cross_check_fields.py RESULTS

RESULTS is the folder of a run with output.format = "vtu". In each file plastic strain has no trace and is no more than
what has accumulated, von Mises' stress is that of the stress, and across the plane there is no stress in plane stress
and no strain in plane strain. Where the body is of one metal that flows, stress is what elasticity makes of the strain
that the corners of a cell show, less the plastic strain. What has accumulated never falls; without recall it is the
dissipation of history.csv, over the yield stress. Where loads act on the top and the bottom alone, horizontal sections
bear them. Needs python3-numpy. Exit code 1 where something else is found.
"""

import csv
import re
import sys
import tomllib
from pathlib import Path

import numpy

TYPES = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}
ROUNDING = 1e-9
ABOUT_A_TIP = 3.0  # sizes of a cell: there tip functions are, and displacement is not linear along its edges


def read(path):
    """The arrays of a file of VTK, by their names."""
    head, data = path.read_bytes().split(b'<AppendedData encoding="raw">\n_', 1)
    arrays = {}
    for text in re.findall(r"<DataArray [^>]*>", head.decode("ascii")):
        of = dict(re.findall(r'(\w+)="([^"]*)"', text))
        offset = int(of["offset"])
        size = int.from_bytes(data[offset : offset + 8], "little")
        values = numpy.frombuffer(data[offset + 8 : offset + 8 + size], TYPES[of["type"]])
        components = int(of["NumberOfComponents"])
        arrays[of["Name"]] = values.reshape(-1, components) if components > 1 else values
    return arrays


class Field:
    """Of one increment. A cell is a polygon of three corners or four."""

    def __init__(self, path):
        self.of = read(path)
        self.increment = int(self.of["increment"][0])
        self.points = self.of["Points"][:, :2]
        ends = self.of["offsets"]
        starts = numpy.concatenate([[0], ends[:-1]])
        last = numpy.minimum(numpy.arange(4), (ends - starts - 1)[:, None])  # the last corner of a triangle counts twice
        self.cells = self.of["connectivity"][starts[:, None] + last]
        x, y = self.corners().T.swapaxes(1, 2)
        self.area = 0.5 * (x * numpy.roll(y, -1, 1) - y * numpy.roll(x, -1, 1)).sum(1)

    def corners(self):
        return self.points[self.cells]

    def away_from(self, tips):
        """Cells in which displacement is linear along the edges."""
        away, centre = self.of["crack_side"] == 0, self.corners().mean(1)
        for tip in tips:
            away &= numpy.hypot(*(centre - tip).T) > ABOUT_A_TIP * numpy.sqrt(self.area)
        return away

    def mean_strain(self):
        """xx, yy and gamma_xy, by the displacement along the edges of each cell."""
        points, moved = self.corners(), self.of["displacement"][self.cells][:, :, :2]
        edge, middle = numpy.roll(points, -1, 1) - points, 0.5 * (numpy.roll(moved, -1, 1) + moved)
        outwards = numpy.stack([edge[:, :, 1], -edge[:, :, 0]], 2)
        gradient = numpy.einsum("cki,ckj->cij", middle, outwards) / self.area[:, None, None]
        return numpy.stack([gradient[:, 0, 0], gradient[:, 1, 1], gradient[:, 0, 1] + gradient[:, 1, 0]], 1)

    def section(self, y):
        """What a horizontal section bears, N/mm, along x and y; nothing where it leaves a row of equally high cells: means
        over cells add up to the load in such a row."""
        begin, end = self.corners(), numpy.roll(self.corners(), -1, 1)
        below, above = begin[:, :, 1] - y, end[:, :, 1] - y
        is_cut = below * above < 0.0
        row = begin[is_cut.any(1), :, 1]
        if numpy.ptp(row.min(1)) + numpy.ptp(row.max(1)) > ROUNDING * (row.max() - row.min()):
            return None
        rise = numpy.where(is_cut, above - below, 1.0)
        x = begin[:, :, 0] - below / rise * (end[:, :, 0] - begin[:, :, 0])
        right, left = numpy.where(is_cut, x, -numpy.inf).max(1), numpy.where(is_cut, x, numpy.inf).min(1)
        width = numpy.where(is_cut.any(1), right - left, 0.0)
        return width @ self.of["stress"][:, [3, 1]]


def of_elasticity(case, strain, plastic):
    """Stress xx, yy, zz, xy."""
    E, nu = case["material"]["young"], case["material"]["poisson"]
    elastic = numpy.stack([strain[:, 0] - plastic[:, 0], strain[:, 1] - plastic[:, 1], -plastic[:, 2]], 1)
    shear = 0.5 * E / (1.0 + nu) * (strain[:, 2] - 2.0 * plastic[:, 3])
    if case["model"]["plane"] == "stress":
        elastic[:, 2] = -nu / (1.0 - nu) * (elastic[:, 0] + elastic[:, 1])
    normal = E / (1.0 + nu) * (elastic + nu / (1.0 - 2.0 * nu) * elastic.sum(1)[:, None])
    return numpy.concatenate([normal, shear[:, None]], 1)


def of_one_field(case, field, row, tips, largest_load):
    """Lines that say what is wrong with it. `tips`: where they are, and were."""
    wrong = []
    material, plane_stress = case["material"], case["model"]["plane"] == "stress"
    one_metal = "region" not in case and "initial_stress" not in case
    stress, plastic, accumulated = (field.of[name] for name in ("stress", "plastic_strain", "accumulated_plastic_strain"))
    size, uncut = numpy.abs(stress).max(), field.of["crack_side"] == 0

    def ask(what, error, tolerance):
        if not error <= tolerance:
            wrong.append(f"increment {field.increment}: {what}: off by {error:.2g}")

    xx, yy, zz, xy = stress.T
    mises = numpy.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3.0 * xy**2)
    ask("von Mises' stress", numpy.abs(mises - field.of["von_mises"]).max(), ROUNDING * size)
    most = accumulated.max()
    ask("trace of the plastic strain", numpy.abs(plastic[:, :3].sum(1)).max(), ROUNDING * most + 1e-15)
    equivalent = numpy.sqrt(2.0 / 3.0 * ((plastic**2).sum(1) + plastic[:, 3] ** 2))
    ask("plastic strain beyond what has accumulated", (equivalent - accumulated).max(), ROUNDING * most + 1e-15)
    if plane_stress:
        ask("stress across the plane", numpy.abs(zz).max(), ROUNDING * size)
    elif one_metal:
        strain = (zz - material["poisson"] * (xx + yy)) / material["young"] + plastic[:, 2]
        ask("strain across the plane", numpy.abs(strain[uncut]).max(), ROUNDING * size / material["young"])
    if one_metal and "yield_stress" in material:
        error = numpy.abs(of_elasticity(case, field.mean_strain(), plastic) - stress).max(1)
        ask("stress by the strain of a cell", error[field.away_from(tips)].max(initial=0.0), 1e-7 * size)
        if "growth" not in case and not any(term.get("gamma") for term in material.get("kinematic", [])):
            dissipated = material["yield_stress"] * float(accumulated @ field.area)
            told = row["dissipation"] - row["frictional_dissipation"]
            ask("dissipation by what has accumulated", abs(dissipated - told), ROUNDING * abs(told) + 1e-14)
    ask("load by sections", section_error(case, field, row), 10.0 * case["solver"]["tolerance"] * largest_load)
    return wrong


def direction(case):
    """Of the load: of what [load] puts on the first boundary that it loads or moves. None: it is no vector."""
    given = {}
    for one in case["boundary"]:
        if "case" in one:
            continue
        if "traction" not in one and "displacement" not in one or numpy.any(one.get("traction_gradient", 0.0)):
            return None
        value = [0.0 if x == "free" else x for x in one.get("traction") or one["displacement"]]
        given[one["on"]] = given.get(one["on"], numpy.zeros(2)) + value
    return next((value / numpy.hypot(*value) for value in given.values() if value.any()), None)


def section_error(case, field, row):
    """By how much horizontal sections bear another load; 0 where one may."""
    if any(one["on"] not in ("top", "bottom") or "travelling" in one for one in case["boundary"]) or row["load"] != row["load"]:
        return 0.0
    y = field.points[:, 1]
    forces = [field.section(y.min() + part * (y.max() - y.min())) for part in (0.0313, 0.1717, 0.8431, 0.9797)]
    along = direction(case)
    told = [force @ along for force in forces if force is not None and along is not None]
    return max((abs(abs(one) - abs(row["load"])) for one in told), default=0.0)


def faults(folder):
    case = tomllib.loads((folder / "case.resolved.toml").read_text(encoding="utf-8"))
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        history = [{name: float(cell or "nan") for name, cell in row.items()} for row in csv.DictReader(file)]
    rows = {int(row["increment"]): row for row in history}
    largest_load = max((abs(row["load"]) for row in history if row["load"] == row["load"]), default=0.0)
    wrong, before = [], None
    for path in sorted((folder / "fields").glob("*.vtu")):
        field = Field(path)
        tips = {(row["x"], row["y"]) for row in history if row["increment"] <= field.increment and row["tip"] == row["tip"]}
        wrong += of_one_field(case, field, rows[field.increment], tips, largest_load)
        now = field.of["accumulated_plastic_strain"]
        if "growth" not in case and before is not None and len(before) == len(now) and (now - before).min() < -ROUNDING * now.max():
            wrong.append(f"increment {field.increment}: what has accumulated falls")
        before = now
    return wrong


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.split("\n\n")[1].strip())
    wrong = faults(Path(sys.argv[1]))
    print("\n".join(wrong) if wrong else "the fields obey mechanics, and are those of history.csv")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
