"""The compiled half of the package; import from ``ffrf``."""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import ClassVar, Union, final

import numpy as np
from numpy.typing import NDArray

from ffrf._simulation import Summary

_Path = Union[str, PathLike[str]]
_BodyModes = Union[int, Sequence[int]]
# of every flexible body, or of each by its name; those that are not named have all
_Modes = Union[_BodyModes, Mapping[str, _BodyModes]]
_Array = NDArray[np.float64]

__all__ = [
    "Body",
    "Configuration",
    "Error",
    "Marker",
    "Outcome",
    "Plan",
    "StressMarker",
    "Study",
    "Sweep",
    "load_model",
    "plan",
    "reduce_words",
    "simulate",
]

class Error(Exception):
    """What ffrf refuses, in the words of the command."""

@final
class Body:
    """A flexible body, reduced to M modes: what a model file holds.

    Quantities are in the body frame and in the units of the body. Each access makes a new array; writing into it leaves the
    body as it is. Bodies can be pickled.
    """

    @classmethod
    def from_json(cls, text: str) -> Body:
        """The body of the text of a model file, checked. Raises :class:`Error`."""
    def to_json(self) -> str:
        """The text of a model file: the same body gives the same text."""
    def save(self, path: _Path) -> None:
        """Write a model file, whole or not at all."""
    @property
    def title(self) -> str:
        """A line for people."""
    @property
    def units(self) -> str:
        """Units of all numbers, such as ``m, kg, s, N``."""
    @property
    def notes(self) -> list[str]:
        """What the import took for granted or found odd."""
    @property
    def mode_count(self) -> int:
        """Number of modes M."""
    @property
    def mode_kinds(self) -> list[str]:
        """How each mode was made: ``free-free``, ``clamped``, ``component``, ``constraint``, ``attachment`` or ``user``."""
    @property
    def frequencies(self) -> _Array:
        """Natural frequencies in Hz; NaN of modes that are no eigenmodes. Shape: M."""
    @property
    def mass(self) -> float:
        """Mass m."""
    @property
    def first_moment(self) -> _Array:
        """First moment of mass, integral of ρ x. Shape: 3."""
    @property
    def modal_first_moment(self) -> _Array:
        """Integral of ρ φ_μ. Shape: M x 3."""
    @property
    def second_moment(self) -> _Array:
        """Euler tensor, integral of ρ xⁱ xʲ. Shape: 3 x 3."""
    @property
    def position_mode_moment(self) -> _Array:
        """Integral of ρ xⁱ φ_μʲ, not symmetric in i and j. Shape: M x 3 x 3."""
    @property
    def mode_mode_moment(self) -> _Array:
        """Integral of ρ φ_μⁱ φ_νʲ; its trace over i = j is the modal mass matrix. Shape: M x M x 3 x 3."""
    @property
    def stiffness(self) -> _Array:
        """Modal stiffness. Shape: M x M."""
    @property
    def damping(self) -> _Array:
        """Modal damping. Shape: M x M."""
    @property
    def geometric_stiffness(self) -> tuple[_Array, _Array] | None:
        """Stress stiffness of unit body forces ρ e_j and ρ xⁱ e_j, if the body has it. Shapes: M x M x 3, M x M x 3 x 3."""
    @property
    def markers(self) -> dict[str, Marker]:
        """Points where forces act and where motion is observed, by name."""
    @property
    def stress_markers(self) -> dict[str, StressMarker]:
        """Places where stress is observed, by name."""

@final
class Marker:
    """A point of a body where forces act and where motion is observed."""

    @property
    def name(self) -> str:
        """Its name."""
    @property
    def nodes(self) -> list[int]:
        """Ids of the nodes whose mean motion it follows."""
    @property
    def position(self) -> _Array:
        """Reference position. Shape: 3."""
    @property
    def translation(self) -> _Array:
        """Displacement per unit modal coordinate. Shape: M x 3."""
    @property
    def rotation(self) -> _Array:
        """Small rotation per unit modal coordinate, rad. Shape: M x 3."""
    @property
    def coupling(self) -> str | None:
        """How an interface holds its nodes: "rigid" (RBE2) or "average" (RBE3); None for a marker that only follows them."""

