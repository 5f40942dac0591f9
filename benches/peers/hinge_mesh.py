#!/usr/bin/env python3
"""The hinge of Exudyn's tutorial on component modes, meshed with Netgen, as gmsh 2.2.

A plate of 400 x 40 x 20 mm with a bolt on one end and a bushing on the other; dimensions as published in the documentation of Exudyn
("Model order reduction and component mode synthesis"). Needs netgen-mesher and ngsolve of PyPI.

Usage: hinge_mesh.py OUTPUT.msh EDGE [ORDER]; EDGE is the largest edge in m, ORDER 1 (tetrahedra of 4 nodes, default) or 2 (of 10).
"""

import sys

from netgen.csg import CSGeometry, Cylinder, OrthoBrick, Plane, Pnt, Vec

LENGTH, WIDTH, HEIGHT = 0.4, 0.04, 0.02
BOLT_RADIUS, BUSHING_RADIUS, BOLT_LENGTH = 0.015, 0.03, 0.05


def cylinder_along_y(x, top, bottom, radius):
    return (Cylinder(Pnt(x, top, 0), Pnt(x, bottom, 0), radius)
            * Plane(Pnt(x, top, 0), Vec(0, 1, 0)) * Plane(Pnt(x, bottom, 0), Vec(0, -1, 0)))


def geometry():
    plate = OrthoBrick(Pnt(0, 0, -0.5 * HEIGHT), Pnt(LENGTH, WIDTH, 0.5 * HEIGHT))
    boss = cylinder_along_y(0, WIDTH, 0, 1.6 * HEIGHT)
    bolt = cylinder_along_y(0, 0.5 * WIDTH, -BOLT_LENGTH, BOLT_RADIUS)
    bushing = (cylinder_along_y(LENGTH, WIDTH, -BOLT_LENGTH, BUSHING_RADIUS)
               - cylinder_along_y(LENGTH, 0, -1.1 * BOLT_LENGTH, BOLT_RADIUS))
    result = CSGeometry()
    result.Add(plate + boss + bolt + bushing)
    return result


def main():
    path, edge = sys.argv[1], float(sys.argv[2])
    order = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    mesh = geometry().GenerateMesh(maxh=edge, curvaturesafety=2)
    if order == 2:
        mesh.SecondOrder()
    points = [point.p for point in mesh.Points()]
    elements = [[vertex.nr for vertex in element.points] for element in mesh.Elements3D()]
    kind = {4: 4, 10: 11}
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
    lines += [f"{n + 1} {x:.15e} {y:.15e} {z:.15e}" for n, (x, y, z) in enumerate(points)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    for number, nodes in enumerate(elements):
        # Netgen turns its tetrahedra the other way: the first two corners change places. Edges of gmsh: 1-2, 2-3, 3-1, 4-1, 4-3, 4-2.
        a, b, c, d, *middle = nodes
        corners = [b, a, c, d]
        if middle:
            ab, ac, ad, bc, bd, cd = middle
            corners += [ab, ac, bc, bd, cd, ad]
        lines.append(f"{number + 1} {kind[len(nodes)]} 2 1 1 " + " ".join(str(n) for n in corners))
    lines.append("$EndElements")
    with open(path, "w", newline="\n") as file:
        file.write("\n".join(lines) + "\n")
    print(f"{len(points)} nodes, {len(elements)} elements")


main()
