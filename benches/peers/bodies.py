#!/usr/bin/env python3
"""Random bodies and reference results. usage: bodies.py FOLDER M [M ...]

Writes FOLDER/body_M.bin, doubles: M, number of states, invariants (see README.md), then per state
q, q_dot, omega, force, mass matrix, quadratic velocity vector, accelerations. The reference is summed over the nodes
in long double from the acceleration of a material point; the invariants are not used for it.
"""
import sys

import numpy as np

STATES = 32
real = np.longdouble


def orthonormal(fields, masses):
    """Gram-Schmidt in the mass inner product; fields: nodes x 3 x M."""
    nodes, _, modes = fields.shape
    weighted = (fields * np.sqrt(masses)[:, None, None]).reshape(3 * nodes, modes).astype(real)
    for _ in range(2):
        for mu in range(modes):
            for nu in range(mu):
                weighted[:, mu] -= (weighted[:, nu] * weighted[:, mu]).sum() * weighted[:, nu]
            weighted[:, mu] /= np.sqrt((weighted[:, mu] ** 2).sum())
    return weighted.reshape(nodes, 3, modes) / np.sqrt(masses.astype(real))[:, None, None]


def solve(matrix, right):
    """Cholesky in long double (numpy's own is double)."""
    n = len(right)
    factor, x = np.zeros_like(matrix), right.copy()
    for j in range(n):
        factor[j, j] = np.sqrt(matrix[j, j] - (factor[j, :j] ** 2).sum())
        for i in range(j + 1, n):
            factor[i, j] = (matrix[i, j] - (factor[i, :j] * factor[j, :j]).sum()) / factor[j, j]
    for i in range(n):
        x[i] = (x[i] - (factor[i, :i] * x[:i]).sum()) / factor[i, i]
    for i in reversed(range(n)):
        x[i] = (x[i] - (factor[i + 1 :, i] * x[i + 1 :]).sum()) / factor[i, i]
    return x


def write(folder, modes):
    random = np.random.default_rng(20_000 + modes)
    nodes = max(40, 2 * modes)
    masses = random.uniform(0.5, 1.5, nodes) / nodes
    points = random.uniform(-1, 1, (nodes, 3)) * [1.0, 0.7, 0.4] + [0.2, -0.1, 0.05]
    gradients = random.standard_normal((3, 3, modes))
    fields = random.standard_normal((nodes, 3, modes)) + 0.5 * np.einsum("ni,ijm->njm", points, gradients)
    fields += 0.5 * random.standard_normal((1, 3, modes))
    fields, x, m = orthonormal(fields, masses), points.astype(real), masses.astype(real)
    total = m.sum()
    euler = np.einsum("n,ni,nj->ij", m, x, x)
    stiffness = random.uniform(1, 400, modes).astype(real)
    record = [
        np.array([modes, STATES, total], real),
        (m[:, None] * x).sum(0) / total,
        (np.trace(euler) * np.eye(3) - euler).ravel(),
        np.einsum("n,nim->mi", m, fields).ravel() / total,
        np.einsum("n,ni,njm->mij", m, x, fields).ravel(),
        np.einsum("n,nik,njl->klij", m, fields, fields).ravel(),
        stiffness,
    ]
    for _ in range(STATES):
        q = (0.2 * random.standard_normal(modes)).astype(real)
        rates = random.standard_normal(modes).astype(real)
        omega = (2 * random.standard_normal(3)).astype(real)
        force = random.standard_normal(6 + modes).astype(real)
        position, speed = x + fields @ q, fields @ rates
        columns = np.zeros((nodes, 3, 6 + modes), real)
        columns[:, range(3), range(3)] = 1
        for i in range(3):
            columns[:, :, 3 + i] = np.cross(np.eye(3)[i], position)
        columns[:, :, 6:] = fields
        known = np.cross(omega, np.cross(omega, position)) + 2 * np.cross(omega, speed)
        mass = np.einsum("n,nia,nib->ab", m, columns, columns)
        quadratic = np.einsum("n,nia,ni->a", m, columns, known)
        right = force - quadratic
        right[6:] -= stiffness * q
        record += [q, rates, omega, force, mass.ravel(), quadratic, solve(mass, right)]
    flat = np.concatenate([np.asarray(part, real).ravel() for part in record])
    flat.astype(np.float64).tofile(f"{folder}/body_{modes}.bin")


for argument in sys.argv[2:]:
    write(sys.argv[1], int(argument))
