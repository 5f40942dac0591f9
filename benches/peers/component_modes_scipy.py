#!/usr/bin/env python3
"""The part of `ffrf-fe/examples/large_part` with SciPy: component modes with rigid interfaces, SuperLU and eigsh.

Usage: component_modes_scipy.py FOLDER INTERFACES MODES [craig-bampton|attachment], with the arrays that
`large_part --write FOLDER` wrote. Prints seconds of each phase, peak memory of the solve, the normal frequencies and those of
the basis without rigid motion. One factorisation serves static shapes and eigenmodes, as on our side.
"""

import resource
import sys
import time
from pathlib import Path

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
import scipy.sparse.linalg as spl


def read(folder, name):
    starts = np.fromfile(folder / f"{name}.starts", dtype="<u8").astype(np.int32)
    rows = np.fromfile(folder / f"{name}.rows", dtype="<u8").astype(np.int32)
    values = np.fromfile(folder / f"{name}.values", dtype="<f8")
    return sp.csc_matrix((values, rows, starts), shape=(len(starts) - 1,) * 2)


def rigid_rows(arms):
    """Displacements of nodes that follow a point: 3 k x 6."""
    rows = np.zeros((len(arms), 3, 6))
    rows[:, 0, 0] = rows[:, 1, 1] = rows[:, 2, 2] = 1.0
    x, y, z = arms.T
    rows[:, 0, 4], rows[:, 0, 5] = z, -y
    rows[:, 1, 3], rows[:, 1, 5] = -z, x
    rows[:, 2, 3], rows[:, 2, 4] = y, -x
    return rows.reshape(-1, 6)


def coupling(positions, interfaces):
    """T with u = T y: free degrees of freedom, then six motions of each rigid interface; and the rigid motions in y."""
    taken = np.concatenate(interfaces)
    free = np.setdiff1d(np.arange(len(positions)), taken)
    free_dofs = (3 * free[:, None] + np.arange(3)).ravel()
    size = 3 * len(positions)
    blocks = [sp.csc_matrix((np.ones(len(free_dofs)), (free_dofs, np.arange(len(free_dofs)))), shape=(size, len(free_dofs)))]
    centre = positions.mean(axis=0)
    rigid = [rigid_rows(positions[free] - centre)]
    for rows in interfaces:
        point = positions[rows].mean(axis=0)
        dofs = np.repeat((3 * rows[:, None] + np.arange(3)).ravel(), 6)
        columns = np.tile(np.arange(6), 3 * len(rows))
        blocks.append(sp.csc_matrix((rigid_rows(positions[rows] - point).ravel(), (dofs, columns)), shape=(size, 6)))
        of_point = np.zeros((6, 6))
        of_point[:3] = rigid_rows((point - centre)[None])
        of_point[3:, 3:] = np.eye(3)
        rigid.append(of_point)
    return sp.hstack(blocks, format="csc"), np.vstack(rigid), len(free_dofs)


def factor(matrix):
    # The best that SuperLU offers a symmetric matrix: minimum degree on A + A^T and symmetric pivoting.
    return spl.splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})


def craig_bampton(stiffness, mass, inner, modes):
    """Constraint modes and modes with the interfaces at rest; and their eigenvalues."""
    size = stiffness.shape[0]
    lu = factor(stiffness[:inner, :inner])
    constraint = np.zeros((size, size - inner))
    constraint[:inner] = -lu.solve(stiffness[:inner, inner:].toarray())
    constraint[inner:] = np.eye(size - inner)
    values, shapes = eigenmodes(stiffness[:inner, :inner], mass[:inner, :inner].tocsc(), modes, lu.solve, inner)
    normal = np.zeros((size, modes))
    normal[:inner] = shapes
    return np.hstack([constraint, normal]), values


def attachment(stiffness, mass, rigid, inner, modes):
    """Inertia-relief attachment modes and free modes, both by the factor with the first interface held."""
    size = stiffness.shape[0]
    kept = np.concatenate([np.arange(inner), np.arange(inner + 6, size)])
    lu = factor(stiffness[kept][:, kept])
    orthonormal = rigid @ la.inv(la.cholesky(rigid.T @ (mass @ rigid)))
    mass_rigid = mass @ orthonormal

    def elastic(forces):
        forces = forces - mass_rigid @ (orthonormal.T @ forces)
        shapes = np.zeros_like(forces)
        shapes[kept] = lu.solve(forces[kept])
        return shapes - orthonormal @ (mass_rigid.T @ shapes)

    unit = np.zeros((size, size - inner))
    unit[inner:] = np.eye(size - inner)
    values, shapes = eigenmodes(stiffness, mass, modes, elastic, size)
    return np.hstack([elastic(unit), shapes]), values


def eigenmodes(stiffness, mass, modes, solve, size):
    inverse = spl.LinearOperator((size, size), matvec=solve, dtype=float)
    start = solve(mass @ np.random.default_rng(1).standard_normal(size))
    values, shapes = spl.eigsh(stiffness, k=modes, M=mass, sigma=0.0, OPinv=inverse, v0=start)
    return np.sort(values), shapes


def free_free(stiffness, mass, rigid, shapes):
    """Eigenvalues of the unsupported part within the span, rigid motion removed."""
    rigid = rigid @ la.inv(la.cholesky(rigid.T @ (mass @ rigid)))
    shapes = shapes - rigid @ ((mass @ rigid).T @ shapes)
    shapes = shapes / np.sqrt(np.einsum("ij,ij->j", shapes, mass @ shapes))
    values, vectors = la.eigh(shapes.T @ (mass @ shapes))
    shapes = shapes @ (vectors[:, values > 1e-12] / np.sqrt(values[values > 1e-12]))
    values, vectors = la.eigh(shapes.T @ (stiffness @ shapes))
    return values, shapes @ vectors


def main():
    folder, count, modes = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    basis = sys.argv[4] if len(sys.argv) > 4 else "craig-bampton"
    stiffness = read(folder, "K")
    mass = sp.kron(read(folder, "M"), sp.identity(3), format="csc")
    positions = np.fromfile(folder / "positions", dtype="<f8").reshape(-1, 3)
    interfaces = [np.fromfile(folder / f"interface{i}", dtype="<u8").astype(np.int64) for i in range(count)]
    start, start_of_work = time.perf_counter(), time.process_time()
    coordinates, rigid, inner = coupling(positions, interfaces)
    stiffness, mass = [(coordinates.T @ matrix @ coordinates).tocsc() for matrix in (stiffness, mass)]
    if basis == "craig-bampton":
        shapes, normal = craig_bampton(stiffness, mass, inner, modes)
    else:
        shapes, normal = attachment(stiffness, mass, rigid, inner, modes)
    values, shapes = free_free(stiffness, mass, rigid, shapes)
    full = coordinates @ shapes
    print(f"solve_seconds {time.perf_counter() - start:.3f}")
    print(f"processor_seconds {time.process_time() - start_of_work:.2f}")
    print(f"peak_megabytes {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.1f}")
    print(f"modes {full.shape[1]}")
    for name, list_ in (("normal_hz", normal), ("frequency_hz", values)):
        for value in list_:
            print(f"{name} {float(np.sqrt(max(value, 0.0)) / (2 * np.pi))!r}")


if __name__ == "__main__":
    main()
