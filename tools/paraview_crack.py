#!/usr/bin/env pvpython
"""The picture of a run in ParaView 5.11 or later: the crack open, coloured by plastic strain, the faces by their pressure.

In ParaView: Tools > Python Shell > Run Script. It asks for nothing where the folder of the run is the present one, or is
named in STRIA_RUN. Without a window:

    pvpython tools/paraview_crack.py runs/overload picture.png [factor]

Warps by displacement times the factor, which is chosen so that the crack is seen open unless given. Time is that of the files, the
number of the increment, and the last one is shown; points on the crack are the stations of faces.csv at that increment.
"""

import math
import os
import sys
from pathlib import Path

from paraview import simple

OPEN = 0.05  # of the picture's width: the widest displacement, less its mean
FLOWED = 1e-7  # plastic strain: less is rounding


def field_file(folder):
    found = [folder / name for name in ("fields.hdf.series", "fields.pvd") if (folder / name).exists()]
    if not found:
        raise SystemExit(f"{folder} holds no fields: output.fields")
    return found[0]


def flowed_part(fields):
    """Bounds of the cells that have flowed, of all where none has; the middle of their displacements, and how far they spread."""
    flowed = simple.Threshold(Input=fields, Scalars=["CELLS", "accumulated_plastic_strain"], LowerThreshold=FLOWED, UpperThreshold=1e9)
    flowed.UpdatePipeline()
    some = flowed.GetDataInformation().GetNumberOfCells() > 0
    bounds = (flowed if some else fields).GetDataInformation().GetBounds()
    displacement = (flowed if some else fields).PointData["displacement"]
    ranges = [displacement.GetRange(k) for k in (0, 1)]
    simple.Delete(flowed)
    return bounds, [0.5 * (low + high) for low, high in ranges], max(high - low for low, high in ranges)


def show_fields(view, fields, middle, factor):
    """Displacements count from those of the plastic zone, so the faces stay where faces.csv has them."""
    relative = simple.Calculator(Input=fields, ResultArrayName="relative displacement")
    relative.Function = f"displacement - ({middle[0]!r})*iHat - ({middle[1]!r})*jHat"
    warp = simple.WarpByVector(Input=relative, Vectors=["POINTS", "relative displacement"], ScaleFactor=factor)
    simple.RenameSource(f"crack open, displacement x {factor:.3g}", warp)
    display = simple.Show(warp, view)
    simple.ColorBy(display, ("CELLS", "accumulated_plastic_strain"))
    display.RescaleTransferFunctionToDataRange(False, True)
    colours = simple.GetColorTransferFunction("accumulated_plastic_strain")
    colours.ApplyPreset("Viridis (matplotlib)", True)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.TitleFontSize, bar.LabelFontSize = "plastic strain", 14, 12


def show_faces(view, folder, increment):
    """Stations of the faces as points: pressure, slip, opening and status to choose from."""
    if not (folder / "faces.csv").exists():
        return
    table = simple.CSVReader(FileName=[str(folder / "faces.csv")])
    rows = simple.ThresholdTable(Input=table, Column=["ROWS", "increment"], MinValue=increment, MaxValue=increment)
    rows.UpdatePipeline()
    if rows.GetDataInformation().GetNumberOfRows() == 0:
        return
    written = simple.TableToPoints(Input=rows, XColumn="x", YColumn="y", a2DPoints=1, KeepAllDataArrays=1)
    simple.RenameSource(f"faces at increment {increment:g}", written)
    display = simple.Show(written, view)
    display.SetRepresentationType("Points")
    display.PointSize = 5.0
    simple.ColorBy(display, ("POINTS", "pressure"))
    display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, False)


def aim(view, bounds):
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    centre = (0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]))
    view.InteractionMode = "2D"
    view.CameraFocalPoint = [*centre, 0.0]
    view.CameraPosition = [*centre, 10.0 * max(width, height)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = 0.7 * max(height, 0.6 * width)


def draw(folder, factor=None):
    simple._DisableFirstRenderCameraReset()  # the camera is ours
    fields = simple.OpenDataFile(str(field_file(folder)))
    times = list(fields.TimestepValues) if hasattr(fields, "TimestepValues") else []
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    if times:
        scene.AnimationTime = times[-1]
    fields.UpdatePipeline(times[-1] if times else 0.0)
    bounds, middle, spread = flowed_part(fields)
    if factor is None:
        factor = OPEN * (bounds[1] - bounds[0]) / spread if spread > 0.0 else 1.0
        factor = float(f"{factor:.1g}")
    view = simple.GetActiveViewOrCreate("RenderView")
    show_fields(view, fields, middle, factor)
    show_faces(view, folder, times[-1] if times else math.nan)
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
