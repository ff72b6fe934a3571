#!/usr/bin/python3
"""Draws docs/images/press-temperature.png from the fields of a run of the shipped press.

    xvfb-run -a scripts/draw-press.py results/jl75g-60 docs/images/press-temperature.png

The half model is mirrored at x = 0. On the half at the left of the picture, parts that hide the linkage are left out. The shape is the
deformed one, its displacement enlarged. Needs python3-vtk9 and, without a screen, xvfb (scripts/packages-checks).
"""
import argparse
import json
import os
import xml.etree.ElementTree as ElementTree

import vtk

TEMPERATURE, DISPLACEMENT = "temperature [degC]", "displacement [mm]"
ENLARGED = 300
OPENED = ("upper_beam_front_plate", "column_front", "guide_4_front", "pin_h", "flywheel")
WIDTH, HEIGHT = 900, 1120
# degC at the ends of the scale, and its colours from cold to warm
RANGE = (20, 65)
COLOURS = ((0.19, 0.21, 0.58), (0.27, 0.46, 0.71), (0.45, 0.68, 0.82), (0.67, 0.85, 0.78), (0.98, 0.93, 0.66),
           (0.99, 0.68, 0.38), (0.96, 0.43, 0.26), (0.65, 0.0, 0.15))


def last_field(results):
    """Path of the field file of the latest time."""
    sets = ElementTree.parse(os.path.join(results, "fields.pvd")).getroot().iter("DataSet")
    return os.path.join(results, max(sets, key=lambda entry: float(entry.get("timestep"))).get("file"))


def part_numbers(results, names):
    """Numbers in the fields' `part` of the parts that are left out: the order of parts is that of view.json."""
    with open(os.path.join(results, "view.json"), encoding="utf-8") as file:
        parts = [part["name"] for part in json.load(file)["parts"]]
    missing = [name for name in names if name not in parts]
    if missing:
        raise SystemExit(f"error: no part {', '.join(missing)} in {results}\n  help: give the results of the shipped press")
    return {parts.index(name) for name in names}


def deformed(path):
    # On several ranks each wrote a piece.
    reader = vtk.vtkXMLPUnstructuredGridReader() if path.endswith(".pvtu") else vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    grid.GetPointData().SetActiveVectors(DISPLACEMENT)
    grid.GetPointData().SetActiveScalars(TEMPERATURE)
    warp = vtk.vtkWarpVector()
    warp.SetInputData(grid)
    warp.SetScaleFactor(ENLARGED * 1e-3)  # points are in metres
    warp.Update()
    return warp.GetOutput()


def without(grid, numbers):
    kept = vtk.vtkIdList()
    part = grid.GetCellData().GetArray("part")
    for cell in range(grid.GetNumberOfCells()):
        if int(part.GetValue(cell)) not in numbers:
            kept.InsertNextId(cell)
    extract = vtk.vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(kept)
    extract.Update()
    return extract.GetOutput()


def skin(grid):
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return surface.GetOutput()


def mirrored(surface):
    turn = vtk.vtkTransform()
    turn.Scale(-1, 1, 1)
    flip = vtk.vtkTransformPolyDataFilter()
    flip.SetInputData(surface)
    flip.SetTransform(turn)
    normals = vtk.vtkReverseSense()
    normals.SetInputConnection(flip.GetOutputPort())
    normals.Update()
    return normals.GetOutput()


def colours():
    table = vtk.vtkColorTransferFunction()
    for i, colour in enumerate(COLOURS):
        table.AddRGBPoint(RANGE[0] + (RANGE[1] - RANGE[0]) * i / (len(COLOURS) - 1), *colour)
    return table


def add(renderer, surface, table):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(table)
    mapper.SetUseLookupTableScalarRange(True)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.65)
    renderer.AddActor(actor)
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.SetFeatureAngle(40)
    lines = vtk.vtkPolyDataMapper()
    lines.SetInputConnection(edges.GetOutputPort())
    lines.ScalarVisibilityOff()
    drawn = vtk.vtkActor()
    drawn.SetMapper(lines)
    drawn.GetProperty().SetColor(0.1, 0.1, 0.1)
    renderer.AddActor(drawn)


def add_text(renderer, text, height, size, bold):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    style = actor.GetTextProperty()
    style.SetFontSize(size)
    style.SetBold(bold)
    style.SetColor(0.1, 0.1, 0.1) if bold else style.SetColor(0.4, 0.4, 0.4)
    actor.SetDisplayPosition(28, height)
    renderer.AddActor2D(actor)


def add_scale(renderer, table):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle("degC")
    bar.SetNumberOfLabels(6)
    bar.SetLabelFormat("%.0f")
    bar.SetPosition(0.86, 0.3)
    bar.SetWidth(0.1)
    bar.SetHeight(0.5)
    bar.UnconstrainedFontSizeOn()
    bar.SetVerticalTitleSeparation(14)
    for style in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        style.SetFontSize(21)
        style.SetColor(0.1, 0.1, 0.1)
        style.ItalicOff()
        style.ShadowOff()
        style.BoldOff()
    renderer.AddActor2D(bar)


def scene(results):
    grid = deformed(last_field(results))
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    table = colours()
    add(renderer, skin(grid), table)
    add(renderer, mirrored(skin(without(grid, part_numbers(results, OPENED)))), table)
    add_text(renderer, "JL75G-60 after three hours at 200 rpm", HEIGHT - 46, 26, True)
    add_text(renderer, f"temperature on the deformed shape (displacement x {ENLARGED}), one half opened", HEIGHT - 78, 19, False)
    add_scale(renderer, table)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(-0.1, -1.02, 0)
    camera.SetPosition(-2.6, 0.6, -8.2)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(25)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", help="folder of `deadpoint run cases/jl75g-60/case.toml`")
    parser.add_argument("picture", help="PNG file to write")
    options = parser.parse_args()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(WIDTH, HEIGHT)
    window.SetMultiSamples(8)
    window.AddRenderer(scene(options.results))
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
