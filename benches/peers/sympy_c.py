#!/usr/bin/env python3
"""SymPy column. usage: sympy_c.py body_M.bin OUTPUT.c; mass matrix and quadratic velocity vector by common
subexpressions, then the accelerations by a Cholesky factorisation in C, as SymPy users do it."""
import sys

import numpy as np
import sympy as sp

data = np.fromfile(sys.argv[1])
modes, p = int(data[0]), data[2:]
size = 6 + modes
exact = lambda values: sp.Matrix(values).applyfunc(lambda x: sp.Float(x, 17))
q, rates = sp.Matrix(sp.symbols(f"q:{modes}")), sp.Matrix(sp.symbols(f"r:{modes}"))
w = sp.Matrix(sp.symbols("w:3"))


def parts(offset):
    t = exact(p[offset : offset + 9].reshape(3, 3))
    return sp.eye(3) * t.trace() - t.T, sp.Matrix([t[1, 2] - t[2, 1], t[2, 0] - t[0, 2], t[0, 1] - t[1, 0]])


moment = exact(p[0] * p[1:4]) + exact(p[0] * p[13 : 13 + 3 * modes].reshape(modes, 3).T) * q
shift = exact(p[0] * p[13 : 13 + 3 * modes].reshape(modes, 3).T)
at = 13 + 3 * modes
single = [parts(at + 9 * k) for k in range(modes)]
at += 9 * modes
pair = [[parts(at + 9 * (modes * k + l)) for l in range(modes)] for k in range(modes)]
stiffness = p[at + 9 * modes * modes :][:modes]

inertia, coupling, rate, turned = exact(p[4:13].reshape(3, 3)), sp.zeros(3, modes), sp.zeros(3, 3), sp.zeros(modes, 1)
for k in range(modes):
    deformed, column = single[k][0], single[k][1]
    for l in range(modes):
        deformed += q[l] * pair[l][k][0]
        column += q[l] * pair[l][k][1]
        turned[k] += 2 * rates[l] * w.dot(pair[l][k][1])
    inertia += q[k] * (single[k][0].T + deformed)
    coupling[:, k] = column
    rate += rates[k] * deformed
    turned[k] -= w.dot(deformed * w)
tilde = sp.Matrix([[0, -moment[2], moment[1]], [moment[2], 0, -moment[0]], [-moment[1], moment[0], 0]])
mass = sp.zeros(size, size)
mass[:3, :3], mass[:3, 3:6], mass[3:6, :3], mass[3:6, 3:6] = sp.eye(3) * sp.Float(p[0], 17), -tilde, tilde, inertia
mass[:3, 6:], mass[6:, :3], mass[3:6, 6:], mass[6:, 3:6], mass[6:, 6:] = shift, shift.T, coupling, coupling.T, sp.eye(modes)
quadratic = sp.Matrix.vstack(w.cross(w.cross(moment) + 2 * shift * rates), w.cross(inertia * w) + 2 * rate * w, turned)

shared, results = sp.cse(list(mass) + list(quadratic), order="none")
state = "const double *q_, const double *r_, const double *w_, const double *f_"
text = ["#include <math.h>", f"int ffrf_prepare(int modes, const double *p) {{ return modes != {modes}; }}"]
text.append(f"static const double K[] = {{{', '.join(map(repr, map(float, stiffness)))}}};")
text.append(f"void ffrf_equations({state}, double *m_, double *g_, double *a_) {{")
text += [f"const double {v} = {v[0]}_[{v[1:]}];" for v in map(str, [*q, *rates, *w])]
text += [f"const double {name} = {sp.ccode(value)};" for name, value in shared]
text += [f"m_[{i}] = {sp.ccode(value)};" for i, value in enumerate(results[: size * size])]
text += [f"g_[{i}] = {sp.ccode(value)};" for i, value in enumerate(results[size * size :])]
text.append(
    f"""enum {{ N = {size} }};
double l[N][N], x[N];
for (int i = 0; i < N; i++) x[i] = f_[i] - g_[i] - (i < 6 ? 0 : K[i - 6] * q_[i - 6]);
for (int j = 0; j < N; j++) {{
  double d = m_[j * N + j];
  for (int k = 0; k < j; k++) d -= l[j][k] * l[j][k];
  l[j][j] = sqrt(d);
  for (int i = j + 1; i < N; i++) {{
    double s = m_[i * N + j];
    for (int k = 0; k < j; k++) s -= l[i][k] * l[j][k];
    l[i][j] = s / l[j][j];
  }}
}}
for (int i = 0; i < N; i++) {{ for (int k = 0; k < i; k++) x[i] -= l[i][k] * x[k]; x[i] /= l[i][i]; }}
for (int i = N; i-- > 0;) {{ for (int k = i + 1; k < N; k++) x[i] -= l[k][i] * x[k]; x[i] /= l[i][i]; a_[i] = x[i]; }}
}}"""
)
with open(sys.argv[2], "w") as file:
    file.write("\n".join(text) + "\n")
