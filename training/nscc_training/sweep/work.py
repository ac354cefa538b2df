"""Computation of points in this process."""

from __future__ import annotations

import os
import socket
import warnings
from collections.abc import Iterable, Iterator
from contextlib import chdir
from threading import Lock
from time import perf_counter

from nscc.diagnostics.diagnostic import Rejected, Severity
from nscc_training.experiments.engine import Done, PointRow
from nscc_training.sweep.kinds import KINDS, key_of
from nscc_training.sweep.point import PointTask

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
    return PointRow(task.key, code=FAILED, error=_anywhere(" ".join(why.split())[:400], task))


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
