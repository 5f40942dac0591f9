#!/usr/bin/env python3
"""CasADi column. usage: casadi_c.py body_M.bin OUTPUT.c; constants baked in, expanded, LDLᵀ with the flexible block first."""
import os
import sys

import casadi as ca
import numpy as np

data = np.fromfile(sys.argv[1])
modes, p = int(data[0]), data[2:]
q, rates, w, force = (ca.SX.sym(name, size) for name, size in (("q", modes), ("r", modes), ("w", 3), ("f", 6 + modes)))


def parts(offset):
    t = ca.DM(p[offset : offset + 9].reshape(3, 3))
    return ca.trace(t) * ca.DM.eye(3) - t.T, ca.vertcat(t[1, 2] - t[2, 1], t[2, 0] - t[0, 2], t[0, 1] - t[1, 0])


mass, centre = p[0], ca.DM(p[1:4])
inertia, shift = ca.DM(p[4:13].reshape(3, 3)), ca.DM(p[13 : 13 + 3 * modes].reshape(modes, 3).T)
at = 13 + 3 * modes
single = [parts(at + 9 * k) for k in range(modes)]
at += 9 * modes
pairs = [[parts(at + 9 * (modes * k + l)) for l in range(modes)] for k in range(modes)]
stiffness = ca.DM(p[at + 9 * modes * modes :][:modes])

moment = mass * (centre + shift @ q)
theta, coupling, rows, turned = ca.SX(inertia), ca.SX(ca.horzcat(*(x for _, x in single))), [], []
for k in range(modes):
    deformed = ca.SX(single[k][0])
    whirl = ca.horzcat(*(pairs[k][l][1] for l in range(modes)))
    for l in range(modes):
        deformed += q[l] * pairs[l][k][0]
    theta += q[k] * (single[k][0].T + deformed)
    coupling += q[k] * whirl
    rows.append(deformed @ w)
    turned.append(-(w.T @ whirl))
rows = ca.horzcat(*rows)
tilde = ca.skew(moment)
rigid = ca.vertcat(ca.horzcat(mass * ca.DM.eye(3), -tilde), ca.horzcat(tilde, theta))
side = ca.vertcat(mass * shift, coupling)
matrix = ca.vertcat(ca.horzcat(rigid, side), ca.horzcat(side.T, ca.DM.eye(modes)))
quadratic = ca.vertcat(
    ca.cross(w, ca.cross(w, moment) + 2 * mass * (shift @ rates)),
    ca.cross(w, theta @ w) + 2 * rows @ rates,
    -(rows.T @ w) + 2 * ca.vertcat(*turned) @ rates,
)
right = force - quadratic - ca.vertcat(ca.SX.zeros(6), stiffness * q)
order = list(range(6, 6 + modes)) + list(range(6))
d, upper, permutation = ca.ldl(ca.sparsify(matrix[order, order]), False)
acceleration = ca.ldl_solve(right[order], d, upper, permutation)[list(np.argsort(order))]

dense = [ca.densify(matrix), ca.densify(quadratic), ca.densify(acceleration)]
both = ca.Function("both", [q, rates, w, force], dense, {"cse": True})
alone = ca.Function("alone", [q, rates, w, force], dense[2:], {"cse": True})
folder, name = os.path.split(os.path.abspath(sys.argv[2]))
os.chdir(folder)
code = ca.CodeGenerator(name)
code.add(both)
code.add(alone)
code.generate()
call = "{ const double *in[8] = {q, r, w, f}; double *out[8] = {%s}; casadi_int iw[%d]; double work[%d]; %s(in, out, iw, work, 0); }\n"
state = "const double *q, const double *r, const double *w, const double *f"
with open(name, "a") as file:
    file.write(f"int ffrf_prepare(int modes, const double *p) {{ return modes != {modes}; }}\n")
    file.write(f"void ffrf_equations({state}, double *m, double *g, double *a) ")
    file.write(call % ("m, g, a", max(both.sz_iw(), 1), max(both.sz_w(), 1), "both"))
    file.write(f"void ffrf_accelerations({state}, double *a) ")
    file.write(call % ("a", max(alone.sz_iw(), 1), max(alone.sz_w(), 1), "alone"))
