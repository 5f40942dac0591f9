#!/usr/bin/env python3
"""Mesh of a shaft with two discs, 20-node hexahedra, as gmsh 2.2. Python 3.8 or later, no packages.

The shaft lies along x from 0, round, with square elements in its core; SI units (m). The same script gives the same bytes.

Usage: mesh.py OUTPUT.msh
"""
import math
import sys

RADIUS = 0.02                                       # of the shaft
SECTIONS = [0.0, 0.04, 0.08, 0.12, 0.16, 0.20, 0.225, 0.25, 0.30, 0.35, 0.40, 0.42, 0.44, 0.48, 0.52, 0.56, 0.60]
DISCS = [(5, 7, [0.055, 0.10]), (10, 12, [0.045, 0.07])]  # from section, to section, radii of rings
CORE = (0.55, 0.43)                                 # of the radius: points on the axes, corners
CIRCLE = 8                                          # elements around

# Corners that each edge joins, in the order of gmsh's 20-node hexahedron.
EDGES = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]


class Mesh:
    """Nodes by keys, elements by their nodes, both in the order of first use."""

    def __init__(self):
        self.index, self.points, self.elements = {}, [], []

    def node(self, key, point):
        if key not in self.index:
            self.index[key] = len(self.points)
            self.points.append(point)
        return self.index[key]

    def corner(self, section, place):
        return self.node((section, place), (SECTIONS[section],) + in_plane(place))

    def hexahedron(self, section, face):
        """The element over a quadrilateral of places in the plane, between a section and the next."""
        corners = [(section, place) for place in face] + [(section + 1, place) for place in face]
        nodes = [self.corner(*corner) for corner in corners]
        for a, b in EDGES:
            nodes.append(self.middle(corners[a], corners[b]))
        self.elements.append(nodes)

    def middle(self, a, b):
        x = 0.5 * (SECTIONS[a[0]] + SECTIONS[b[0]])
        (y, z), (v, w) = in_plane(a[1]), in_plane(b[1])
        point = (0.5 * (y + v), 0.5 * (z + w))
        if a[0] == b[0] and a[1][0] == b[1][0] == "ring" and a[1][1] == b[1][1]:
            radius = a[1][1]                        # along a circle
            scale = radius / math.hypot(*point)
            point = (scale * point[0], scale * point[1])
        return self.node(("middle",) + tuple(sorted([a, b])), (x,) + point)


def in_plane(place):
    """y, z of ("centre",), ("core", k) or ("ring", radius, k)."""
    if place[0] == "centre":
        return 0.0, 0.0
    k = place[-1]
    radius = RADIUS * (CORE[0] if k % 2 == 0 else CORE[1] * math.sqrt(2.0)) if place[0] == "core" else place[1]
    angle = 2.0 * math.pi * k / CIRCLE
    return radius * math.cos(angle), radius * math.sin(angle)


def build():
    mesh = Mesh()
    for section in range(len(SECTIONS) - 1):
        for k in range(0, CIRCLE, 2):
            around = [("core", (k + i) % CIRCLE) for i in range(3)]
            mesh.hexahedron(section, [("centre",)] + around)
        radii = [None, RADIUS]
        for first, last, rings in DISCS:
            if first <= section < last:
                radii += rings
        for inner, outer in zip(radii, radii[1:]):
            for k in range(CIRCLE):
                next_k = (k + 1) % CIRCLE
                place = lambda radius, k: ("core", k) if radius is None else ("ring", radius, k)
                mesh.hexahedron(section, [place(inner, k), place(outer, k), place(outer, next_k), place(inner, next_k)])
    return mesh


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    mesh = build()
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(mesh.points))]
    lines += [f"{n + 1} " + " ".join(f"{x + 0.0:.12e}" for x in point) for n, point in enumerate(mesh.points)]
    lines += ["$EndNodes", "$Elements", str(len(mesh.elements))]
    lines += [f"{n + 1} 17 2 1 1 " + " ".join(str(m + 1) for m in nodes) for n, nodes in enumerate(mesh.elements)]
    lines.append("$EndElements")
    with open(sys.argv[1], "w", newline="\n") as file:
        file.write("\n".join(lines) + "\n")
    print(f"{len(mesh.points)} nodes, {len(mesh.elements)} elements")


main()
