"""Computing the points of a sweep: in this process, in processes here, or by a Dask scheduler."""

from __future__ import annotations

import logging
import os
import socket
import warnings
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import chdir, contextmanager
from itertools import islice
from multiprocessing import resource_tracker
from signal import SIG_BLOCK, SIG_SETMASK, SIGINT, pthread_sigmask
from threading import Lock
from time import perf_counter
from typing import TYPE_CHECKING

from nscc.diagnostics.diagnostic import Rejected, Severity, rejected
from nscc_training.experiments.engine import Done, Executor, PointRow
from nscc_training.problems import one_line
from nscc_training.sweep.kinds import KINDS, key_of
from nscc_training.sweep.point import PointTask

if TYPE_CHECKING:
    from distributed import Client, Future

FAILED = "NS0833"
"""The code of a point that failed for reasons other than its values."""


_ONE = Lock()
"""Makes a worker with several threads compute one point at a time.

The current folder, warnings and torch's thread count are shared by the process."""


def serially(tasks: Iterable[PointTask]) -> Iterator[Done]:
    """Compute all tasks in this process, one after the other, and yield their results. A task that
    fails unexpectedly is tried once more."""
    for task in tasks:
        result = work(task)
        yield work(task) if result.failed else result


def work(task: PointTask) -> Done:
    """Compute a task and return its result. Errors become part of its row, except for a missing
    package, which is raised as ModuleNotFoundError.

    If this process computes another key for the point, its code or data differ: nothing is
    computed, and the result has `other_key`."""
    with _ONE, chdir(task.folder), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # errors of the compiler and of scenes for this point
        current_key = key_of(task.point, task.threads)
        begin = perf_counter()
        if current_key != task.key:
            return Done(task, PointRow(task.key), 0.0, _worker(), other_key=current_key)
        row, failed = _row(task)
    return Done(task, row, perf_counter() - begin, _worker(), failed)


def failure(task: PointTask, why: str) -> PointRow:
    """Return the row of a point that failed, with the reason `why` in one line."""
    return PointRow(task.key, code=FAILED, error=_anywhere(one_line(why, 400), task))


def _row(task: PointTask) -> tuple[PointRow, bool]:
    """Compute a point and return its row, and whether it failed unexpectedly.

    An error of nscc becomes a row with its code (of several errors the first that is proved, else
    the first), and did not fail; any other exception becomes a row, too, so that the sweep goes on.
    Only a missing package is raised (ModuleNotFoundError)."""
    kind = KINDS[task.point.kind]
    values = {
        name: str(task.runs[value]) if isinstance(value, str) and value in task.runs else value
        for name, value in task.point.values.items()
    }
    try:
        figures = kind.compute(values, task)
    except Rejected as rejected:
        errors = [d for d in rejected.diagnostics if d.severity is Severity.ERROR]
        first = next((d for d in errors if d.data.get("proved")), errors[0])
        return PointRow(task.key, code=first.code, error=_anywhere(first.message, task)), False
    except ModuleNotFoundError:
        raise
    except Exception as error:  # no exception of one point may stop the others
        return failure(task, f"{type(error).__name__}: {error}"), True
    return PointRow(task.key, figures), False


def _anywhere(text: str, task: PointTask) -> str:
    """Return a message without the paths of this machine's folders, so that all machines give the
    same rows."""
    for folder in (task.files.parents[1], task.folder):
        text = text.replace(f"{folder}{os.sep}", "")
    return text


def _worker() -> str:
    """Return the name of this process: machine and number."""
    return f"{socket.gethostname()}:{os.getpid()}"


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
        reason = one_line(error)
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
