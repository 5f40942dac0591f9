"""FMPy validates and simulates an FMU and compares it with the samples of `ffrf simulate`, bit by bit.

Usage: fmu.py PART.fmu SAMPLES.csv
"""

import csv
import shutil
import sys

from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

fmu, samples = sys.argv[1:]

problems = validate_fmu(fmu)
assert problems == [], problems

with open(samples, newline="") as file:
    rows = list(csv.reader(file))
header, rows = rows[0], [[float(number) for number in row] for row in rows[1:]]

description = read_model_description(fmu)
step = float(description.defaultExperiment.stepSize)
names = [v.name for v in description.modelVariables if v.causality in ("output", "local")]
assert names == header[1:], "the variables are the columns"

result = simulate_fmu(fmu, output=names, output_interval=step)
assert len(result) == len(rows), (len(result), len(rows))
for found, expected in zip(result, rows):
    assert list(found)[1:] == expected[1:], found["time"]

# states: saved, as bytes, in another instance, goes on bit by bit
folder = extract(fmu)
two = description.fmiVersion == "2.0"
references = [v.valueReference for v in description.modelVariables if v.causality in ("output", "local")]


def begun(name):
    kind = FMU2Slave if two else FMU3Slave
    instance = kind(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName=name,
    )
    instance.instantiate()
    if two:
        instance.setupExperiment(startTime=0.0)
        instance.enterInitializationMode()
    else:
        instance.enterInitializationMode(startTime=0.0)
    instance.exitInitializationMode()
    return instance


def values(instance):
    return list(instance.getReal(references) if two else instance.getFloat64(references))


def go(instance, first, last):
    for index in range(first, last):
        instance.doStep(currentCommunicationPoint=index * step, communicationStepSize=step)
    return values(instance)


one, other = begun("one"), begun("other")
go(one, 0, 3)
if two:
    state = one.getFMUstate()
    data = one.serializeFMUstate(state)
    there = go(one, 3, 6)
    one.setFMUstate(state)
    one.freeFMUstate(state)
    other.setFMUstate(other.deSerializeFMUstate(data))
else:
    state = one.getFMUState()
    data = one.serializeFMUState(state)
    there = go(one, 3, 6)
    one.setFMUState(state)
    one.freeFMUState(state)
    other.setFMUState(other.deserializeFMUState(data))
assert go(one, 3, 6) == there
assert go(other, 3, 6) == there
for instance in (one, other):
    instance.terminate()
    instance.freeInstance()
shutil.rmtree(folder)
print(f"{len(rows)} samples of {len(names)} variables are the same")
