"""The cases of the comparison as Exudyn models, and its solvers with the settings that favour it."""
import json
import sys
import time
from math import pi

import numpy as np

from exudyn_body import exu, interface  # first: it chooses exudyn's fast module
import exudyn.utilities as eu

EULER_PARAMETERS = "NodeType.RotationEulerParameters"
# without a constraint on the node, as explicit solvers need it. Not Tait-Bryan angles: with them this object converges to
# another motion, 1e-4 m off on the rotor, whatever the solver
ROTATION_VECTOR = "NodeType.RotationRotationVector"

# name -> solver, frame node, options
METHODS = {
    "generalised_alpha": ("implicit", EULER_PARAMETERS, {}),
    "generalised_alpha_newton_1e-5": ("implicit", EULER_PARAMETERS, {"newton": 1e-5}),
    "generalised_alpha_newton_1e-4": ("implicit", EULER_PARAMETERS, {"newton": 1e-4}),
    "generalised_alpha_tight": ("implicit", EULER_PARAMETERS, {"newton": 1e-12}),
    "generalised_alpha_full_newton": ("implicit", EULER_PARAMETERS, {"modified": False}),
    "generalised_alpha_rotation_vector": ("implicit", ROTATION_VECTOR, {}),
    "trapezoidal_index2": ("implicit", EULER_PARAMETERS, {"newmark": True}),
    "trapezoidal_index2_rotation_vector": ("implicit", ROTATION_VECTOR, {"newmark": True}),
    "rk4": ("RK44", ROTATION_VECTOR, {}),
    "rk67": ("RK67", ROTATION_VECTOR, {}),
    "dopri5": ("DOPRI5", ROTATION_VECTOR, {"automatic": True}),
}
SPEED = 100 * pi  # rad/s, of the rotor
STIFFNESS, DAMPING = 2e8, 2e6  # N/m, N s/m, of its supports


def observe(mbs, body, nodes, names):
    return [
        mbs.AddSensor(eu.SensorSuperElement(
            bodyNumber=body, meshNodeNumber=nodes[name], storeInternal=True,
            outputVariableType=exu.OutputVariableType.Position))
        for name in names
    ]


def rotor(bodies, start, node_type):
    """On two supports, turning; observed: both ends and the middle."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    cms, nodes = interface(f"{bodies}/rotor.ffrf.json", node_type)
    made = cms.AddObjectFFRFreducedOrder(mbs, initialAngularVelocity=start["angular_velocity"])
    body = made["oFFRFreducedOrder"]
    ground = mbs.AddObject(eu.ObjectGround())
    for name, z, axial in [("LEFT", 0.0, STIFFNESS), ("RIGHT", 0.5, 0.0)]:
        support = mbs.AddMarker(eu.MarkerBodyPosition(bodyNumber=ground, localPosition=[0.0, 0.0, z]))
        end = mbs.AddMarker(eu.MarkerSuperElementPosition(
            bodyNumber=body, meshNodeNumbers=[nodes[name]], weightingFactors=[1.0]))
        mbs.AddObject(eu.CartesianSpringDamper(
            markerNumbers=[end, support], stiffness=[STIFFNESS, STIFFNESS, axial],
            damping=[DAMPING] * 3))
    sensors = observe(mbs, body, nodes, ["LEFT", "MIDDLE", "RIGHT"])
    mbs.Assemble()
    return container, mbs, sensors


def slider_crank(bodies, start, node_type):
    """Simeon's: crank and slider have one coordinate each; observed: the rod's tip and middle."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    cms, nodes = interface(f"{bodies}/rod.ffrf.json", node_type)
    made = cms.AddObjectFFRFreducedOrder(
        mbs, positionRef=start["position"], initialVelocity=start["velocity"],
        rotationMatrixRef=eu.RotationVector2RotationMatrix(np.array(start["rotation"])),
        initialAngularVelocity=start["angular_velocity"])
    body = made["oFFRFreducedOrder"]
    mbs.SetNodeParameter(made["nGenericODE2"], "initialCoordinates", start["q"])
    mbs.SetNodeParameter(made["nGenericODE2"], "initialCoordinates_t", start["q_dot"])
    ground = mbs.AddObject(eu.ObjectGround())
    coordinate = lambda value, rate: mbs.AddNode(eu.Node1D(
        referenceCoordinates=[0.0], initialCoordinates=[value], initialVelocities=[rate]))
    turn = coordinate(start["crank"], start["crank_rate"])
    way = coordinate(start["slider"], start["slider_rate"])
    crank = mbs.AddObject(eu.Rotor1D(nodeNumber=turn, inertia=0.002727))
    slider = mbs.AddObject(eu.Mass1D(nodeNumber=way, mass=0.075552))
    still = mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(eu.NodePointGround()), coordinate=0))
    driven = mbs.AddMarker(eu.MarkerNodeCoordinate(nodeNumber=turn, coordinate=0))
    mbs.AddObject(eu.CoordinateConstraint(markerNumbers=[still, driven], velocityLevel=True, offset=150.0))
    pin = mbs.AddMarker(eu.MarkerBodyRigid(bodyNumber=crank, localPosition=[0.15, 0.0, 0.0]))
    root = mbs.AddMarker(eu.MarkerNodeRigid(nodeNumber=made["nRigidBody"]))
    mbs.AddObject(eu.GenericJoint(markerNumbers=[pin, root], constrainedAxes=[1, 1, 1, 1, 1, 0]))
    tip = mbs.AddMarker(eu.MarkerSuperElementPosition(
        bodyNumber=body, meshNodeNumbers=[nodes["TIP"]], weightingFactors=[1.0]))
    end = mbs.AddMarker(eu.MarkerBodyPosition(bodyNumber=slider))
    # the frame of the rod is held in the plane already
    mbs.AddObject(eu.SphericalJoint(markerNumbers=[end, tip], constrainedAxes=[1, 1, 0]))
    sensors = observe(mbs, body, nodes, ["TIP", "MIDDLE"])
    mbs.Assemble()
    return container, mbs, sensors


