"""The example that spreads a trade-off over a Dask cluster: processes of this machine, one of which is killed."""

from __future__ import annotations

import importlib.util
import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import ffrf
from distributed import Client, LocalCluster

EXAMPLE = Path(__file__).resolve().parents[1] / "examples" / "dask_tradeoff.py"


def without_time(outcome: ffrf.Outcome) -> object:
    """The numbers of an outcome but the time that it took."""
    numbers = json.loads(outcome.to_json())
    numbers["finding"].get("finished", {}).pop("time", None)
    return numbers


def grid(study: ffrf.Study) -> list[ffrf.Configuration]:
    """Runs of some tenths of a second each, and a few that fail."""
    return study.configurations(
        modes=[2, 4],
        fidelity=["linear", "full"],
        scalar=["f64", "f32"],
        integrator=["linearly_implicit", "rk4"],
        step=[1e-1, 2e-3, 1e-3],
    )


def spread() -> Any:
    """The function of the example, as one imports it here; workers do not have it."""
    spec = importlib.util.spec_from_file_location("dask_tradeoff", EXAMPLE)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.spread


def test_a_killed_worker_loses_nothing(scenes: Path, tmp_path: Path) -> None:
    spread_over = spread()
    scene = scenes / "tumbling_rod.toml"
    question = {"quantity": ["tip", "energy"], "reference_tolerance": 1e-8}
    sweep = ffrf.Sweep(scene, tmp_path / "cluster", **question)  # type: ignore[arg-type]
    configurations = grid(sweep.study)
    with LocalCluster(
        n_workers=3, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, Client(cluster) as client:
        before = client.run(os.getpid)
        assert len(set(before.values()) | {os.getpid()}) == 4, "three processes besides this one"
        found: list[ffrf.Outcome] = []
        work = threading.Thread(target=lambda: found.extend(spread_over(client, sweep, configurations)))
        work.start()
        done = 0
        while done < 4:
            assert work.is_alive(), "the sweep was over before a worker could be killed"
            time.sleep(0.01)
            done = len(configurations) - len(sweep.missing(configurations))
        busy = [worker for worker, tasks in client.processing().items() if tasks]
        assert busy, "nobody was at work"
        os.kill(before[busy[0]], signal.SIGKILL)
        left = len(sweep.missing(configurations))
        assert left > 3, "it was killed in the middle"
        work.join(timeout=300)
        assert not work.is_alive()
        after = client.run(os.getpid)
        assert before[busy[0]] not in after.values()
    assert [outcome.configuration for outcome in found] == configurations
    assert any(outcome.failure for outcome in found) and any(outcome.failure is None for outcome in found)
    # one process, all by itself
    alone = ffrf.Sweep(scene, tmp_path / "alone", **question)  # type: ignore[arg-type]
    single = alone.run(configurations, threads=1)
    assert [without_time(outcome) for outcome in found] == [without_time(outcome) for outcome in single]
    assert (tmp_path / "cluster" / "report.html").exists()
    # the folder is one of the command: nothing is left to run in it
    assert sweep.run(configurations) == found


def test_the_example_runs_by_itself_and_goes_on(scenes: Path, tmp_path: Path) -> None:
    words = [str(scenes / "tumbling_rod.toml"), str(tmp_path / "sweep"), "--modes", "1", "--fidelity", "full"]
    words += ["--scalar", "f64", "--step", "1e-1", "--quantity", "tip", "--workers", "2"]
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, str(EXAMPLE), *words], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        # rk4 among the usual integrators is not stable with this step
        assert done.stdout.startswith("3 runs, 1 failed"), done.stdout
    files = (tmp_path / "sweep" / "runs").iterdir()
    assert sum(len(file.read_text().splitlines()) for file in files) == 3
