"""Finite-element models to bodies: of arrays, of files, and what is refused."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import ffrf
import numpy as np
import pytest
import scipy.io
import scipy.linalg
import scipy.sparse
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass
class Truss:
    """Point masses with springs between all of them: its stiffness knows rigid motion to round-off."""

    nodes: Array
    mass: Array
    stiffness: Array


@pytest.fixture(scope="module")
def truss() -> Truss:
    random = np.random.default_rng(7)
    count = 10
    nodes = random.uniform(-1.0, 1.0, (count, 3))
    mass = np.diag(random.uniform(0.5, 2.0, count))
    stiffness = np.zeros((3 * count, 3 * count))
    for first in range(count):
        for second in range(first):
            along = nodes[first] - nodes[second]
            along /= np.linalg.norm(along)
            block = random.uniform(1e4, 1e5) * np.outer(along, along)
            a, b = slice(3 * first, 3 * first + 3), slice(3 * second, 3 * second + 3)
            stiffness[a, a] += block
            stiffness[b, b] += block
            stiffness[a, b] -= block
            stiffness[b, a] -= block
    return Truss(nodes, mass, stiffness)


def quietly(**flags: Any) -> ffrf.Body:
    """A reduction whose remarks are of no matter."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ffrf.ImportRemark)
        return ffrf.reduce(**flags)


def test_a_body_of_arrays_is_that_of_the_definition(truss: Truss) -> None:
    body = quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness, modes=5, marker={"TIP": 3}, title="Truss")
    masses = np.diag(truss.mass)
    assert (body.title, body.mode_count) == ("Truss", 5)
    np.testing.assert_allclose(body.mass, masses.sum(), rtol=1e-14)
    np.testing.assert_allclose(body.first_moment, masses @ truss.nodes, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(body.second_moment, truss.nodes.T @ truss.mass @ truss.nodes, rtol=1e-12, atol=1e-14)
    squares = scipy.linalg.eigh(truss.stiffness, np.kron(truss.mass, np.eye(3)), eigvals_only=True)
    # the six lowest are rigid motion
    np.testing.assert_allclose(2 * np.pi * body.frequencies, np.sqrt(squares[6:11]), rtol=1e-10)
    np.testing.assert_array_equal(body.markers["TIP"].position, truss.nodes[3])
    # mass-orthonormal modes
    modal_mass = np.trace(body.mode_mode_moment, axis1=2, axis2=3)
    np.testing.assert_allclose(modal_mass, np.eye(5), atol=1e-12)


def test_arrays_sparse_matrices_triples_and_files_give_one_body(truss: Truss, tmp_path: Path) -> None:
    np.savetxt(tmp_path / "X.txt", truss.nodes, fmt="%.17g")
    scipy.io.mmwrite(tmp_path / "M.mtx", scipy.sparse.coo_matrix(truss.mass), precision=17, symmetry="general")
    scipy.io.mmwrite(tmp_path / "K.mtx", scipy.sparse.coo_matrix(truss.stiffness), precision=17, symmetry="general")
    full_mass = np.kron(truss.mass, np.eye(3))
    rows, columns = np.nonzero(truss.stiffness)
    # every entry in two halves, as assembly leaves them
    halves = (np.tile(truss.stiffness[rows, columns] / 2, 2), (np.tile(rows, 2), np.tile(columns, 2)))
    forms: list[dict[str, Any]] = [
        {"nodes": truss.nodes, "mass": truss.mass, "stiffness": truss.stiffness},
        {"nodes": truss.nodes, "mass": scipy.sparse.csr_matrix(full_mass), "stiffness": scipy.sparse.csc_array(truss.stiffness)},
        {"nodes": truss.nodes, "mass": scipy.sparse.coo_array(truss.mass), "stiffness": halves},
        {"nodes": tmp_path / "X.txt", "mass": str(tmp_path / "M.mtx"), "stiffness": tmp_path / "K.mtx"},
    ]
    bodies = [quietly(**form, modes=4, damping_ratio=[0.01, 0.02, 0.03, 0.04]) for form in forms]
    for body in bodies[1:]:
        for name in ["frequencies", "stiffness", "damping", "second_moment", "mode_mode_moment", "position_mode_moment"]:
            np.testing.assert_array_equal(getattr(body, name), getattr(bodies[0], name), err_msg=name)


def test_mode_shapes_of_the_user_are_taken(truss: Truss) -> None:
    chosen = quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness, modes=3)
    _, shapes = scipy.linalg.eigh(truss.stiffness, np.kron(truss.mass, np.eye(3)))
    body = quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness, mode_shapes=shapes[:, 6:9])
    assert body.mode_kinds == ["user"] * 3
    np.testing.assert_allclose(np.diag(body.stiffness), (2 * np.pi * chosen.frequencies) ** 2, rtol=1e-9)


