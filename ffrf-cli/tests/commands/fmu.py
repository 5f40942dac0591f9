"""FMPy validates and simulates an FMU and compares it with the samples of `ffrf simulate`, bit by bit.

Usage: fmu.py PART.fmu SAMPLES.csv
"""

import csv
import shutil
import sys

import fmu_states
from fmpy import extract, read_model_description, simulate_fmu
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

folder = extract(fmu)
fmu_states.check(description, folder, step)
shutil.rmtree(folder)
print(f"{len(rows)} samples of {len(names)} variables are the same")
