"""Writes part.bdf, part.pch and the files .op4 with pyNastran 1.4.1 and pyYeti 1.4.7: one hexahedron of steel, its matrices integrated here by NumPy.

    pip install pyNastran==1.4.1 pyyeti==1.4.7
    python make.py
"""

import itertools

import numpy

numpy.in1d = numpy.isin  # older name, which pyNastran 1.4.1 calls

from pyNastran.bdf.bdf import BDF
from pyNastran.op4.op4 import OP4
from pyyeti.nastran import op4

LENGTHS = numpy.array([0.5, 0.25, 0.125])
YOUNG, POISSON, DENSITY = 2.1e11, 0.3, 7850.0
# corners of CHEXA in order, and their grid points, which are not in order
CORNERS = numpy.array(
    [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]]
)
GRIDS = [10, 20, 40, 30, 50, 60, 80, 70]


def matrices():
    """Stiffness 24 x 24 and mass of one direction 8 x 8, by 2 x 2 x 2 Gauss points."""
    lame = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    shear = YOUNG / (2 * (1 + POISSON))
    elastic = numpy.zeros((6, 6))
    elastic[:3, :3] = lame
    elastic += numpy.diag([2 * shear] * 3 + [shear] * 3)
    stiffness, mass = numpy.zeros((24, 24)), numpy.zeros((8, 8))
    volume = LENGTHS.prod() / 8
    for point in itertools.product([-1 / 3**0.5, 1 / 3**0.5], repeat=3):
        factors = (1 + CORNERS * point) / 2
        shape = factors.prod(axis=1)
        gradient = numpy.empty((8, 3))
        for k in range(3):
            others = [i for i in range(3) if i != k]
            gradient[:, k] = CORNERS[:, k] / 2 * factors[:, others].prod(axis=1) * 2 / LENGTHS[k]
        strain = numpy.zeros((6, 24))
        for node, (x, y, z) in enumerate(gradient):
            strain[:, 3 * node : 3 * node + 3] = [
                [x, 0, 0], [0, y, 0], [0, 0, z], [y, x, 0], [z, 0, x], [0, z, y]
            ]  # fmt: skip
        stiffness += volume * strain.T @ elastic @ strain
        mass += volume * DENSITY * numpy.outer(shape, shape)
    return stiffness, mass


def add(model, name, matrix):
    """The upper triangle in the order of grid points, column by column."""
    labels = [(GRIDS[row // 3], row % 3 + 1) for row in range(24)]
    order = sorted(range(24), key=lambda row: labels[row])
    columns, rows, values = [], [], []
    for at, column in enumerate(order):
        for row in order[: at + 1]:
            if abs(matrix[row, column]) > 1e-9 * abs(matrix).max():
                columns.append(labels[column])
                rows.append(labels[row])
                values.append(matrix[row, column])
    model.add_dmig(name, 6, 2, 0, 0, None, columns, rows, values)


deck = BDF(debug=False)
for corner, grid in zip(CORNERS, GRIDS):
    deck.add_grid(grid, (corner + 1) / 2 * LENGTHS)
deck.add_grid(99, [0.0, 0.0, 1.0], comment="a point without elements")
deck.add_chexa(1, 1, GRIDS)
deck.add_psolid(1, 1)
deck.add_mat1(1, YOUNG, None, POISSON, rho=DENSITY)
deck.add_set1(4, [10, 30, 50, 70], comment="the end at x = 0")
deck.write_bdf("part.bdf")

punch = BDF(debug=False)
stiffness, mass = matrices()
add(punch, "KAAX", stiffness)
add(punch, "MAAX", numpy.kron(mass, numpy.eye(3)))
punch.write_bdf("part.pch", is_double=True)

# The same matrices by columns: in the order of the grid points, and with the rows of rotations and of the point without elements.
order = sorted(range(24), key=lambda row: (GRIDS[row // 3], row % 3))
full = [matrix[numpy.ix_(order, order)] for matrix in (stiffness, numpy.kron(mass, numpy.eye(3)))]
large = [numpy.zeros((54, 54)) for _ in full]
rows = [6 * (row // 3) + row % 3 for row in range(24)]
for target, matrix in zip(large, full):
    target[numpy.ix_(rows, rows)] = matrix
OP4(debug=False).write_op4("text.op4", {"KAA": (6, full[0]), "MAA": (6, full[1])}, is_binary=False)
for name, matrices, binary, sparse, endian in [
    ("binary.op4", full, True, "dense", "<"),
    ("text_strings.op4", full, False, "nonbigmat", ""),
    ("text_big_strings.op4", large, False, "bigmat", ""),
    ("binary_strings.op4", large, True, "nonbigmat", ">"),
    ("binary_big_strings.op4", full, True, "bigmat", "<"),
]:
    op4.write(name, ["KGG", "MGG"], matrices, binary=binary, sparse=sparse, endian=endian, forms=[6, 6])
