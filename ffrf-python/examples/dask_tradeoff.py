"""Spread a trade-off over a Dask cluster.

    pip install "./ffrf-python[dask]"
    python ffrf-python/examples/dask_tradeoff.py models/scenes/tumbling_rod.toml sweep --modes 0 2 4 --workers 2
    python ffrf-python/examples/dask_tradeoff.py SCENE FOLDER --scheduler tcp://head:8786

Every worker needs the package and the files of the scene under the same names, on a shared file system for example; other files
under these names are refused. What is done is in the folder, in the form of ``ffrf tradeoff``: a sweep that was interrupted, by
the death of this program too, goes on where it was, here or with the command.
"""

from __future__ import annotations

import argparse
import pickle
from collections.abc import Sequence
from pathlib import Path

import ffrf
from distributed import Client, LocalCluster, as_completed


def spread(
    client: Client, sweep: ffrf.Sweep, configurations: Sequence[ffrf.Configuration]
) -> list[ffrf.Outcome]:
    """Run on the cluster what the folder of the sweep does not hold yet, and keep outcomes as soon as they are there.

    A worker that dies takes only its runs in flight with it: the scheduler gives them to others, and so it does with the study,
    which is the result of a task and no data scattered once. Workers import nothing but the package.
    """
    # the costliest first, so that no worker waits at the end for one that came late
    missing = sorted(sweep.missing(configurations), key=lambda one: -one.expected_effort)
    # read once by each worker, and shared by its runs
    study = client.submit(pickle.loads, pickle.dumps(sweep.study), pure=False)
    runs = [client.submit(ffrf.Study.run, study, one, pure=False) for one in missing]
    for batch in as_completed(runs).batches():
        sweep.keep(*(done.result() for done in batch))
        for done in batch:
            # the cluster need not remember it
            done.release()
    outcomes = sweep.outcomes(configurations)
    sweep.write(outcomes)
    return outcomes


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("scene", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scheduler", help="address of a running scheduler; without it, workers of this machine")
    parser.add_argument("--workers", type=int, help="processes of this machine (default: one for each core)")
    parser.add_argument("--modes", type=int, nargs="+")
    parser.add_argument("--fidelity", nargs="+")
    parser.add_argument("--scalar", nargs="+")
    parser.add_argument("--integrator", nargs="+")
    parser.add_argument("--step", type=float, nargs="+")
    parser.add_argument("--quantity", nargs="+", default=[])
    given = parser.parse_args()
    # workers of other machines have other folders at work
    scene = given.scene.resolve()
    sweep = ffrf.Sweep(scene, given.folder, quantity=given.quantity)
    configurations = sweep.study.configurations(
        modes=given.modes,
        fidelity=given.fidelity,
        scalar=given.scalar,
        integrator=given.integrator,
        step=given.step,
    )
    cluster = given.scheduler or LocalCluster(n_workers=given.workers, threads_per_worker=1, processes=True)
    with Client(cluster) as client:
        outcomes = spread(client, sweep, configurations)
    failed = sum(outcome.failure is not None for outcome in outcomes)
    print(f"{len(outcomes)} runs, {failed} failed; written: {given.folder / 'report.html'}")


if __name__ == "__main__":
    main()
