"""Flexible multibody dynamics in the floating frame of reference, on NumPy arrays.

A thin layer over the Rust libraries behind the ``ffrf`` command: what the command refuses raises :class:`Error` with the
same text, and numbers are the same to the last bit. ``docs/python.md`` in the repository shows each part at work.
"""

from __future__ import annotations

from ffrf._native import (
    Body,
    Configuration,
    Error,
    Marker,
    Outcome,
    Plan,
    StressMarker,
    Study,
    Sweep,
    load_model,
    plan,
)
from ffrf._reduction import ImportRemark, reduce
from ffrf._simulation import Simulation, Summary, simulate
from ffrf._tradeoff import tradeoff

__all__ = [
    "Body",
    "Configuration",
    "Error",
    "ImportRemark",
    "Marker",
    "Outcome",
    "Plan",
    "Simulation",
    "StressMarker",
    "Study",
    "Summary",
    "Sweep",
    "load_model",
    "plan",
    "reduce",
    "simulate",
    "tradeoff",
]
