"""Scenes through time."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, Dict, List, Tuple, TypedDict, Union

import numpy as np
from numpy.typing import NDArray

from ffrf import _native


class Summary(TypedDict):
    """What a simulation says at its end."""

    steps: int
    """Whole steps."""
    side_steps: int
    """Shorter steps for samples between whole ones."""
    refused: int
    """Tries that error control refused."""
    iterations: int
    """Most iterations of a step."""
    drift: Tuple[float, float]
    """Largest residual of the joints before it was corrected: m or rad, and per second."""
    initial_residuals: Tuple[float, float]
    """How far the scene's state was from the joints: m or rad, and per second."""
    events: List[Tuple[str, float, bool]]
    """Events that happened: name, time in s, whether the sensor rose through the value."""
    warnings: List[str]
    """Bodies that turned faster than their modes can stand."""


class Simulation(Dict[str, "NDArray[np.float64]"]):
    """Samples over time: an array for each column of ``ffrf simulate -o OUT.csv``, by its name; ``t`` is the time in s.

    It is a dictionary, so ``pandas.DataFrame(simulation)`` is a table.
    """

    summary: Summary
    """Steps, drift, events and warnings."""
    end_state: str
    """The state at the end, as ``ffrf simulate --save-state`` writes it (JSON)."""

    def __init__(self, columns: Dict[str, NDArray[np.float64]], summary: Summary, end_state: str) -> None:
        super().__init__(columns)
        self.summary = summary
        self.end_state = end_state

    def __reduce__(self) -> Tuple[Any, ...]:
        return (Simulation, (dict(self), self.summary, self.end_state))


def simulate(
    scene: Union[str, "os.PathLike[str]"],
    *,
    state: Union[Simulation, str, "os.PathLike[str]", None] = None,
) -> Simulation:
    """Simulate a scene file (TOML) from its initial state.

    Begin with ``state`` instead if it is given: the end of another simulation, or the name of a file that
    ``ffrf simulate --save-state`` wrote.
    """
    saved = state.end_state if isinstance(state, Simulation) else None if state is None else _read(state)
    columns, summary, end_state = _native.simulate(os.fspath(scene), saved)
    return Simulation(dict(columns), summary, end_state)


def _read(path: Union[str, "os.PathLike[str]"]) -> str:
    try:
        return Path(path).read_text(encoding="utf-8")
    except OSError as error:
        raise _native.Error(f"{os.fspath(path)}: {error.strerror}") from error
