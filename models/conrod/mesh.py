#!/usr/bin/env python3
"""Mesh of the connecting rod and its two CalculiX decks. Python 3.8 or later, no packages.

Structured 20-node hexahedra: two rings and a shank whose outer layers are left out between the flanges.
The origin of the deck is the centre of mass. SI units (m, kg, N). The same script gives the same bytes.

Usage: mesh.py OUTPUT_FOLDER
"""
import itertools
import sys

from geometry import ACROSS, BIG, LAYERS, LENGTHWISE, SMALL, halved, shank
from hexahedron import NODES, volume_and_centre

YOUNG, POISSON, DENSITY = 210e9, 0.3, 7850.0  # structural steel
HALF_LAYERS, HALF_ACROSS = halved(LAYERS), halved(ACROSS)


class Mesh:
    """Nodes, found again by an exact key of half steps, and elements, both in the order of first use."""

    def __init__(self):
        self.index, self.points, self.elements = {}, [], []

    def node(self, key, point):
        if key not in self.index:
            self.index[key] = len(self.points)
            self.points.append(point)
        return self.index[key]

    def element(self, place, i, j, k):
        """The element whose cell is (i, j, k); place(I, J, K) gives the node at doubled indices."""
        self.elements.append([place(*(2 * c + 1 + step for c, step in zip((i, j, k), node))) for node in NODES])


def ring_node(mesh, ring, level, angle, layer):
    angle %= 2 * ring.count
    x, y = ring.plan(ring.angles[angle], 0.5 * level)
    return mesh.node((ring.name, level, angle, layer), (x, y, ring.half_thickness * HALF_LAYERS[layer]))


def add_ring(mesh, ring):
    for angle, layer in itertools.product(range(ring.count), range(len(LAYERS) - 1)):
        mesh.element(lambda i, j, k: ring_node(mesh, ring, i, j, k), 0, angle, layer)


def shank_node(mesh, i, j, k):
    if i == 0:
        return ring_node(mesh, BIG, 2, j, k)
    if i == 2 * LENGTHWISE:
        # the small end looks the other way: its root runs from +y to -y
        return ring_node(mesh, SMALL, 2, len(HALF_ACROSS) - 1 - j, k)
    x, y, half_thickness = shank(0.5 * i / LENGTHWISE, HALF_ACROSS[j])
    return mesh.node(("shank", i, j, k), (x, y, half_thickness * HALF_LAYERS[k]))


def add_shank(mesh):
    for i, j, k in itertools.product(range(LENGTHWISE), range(len(ACROSS) - 1), range(len(LAYERS) - 1)):
        pocket = j == 1 and k != 1 and 1 <= i < LENGTHWISE - 1
        if not pocket:
            mesh.element(lambda a, b, c: shank_node(mesh, a, b, c), i, j, k)


def bore(mesh, ring):
    return sorted(n for key, n in mesh.index.items() if key[:2] == (ring.name, 0))


def wrapped(numbers, per_line):
    lines = [numbers[i:i + per_line] for i in range(0, len(numbers), per_line)]
    return [", ".join(str(n) for n in line) + ("," if line is not lines[-1] else "") for line in lines]


def deck(mesh, step):
    lines = ["*HEADING", "Connecting rod, steel, SI units (m, kg, N); written by mesh.py", "*NODE, NSET=ALL"]
    # CalculiX reads at most 20 characters per number
    lines += [f"{n + 1}, " + ", ".join(f"{x:.12e}" for x in point) for n, point in enumerate(mesh.points)]
    lines.append("*ELEMENT, TYPE=C3D20, ELSET=CONROD")
    for number, nodes in enumerate(mesh.elements):
        lines += wrapped([number + 1] + [n + 1 for n in nodes], 11)
    for name, ring in (("BIG_END", BIG), ("SMALL_END", SMALL)):
        lines += [f"*NSET, NSET={name}"] + wrapped([n + 1 for n in bore(mesh, ring)], 12)
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG:.6e}, {POISSON}", "*DENSITY", f"{DENSITY}",
              "*SOLID SECTION, ELSET=CONROD, MATERIAL=STEEL", "*STEP", *step, "*END STEP"]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    mesh = Mesh()
    add_ring(mesh, BIG)
    add_shank(mesh)
    add_ring(mesh, SMALL)
    centre = volume_and_centre(mesh.points, mesh.elements)[1]
    # symmetric in y and z by construction; + 0.0 turns a negative zero into zero
    mesh.points = [(x - centre[0] + 0.0, y + 0.0, z + 0.0) for x, y, z in mesh.points]
    volume, centre, smallest = volume_and_centre(mesh.points, mesh.elements)
    decks = {"conrod.inp": ["*FREQUENCY, SOLVER=MATRIXSTORAGE", "1"], "conrod_frequencies.inp": ["*FREQUENCY", "20"]}
    for name, step in decks.items():
        with open(f"{sys.argv[1]}/{name}", "w", newline="\n") as file:
            file.write(deck(mesh, step))
    print(f"{len(mesh.points)} nodes, {3 * len(mesh.points)} dofs, {len(mesh.elements)} elements, "
          f"smallest Jacobian {smallest:.3f} of the element's centre")
    print(f"volume {volume:.6e} m^3, mass {DENSITY * volume:.6f} kg, centre of mass {centre}")


main()
