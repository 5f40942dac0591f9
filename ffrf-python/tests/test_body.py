"""Model files as arrays."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import ffrf
import numpy as np
import pytest


@pytest.fixture(params=["conrod.ffrf.json", "spin_up_beam.ffrf.json"])
def path(request: pytest.FixtureRequest, models: Path) -> Path:
    return models / str(request.param)


def test_every_number_of_the_file_is_in_an_array(path: Path) -> None:
    body = ffrf.load_model(path)
    written: dict[str, Any] = json.loads(path.read_text())
    inertia = written["inertia"]
    modes = len(written["modes"])
    assert body.mode_count == modes > 0
    assert (body.title, body.units) == (written["title"], written["units"])
    assert body.mass == inertia["mass"]
    arrays = {
        "first_moment": (3,),
        "modal_first_moment": (modes, 3),
        "second_moment": (3, 3),
        "position_mode_moment": (modes, 3, 3),
        "mode_mode_moment": (modes, modes, 3, 3),
    }
    for name, shape in arrays.items():
        array = getattr(body, name)
        assert array.shape == shape and array.dtype == np.float64
        np.testing.assert_array_equal(array, inertia[name])
    np.testing.assert_array_equal(body.stiffness, written["stiffness"])
    np.testing.assert_array_equal(body.damping, written["damping"])
    frequencies = [np.nan if mode["frequency_hz"] is None else mode["frequency_hz"] for mode in written["modes"]]
    np.testing.assert_array_equal(body.frequencies, frequencies)
    assert body.mode_kinds == [mode["kind"] for mode in written["modes"]]
    for marker in written["markers"]:
        found = body.markers[marker["name"]]
        assert (found.name, found.nodes) == (marker["name"], marker["nodes"])
        for name in ["position", "translation", "rotation"]:
            np.testing.assert_array_equal(getattr(found, name), marker[name])
    assert list(body.markers) == [marker["name"] for marker in written["markers"]]
    geometric = written.get("geometric_stiffness")
    if geometric is None:
        assert body.geometric_stiffness is None
    else:
        assert body.geometric_stiffness is not None
        uniform, linear = body.geometric_stiffness
        np.testing.assert_array_equal(uniform, geometric["uniform_load"])
        np.testing.assert_array_equal(linear, geometric["linear_load"])


def test_eigenmodes_have_the_frequencies_that_they_state(path: Path) -> None:
    body = ffrf.load_model(path)
    modal_mass = np.trace(body.mode_mode_moment, axis1=2, axis2=3)
    stated = 2 * np.pi * body.frequencies
    found = np.sqrt(np.diag(body.stiffness) / np.diag(modal_mass))
    eigenmodes = np.isfinite(stated)
    # the file's frequencies are rounded results of the same eigenvalue problem
    np.testing.assert_allclose(found[eigenmodes], stated[eigenmodes], rtol=1e-6)


def test_a_body_goes_to_a_file_and_to_another_process_as_it_is(path: Path, tmp_path: Path) -> None:
    body = ffrf.load_model(path)
    body.save(tmp_path / "copy.ffrf.json")
    assert (tmp_path / "copy.ffrf.json").read_text() == body.to_json()
    assert json.loads(body.to_json()) == json.loads(path.read_text())
    assert pickle.loads(pickle.dumps(body)).to_json() == body.to_json()
    assert ffrf.Body.from_json(body.to_json()).title == body.title


def test_what_is_no_model_is_refused_in_the_words_of_the_command(tmp_path: Path, path: Path) -> None:
    missing = tmp_path / "missing.ffrf.json"
    with pytest.raises(ffrf.Error, match="missing.ffrf.json"):
        ffrf.load_model(missing)
    spoiled = json.loads(path.read_text())
    spoiled["inertia"]["mass"] = "heavy"
    file = tmp_path / "spoiled.ffrf.json"
    file.write_text(json.dumps(spoiled))
    with pytest.raises(ffrf.Error, match=r"spoiled.ffrf.json.*inertia\.mass"):
        ffrf.load_model(file)
