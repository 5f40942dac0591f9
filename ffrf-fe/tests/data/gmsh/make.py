"""Writes the meshes of this folder with gmsh 4.15.2, and their frequencies by CalculiX 2.20 to frequencies.txt.

    pip install gmsh==4.15.2 meshio==5.3.5
    python make.py

A beam of 1 x 0.1 x 0.2 with hexahedra or tetrahedra of first and second order; physical groups: the volume, the end
surface at x = 0, the edge at x = 1, y = 0, and the corner at x = 1, y = z = 0, which has no name. CalculiX gets the same
mesh by way of meshio.
"""

import pathlib
import subprocess
import tempfile

import gmsh
import meshio

YOUNG, POISSON, DENSITY = 2.1e11, 0.3, 7850.0


def mesh(hexahedra, order):
    gmsh.clear()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
    corner = gmsh.model.geo.addPoint(0, 0, 0)
    _, edge = gmsh.model.geo.extrude([(0, corner)], 0, 0.1, 0, [1], recombine=hexahedra)[:2]
    _, end = gmsh.model.geo.extrude([edge], 0, 0, 0.2, [1], recombine=hexahedra)[:2]
    _, volume = gmsh.model.geo.extrude([end], 1, 0, 0, [6], recombine=hexahedra)[:2]
    gmsh.model.geo.synchronize()
    at = lambda dimension, *box: [tag for _, tag in gmsh.model.getEntitiesInBoundingBox(*box, dimension)]
    small = 1e-6
    groups = [
        (3, [volume[1]], "part"),
        (2, [end[1]], "left end"),
        (1, at(1, 1 - small, -small, -small, 1 + small, small, 0.2 + small), "edge"),
        (0, at(0, 1 - small, -small, -small, 1 + small, small, small), None),
    ]
    for tag, (dimension, members, name) in enumerate(groups, 5):
        assert len(members) == 1, (dimension, members)
        gmsh.model.addPhysicalGroup(dimension, members, tag)
        if name:
            gmsh.model.setPhysicalName(dimension, tag, name)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(order)


def frequencies(path):
    """The first four of the beam with its left end held, in Hz."""
    part = meshio.read(path)
    (cells,) = [block for block in part.cells if block.dim == 3]
    kind = {"tetra": "C3D4", "tetra10": "C3D10", "hexahedron": "C3D8", "hexahedron20": "C3D20"}[cells.type]
    lines = ["*NODE"]
    lines += [f"{row + 1},{x:.17g},{y:.17g},{z:.17g}" for row, (x, y, z) in enumerate(part.points)]
    lines.append(f"*ELEMENT,TYPE={kind},ELSET=ALL")
    for number, nodes in enumerate(cells.data + 1, 1):
        words = [str(word) for word in (number, *nodes)]
        lines += [",".join(words[:10]) + ","] * (len(words) > 10) + [",".join(words[10 * (len(words) > 10) :])]
    held = [str(row + 1) for row, (x, _, _) in enumerate(part.points) if abs(x) < 1e-9]
    lines += ["*BOUNDARY"] + [f"{row},1,3" for row in held]
    lines += ["*MATERIAL,NAME=STEEL", "*ELASTIC", f"{YOUNG},{POISSON}", "*DENSITY", str(DENSITY)]
    lines += ["*SOLID SECTION,ELSET=ALL,MATERIAL=STEEL", "*STEP", "*FREQUENCY", "4", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "job.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "job"], cwd=folder, check=True, capture_output=True)
        rows = (pathlib.Path(folder) / "job.dat").read_text().split("\n")
    # MODE NO, EIGENVALUE, rad/s, cycles/s, imaginary part
    found = [row.split() for row in rows if len(row.split()) == 5 and row.split()[0].isdigit()]
    return [float(row[3]) for row in found[:4]]


gmsh.initialize()
table = []
for name, hexahedra, order in [("tet4", 0, 1), ("tet10", 0, 2), ("hex8", 1, 1), ("hex20", 1, 2)]:
    mesh(hexahedra, order)
    for version in ["4.1", "2.2"] if order == 2 else ["4.1"]:
        gmsh.option.setNumber("Mesh.MshFileVersion", float(version))
        path = f"{name}_{version}.msh"
        gmsh.write(path)
        # CalculiX integrates the mass of C3D4 with one point: no witness
        if name == "tet4":
            continue
        table.append(f"{path} " + " ".join(f"{value:.7e}" for value in frequencies(path)))
pathlib.Path("frequencies.txt").write_text("\n".join(table) + "\n")
