"""Finite-element models, of files or of arrays, to reduced bodies."""

from __future__ import annotations

import os
import tempfile
import warnings
from pathlib import Path
from typing import Any, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union, cast

import numpy as np
from numpy.typing import ArrayLike

from ffrf import _native

PathLike = Union[str, "os.PathLike[str]"]
#: A file, an array, or a sparse matrix of SciPy.
Matrix = Union[PathLike, ArrayLike, Any]
#: Density, Young's modulus and Poisson's ratio.
SolidMaterial = Tuple[float, float, float]
#: A node set of the deck, a node id, or several.
NodeChoice = Union[str, int, Sequence[int]]


class ImportRemark(UserWarning):
    """What an import took for granted, or numbers that look odd: the remarks of ``ffrf reduce`` on standard error."""


def reduce(
    *,
    mesh: Optional[PathLike] = None,
    material: Union[SolidMaterial, Mapping[Optional[str], SolidMaterial], None] = None,
    nodes: Optional[Matrix] = None,
    abaqus: Optional[PathLike] = None,
    calculix: Optional[PathLike] = None,
    nastran: Optional[PathLike] = None,
    ansys: Optional[PathLike] = None,
    mass: Optional[Matrix] = None,
    stiffness: Optional[Matrix] = None,
    mapping: Optional[PathLike] = None,
    mass_form: Optional[str] = None,
    allow_massless: bool = False,
    inflated_limit: Optional[int] = None,
    units: Optional[str] = None,
    convert_to: Optional[str] = None,
    modes: Optional[int] = None,
    mode_shapes: Optional[Matrix] = None,
    clamp: Optional[NodeChoice] = None,
    modal_stiffness: Optional[Matrix] = None,
    damping_ratio: Union[float, Sequence[float], None] = None,
    damping_bands: Union[str, bool, None] = None,
    rayleigh: Optional[Tuple[float, float]] = None,
    marker: Optional[Mapping[str, NodeChoice]] = None,
    stress: Optional[Mapping[str, NodeChoice]] = None,
    section: Optional[Mapping[str, str]] = None,
    interface: Sequence[str] = (),
    basis: Optional[str] = None,
    raw: bool = False,
    reference: Optional[str] = None,
    static_load: Sequence[str] = (),
    keep_below: Optional[float] = None,
    keep_above: Optional[float] = None,
    keep_importance: Optional[float] = None,
    keep_count: Optional[int] = None,
    geometric_stiffness: bool = False,
    load_stiffness: Sequence[str] = (),
    elastic: Optional[Tuple[float, float]] = None,
    surface: Optional[PathLike] = None,
    view: Optional[PathLike] = None,
    sheet: Optional[PathLike] = None,
    title: Optional[str] = None,
) -> _native.Body:
    """Reduce a finite-element model to a flexible body: the arguments are the flags of ``ffrf reduce``.

    Files are read as the command reads them. ``nodes`` (N x 3, or N x 4 with ids first), ``mass`` (N x N or 3N x 3N),
    ``stiffness`` (3N x 3N), ``mode_shapes`` (3N x M) and ``modal_stiffness`` (M x M) may be arrays as well, and the matrices
    sparse ones of SciPy or triples ``(values, (rows, columns))``, where equal places add up. The body's provenance then names
    the file that such an array was saved to, with its hash.

    ``mesh`` is a mesh of gmsh or VTK, ``material`` what its solids are made of: density, Young's modulus and Poisson's ratio in
    the units of the mesh, or such triples by the name of a group of solids, with ``None`` for all solids that no named group holds.

    What the command says on standard error is warned of as :class:`ImportRemark`; what it refuses raises :class:`Error`.
    """
    with tempfile.TemporaryDirectory(prefix="ffrf-") as folder:
        matrices = {
            "nodes": nodes,
            "mass": mass,
            "stiffness": stiffness,
            "mode_shapes": mode_shapes,
            "modal_stiffness": modal_stiffness,
        }
        flags: Dict[str, object] = {name: _file(Path(folder), name, value) for name, value in matrices.items()}
        flags.update(
            abaqus=abaqus,
            calculix=calculix,
            nastran=nastran,
            material=_materials(material),
            ansys=ansys,
            mapping=mapping,
            mass_form=mass_form,
            allow_massless=allow_massless,
            inflated_limit=inflated_limit,
            units=units,
            convert_to=convert_to,
            modes=modes,
            clamp=None if clamp is None else _nodes(clamp),
            damping_ratio=damping_ratio,
            damping_bands=damping_bands,
            rayleigh=rayleigh,
            marker=[f"{name}={_nodes(choice)}" for name, choice in (marker or {}).items()],
            stress=[f"{name}={_nodes(choice)}" for name, choice in (stress or {}).items()],
            section=[f"{name}={cut}" for name, cut in (section or {}).items()],
            interface=list(interface),
            basis=basis,
            raw=raw,
            reference=reference,
            static_load=list(static_load),
            keep_below=keep_below,
            keep_above=keep_above,
            keep_importance=keep_importance,
            keep_count=keep_count,
            geometric_stiffness=geometric_stiffness,
            load_stiffness=",".join(load_stiffness) or None,
            elastic=elastic,
            surface=surface,
            view=view,
            sheet=sheet,
            title=title,
        )
        # the command must be told where to write; here nothing is written
        words = ["--output=body.ffrf.json", *_words(flags)]
        if mesh is not None:
            words += ["--", os.fspath(mesh)]
        body, _, remarks = _native.reduce_words(words)
    for remark in remarks:
        warnings.warn(remark, ImportRemark, stacklevel=2)
    return body


