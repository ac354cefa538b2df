"""Parallel computation of points by Dask workers, on this machine or of a scheduler."""

from __future__ import annotations

import logging
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from itertools import islice
from multiprocessing import resource_tracker
from signal import SIG_BLOCK, SIG_SETMASK, SIGINT, pthread_sigmask
from typing import TYPE_CHECKING

from nscc.diagnostics.diagnostic import rejected
from nscc_training.experiments.engine import Done, Executor
from nscc_training.sweep.point import PointTask
from nscc_training.sweep.work import failure, work

if TYPE_CHECKING:
    from distributed import Client, Future

_TRIES = 2
"""How often a point is tried whose worker ended."""
_POOLS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS")
"""Environment variables for the number of threads of libraries; they are read at import."""
_PATIENCE_S = 10
"""Seconds in which a scheduler must answer."""
_AHEAD = 2
"""Number of points per worker that are submitted in advance."""


@contextmanager
def local_workers(workers: int, threads: int) -> Iterator[Executor[PointTask]]:
    """Start `workers` processes with `threads` threads each on this machine, until the block ends.
    Yield the function that executes tasks on them."""
    import dask
    from distributed import Client, LocalCluster

    settings = {
        "distributed.nanny.pre-spawn-environ": dict.fromkeys(_POOLS, threads),
        # A worker that dies loses one point, which is tried once more.
        "distributed.scheduler.worker-saturation": 1.0,
        "distributed.scheduler.allowed-failures": 0,
        # Compiling holds the interpreter for longer than a worker may be silent by default.
        "distributed.worker.profile.enabled": False,
        "distributed.admin.tick.limit": "1h",
    }
    with dask.config.set(settings):
        # A terminal interrupts workers too: they ignore it, and the main thread ends them.
        # Starting Python's resource tracker unblocks interrupts, so it is started before.
        resource_tracker.ensure_running()
        before = pthread_sigmask(SIG_BLOCK, {SIGINT})
        try:
            cluster = LocalCluster(
                n_workers=workers,
                threads_per_worker=1,
                processes=True,
                dashboard_address=None,
                silence_logs=logging.CRITICAL,
            )
        finally:
            pthread_sigmask(SIG_SETMASK, before)
    with dask.config.set(settings), cluster, Client(cluster) as client:
        yield lambda tasks: _computed(client, tasks)


@contextmanager
def scheduler_workers(scheduler: str) -> Iterator[Executor[PointTask]]:
    """Yield the function that executes tasks on the workers of the Dask scheduler at the address
    `scheduler`. Raise Rejected (NS0835) if it does not answer."""
    from distributed import Client

    try:
        client = Client(scheduler, timeout=_PATIENCE_S)
    except (OSError, ValueError, TimeoutError) as error:
        reason = " ".join(str(error).split())[:200]
        raise rejected(
            "NS0835",
            f"the scheduler at '{scheduler[:100]}' does not answer",
            notes=(reason,) if reason else (),
            helps=("`dask scheduler` prints its address, tcp://HOST:PORT",),
        ) from None
    with client:
        yield lambda tasks: _computed(client, tasks)


def _computed(client: Client, tasks: Iterable[PointTask]) -> Iterator[Done]:
    """Yield the results of tasks, in the order in which the workers of `client` finish them. A task
    whose worker ended is tried once more; after that its result is a failed row."""
    from distributed import as_completed

    tries: Counter[str] = Counter()
    running: dict[Future, PointTask] = {}

    def start(task: PointTask) -> Future:
        """Submit a task to a worker and return its future. Each try has a name of its own, because
        Dask would otherwise return the earlier failure."""
        tries[task.key] += 1
        name = f"point-{task.key}-{tries[task.key]}"
        future = client.submit(work, task, key=name, pure=False)
        running[future] = task
        return future

    # Submit few points at a time: other sweeps may claim points that have not begun.
    waiting = iter(tasks)
    at_once = _AHEAD * max(1, len(client.scheduler_info(n_workers=-1)["workers"]))
    queue = as_completed([start(task) for task in islice(waiting, at_once)], loop=client.loop)
    for future in queue:
        task = running.pop(future)
        finished = _finished(future, task)
        future.release()
        if finished.failed and tries[task.key] < _TRIES:
            queue.add(start(task))
        else:
            yield finished
            for following in islice(waiting, 1):
                queue.add(start(following))


def _finished(future: Future, task: PointTask) -> Done:
    """Return the result of a task from its finished `future`, or a failed row if its worker ended.
    Raise ModuleNotFoundError if a package is missing, because all tasks would fail for this reason.
    """
    if future.status == "finished":
        result: Done = future.result()
        return result
    error = future.exception()
    if isinstance(error, ModuleNotFoundError):
        raise error
    why = f"its worker ended while it was computed ({type(error).__name__})"
    return Done(task, failure(task, why), failed=True)
