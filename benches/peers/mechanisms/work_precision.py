#!/usr/bin/env python3
"""Runs every method and step of cases.py on both sides, the sides taking turns, and writes work_precision.json.

usage: work_precision.py BODIES OURS OUT PASSES ROUNDS CASE...; OURS is the program `work_precision`. The least time of all
passes and rounds is kept. Errors: largest distance of an observed point from the reference over all samples, over the
largest deflection in the reference; samples of Exudyn's error-controlled method lie elsewhere, its error is that at the end."""
import json
import os
import subprocess
import sys

import numpy as np

from cases import CASES

HERE = os.path.dirname(os.path.abspath(__file__))
ALIKE = 1e-5  # most that the references of both sides may differ by, over the largest deflection
TIMEOUT = 120  # s of one run with its rounds; Exudyn's step control may creep


class Sides:
    def __init__(self, bodies, program, case):
        self.bodies, self.program, self.case = bodies, program, case
        self.start = self.command([program, case, "start"])

    def command(self, words):
        done = subprocess.run(words, capture_output=True, text=True, timeout=TIMEOUT)
        if done.returncode:
            raise RuntimeError(next(iter((done.stderr or done.stdout).strip().splitlines()[-1:]), "no message"))
        return done.stdout

    def run(self, side, method, step, rounds):
        facts = CASES[self.case]
        numbers = [repr(step), repr(facts["duration"]), str(facts["samples"]), str(rounds)]
        if side == "ours":
            return json.loads(self.command([self.program, self.case, method, *numbers]))
        words = [sys.executable, f"{HERE}/exudyn_cases.py", self.case, self.bodies, self.start, method, *numbers]
        lines = [line for line in self.command(words).splitlines() if line.startswith("RESULT ")]
        return json.loads(lines[-1][len("RESULT "):])


def reference(sides, side):
    method, step = CASES[sides.case]["reference"][side]
    points = np.array(sides.run(side, method, step, 1)["samples"])
    if method.startswith("generalised_alpha"):  # order two
        points = (4 * np.array(sides.run(side, method, step / 2, 1)["samples"]) - points) / 3
    return points


def deflection(case, points):
    """The largest deflection: of the rotor's middle from its axis, of the rod's middle from the line between its ends."""
    if case == "rotor":
        return float(np.linalg.norm(points[:, 3:5], axis=1).max())
    facts = CASES[case]
    angle = 150.0 * facts["duration"] / facts["samples"] * np.arange(1, facts["samples"] + 1)
    pin = 0.15 * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along, middle = points[:, 0:2] - pin, points[:, 3:5] - pin
    return float(np.abs((along[:, 0] * middle[:, 1] - along[:, 1] * middle[:, 0]) / np.linalg.norm(along, axis=1)).max())


def distance(points, exact):
    return float(np.linalg.norm((points - exact).reshape(len(exact), -1, 3), axis=2).max())


def compare(bodies, program, case, passes, rounds):
    sides = Sides(bodies, program, case)
    exact = {side: reference(sides, side) for side in ("ours", "exudyn")}
    scale = deflection(case, exact["ours"])
    between = distance(exact["exudyn"], exact["ours"]) / scale
    if not between < ALIKE:
        raise SystemExit(f"{case}: references differ by {between:.1e} of the deflection: these are not two models of one case")
    print(f"{case}: deflection {scale:.3e} m, references differ by {between:.1e} of it", flush=True)
    rows = {}
    for number in range(passes):
        print(f"{case}: pass {number + 1} of {passes}", flush=True)
        longest = max(len(steps) for side in ("ours", "exudyn") for steps in CASES[case][side].values())
        for turn in range(longest):
            for side in ("ours", "exudyn"):
                for method, steps in CASES[case][side].items():
                    if turn < len(steps):
                        measure(sides, side, method, steps[turn], rounds, exact["ours"], scale, rows)
    return {
        "case": case, "deflection_m": scale, "between_references": between, "duration_s": CASES[case]["duration"],
        # of each method from its largest step on
        "rows": [{"side": key[0], "method": key[1], "step": key[2], **rows[key]} for key in sorted(rows, key=lambda k: (k[0], k[1], -k[2]))],
    }


def measure(sides, side, method, step, rounds, exact, scale, rows):
    key = (side, method, step)
    if "refused" in rows.get(key, {}):
        return
    try:
        result = sides.run(side, method, step, rounds)
    except (RuntimeError, subprocess.TimeoutExpired) as error:
        rows[key] = {"refused": str(error)[:200]}
        return
    points = np.array(result.pop("samples"))
    last_only = (side, method) == ("exudyn", "dopri5")
    error = distance(points[-1:], exact[-1:]) if last_only else distance(points, exact)
    before = rows.get(key, {}).get("seconds", float("inf"))
    if not np.isfinite(error):
        rows[key] = {"refused": "not a number"}
        return
    rows[key] = {**result, "seconds": min(before, result["seconds"]), "error": error / scale, "error_at_end_only": last_only}


def main(bodies, program, out, passes, rounds, *cases):
    results = [compare(bodies, program, case, int(passes), int(rounds)) for case in cases]
    with open(f"{out}/work_precision.json", "w") as file:
        json.dump(results, file, indent=1)


main(*sys.argv[1:])
