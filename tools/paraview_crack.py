#!/usr/bin/env pvpython
"""The picture of a run in ParaView 5.11 or later: the crack open over the stress or the plastic strain, its faces as lines.

In ParaView: Tools > Python Shell > Run Script. It asks for nothing where the folder of the run is the present one, or is
named in STRIA_RUN. Without a window:

    pvpython tools/paraview_crack.py runs/overload picture.png [factor]

Warps by displacement times the factor, which is chosen so that the crack is seen open unless given. Time is that of the files, in
cycles, and the last one is shown. Lines on the crack join the stations of faces.csv at that increment and carry pressure, shear,
opening, slip and status.
"""

import csv
import math
import os
import sys
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

OPEN = 0.05  # of the picture's width: the widest displacement, less its mean
FLOWED = 1e-7  # plastic strain: less is rounding
# What is shown, its title, and the share of its largest value at which colours end: a tip in an elastic body would take them all.
FLOW = ("accumulated_plastic_strain", "plastic strain", 1.0)
STRESS = ("von_mises", "von Mises stress, MPa", 0.2)
ASIDE = 1e-3  # of the distance of stations
ON_FACES = ("pressure", "shear", "opening", "slip", "status")  # columns of faces.csv

def field_file(folder):
    found = [folder / name for name in ("fields.hdf.series", "fields.pvd") if (folder / name).exists()]
    if not found:
        raise SystemExit(f"{folder} holds no fields: output.fields")
    return found[0]


def open_fields(folder, moment=None):
    """The fields of a run, at a time in cycles or else the last one; and the times."""
    fields = simple.OpenDataFile(str(field_file(folder)))
    times = list(fields.TimestepValues) if hasattr(fields, "TimestepValues") else []
    if moment is None:
        moment = times[-1] if times else 0.0
    fields.UpdatePipeline(moment)
    return fields, times


def increment_of(fields):
    """The number of the increment whose fields are shown."""
    numbers = servermanager.Fetch(fields).GetFieldData().GetArray("increment")
    return numbers.GetValue(0) if numbers else math.nan


def stations_of(folder, increment):
    """The rows of faces.csv at an increment, of each crack in their order along it."""
    if not (folder / "faces.csv").exists():
        return {}
    with open(folder / "faces.csv", encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if float(row["increment"]) == increment]
    cracks = {}
    for row in sorted(rows, key=lambda row: float(row["s"])):
        cracks.setdefault(int(row["crack"]), []).append(row)
    return cracks


def places_of(rows, side):
    """Of stations in their order; on the plus (1) or minus (-1) side of the crack by a little, where fields tell one from the other."""
    places = [(float(row["x"]), float(row["y"])) for row in rows]
    off = side * ASIDE * (float(rows[-1]["s"]) - float(rows[0]["s"])) / len(rows)
    for k, (x, y) in enumerate(places):
        (x0, y0), (x1, y1) = places[max(k - 2, 0)], places[min(k + 2, len(places) - 1)]
        length = math.hypot(x1 - x0, y1 - y0) or 1.0
        yield x - off * (y1 - y0) / length, y + off * (x1 - x0) / length


def face_lines(folder, increment, side=0):
    """The faces at an increment as a line for each crack; nothing where none are written."""
    cracks = stations_of(folder, increment)
    if not cracks:
        return None
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    data.SetPoints(points)
    data.SetLines(lines)
    arrays = {name: vtkDoubleArray() for name in ON_FACES}
    for name, array in arrays.items():
        array.SetName(name)
        data.GetPointData().AddArray(array)
    for rows in cracks.values():
        lines.InsertNextCell(len(rows))
        for row, place in zip(rows, places_of(rows, side)):
            lines.InsertCellPoint(points.InsertNextPoint(*place, 0.0))
            for name, array in arrays.items():
                array.InsertNextValue(float(row[name] or math.nan))
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def part_shown(fields):
    """Bounds of the cells that have flowed, of all where none has; whether some have; the middle of their displacements and how far
    these spread."""
    flowed = simple.Threshold(Input=fields, Scalars=["CELLS", "accumulated_plastic_strain"], LowerThreshold=FLOWED, UpperThreshold=1e9)
    flowed.UpdatePipeline()
    some = flowed.GetDataInformation().GetNumberOfCells() > 0
    bounds = (flowed if some else fields).GetDataInformation().GetBounds()
    displacement = (flowed if some else fields).PointData["displacement"]
    ranges = [displacement.GetRange(k) for k in (0, 1)]
    simple.Delete(flowed)
    return bounds, some, [0.5 * (low + high) for low, high in ranges], max(high - low for low, high in ranges)