MODELS = {"rotor": rotor, "slider_crank": slider_crank}


def settings_for(step, duration, options, samples):
    """What a user who wants speed would choose; `step` is the tolerance of an error-controlled method."""
    settings = exu.SimulationSettings()
    integration = settings.timeIntegration
    integration.endTime = duration
    integration.numberOfSteps = samples if "automatic" in options else round(duration / step)
    integration.verboseMode = 0
    settings.solution.file.write = False  # nothing is written
    settings.solution.sensors.writePeriod = duration / samples
    settings.parallel.numberOfThreads = 1
    integration.newton.useModifiedNewton = options.get("modified", True)
    integration.newton.relativeTolerance = options.get("newton", 1e-8)
    integration.newton.absoluteTolerance = options.get("newton", 1e-8) * 1e-2
    integration.generalizedAlpha.spectralRadius = 0.9
    if options.get("newmark"):
        integration.generalizedAlpha.useNewmark = True
        integration.generalizedAlpha.useIndex2Constraints = True
    integration.explicit.computeEndOfStepAccelerations = False
    integration.explicit.computeMassMatrixInversePerBody = False  # with it this object gives NaN
    integration.automaticStepSize = bool(options.get("automatic"))
    if options.get("automatic"):
        integration.relativeTolerance = step
        integration.absoluteTolerance = step * 1e-3
        integration.initialStepSize = 1e-7
    return settings


def run(case, bodies, start, method, step, duration, samples, rounds):
    """Seconds of SolveDynamic (least of the rounds), steps and Newton iterations, and the observed points."""
    solver, node_type, options = METHODS[method]
    best = float("inf")
    for _ in range(rounds):
        # a new system each time: initial values are those of the first run; not timed
        container, mbs, sensors = MODELS[case](bodies, start, node_type)
        settings = settings_for(step, duration, options, samples)
        kind = exu.DynamicSolverType.GeneralizedAlpha if solver == "implicit" else getattr(exu.DynamicSolverType, solver)
        begin = time.perf_counter()
        mbs.SolveDynamic(settings, solverType=kind)
        best = min(best, time.perf_counter() - begin)
        data = [np.array(mbs.GetSensorStoredData(sensor)) for sensor in sensors]
        counts = mbs.sys["dynamicSolver"].it
    # the first row is the initial state; an error-controlled method has its rows where its steps end
    rows = np.hstack([table[:, 1:4] for table in data])[1:]
    return {
        "seconds": best, "steps": counts.currentStepIndex, "iterations": counts.newtonStepsCount,
        "jacobians": counts.newtonJacobiCount, "samples": rows.tolist(), "version": exu.__version__,
    }


if __name__ == "__main__":
    case, bodies, start, method, *numbers = sys.argv[1:]
    step, duration, samples, rounds = (float(number) for number in numbers)
    result = run(case, bodies, json.loads(start), method, step, duration, int(samples), int(rounds))
    print("RESULT", json.dumps(result))
