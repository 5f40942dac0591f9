"""FMPy validates an FMU of C sources, simulates it with the binary inside and with one that it compiles of the sources, and
compares with the samples of `ffrf simulate`.

Usage: fmu_c.py PART.fmu SAMPLES.csv STEP PLACES

STEP: that of the scene (s). PLACES: what may be off after each step, in units in the last place of the largest state, sensor
or energy.
"""

import csv
import pathlib
import shutil
import subprocess
import sys

import fmpy
import fmu_states
import numpy
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.build import build_platform_binary
from fmpy.validation import validate_fmu

# of an energy: what first moments and the like that are zero but for round-off (1e-15 of the largest of their kind) add to it
DROPPED = 1e-12
# of a sensor: the round-off of one evaluation of accelerations and reactions, sums of larger forces of stiff modes
SENSED = 100 * numpy.finfo(float).eps
# the last place of a velocity is, over a step, an acceleration: stiff modes of an implicit method follow it at rest, and reactions
# are such accelerations times masses, which are of this order in these scenes (kg)
MASS = 1.0

fmu, samples, own_step, places = sys.argv[1], sys.argv[2], float(sys.argv[3]), float(sys.argv[4])

problems = validate_fmu(fmu)
assert problems == [], problems

with open(samples, newline="") as file:
    rows = list(csv.reader(file))
header, rows = rows[0], numpy.array(rows[1:], dtype=float)

description = read_model_description(fmu)
step = float(description.defaultExperiment.stepSize)
names = [v.name for v in description.modelVariables if v.causality in ("output", "local")]
assert names == header[1:], "the variables are the columns"
outputs = {v.name for v in description.modelVariables if v.causality == "output"}


def kind(name):
    if name in outputs:
        return "sensors"
    return name.split(".")[0] if name.startswith(("energy.", "drift.")) else "states"


def compare(what):
    """How far the FMU is from the samples, in units in the last place a step."""
    result = simulate_fmu(what, output=names, output_interval=step)
    assert len(result) == len(rows), (len(result), len(rows))
    found = numpy.array([list(row)[1:] for row in result])
    worst = 0.0
    for group in ("states", "sensors", "energy"):
        columns = [index for index, name in enumerate(names) if kind(name) == group]
        if not columns:
            continue
        expected = rows[:, 1:][:, columns]
        # of the largest of the run: what passes through zero has the round-off of what it was
        size = numpy.abs(expected).max()
        steps = numpy.arange(len(rows)) * max(step / own_step, 1.0) + 1.0
        apart = numpy.abs(found[:, columns] - expected).max(axis=1)
        if group == "energy":
            # numbers that the generator takes for the zeros they stand for are in the samples
            apart = numpy.maximum(apart - DROPPED * size, 0.0)
        if group == "sensors":
            moving = numpy.abs(rows[:, 1:][:, [kind(name) == "states" for name in names]]).max()
            size = max(size, MASS * moving / own_step)
            apart = numpy.maximum(apart - SENSED * size, 0.0)
        places_apart = apart / (numpy.finfo(float).eps * numpy.maximum(size, 1e-300) * steps)
        worst = max(worst, places_apart.max())
    assert worst <= places, worst
    return worst, found


inside, found = compare(fmu)

folder = extract(fmu)
fmu_states.check(description, folder, step)

# types and prototypes are those of the standard's own headers
headers = pathlib.Path(fmpy.__file__).parent / "c-code"
sources = pathlib.Path(folder) / "sources"
files = [str(path) for path in sources.glob("*.c")]
options = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-fsyntax-only", "-DFFRF_STANDARD_HEADERS"]
subprocess.run(["cc", *options, f"-I{headers}", f"-I{sources}", *files], check=True)

# compiled anew, by CMake as FMPy does it
shutil.rmtree(pathlib.Path(folder) / "binaries")
if shutil.which("cmake") is None:
    print("SKIPPED: no cmake here; FMPy has not compiled the sources")
else:
    build_platform_binary(folder)
    outside, again = compare(folder)
    fmu_states.check(description, folder, step)
    same = "the same bits as" if (found == again).all() else "other bits than"
    print(f"compiled by FMPy: {outside:.3f} units in the last place a step, {same} the binary inside")
shutil.rmtree(folder)
print(f"{len(rows)} samples of {len(names)} variables: {inside:.3f} units in the last place a step")