def warped(data, middle, factor, name):
    """Displacements count from the middle of those of the part that is shown."""
    relative = simple.Calculator(Input=data, ResultArrayName="relative displacement")
    relative.Function = f"displacement - ({middle[0]!r})*iHat - ({middle[1]!r})*jHat"
    warp = simple.WarpByVector(Input=relative, Vectors=["POINTS", "relative displacement"], ScaleFactor=factor)
    simple.RenameSource(name, warp)
    return warp


def colour_by(view, display, array, title, largest):
    simple.ColorBy(display, array)
    colours = simple.GetColorTransferFunction(array[1])
    colours.ApplyPreset("Viridis (matplotlib)", True)
    colours.InvertTransferFunction()  # light where there is nothing
    colours.RescaleTransferFunction(0.0, largest)
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle, bar.TitleFontSize, bar.LabelFontSize = title, "", 9, 8
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.AutoOrient, bar.Orientation, bar.WindowLocation, bar.ScalarBarLength = 0, "Horizontal", "Upper Center", 0.4
    display.SetScalarBarVisibility(view, True)


def show_fields(view, warp, plastic):
    display = simple.Show(warp, view)
    name, title, share = FLOW if plastic else STRESS
    largest = share * warp.CellData[name].GetRange()[1]
    colour_by(view, display, ("CELLS", name), title, float(f"{largest:.1g}"))


def show_faces(view, fields, lines, middle, factor, name):
    """A line that goes with the body."""
    moved = simple.ResampleWithDataset(SourceDataArrays=fields, DestinationMesh=lines, PassPointArrays=1, MarkBlankPointsAndCells=0)
    warp = warped(moved, middle, factor, name)
    display = simple.Show(warp, view)
    display.SetRepresentationType("Wireframe")
    display.LineWidth = 3.0
    display.RenderLinesAsTubes = 1
    simple.ColorBy(display, ("POINTS", "pressure"))
    display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, False)


def aim(view, bounds):
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    centre = (0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]))
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = "2D"
    view.CameraFocalPoint = [*centre, 0.0]
    view.CameraPosition = [*centre, 10.0 * max(width, height)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.7 * max(height, 0.6 * width)


def draw(folder, factor=None):
    simple._DisableFirstRenderCameraReset()  # the camera is ours
    fields, times = open_fields(folder)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    if times:
        scene.AnimationTime = times[-1]
    bounds, plastic, middle, spread = part_shown(fields)
    if factor is None:
        factor = OPEN * (bounds[1] - bounds[0]) / spread if spread > 0.0 else 1.0
        factor = float(f"{factor:.1g}")
    view = simple.GetActiveViewOrCreate("RenderView")
    show_fields(view, warped(fields, middle, factor, f"crack open, displacement x {factor:.3g}"), plastic)
    increment = increment_of(fields)
    for side, word in ((1, "plus"), (-1, "minus")):
        lines = face_lines(folder, increment, side)
        if lines:
            show_faces(view, fields, lines, middle, factor, f"{word} face at increment {increment:g}")
    aim(view, bounds)
    simple.Render(view)
    return view


def main(arguments):
    folder = Path(arguments[0] if arguments else os.environ.get("STRIA_RUN", "."))
    view = draw(folder, float(arguments[2]) if len(arguments) > 2 else None)
    if len(arguments) > 1:
        simple.SaveScreenshot(arguments[1], view, ImageResolution=[1400, 900])


if __name__ in ("__main__", "__vtkconsole__"):
    main(sys.argv[1:])
