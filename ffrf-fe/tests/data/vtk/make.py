"""Writes the grids of this folder from the meshes of ../gmsh, with meshio 5.3.5 and VTK 9.7.2.

    pip install meshio==5.3.5 vtk==9.7.2
    python make.py

Each format once: text, base64 deflated or not (meshio), appended in base64 or raw, 32-bit and 64-bit headers (VTK).
"""

import pathlib

import meshio
import numpy
import vtk

GMSH = pathlib.Path(__file__).resolve().parent.parent / "gmsh"


def grid(name):
    """The mesh with its groups: a number for each cell, and 0 or 1 for the points of the edge."""
    mesh = meshio.read(GMSH / name)
    end = mesh.points[:, 0] == 0.0
    tags = mesh.cell_data["gmsh:physical"]
    return meshio.Mesh(
        mesh.points,
        mesh.cells,
        point_data={"end": end.astype(numpy.int32), "height": mesh.points[:, 2]},
        cell_data={"physical": [numpy.asarray(tag, dtype=numpy.int64) for tag in tags]},
    )


meshio.vtu.write("hex20_ascii.vtu", grid("hex20_4.1.msh"), binary=False)
meshio.vtu.write("hex20_zlib.vtu", grid("hex20_4.1.msh"), compression="zlib")
meshio.vtu.write("tet10_base64.vtu", grid("tet10_4.1.msh"), compression=None)


def again(source, target, *settings):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(source)
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(target)
    for setting in settings:
        getattr(writer, setting)()
    assert writer.Write() == 1


again("hex20_ascii.vtu", "hex20_raw.vtu", "SetDataModeToAppended", "EncodeAppendedDataOff", "SetHeaderTypeToUInt64")
again("hex20_ascii.vtu", "hex20_appended.vtu", "SetDataModeToAppended", "EncodeAppendedDataOn", "SetHeaderTypeToUInt32")
again("tet10_base64.vtu", "tet10_binary.vtu", "SetDataModeToBinary", "SetCompressorTypeToNone", "SetHeaderTypeToUInt32")