@final
class StressMarker:
    """A place of a body where stress is observed."""

    @property
    def name(self) -> str:
        """Its name."""
    @property
    def nodes(self) -> list[int]:
        """Ids of the nodes over which the stress is averaged."""
    @property
    def position(self) -> _Array:
        """Mean reference position of its nodes. Shape: 3."""
    @property
    def stress(self) -> _Array:
        """Stress per unit modal coordinate: xx, yy, zz, xy, xz, yz. Shape: M x 6."""

def load_model(path: _Path) -> Body:
    """Read a model file (``*.ffrf.json``) and check it. Raises :class:`Error`."""

def simulate(scene: _Path, state: str | None = None) -> tuple[list[tuple[str, _Array]], Summary, str]:
    """Names and columns, summary, and the state at the end as JSON."""

@final
class Configuration:
    """One way to simulate a scene. Equal ones have equal hashes; can be pickled."""

    def __new__(cls, modes: _Modes, fidelity: str, scalar: str, integrator: str, step: float) -> Configuration:
        """Names as on the command line: ``full`` or terms separated by commas, ``f64`` or ``f32``, ``rk4``, ...; step in s."""
    @property
    def modes(self) -> int | list[int] | dict[str, int | list[int]]:
        """The first so many modes of every flexible body, or a list of those from 0 that are used; or one of these for each body."""
    @property
    def fidelity(self) -> str:
        """Terms of the kinetic energy that are kept."""
    @property
    def scalar(self) -> str:
        """Number type of the whole simulation."""
    @property
    def integrator(self) -> str:
        """Its name in scene files."""
    @property
    def step(self) -> float:
        """Longest step in s; steps are equal and end at the samples."""
    @property
    def key(self) -> str:
        """A name that no other configuration has, fit for files."""
    @property
    def expected_effort(self) -> float:
        """Grows with what a run takes: run the largest first, so that nobody waits for one that came late."""
    def __hash__(self) -> int: ...
    def __eq__(self, value: object, /) -> bool: ...

@final
class Outcome:
    """A configuration and what came of it: errors and cost, or why it failed. Numbers are None of runs that failed.

    Equal outcomes have equal numbers, times of the machine included. Can be pickled.
    """

    @classmethod
    def from_json(cls, text: str) -> Outcome:
        """The outcome of a text of :meth:`to_json`, or of a file in the folder ``runs`` of a sweep."""
    def to_json(self) -> str:
        """The outcome as text, to its last bit."""
    @property
    def configuration(self) -> Configuration:
        """What was run."""
    @property
    def failure(self) -> str | None:
        """When and why the run failed; None if it reached its end."""
    @property
    def error(self) -> float | None:
        """The largest of :attr:`errors`."""
    @property
    def errors(self) -> _Array | None:
        """The largest error over time of each channel of the study, over its scale."""
    @property
    def step(self) -> float | None:
        """The step that was taken, in s."""
    @property
    def steps(self) -> int | None:
        """Number of steps."""
    @property
    def evaluations_per_step(self) -> float | None:
        """Evaluations of the accelerations per step."""
    @property
    def time_per_second(self) -> float | None:
        """Processor time of this machine per simulated second; another run gives another."""
    @property
    def operations_per_step(self) -> float | None:
        """Floating-point operations of compiled code per step."""
    @property
    def operations_per_second(self) -> float | None:
        """The same per simulated second."""
    @property
    def instructions_per_step_estimated(self) -> float | None:
        """Instructions of compiled code per step, about."""
    @property
    def data_bytes(self) -> int | None:
        """Numbers of the bodies in compiled code."""
    @property
    def stack_bytes_estimated(self) -> int | None:
        """What a step keeps on the stack, about."""
    def __eq__(self, value: object, /) -> bool: ...
    __hash__: ClassVar[None]  # type: ignore[assignment]

