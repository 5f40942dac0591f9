"""A scene in many configurations: one by one, in a folder, and in the folder of the command."""

from __future__ import annotations

import csv
import json
import pickle
import subprocess
import sys
from pathlib import Path

import ffrf
import numpy as np
import pytest



def configurations(study: ffrf.Study) -> list[ffrf.Configuration]:
    return study.configurations(
        modes=[0, 2],
        fidelity=["linear", "full"],
        scalar=["f64", "f32"],
        integrator=["linearly_implicit", "rk4"],
        step=[5e-2, 1e-2],
    )


def without_time(outcome: ffrf.Outcome) -> object:
    """The numbers of an outcome but the time that it took."""
    numbers = json.loads(outcome.to_json())
    numbers["finding"].get("finished", {}).pop("time", None)
    return numbers


@pytest.fixture(scope="module")
def rod(scenes: Path) -> Path:
    return scenes / "tumbling_rod.toml"


@pytest.fixture(scope="module")
def study(rod: Path) -> ffrf.Study:
    return ffrf.Study(rod, quantity=["tip", "energy"], reference_tolerance=1e-8)


def test_the_grid_is_that_of_the_names(study: ffrf.Study) -> None:
    grid = configurations(study)
    # without modes both fidelities are one body
    assert len(grid) == (1 + 2) * 2 * 2 * 2
    assert len(set(grid)) == len(grid)
    one = ffrf.Configuration(2, "linear", "f32", "rk4", 1e-2)
    assert one in grid
    assert (one.modes, one.fidelity, one.scalar, one.integrator, one.step) == (2, "linear", "f32", "rk4", 1e-2)
    usual = study.configurations()
    assert {one.integrator for one in usual} == {"rk4", "linearly_implicit", "generalized_alpha"}
    assert max(one.modes for one in usual if isinstance(one.modes, int)) == study.most_modes
    assert [name for name, _ in study.channels] == ["tip", "energy"]
    assert study.scales.shape == study.own_errors.shape == (2,)
    assert float(study.own_errors.max()) < 1e-5


def test_smaller_steps_have_smaller_errors(study: ffrf.Study) -> None:
    errors = []
    for step in [4e-2, 2e-2]:
        outcome = study.run(ffrf.Configuration(study.most_modes, "full", "f64", "linearly_implicit", step))
        assert outcome.failure is None and outcome.error is not None and outcome.errors is not None
        assert outcome.error == outcome.errors.max()
        errors.append(outcome.error)
    # order 2, within what the coarse step leaves of it
    assert 2.0 < errors[0] / errors[1] < 8.0


def test_bodies_have_modes_of_their_own(models: Path, tmp_path: Path) -> None:
    model = (models / "spin_up_beam.ffrf.json").resolve()
    scene = tmp_path / "two.toml"
    body = "[bodies.{0}]\nmodel = \"{1}\"\n[joints.hinge_{0}]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"{0}\"\naxis = [0.0, 1.0, 0.0]\n"
    scene.write_text(
        "[simulation]\nduration = 0.2\nstep = 1e-2\ngravity = [0.0, 0.0, -9.81]\noutput_step = 0.05\n"
        + body.format("left", model)
        + body.format("right", model)
    )
    study = ffrf.Study(scene, reference_tolerance=1e-6)
    assert study.flexible_bodies == {"left": 4, "right": 4}
    grid = study.configurations(
        modes=[2, {"left": 2, "right": [0, 2]}, {"left": 2}, {"left": 2, "right": 2}],
        fidelity=["full"], scalar=["f64"], integrator=["linearly_implicit"], step=[1e-2],
    )
    # the last says what the first does
    assert [one.modes for one in grid] == [2, {"left": 2, "right": [0, 2]}, {"left": 2, "right": 4}]
    outcome = study.run(grid[1])
    assert outcome.failure is None
    assert ffrf.Outcome.from_json(outcome.to_json()) == outcome == pickle.loads(pickle.dumps(outcome))
    # a body that is not named has all its modes
    one = ffrf.Configuration({"left": 2}, "full", "f64", "linearly_implicit", 1e-2)
    assert study.run(one).error == study.run(grid[2]).error
    with pytest.raises(ffrf.Error, match="modes of `nose`: expected a flexible body, `left`, `right`"):
        study.run(ffrf.Configuration({"nose": 2}, "full", "f64", "rk4", 1e-2))


def test_an_unstable_run_is_an_outcome(study: ffrf.Study) -> None:
    outcome = study.run(ffrf.Configuration(study.most_modes, "full", "f64", "rk4", 0.1))
    assert outcome.failure is not None and "t = " in outcome.failure
    assert outcome.error is None and outcome.errors is None and outcome.steps is None


