"""Scenes through time."""

from __future__ import annotations

import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import ffrf
import numpy as np
import pytest

PENDULUM = """
[simulation]
duration = {duration}
step = 1e-3
gravity = [0.0, -9.81, 0.0]
output_step = 0.01

[bodies.bob]
mass = 2.0
inertia = [[1e-3, 0.0, 0.0], [0.0, 1e-3, 0.0], [0.0, 0.0, 1e-3]]
position = [0.5, 0.0, 0.0]
markers.pivot = [-0.5, 0.0, 0.0]

[joints.pivot]
kind = "revolute"
first = "ground"
second = "bob.pivot"

[sensors.swing]
kind = "angle"
of = "pivot"

[sensors.load]
kind = "reaction_force"
of = "pivot"
"""


def scene(folder: Path, duration: float) -> Path:
    path = folder / "pendulum.toml"
    path.write_text(PENDULUM.format(duration=duration))
    return path


def test_a_pendulum_swings_as_its_energy_says(tmp_path: Path) -> None:
    found = ffrf.simulate(scene(tmp_path, 1.0))
    assert list(found)[0] == "t"
    np.testing.assert_allclose(found["t"], np.linspace(0.0, 1.0, 101), atol=1e-12)
    # it falls from the horizontal: speed and height change energy into each other
    inertia = 1e-3 + 2.0 * 0.5**2
    kinetic = 0.5 * inertia * found["bob.angular_velocity.z"] ** 2
    np.testing.assert_allclose(kinetic, -2.0 * 9.81 * found["bob.position.y"], atol=1e-9)
    np.testing.assert_allclose(found["energy.kinetic"], kinetic, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(np.sin(found["swing"]) * 0.5, found["bob.position.y"], atol=1e-9)
    assert {"load.x", "load.y", "load.z", "drift.position"} < set(found)
    assert found.summary["steps"] == 1000
    assert found.summary["events"] == [] and found.summary["warnings"] == []


def test_a_simulation_goes_on_where_another_ended(tmp_path: Path) -> None:
    (tmp_path / "half").mkdir()
    whole = ffrf.simulate(scene(tmp_path, 1.0))
    half = ffrf.simulate(scene(tmp_path / "half", 0.5))
    rest = ffrf.simulate(scene(tmp_path, 1.0), state=pickle.loads(pickle.dumps(half)))
    file = tmp_path / "state.json"
    file.write_text(half.end_state)
    from_file = ffrf.simulate(scene(tmp_path, 1.0), state=file)
    for name in whole:
        np.testing.assert_array_equal(whole[name][50:], rest[name])
        np.testing.assert_array_equal(rest[name], from_file[name])


def test_a_flexible_scene_has_the_columns_of_its_modes(scenes: Path, models: Path) -> None:
    found = ffrf.simulate(scenes / "tumbling_rod.toml")
    modes = ffrf.load_model(models / "spin_up_beam.ffrf.json").mode_count
    assert {f"rod.modal_coordinates.{mode}" for mode in range(1, modes + 1)} < set(found)
    total = found["energy.kinetic"] + found["energy.elastic"]
    # linearly_implicit damps what it does not resolve, and nothing acts on the rod
    np.testing.assert_allclose(total, total[0], rtol=1e-3)


def test_what_is_wrong_with_a_scene_is_said_with_its_line(tmp_path: Path) -> None:
    path = scene(tmp_path, 1.0)
    path.write_text(path.read_text().replace('kind = "revolute"', 'kind = "revolving"'))
    with pytest.raises(ffrf.Error, match=r"(?s)pendulum.toml.*revolving"):
        ffrf.simulate(path)
    with pytest.raises(ffrf.Error, match="nowhere.toml"):
        ffrf.simulate(tmp_path / "nowhere.toml")
    with pytest.raises(ffrf.Error, match="saved state"):
        state = tmp_path / "state.json"
        state.write_text("{}")
        ffrf.simulate(scene(tmp_path, 1.0), state=state)
    with pytest.raises(ffrf.Error, match="none.json"):
        ffrf.simulate(scene(tmp_path, 1.0), state=tmp_path / "none.json")


def test_the_interpreter_runs_while_a_scene_is_simulated(tmp_path: Path) -> None:
    path = scene(tmp_path, 20.0)
    ticks = 0
    done = threading.Event()

    def work() -> None:
        ffrf.simulate(path)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    # an interpreter that is held would give the first turn when everything is over
    while not done.is_set():
        ticks += 1
        time.sleep(1e-3)
    thread.join()
    assert ticks > 3


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_a_simulation(tmp_path: Path) -> None:
    program = "import ffrf, sys; print('begun', flush=True); ffrf.simulate(sys.argv[1])"
    child = subprocess.Popen(
        [sys.executable, "-c", program, str(scene(tmp_path, 1e5))],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert child.stdout is not None and child.stdout.readline() == "begun\n"
    time.sleep(0.5)
    assert child.poll() is None, "it was to take long"
    child.send_signal(signal.SIGINT)
    _, said = child.communicate(timeout=20)
    assert "KeyboardInterrupt" in said