@final
class Study:
    """A scene to be run in many configurations, and the reference that their errors are taken against.

    Making one computes the reference. Pickled, it takes the reference along and the *names* of its files: where it is unpickled
    they must be what they were here, or it is refused.
    """

    def __new__(cls, scene: _Path, *, quantity: Sequence[str] = ..., reference_tolerance: float = 1e-10) -> Study:
        """``quantity``: ``sensor NAME``, ``reaction`` or ``energy``; without any, every sensor, or the frames of all bodies."""
    @property
    def scene(self) -> str | PathLike[str]:
        """The scene file."""
    @property
    def most_modes(self) -> int:
        """The most modes that a body of the scene has."""
    @property
    def flexible_bodies(self) -> dict[str, int]:
        """Names of the flexible bodies, and how many modes they have."""
    @property
    def channels(self) -> list[tuple[str, str]]:
        """Name and unit of each vector whose error is taken."""
    @property
    def scales(self) -> _Array:
        """What the errors of each channel are divided by."""
    @property
    def own_errors(self) -> _Array:
        """The error of the reference itself in each channel, over its scale."""
    def configurations(
        self,
        *,
        modes: Sequence[_Modes] | None = None,
        fidelity: Sequence[str] | None = None,
        scalar: Sequence[str] | None = None,
        integrator: Sequence[str] | None = None,
        step: Sequence[float] | None = None,
    ) -> list[Configuration]:
        """Every combination, each once; what is not given is what ``ffrf tradeoff`` runs without flags."""
    def run(self, configuration: Configuration) -> Outcome:
        """Run one configuration. A run that fails is an outcome as well."""

@final
class Sweep:
    """The folder of a sweep, as ``ffrf tradeoff SCENE -o FOLDER`` makes it: an interrupted one goes on, here or there."""

    def __new__(
        cls,
        scene: _Path,
        folder: _Path,
        *,
        quantity: Sequence[str] = ...,
        reference_tolerance: float = 1e-10,
    ) -> Sweep:
        """Open the folder or make it; the reference is read from it, or computed and kept. Another sweep's folder is refused."""
    @property
    def study(self) -> Study:
        """The scene and its reference."""
    @property
    def folder(self) -> str | PathLike[str]:
        """The folder."""
    def missing(self, configurations: Sequence[Configuration]) -> list[Configuration]:
        """Those that have no outcome here yet."""
    def keep(self, outcomes: Sequence[Outcome]) -> None:
        """Write outcomes, all in one file that is whole or not there."""
    def outcomes(self, configurations: Sequence[Configuration]) -> list[Outcome]:
        """The outcomes that are here, in the order of the configurations."""
    def run(self, configurations: Sequence[Configuration], *, threads: int | None = None) -> list[Outcome]:
        """Run what is missing on so many threads of this process (default: one for each core) and keep it."""
    def write(self, outcomes: Sequence[Outcome]) -> str | PathLike[str]:
        """Write tables, pictures and the page of the command; gives the name of the page."""

@final
class Plan:
    """A configuration for an error that is allowed. ``str(plan)`` is what ``ffrf plan`` prints: the plan and why."""

    @property
    def configuration(self) -> Configuration:
        """What is chosen."""
    @property
    def predicted_error(self) -> float:
        """The error that is expected, over the scale of the worst quantity."""
    @property
    def predicted_parts(self) -> tuple[float, float, float, float]:
        """Its parts: of the model, of the steps, of rounding, of the reference."""
    @property
    def operations_per_step(self) -> float:
        """Floating-point operations of compiled code per step, estimated."""
    @property
    def operations_per_second(self) -> float:
        """The same per simulated second."""
    @property
    def measured(self) -> Outcome | None:
        """The run of what is planned, if ``measure`` was asked for."""
    @property
    def macro_calls(self) -> str:
        """The calls of ``flexible_body!`` and ``mechanism!``."""

def plan(
    scene: _Path,
    *,
    error: float,
    quantity: Sequence[str] = ...,
    integrator: Sequence[str] | None = None,
    scalar: Sequence[str] | None = None,
    measure: bool = False,
) -> Plan:
    """Choose modes, terms, scalar, integrator and step of a scene for an error that is allowed, as ``ffrf plan`` does."""

def reduce_words(words: Sequence[str]) -> tuple[Body, str, list[str]]:
    """``ffrf reduce`` with these words, without writing the body: the body, the report, and warnings."""
