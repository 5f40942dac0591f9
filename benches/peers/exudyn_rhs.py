#!/usr/bin/env python3
"""Exudyn per right-hand side: a free body, rotation vector, explicit RK44, time per step divided by four.

usage: exudyn_rhs.py M [M ...]; environment ROTOR: path without ending of the rotor's Abaqus files (.inp, MASS1.mtx,
STIF1.mtx; default ../shared/fe-exports/rotorDiscTest beside the workspace). One JSON line per M. Another object than the
kernels: it forms and solves the whole system of equations in a general-purpose program."""
import json
import os
import sys
import time

folder = os.path.dirname(os.path.abspath(__file__))
rotor = os.environ.get("ROTOR", os.path.join(folder, "../../../shared/fe-exports/rotorDiscTest"))
if not os.path.exists(rotor + ".inp"):
    sys.exit(f"SKIPPED: exudyn: no {rotor}.inp")

import exudyn as exu
from exudyn.FEM import FEMinterface, ObjectFFRFreducedOrderInterface
from exudyn.utilities import *  # noqa: F403  (adds methods to exudyn's classes)


def body(modes):
    fem = FEMinterface()
    fem.ImportFromAbaqusInputFile(rotor + ".inp", typeName="Instance", name="rotor-1")
    fem.ReadMassMatrixFromAbaqus(rotor + "MASS1.mtx")
    fem.ReadStiffnessMatrixFromAbaqus(rotor + "STIF1.mtx")
    fem.ComputeEigenmodes(modes, excludeRigidBodyModes=6, useSparseSolver=True)
    container = exu.SystemContainer()
    system = container.AddSystem()
    interface = ObjectFFRFreducedOrderInterface(fem, rigidBodyNodeType="NodeType.RotationRotationVector")
    interface.AddObjectFFRFreducedOrder(
        system, positionRef=[0, 0, 0], initialVelocity=[0, 0, 0], initialAngularVelocity=[0.2, 0.1, 5.0]
    )
    system.Assemble()
    return container, system


def seconds(system, steps):
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = steps * 1e-7
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = settings.solutionSettings.solutionWritePeriod = 1e3
    start = time.process_time()
    system.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44, updateInitialValues=False)
    return time.process_time() - start


for modes in map(int, sys.argv[1:]):
    try:
        container, system = body(modes)
        seconds(system, 100)
        few, many = 200, 4200
        steps = [(seconds(system, many) - seconds(system, few)) / (many - few) for _ in range(4)]
        print(json.dumps({"modes": modes, "microseconds": min(steps) / 4 * 1e6, "version": exu.__version__}), flush=True)
    except Exception as error:  # a newer Exudyn may have changed its interface: say so, go on
        print(f"SKIPPED: exudyn at {modes} modes: {error}", file=sys.stderr)