def test_an_export_is_reduced_as_by_the_command(models: Path) -> None:
    folder = models / "conrod"
    deck = next(folder.glob("*.inp"))
    written = ffrf.load_model(models / "conrod.ffrf.json")
    body = quietly(calculix=deck, modes=written.mode_count)
    np.testing.assert_allclose(body.frequencies, written.frequencies, rtol=1e-9)
    assert body.mass == written.mass


def test_remarks_are_warnings(truss: Truss) -> None:
    with pytest.warns(ffrf.ImportRemark, match="density|size|frequency|units|solid"):
        ffrf.reduce(nodes=truss.nodes, mass=1e12 * truss.mass, stiffness=truss.stiffness, modes=2, units="mm,t,s")


def test_what_is_wrong_is_said_in_the_words_of_the_command(truss: Truss) -> None:
    crooked = truss.stiffness.copy()
    crooked[0, 4] += 1e3
    with pytest.raises(ffrf.Error, match=r"stiffness\.npy.*symmetric"):
        quietly(nodes=truss.nodes, mass=truss.mass, stiffness=crooked, modes=2)
    with pytest.raises(ffrf.Error, match="required"):
        quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness)
    with pytest.raises(ffrf.Error, match="--basis"):
        quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness, modes=2, interface=["A=ids:1"], basis="best")
    with pytest.raises(ffrf.Error, match="there is no node 77"):
        quietly(nodes=truss.nodes, mass=truss.mass, stiffness=truss.stiffness, modes=2, marker={"TIP": 77})
    with pytest.raises(ffrf.Error, match="values, rows and columns of one length"):
        quietly(nodes=truss.nodes, mass=([1.0], ([0, 1], [0])), stiffness=truss.stiffness, modes=2)


def two_tetrahedra(folder: Path) -> Path:
    """Volumes of 1/6 and 1/3 cubic metres, in the groups HUB and ARM."""
    path = folder / "part.msh"
    path.write_text(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
        '$PhysicalNames\n2\n3 1 "HUB"\n3 2 "ARM"\n$EndPhysicalNames\n'
        "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
        "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 2 3 4 5\n$EndElements\n"
    )
    return path


def test_each_group_of_a_mesh_has_its_own_material(tmp_path: Path) -> None:
    mesh = two_tetrahedra(tmp_path)
    steel, rubber = (7850.0, 2.1e11, 0.3), (1100.0, 1e7, 0.45)
    plain = quietly(mesh=mesh, material=steel, modes=2)
    assert plain.mass == pytest.approx(7850.0 / 2)
    for material in [{"HUB": steel, "ARM": rubber}, {"HUB": steel, None: rubber}]:
        body = quietly(mesh=mesh, material=material, modes=2, section={"cut": "plane:0.5,0.2,0.2,1,0,0"})
        assert body.mass == pytest.approx((7850.0 + 2 * 1100.0) / 6)
    with pytest.raises(ffrf.Error, match=r"groups of solids: ARM \(1 solid\), HUB \(1 solid\)"):
        quietly(mesh=mesh, material={"HUB": steel}, modes=2)
