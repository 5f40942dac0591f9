#!/usr/bin/env python3
"""The brick of `ffrf-fe/examples/brick_modes.rs` with SciPy: eigsh, shift-invert, SuperLU.

Usage: brick_scipy.py FOLDER MODES [free|clamped], with the arrays that `brick_modes --write FOLDER` wrote.
Prints seconds of each phase, peak memory of the solve and the elastic frequencies.
"""

import resource
import sys
import time
from pathlib import Path

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl


def read(folder, name):
    starts = np.fromfile(folder / f"{name}.starts", dtype="<u8").astype(np.int32)
    rows = np.fromfile(folder / f"{name}.rows", dtype="<u8").astype(np.int32)
    values = np.fromfile(folder / f"{name}.values", dtype="<f8")
    return sp.csc_matrix((values, rows, starts), shape=(len(starts) - 1,) * 2)


def main():
    folder, modes = Path(sys.argv[1]), int(sys.argv[2])
    clamped = len(sys.argv) > 3 and sys.argv[3] == "clamped"
    stiffness = read(folder, "K")
    mass = sp.kron(read(folder, "M"), sp.identity(3), format="csc")
    rigid = 6
    if clamped:
        held = np.fromfile(folder / "face", dtype="<u8").astype(np.int64)
        free = np.setdiff1d(np.arange(stiffness.shape[0]), (3 * held[:, None] + np.arange(3)).ravel())
        stiffness, mass = stiffness[free][:, free].tocsc(), mass[free][:, free].tocsc()
        rigid = 0
    start = time.perf_counter()
    # A negative shift below the first elastic eigenvalue: a free body has six zero eigenvalues. It is given
    # to SciPy for nothing; our side finds its own within its time.
    shift = -((2 * np.pi * (50.0 if clamped else 300.0)) ** 2)
    # The best that SuperLU offers a symmetric matrix: minimum degree on A + A^T and symmetric pivoting.
    factor = spl.splu(
        (stiffness - shift * mass).tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    factored = time.perf_counter()
    print(f"factorising {factored - start:.2f} s, {factor.nnz * 1e-6:.1f} million entries of L and U")
    inverse = spl.LinearOperator(stiffness.shape, matvec=factor.solve, dtype=float)
    counted = time.perf_counter()
    start_vector = np.random.default_rng(1).standard_normal(stiffness.shape[0])
    values, _ = spl.eigsh(stiffness, k=modes + rigid, M=mass, sigma=shift, OPinv=inverse, v0=start_vector)
    end = time.perf_counter()
    print(f"iterating {end - counted:.2f} s")
    print(f"solve_seconds {factored - start + end - counted:.3f}")
    print(f"peak_megabytes {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.1f}")
    for value in np.sort(values)[rigid:]:
        print(f"frequency_hz {float(np.sqrt(max(value, 0.0)) / (2 * np.pi))!r}")


if __name__ == "__main__":
    main()
