"""A reduced body (*.ffrf.json) as Exudyn's ObjectFFRFreducedOrder: the same invariants, its mesh nodes are the body's markers."""
import json
import sys

import numpy as np

sys.exudynFast = True  # the module without range checks, as Exudyn's documentation advises for speed
import exudyn as exu  # noqa: E402
from exudyn.FEM import ObjectFFRFreducedOrderInterface  # noqa: E402


def skew(a):
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def crossed(moment):
    """The integral of skew(a)ᵀ skew(b) from that of a bᵀ."""
    return np.trace(moment) * np.eye(3) - np.transpose(moment)


def axial(moment):
    """The integral of skew(a)ᵀ b = b × a from that of a bᵀ."""
    return np.array([moment[2, 1] - moment[1, 2], moment[0, 2] - moment[2, 0], moment[1, 0] - moment[0, 1]])


def interface(path, node_type):
    """The body in `path` for Exudyn with a frame of `node_type`; and the mesh node of each marker by name."""
    body = json.load(open(path))
    inertia = {key: np.array(value) for key, value in body["inertia"].items()}
    modes = len(body["modes"])
    mass = float(inertia["mass"])
    first, second = inertia["first_moment"], inertia["second_moment"]
    along, mixed, pairs = (
        inertia[key] for key in ("modal_first_moment", "position_mode_moment", "mode_mode_moment")
    )
    markers = body["markers"]
    count = range(modes)
    rotations = 4 if node_type.endswith("EulerParameters") else 3
    cms = ObjectFFRFreducedOrderInterface()
    cms.SetWithDictionary({
        "modeBasis": np.column_stack([np.ravel([m["translation"][mu] for m in markers]) for mu in count]),
        "trigList": np.zeros((0, 3), dtype=int),
        "postProcessingModes": {},
        "massMatrixReduced": np.trace(pairs, axis1=2, axis2=3),
        "stiffnessMatrixReduced": np.array(body["stiffness"]),
        "infoList": [modes, len(markers), 3, rotations, 3 + rotations, 3 + rotations + modes],
        "rigidBodyNodeType": node_type,
        "xRef": np.ravel([m["position"] for m in markers]).astype(float),
        "inertiaLocal": crossed(second),
        "Mtt": mass * np.eye(3),
        "totalMass": mass,
        "chiU": first / mass,
        "chiUtilde": skew(first / mass),
        "mPsiTildePsi": np.block([[axial(pairs[mu, nu])[:, None] for nu in count] for mu in count]),
        "mPsiTildePsiTilde": np.block([[crossed(pairs[mu, nu]) for nu in count] for mu in count]),
        "mPhitTPsi": along.T.copy(),
        "mPhitTPsiTilde": np.hstack([skew(along[mu]) for mu in count]),
        "mXRefTildePsi": np.column_stack([axial(mixed[mu]) for mu in count]),
        "mXRefTildePsiTilde": np.hstack([crossed(mixed[mu]) for mu in count]),
    })
    return cms, {marker["name"]: index for index, marker in enumerate(markers)}
