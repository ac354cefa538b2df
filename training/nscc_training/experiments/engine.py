"""The engine of all experiments: it computes the tasks that have no stored row, and stores rows."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from time import sleep
from typing import Any, Protocol, TypeVar

from nscc.experiment_store import ExperimentStore

_POLL_S = 0.2
"""Seconds between two looks at the store while another process computes."""

Figures = dict[str, Any]
"""Results by name: text, numbers, true, false or None. A name ends in the unit."""


class Task(Protocol):
    """A point that a worker measures: `key` identifies its result in the store, `label` is its name
    in messages."""

    @property
    def key(self) -> str: ...

    @property
    def label(self) -> str: ...


SomeTask = TypeVar("SomeTask", bound=Task)


@dataclass(frozen=True)
class PointRow:
    """The stored result of the task with this `key`. `figures` are its results by name; if there
    are none, `code` and `error` are those of a message."""

    key: str
    figures: Figures = field(default_factory=dict, hash=False)
    code: str = ""
    error: str = ""


@dataclass(frozen=True)
class Done:
    """The row of a task that was just computed, with the `seconds` it took and the name of the
    worker that computed it.

    If it `failed`, the row says why, and the task may be tried again. `other_key` is the key that
    the worker computed for the task, if it differs: its version or data are different."""

    task: Any
    row: PointRow
    seconds: float = 0.0
    worker: str = ""
    failed: bool = False
    other_key: str = ""


Executor = Callable[[Iterable[SomeTask]], Iterator[Done]]
"""A function that computes tasks and yields their rows in any order."""


def rows_in(store: ExperimentStore) -> dict[str, PointRow]:
    """Return all stored rows by the key of their task. Infinity and NaN, which the store keeps as
    text, are numbers again."""
    return {
        key: PointRow(key, **{**row, "figures": _numbers(row["figures"])})
        for key, row in store.values().items()
    }


def keep(store: ExperimentStore, done: Done) -> None:
    """Store the row of a task under its key, with label, time and worker. JSON has no infinity and
    no NaN, so that they become text."""
    row = done.row
    figures = {name: _text(value) for name, value in row.figures.items()}
    value = {"figures": figures, "code": row.code, "error": row.error}
    store.keep(row.key, value, label=done.task.label, seconds=done.seconds, worker=done.worker)


def results(
    store: ExperimentStore, tasks: Sequence[SomeTask], execute: Executor[SomeTask]
) -> Iterator[Done]:
    """Compute and store the tasks that have no row in the store, and yield their rows, as they are
    done. Tasks with a row are not yielded.

    `execute` computes tasks. Several processes may share a store: a task that another process has
    claimed is waited for, and computed here if that process drops it."""
    waiting = [task for task in tasks if store.get(task.key) is None]
    while waiting:
        claimed_tasks: list[SomeTask] = []

        def claimed(
            claimed_tasks: list[SomeTask] = claimed_tasks, waiting: Sequence[SomeTask] = waiting
        ) -> Iterator[SomeTask]:
            """Claim and yield the tasks that no other process computes, and that have no row yet.
            All claimed tasks are added to `claimed_tasks`.

            The arguments are defaults so that they keep the values of this turn of the loop."""
            for task in waiting:
                if store.claim(task.key):
                    claimed_tasks.append(task)
                    if store.get(task.key) is None:
                        yield task

        try:
            for done in execute(claimed()):
                keep(store, done)
                store.release(done.task.key)
                yield done
        finally:
            for task in claimed_tasks:
                store.release(task.key)
        claimed_keys = {task.key for task in claimed_tasks}
        unclaimed = (task for task in waiting if task.key not in claimed_keys)
        waiting = [task for task in unclaimed if store.get(task.key) is None]
        if waiting:
            sleep(_POLL_S)


def _text(value: Any) -> Any:
    """Return a float that JSON does not know as text ("inf", "-inf", "nan"), other values
    unchanged."""
    if isinstance(value, float) and not math.isfinite(value):
        return "nan" if math.isnan(value) else "inf" if value > 0 else "-inf"
    return value


def _numbers(figures: Figures) -> Figures:
    """Return figures in which the texts "inf", "-inf" and "nan", as `_text` writes them, are
    numbers again."""
    numbers = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}
    return {n: numbers.get(v, v) if isinstance(v, str) else v for n, v in figures.items()}
