#!/usr/bin/env python3
"""The rotor of Exudyn's test perfObjectFFRFreducedOrder: its finite-element model made softer, with an unbalance.

usage: rotor_body.py EXPORTS OUT FFRF; EXPORTS holds rotorDiscTest.inp, rotorDiscTestMASS1.mtx and rotorDiscTestSTIF1.mtx.
Writes OUT/rotor.ffrf.json with eight free-free modes by the command FFRF, with the markers LEFT and RIGHT (means of the end
faces, as the test weighs them) and MIDDLE (the node that the test observes)."""
import subprocess
import sys

import numpy as np

STIFFNESS_FACTOR = 1e-2  # "for larger deformations", the test says
UNBALANCE_MASS = 0.1  # kg
UNBALANCE = [0.0, 0.19598444, 0.15]  # m, the node it is put on
MODES = 8
LEFT, MIDDLE, RIGHT = 0.0, 0.25, 0.5  # m, along z
NEAR = 1e-5  # m, what Exudyn's search for nodes takes for the same place


def nodes_of(deck):
    """Ids and places of the deck's nodes: the lines from *Node to the next keyword."""
    rows, inside = [], False
    for line in open(deck):
        if line.startswith("*"):
            inside = line.strip().lower() == "*node"
        elif inside:
            rows.append([float(number) for number in line.split(",")])
    table = np.array(rows)
    return table[:, 0].astype(int), table[:, 1:4]


def entries(path):
    """Rows of a matrix in the coordinate form of Abaqus: row, column, value; rows count from one, three a node."""
    return np.loadtxt(path)


def main(exports, out, ffrf):
    deck = f"{exports}/rotorDiscTest.inp"
    ids, places = nodes_of(deck)
    near = lambda point: ids[int(np.argmin(np.linalg.norm(places - point, axis=1)))]
    plane = lambda z: ids[np.abs(places[:, 2] - z) < NEAR]
    files = {}
    for name, factor in [("MASS1", 1.0), ("STIF1", STIFFNESS_FACTOR)]:
        rows = entries(f"{exports}/rotorDiscTest{name}.mtx")
        rows[:, 2] *= factor
        if name == "MASS1":
            heavy = int(np.flatnonzero(ids == near(UNBALANCE))[0])
            on_it = (rows[:, 0] == rows[:, 1]) & ((rows[:, 0] - 1) // 3 == heavy)
            assert on_it.sum() == 3, on_it.sum()
            rows[on_it, 2] += UNBALANCE_MASS
        files[name] = f"{out}/rotor_{name}.mtx"
        with open(files[name], "w") as file:
            file.writelines(f"{row:.0f} {column:.0f} {value:.17e}\n" for row, column, value in rows)
    marker = lambda name, nodes: ["--marker", f"{name}=" + ",".join(str(node) for node in nodes)]
    subprocess.run(
        [ffrf, "reduce", "--abaqus", deck, "--mass", files["MASS1"], "--stiffness", files["STIF1"]]
        + ["--modes", str(MODES), "-o", f"{out}/rotor.ffrf.json"]
        + marker("LEFT", plane(LEFT)) + marker("RIGHT", plane(RIGHT)) + marker("MIDDLE", [near([0.0, 0.0, MIDDLE])]),
        check=True,
    )


main(*sys.argv[1:])