def test_a_folder_holds_the_sweep_of_the_command(rod: Path, study: ffrf.Study, tmp_path: Path) -> None:
    folder = tmp_path / "sweep"
    sweep = ffrf.Sweep(rod, folder, quantity=["tip", "energy"], reference_tolerance=1e-8)
    grid = configurations(sweep.study)
    assert sweep.missing(grid) == grid
    sweep.keep([study.run(grid[0])])
    sweep.keep([study.run(configuration) for configuration in grid[1:5]])
    sweep.keep([])
    assert sweep.missing(grid) == grid[5:]
    outcomes = ffrf.tradeoff(
        rod,
        folder,
        modes=[0, 2],
        fidelity=["linear", "full"],
        scalar=["f64", "f32"],
        integrator=["linearly_implicit", "rk4"],
        step=[5e-2, 1e-2],
        quantity=["tip", "energy"],
        reference_tolerance=1e-8,
    )
    assert [outcome.configuration for outcome in outcomes] == grid
    assert sweep.missing(grid) == [] and sweep.outcomes(grid) == outcomes
    # one process, run by run, gives the same numbers
    for outcome in outcomes:
        assert without_time(study.run(outcome.configuration)) == without_time(outcome)
    with (folder / "table.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["error"]) if row["error"] else None for row in rows] == [one.error for one in outcomes]
    assert "<svg" in (folder / "pareto_operations.svg").read_text()
    assert (folder / "report.html").exists()
    with pytest.raises(ffrf.Error, match="other quantities"):
        ffrf.Sweep(rod, folder, quantity=["energy"], reference_tolerance=1e-8)


def test_a_study_works_in_another_process_as_here(study: ffrf.Study, tmp_path: Path) -> None:
    configuration = ffrf.Configuration(2, "first_moment, modal_momentum", "f64", "linearly_implicit", 2e-2)
    file = tmp_path / "study.pickle"
    file.write_bytes(pickle.dumps((study, configuration)))
    program = (
        "import pickle, sys; study, one = pickle.load(open(sys.argv[1], 'rb')); "
        "sys.stdout.buffer.write(pickle.dumps(study.run(one)))"
    )
    done = subprocess.run([sys.executable, "-c", program, str(file)], capture_output=True, check=True)
    there = pickle.loads(done.stdout)
    assert there.configuration == configuration
    assert without_time(there) == without_time(study.run(configuration))


def test_a_study_of_other_files_is_refused(scenes: Path, models: Path, tmp_path: Path) -> None:
    (tmp_path / "scenes").mkdir()
    scene = tmp_path / "scenes" / "rod.toml"
    scene.write_text((scenes / "tumbling_rod.toml").read_text())
    model = tmp_path / "spin_up_beam.ffrf.json"
    body = ffrf.load_model(models / "spin_up_beam.ffrf.json")
    body.save(model)
    pickled = pickle.dumps(ffrf.Study(scene, quantity=["tip"], reference_tolerance=1e-6))
    pickle.loads(pickled)
    text = model.read_text()
    model.write_text(text.replace(f'"title": "{body.title}"', '"title": "another"'))
    assert model.read_text() != text
    with pytest.raises(ffrf.Error, match="other models or tables"):
        pickle.loads(pickled)


def test_names_that_nothing_has_are_refused(rod: Path, study: ffrf.Study) -> None:
    with pytest.raises(ffrf.Error, match="quantity `nose`: expected one of `tip`, `root`"):
        ffrf.Study(rod, quantity=["nose"])
    with pytest.raises(ffrf.Error, match="expected one of .*rk4"):
        study.configurations(integrator=["euler"])
    with pytest.raises(ffrf.Error, match="unknown fidelity"):
        ffrf.Configuration(2, "fullest", "f64", "rk4", 1e-3)
    with pytest.raises(ffrf.Error, match="f64 or f32"):
        ffrf.Configuration(2, "full", "f16", "rk4", 1e-3)
    with pytest.raises(ffrf.Error, match="positive number"):
        ffrf.Configuration(2, "full", "f64", "rk4", 0.0)


def test_outcomes_are_what_they_were_as_text(study: ffrf.Study) -> None:
    outcome = study.run(ffrf.Configuration(1, "full", "f32", "generalized_alpha", 5e-2))
    assert ffrf.Outcome.from_json(outcome.to_json()) == outcome == pickle.loads(pickle.dumps(outcome))
    assert outcome.errors is not None and outcome.errors.dtype == np.float64
    assert outcome.data_bytes is not None and outcome.data_bytes % 4 == 0
    with pytest.raises(ffrf.Error, match="outcome"):
        ffrf.Outcome.from_json("{}")
