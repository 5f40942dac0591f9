"""A scene in many configurations on the cores of this machine."""

from __future__ import annotations

import os
from typing import List, Mapping, Optional, Sequence, Union

from ffrf._native import Outcome, Sweep


def tradeoff(
    scene: Union[str, "os.PathLike[str]"],
    folder: Union[str, "os.PathLike[str]"],
    *,
    modes: Optional[Sequence[Union[int, Sequence[int], Mapping[str, Union[int, Sequence[int]]]]]] = None,
    fidelity: Optional[Sequence[str]] = None,
    scalar: Optional[Sequence[str]] = None,
    integrator: Optional[Sequence[str]] = None,
    step: Optional[Sequence[float]] = None,
    quantity: Sequence[str] = (),
    reference_tolerance: float = 1e-10,
    threads: Optional[int] = None,
) -> List[Outcome]:
    """Do what ``ffrf tradeoff SCENE -o FOLDER`` does, with its flags as arguments, and give the outcomes.

    Ctrl-C ends it behind the runs in flight; called again it goes on where it was.
    """
    sweep = Sweep(scene, folder, quantity=quantity, reference_tolerance=reference_tolerance)
    configurations = sweep.study.configurations(
        modes=modes, fidelity=fidelity, scalar=scalar, integrator=integrator, step=step
    )
    outcomes = sweep.run(configurations, threads=threads)
    sweep.write(outcomes)
    return outcomes
