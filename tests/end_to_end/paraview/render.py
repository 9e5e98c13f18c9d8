# SPDX-License-Identifier: GPL-3.0-or-later
"""pvbatch render.py OUT FILE...

Opens each file (.hdf particle file, .vtu, .pvd) in ParaView and renders its particles, coloured by
speed, to OUT/NAME_KIND.png. Fails if a file has no particles, if a reader lacks the fields that we
write, or if a picture is blank.
"""

import os
import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

# VTKHDF shares the GADGET names of /PartType0, VTU has the names of the field table.
EXPECTED = {
    ".hdf": ("Velocities", ["Masses", "Density", "SmoothingLength", "ParticleIDs", "ParticleTypes"]),
    ".vtu": ("velocity", ["type"]),
    ".pvd": ("velocity", ["type"]),
}


def fail(message):
    print("render.py: " + message, file=sys.stderr, flush=True)
    os._exit(1)  # pvbatch turns sys.exit(1) into exit code 0


def open_in_paraview(path):
    reader = simple.OpenDataFile(path)
    if reader is None:
        fail(f"{path}: ParaView has no reader for it")
    reader.UpdatePipeline()
    times = list(getattr(reader, "TimestepValues", []) or [])
    if path.endswith(".pvd"):
        if not times:
            fail(f"{path}: ParaView finds no times")
        reader.UpdatePipeline(times[-1])
    return reader, times


def check_arrays(reader, path):
    velocity, others = EXPECTED[os.path.splitext(path)[1]]
    information = reader.GetDataInformation()
    if information.GetNumberOfPoints() == 0:
        fail(f"{path}: ParaView finds no particles")
    if information.GetNumberOfCells() != information.GetNumberOfPoints():
        fail(f"{path}: not one cell a particle")
    names = set(reader.PointData.keys())
    for name in [velocity, *others]:
        if name not in names:
            fail(f"{path}: ParaView finds no field {name}; it has {', '.join(sorted(names))}")
    return velocity, information


def render(reader, velocity, information, picture, time):
    view = simple.CreateRenderView(ViewSize=[900, 700])
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    if time is not None:
        view.ViewTime = time
    display = simple.Show(reader, view)
    display.SetRepresentationType("Point Gaussian")
    bounds = information.GetBounds()
    extents = [bounds[2 * k + 1] - bounds[2 * k] for k in range(3)]
    axes = [extent for extent in extents if extent > 0]
    volume = 1.0
    for extent in axes:
        volume *= extent
    spacing = (volume / information.GetNumberOfPoints()) ** (1 / max(len(axes), 1))
    display.GaussianRadius = 0.5 * spacing
    simple.ColorBy(display, ("POINTS", velocity, "Magnitude"))
    display.RescaleTransferFunctionToDataRange(True, False)
    view.ResetCamera()
    simple.Render(view)
    simple.SaveScreenshot(picture, view)
    simple.Delete(view)


def check_picture(picture):
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    colours = len(set((pixels[:, 0] * 65536 + pixels[:, 1] * 256 + pixels[:, 2]).tolist()))
    drawn = (pixels != 255).any(axis=1).mean()
    # A blank picture has one colour; the sparsest of ours (a few particles) covers over 1 %.
    if colours < 8 or drawn < 0.01:
        fail(f"{picture}: blank ({colours} colours, {100 * drawn:.1f} % drawn)")
    return colours, drawn


def main():
    out = sys.argv[1]
    for path in sys.argv[2:]:
        stem, ending = os.path.splitext(os.path.basename(path))
        picture = os.path.join(out, f"{stem}_{ending[1:]}.png")
        if os.path.exists(picture):
            os.remove(picture)
        reader, times = open_in_paraview(path)
        velocity, information = check_arrays(reader, path)
        render(reader, velocity, information, picture, times[-1] if times else None)
        if not os.path.exists(picture):
            fail(f"{picture}: was not written")
        colours, drawn = check_picture(picture)
        print(f"{path}: {information.GetNumberOfPoints()} particles, {len(times)} times -> "
              f"{picture} ({colours} colours, {100 * drawn:.0f} % drawn)", flush=True)
        simple.Delete(reader)


main()
