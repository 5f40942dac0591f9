#!/usr/bin/env python3
"""Elastic frequencies of the connecting rod by LAPACK: the dense generalised eigenproblem of CalculiX's matrices.

Usage: conrod_frequencies.py FOLDER_OF_CONROD > conrod_frequencies.txt (needs numpy and scipy; a minute or two).
Free, and with the nodes of the set BIG_END held. One frequency in Hz a line, 200 of each.
"""

import gzip
import sys
from pathlib import Path

import numpy as np
import scipy.linalg

COUNT = 200


def triangle(path, size):
    rows, columns, values = np.loadtxt(gzip.open(path), unpack=True)
    rows, columns = rows.astype(int) - 1, columns.astype(int) - 1
    matrix = np.zeros((size, size))
    matrix[rows, columns] = values
    matrix[columns, rows] = values
    return matrix


def node_set(path, name):
    nodes, inside = set(), False
    for line in path.read_text().splitlines():
        if line.startswith("*"):
            words = line.upper().replace(" ", "").split(",")
            inside = words[0] == "*NSET" and f"NSET={name}" in words
        elif inside:
            nodes.update(int(word) for word in line.split(",") if word.strip())
    return nodes


def frequencies(stiffness, mass, skipped):
    values = scipy.linalg.eigh(
        stiffness, mass, eigvals_only=True, subset_by_index=(skipped, skipped + COUNT - 1), check_finite=False
    )
    return np.sqrt(values) / (2.0 * np.pi)


def main():
    folder = Path(sys.argv[1])
    dofs = [line.strip() for line in (folder / "conrod.dof").read_text().split() if line.strip()]
    stiffness = triangle(folder / "conrod.sti.gz", len(dofs))
    mass = triangle(folder / "conrod.mas.gz", len(dofs))
    held = node_set(folder / "conrod.inp", "BIG_END")
    free = np.array([i for i, dof in enumerate(dofs) if int(dof.split(".")[0]) not in held])
    print("# free, then with BIG_END held")
    for value in frequencies(stiffness, mass, 6):
        print(repr(float(value)))
    for value in frequencies(stiffness[np.ix_(free, free)], mass[np.ix_(free, free)], 0):
        print(repr(float(value)))


if __name__ == "__main__":
    main()
