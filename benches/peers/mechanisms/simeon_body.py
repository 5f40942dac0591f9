#!/usr/bin/env python3
"""The rod of Simeon's flexible slider-crank (problem `crank` of the test set for IVP solvers) as a reduced body.

usage: simeon_body.py OUT; writes OUT/rod.ffrf.json with the markers ROOT, TIP and MIDDLE. Two lateral sine modes, two axial
modes with the masses of crank.f as they stand there. In space the rod gets a small moment of inertia about its own axis,
which planar motion does not see. Source: crank.f, revision 2006-10-02."""
import json
import sys
from math import pi

LENGTH, WIDTH, DENSITY, YOUNG = 0.30, 0.008, 7870.0, 2e11
MASS, INERTIA, AXIAL_INERTIA = 0.151104, 0.0045339259, 1e-5


def rod():
    shape_mass = DENSITY * WIDTH * WIDTH * LENGTH
    spring = YOUNG * WIDTH * WIDTH / LENGTH
    slender = (WIDTH / LENGTH) ** 2
    scaled = lambda factor, numbers: [factor * number for number in numbers]
    along = scaled(shape_mass, [0.0, 0.0, 2 / 3, 1 / 6])
    across = scaled(shape_mass, [2 / pi, 0.0, 0.0, 0.0])
    along_moment = scaled(LENGTH * shape_mass, [0.0, 0.0, 1 / 3, 1 / 6])
    across_moment = scaled(LENGTH * shape_mass, [1 / pi, -0.5 / pi, 0.0, 0.0])
    pairs = [[[[0.0] * 3 for _ in range(3)] for _ in range(4)] for _ in range(4)]
    for mu, nu, value in [(2, 2, 8.0), (2, 3, 1.0), (3, 2, 1.0), (3, 3, 2.0)]:
        pairs[mu][nu][0][0] = shape_mass * value
    for mu in (0, 1):
        pairs[mu][mu][1][1] = 0.5 * shape_mass
    # the skew part: lateral against axial motion
    for mu, nu, value in [(0, 2, -16 / pi**3), (0, 3, 8 / pi**3 - 1 / pi), (1, 3, 0.5 / pi)]:
        pairs[mu][nu][1][0] = pairs[nu][mu][0][1] = -shape_mass * value
    zero = [0.0] * 3
    marker = lambda name, x, translation: {
        "name": name, "nodes": [], "position": [x, 0.0, 0.0], "translation": translation, "rotation": [zero] * 4,
    }
    return {
        "schema_version": 1,
        "title": "connecting rod of Simeon's slider-crank",
        "units": "SI",
        "provenance": {"tool": "simeon_body.py", "tool_version": "1", "sources": [], "notes": []},
        "modes": [{"kind": "user", "frequency_hz": None}] * 4,
        "inertia": {
            "mass": MASS,
            "first_moment": [0.5 * MASS * LENGTH, 0.0, 0.0],
            "modal_first_moment": [[along[mu], across[mu], 0.0] for mu in range(4)],
            "second_moment": [[INERTIA, 0.0, 0.0], zero, [0.0, 0.0, AXIAL_INERTIA]],
            "position_mode_moment": [[[along_moment[mu], across_moment[mu], 0.0], zero, zero] for mu in range(4)],
            "mode_mode_moment": pairs,
        },
        "stiffness": [
            [spring * pi**4 / 24 * slender, 0.0, 0.0, 0.0],
            [0.0, spring * 2 * pi**4 / 3 * slender, 0.0, 0.0],
            [0.0, 0.0, 16 / 3 * spring, -8 / 3 * spring],
            [0.0, 0.0, -8 / 3 * spring, 7 / 3 * spring],
        ],
        "damping": [[0.0] * 4] * 4,
        "markers": [
            marker("ROOT", 0.0, [zero] * 4),
            marker("TIP", LENGTH, [zero, zero, zero, [1.0, 0.0, 0.0]]),
            marker("MIDDLE", 0.5 * LENGTH, [[0.0, 1.0, 0.0], zero, [1.0, 0.0, 0.0], zero]),
        ],
    }


if __name__ == "__main__":
    with open(f"{sys.argv[1]}/rod.ffrf.json", "w") as file:
        json.dump(rod(), file, indent=1)
