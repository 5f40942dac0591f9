"""States of an FMU: saved, as bytes, in another instance, the run goes on bit by bit. Used by the scripts beside it."""

from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave


def check(description, folder, step):
    """Takes states of an unzipped FMU up again; step: the communication step (s)."""
    two = description.fmiVersion == "2.0"
    columns = [v for v in description.modelVariables if v.causality in ("output", "local")]
    references = [v.valueReference for v in columns]

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
