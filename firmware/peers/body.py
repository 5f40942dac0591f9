#!/usr/bin/env python3
"""The invariants of a model for casadi_c.py of benches/peers. usage: body.py MODEL.ffrf.json MODES OUTPUT.bin

What is below 1e-9 of the largest entry of its invariant is zero, as for our generator with layout_tolerance 1e-9 (build.rs):
what a mesh leaves of symmetries is 1e-10 and less. CasADi leaves zeros out as well.
"""
import json
import sys

import numpy as np

model, modes = json.load(open(sys.argv[1])), int(sys.argv[2])
inertia = model["inertia"]


def clean(values):
    values = np.array(values, float)
    return np.where(abs(values) < 1e-9 * abs(values).max(initial=1e-300), 0.0, values)


mass = inertia["mass"]
euler = np.array(inertia["second_moment"])
pairs = clean(inertia["mode_mode_moment"])[:modes, :modes]
scale = np.sqrt(mass * np.trace(euler))
first, shift = np.array(inertia["first_moment"]), np.array(inertia["modal_first_moment"])[:modes]
first = np.where(abs(first) < 1e-9 * scale, 0.0, first)
shift = np.where(abs(shift) < 1e-9 * np.sqrt(mass), 0.0, shift)
record = [
    [modes, 0, mass],
    first / mass,
    (np.trace(euler) * np.eye(3) - euler).ravel(),
    shift.ravel() / mass,
    clean(inertia["position_mode_moment"])[:modes].ravel(),
    pairs.ravel(),
    np.diag(clean(model["stiffness"]))[:modes],
]
np.concatenate([np.asarray(part, float) for part in record]).tofile(sys.argv[3])
