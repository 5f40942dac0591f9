#!/usr/bin/env python3
"""How far motions of `ffrf simulate` are from Exudyn's: the same bodies, joints and initial states, written once.

usage: agreement.py FFRF WORK OUT. Writes OUT/agreement.md. The connecting rod of models/ with eight modes; Exudyn's motions are
extrapolated from two steps (order two), that of the free body is Runge-Kutta's of order four as it is."""
import csv
import datetime
import json
import math
import os
import subprocess
import sys

import numpy as np

from exudyn_body import exu, interface  # first: it chooses exudyn's fast module
import exudyn.utilities as eu

MODEL = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../../models/conrod.ffrf.json"))
DURATION, SAMPLES = 0.01, 10
OURS_STEP = 1e-6  # s, Runge-Kutta
EXUDYN_STEP = {"free": 1e-6, "joined": 5e-7}  # s; and half of it
NEWTON = 1e-11

MARKERS = {m["name"]: np.array(m["position"]) for m in json.load(open(MODEL))["markers"]}
BIG, SMALL = MARKERS["BIG_END"], MARKERS["SMALL_END"]


def hung(rates, first):
    """A chain of rods along x from the place `first`, one turning with each of the rates."""
    bodies, place, velocity = [], np.array(first), np.zeros(3)
    for rate in map(np.array, rates):
        bodies.append({"position": place - BIG, "velocity": velocity - np.cross(rate, BIG), "rate": rate})
        place, velocity = place + SMALL - BIG, velocity + np.cross(rate, SMALL - BIG)
    return bodies


CASES = {
    "free rod, 160 rad/s about an oblique axis": {
        "gravity": [0.0, 0.0, 0.0], "fixed": False,
        "bodies": [{"position": np.zeros(3), "velocity": np.array([1.0, 2.0, 3.0]), "rate": np.array([40.0, 60.0, 140.0])}],
    },
    "pendulum on a ball joint, 60 rad/s": {
        "gravity": [0.0, -9.81, 0.0], "fixed": True, "bodies": hung([[5.0, 20.0, 60.0]], [0.0, 0.0, 0.0])},
    "double pendulum on ball joints": {
        "gravity": [0.0, -9.81, 0.0], "fixed": True, "bodies": hung([[5.0, 20.0, 60.0], [10.0, -30.0, -50.0]], [0.0, 0.0, 0.0])},
}


def scene(case):
    numbers = lambda vector: "[" + ", ".join(repr(float(x)) for x in vector) + "]"
    text = [f'[simulation]\nduration = {DURATION}\nstep = {OURS_STEP}\nintegrator = "rk4"\noutput_step = {DURATION / SAMPLES}',
            f"gravity = {numbers(case['gravity'])}"]
    for k, body in enumerate(case["bodies"]):
        text.append(f'[bodies.rod{k}]\nmodel = "{MODEL}"\nposition = {numbers(body["position"])}\nvelocity = {numbers(body["velocity"])}\n'
                    f'angular_velocity = {numbers(body["rate"])}\n[sensors.end{k}]\nkind = "position"\nof = "rod{k}.SMALL_END"')
        if case["fixed"]:
            first = f'"rod{k - 1}.SMALL_END"' if k else '"ground"'
            text.append(f'[joints.ball{k}]\nkind = "spherical"\nfirst = {first}\nsecond = "rod{k}.BIG_END"')
    return "\n".join(text) + "\n"


def ours(ffrf, case, work):
    """Positions of the small ends at all samples, and the largest deflection of one."""
    with open(f"{work}/agreement.toml", "w") as file:
        file.write(scene(case))
    subprocess.run([ffrf, "simulate", f"{work}/agreement.toml", "-o", f"{work}/agreement.csv"], check=True, capture_output=True)
    rows = list(csv.DictReader(open(f"{work}/agreement.csv")))[1:]
    count = range(len(case["bodies"]))
    points = np.array([[float(row[f"end{k}.{axis}"]) for k in count for axis in "xyz"] for row in rows])
    shapes = np.array(next(m for m in json.load(open(MODEL))["markers"] if m["name"] == "SMALL_END")["translation"])
    amplitudes = np.array([[[float(row[f"rod{k}.modal_coordinates.{mu + 1}"]) for mu in range(len(shapes))] for k in count] for row in rows])
    return points, float(np.linalg.norm(amplitudes @ shapes, axis=2).max())


def exudyn(case, step):
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    explicit = not case["fixed"]
    cms, nodes = interface(MODEL, "NodeType.RotationRotationVector" if explicit else "NodeType.RotationEulerParameters")
    marker = lambda body, name: mbs.AddMarker(eu.MarkerSuperElementPosition(
        bodyNumber=body, meshNodeNumbers=[nodes[name]], weightingFactors=[1.0]))
    end = mbs.AddMarker(eu.MarkerBodyPosition(bodyNumber=mbs.AddObject(eu.ObjectGround())))
    sensors = []
    for body in case["bodies"]:
        made = cms.AddObjectFFRFreducedOrder(
            mbs, positionRef=list(body["position"]), initialVelocity=list(body["velocity"]),
            initialAngularVelocity=list(body["rate"]), gravity=case["gravity"])["oFFRFreducedOrder"]
        if case["fixed"]:
            mbs.AddObject(eu.SphericalJoint(markerNumbers=[end, marker(made, "BIG_END")]))
            end = marker(made, "SMALL_END")
        sensors.append(mbs.AddSensor(eu.SensorSuperElement(
            bodyNumber=made, meshNodeNumber=nodes["SMALL_END"], storeInternal=True, outputVariableType=exu.OutputVariableType.Position)))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    integration = settings.timeIntegration
    integration.endTime, integration.numberOfSteps = DURATION, round(DURATION / step)
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = DURATION / SAMPLES
    integration.newton.relativeTolerance, integration.newton.absoluteTolerance = NEWTON, NEWTON * 1e-2
    integration.generalizedAlpha.useNewmark = integration.generalizedAlpha.useIndex2Constraints = True
    kind = exu.DynamicSolverType.RK44 if explicit else exu.DynamicSolverType.GeneralizedAlpha
    mbs.SolveDynamic(settings, solverType=kind)
    return np.hstack([np.array(mbs.GetSensorStoredData(sensor))[1:, 1:4] for sensor in sensors])


def main(ffrf, work, out):
    lines = [f"# Motions of `ffrf simulate` and of Exudyn {exu.__version__}, {datetime.date.today().isoformat()}", "",
             f"{DURATION} s, small ends of the rods at {SAMPLES} times; the difference is the largest distance of a point.", "",
             "| motion | largest deflection, m | difference, m | digits of the deflection | Exudyn from one step to its half, m |", "| --- | --- | --- | --- | --- |"]
    for name, case in CASES.items():
        found, deflection = ours(ffrf, case, work)
        step = EXUDYN_STEP["joined" if case["fixed"] else "free"]
        coarse, fine = exudyn(case, step), exudyn(case, step / 2)
        best = (4 * fine - coarse) / 3 if case["fixed"] else fine
        distance = lambda a, b: float(np.linalg.norm((a - b).reshape(len(a), -1, 3), axis=2).max())
        difference = distance(best, found)
        digits = math.log10(deflection / difference)
        lines.append(f"| {name} | {deflection:.2e} | {difference:.1e} | {digits:.1f} | {distance(coarse, fine):.0e} |")
        print(lines[-1], flush=True)
    with open(f"{out}/agreement.md", "w") as file:
        file.write("\n".join(lines) + "\n")


main(*sys.argv[1:])