def _words(flags: Mapping[str, object]) -> Iterable[str]:
    """The words of a command line."""
    for name, value in flags.items():
        flag = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            yield flag
        elif isinstance(value, list):
            # repeatable flags
            yield from (f"{flag}={_text(one)}" for one in cast("list[object]", value))
        else:
            yield f"{flag}={_text(value)}"


def _text(value: object) -> str:
    if isinstance(value, str):
        return value
    if hasattr(value, "__fspath__"):
        return os.fspath(cast("os.PathLike[str]", value))
    if hasattr(value, "__index__"):
        return str(int(cast(int, value)))
    if hasattr(value, "__float__"):
        # repr gives every bit back
        return repr(float(cast(float, value)))
    if isinstance(value, Iterable):
        return ",".join(_text(one) for one in cast("Iterable[object]", value))
    raise TypeError(f"expected a text, a number or several, found {value!r}")


def _materials(material: Union[SolidMaterial, Mapping[Optional[str], SolidMaterial], None]) -> List[str]:
    if material is None:
        return []
    by_group: Mapping[Optional[str], SolidMaterial] = material if isinstance(material, Mapping) else {None: material}
    return [("" if group is None else f"{group}=") + _text(constants) for group, constants in by_group.items()]


def _nodes(choice: NodeChoice) -> str:
    return _text(choice)


def _file(folder: Path, name: str, value: Optional[Matrix]) -> Optional[str]:
    """The name of a file with the matrix: that of the user, or one in the folder."""
    if value is None:
        return None
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(cast(PathLike, value))
    sparse = _triples(name, value)
    if sparse is None:
        path = folder / f"{name}.npy"
        np.save(path, np.asarray(value, dtype=np.float64))
    else:
        values, rows, columns, shape = sparse
        path = folder / f"{name}.npz"
        # as scipy.sparse.save_npz writes it, which needs no SciPy
        np.savez(path, format=np.array(b"coo"), shape=np.array(shape), row=rows, col=columns, data=values)
    return os.fspath(path)


_Triples = Tuple[Any, Any, Any, Tuple[int, int]]


def _triples(name: str, value: Any) -> Optional[_Triples]:
    """Values, rows, columns and shape of a sparse matrix of SciPy or of a triple; none of what is dense."""
    if hasattr(value, "tocoo"):
        coo = value.tocoo(copy=True)
        coo.sum_duplicates()
        return np.asarray(coo.data, dtype=np.float64), coo.row, coo.col, coo.shape
    if not isinstance(value, tuple) or [type(part) for part in cast("Tuple[object, ...]", value)][1:] != [tuple]:
        return None
    entries, places = cast("Tuple[ArrayLike, Tuple[ArrayLike, ArrayLike]]", value)
    values = np.asarray(entries, dtype=np.float64)
    rows, columns = (np.asarray(part, dtype=np.int64) for part in places)
    if not values.shape == rows.shape == columns.shape or values.ndim != 1:
        raise _native.Error(f"{name}: expected values, rows and columns of one length, found {values.shape}, "
                            f"{rows.shape} and {columns.shape}")
    if values.size and min(rows.min(), columns.min()) < 0:
        raise _native.Error(f"{name}: expected rows and columns from 0, found {min(rows.min(), columns.min())}")
    size = int(max(rows.max(), columns.max())) + 1 if values.size else 0
    # equal places add up
    unique, index = np.unique(rows * size + columns, return_inverse=True)
    summed = np.bincount(index, weights=values, minlength=unique.size)
    return summed, unique // max(size, 1), unique % max(size, 1), (size, size)
