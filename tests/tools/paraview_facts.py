"""What ParaView finds in the fields and faces of a run, as JSON. Run by pvpython:  paraview_facts.py RUN

Nothing is drawn, so it needs no display.
"""

import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))

from paraview import servermanager  # noqa: E402
from paraview_crack import face_lines, increment_of, open_fields  # noqa: E402


def values_of(data, name):
    array = data.GetArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfTuples())]


def jump_at(grid, place):
    """The largest difference of displacements between points at one place: how far the crack is open there."""
    displacement = grid.GetPointData().GetArray("displacement")
    here = [k for k in range(grid.GetNumberOfPoints()) if all(abs(a - b) < 1e-9 for a, b in zip(grid.GetPoint(k), place))]
    across = [displacement.GetTuple3(k)[1] for k in here]
    return max(across) - min(across)


def facts_at(folder, moment):
    fields, times = open_fields(folder, moment)
    grid = servermanager.Fetch(fields)
    cells = grid.GetCellData()
    lines = face_lines(folder, increment_of(fields))
    faces = servermanager.Fetch(lines)
    centres = [0.5 * (low + high) for low, high in (grid.GetCell(k).GetBounds()[:2] for k in range(grid.GetNumberOfCells()))]
    flowed = [x for x, strain in zip(centres, values_of(cells, "accumulated_plastic_strain")) if strain > 1e-7]
    return {
        "times": times,
        "increment": increment_of(fields),
        "cycle": grid.GetFieldData().GetArray("cycle").GetValue(0),
        "jump at the mouth": jump_at(grid, (0.0, 50.0, 0.0)),
        "flowed from": min(flowed),
        "cells in the zone": sum(zone > 0.0 for zone in values_of(cells, "zone")),
        "lines": faces.GetNumberOfCells(),
        "stations": faces.GetNumberOfPoints(),
        **{name: values_of(faces.GetPointData(), name) for name in ("pressure", "shear", "slip", "status")},
    }


def main(folder):
    _, times = open_fields(folder)
    print(json.dumps([facts_at(folder, moment) for moment in times]))


main(Path(sys.argv[1]))
