"""A sweep from its grid to its table: what is known is not computed again."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, chdir, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from time import sleep

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc.experiment_store import ExperimentStore
from nscc.files import Product, write_together
from nscc.program.problems import counted
from nscc_runtime.progress import Progress, unseen
from nscc_training.sweep.grid import Grid, of_parts
from nscc_training.sweep.kinds import KINDS, key_of
from nscc_training.sweep.point import OF_RUN, Point, Row
from nscc_training.sweep.store import POINTS, TIMES, put_row, rows_in, store_in, times_csv
from nscc_training.sweep.table import Table, csv_text, parquet_bytes, table_of
from nscc_training.sweep.work import FAILED, Done, Task, serially

TABLE, PARQUET, REPORT, DIAGRAM = "table.csv", "table.parquet", "report.html", "diagram.png"
_POINTS = "points"
_MOST_REASONS = 5
_POLL_S = 0.2
_NAMED = {"train": "runs", "evaluate": "results", "design": "programs"}
"""Folders in which what points leave has their names."""


@dataclass(frozen=True)
class How:
    """Where points are computed.

    `workers` processes of `threads` each on this machine, 0: in this process; or those of a
    `scheduler`. `again` computes points that failed before.
    """

    workers: int = 0
    threads: int = 1
    scheduler: str | None = None
    again: bool = False


@dataclass(frozen=True)
class Swept:
    """A sweep that is done: its table, how many of its points have a message instead of figures
    (`misfits`), and `failed`; the files that were written."""

    table: Table
    misfits: int
    failed: int
    files: tuple[Path, ...]


def known(grid: Grid, out: Path, how: How) -> tuple[int, int]:
    """How many points a grid has, and how many of them are known; nothing is computed."""
    keys = _keys(grid, how.threads)
    if not out.is_dir():
        return len(keys), 0
    with store_in(out) as store:
        rows = rows_in(store)
    found = (_is_known(rows.get(key), how, _left(out, p, key)) for p, key in keys.items())
    return len(keys), sum(found)


def sweep(
    grid: Grid, out: Path, how: How, *, parts: Sequence[str] = (), parquet: bool = False,
    track: Progress = unseen, report: Callable[[str], None] = lambda _text: None,
) -> Swept:  # fmt: skip
    """Compute what is not known of a grid, or of `parts` of it, and write table, report and diagram
    of all that is known into `out`.

    Rows are kept as they are found: killed and started again it goes on, and two sweeps with one
    `out` share the work. Paths in the grid, and in what it names, are relative to its folder.
    `track` draws progress, `report` is told what there is to do. Raises Rejected: NS0834 for a
    damaged store in `out`, NS0835 without the scheduler, NS0836 where workers have other files or
    another nscc.
    """
    keys = _keys(grid, how.threads)
    wanted = of_parts(grid, parts).points
    with store_in(out) as store:
        rows = rows_in(store)
        todo = {
            keys[point]: point
            for point in dict.fromkeys(wanted)
            if not _is_known(rows.get(keys[point]), how, _left(out, point, keys[point]))
        }
        count = len({keys[point] for point in wanted})
        report(f"{count} points: {count - len(todo)} known, {len(todo)} to compute")
        for key in todo.keys() & rows.keys():  # failed before, or lost what they left
            store.forget(POINTS, key)
        tasks = [_task(point, keys, grid, out, how) for point in todo.values()]
        if tasks:
            _compute(tasks, keys, store, how, track)
        rows, times = rows_in(store), times_csv(store)
    keys = {point: key for point, key in keys.items() if key in rows}
    found = [(point, rows[key]) for point, key in keys.items()]
    grid = replace(grid, points=tuple(keys))
    table = table_of(grid, found)
    files = _write(grid, table, out, times, parquet=parquet)
    _name(out, keys)
    codes = [row.code for _, row in found if row.code]
    failed = codes.count(FAILED)
    return Swept(table, len(codes) - failed, failed, files)


def told(swept: Swept) -> list[str]:
    """What came of a sweep, in lines: how many points, why some have no figures, the files."""
    columns, count = swept.table.columns, len(swept.table)
    figures = count - swept.misfits - swept.failed
    lines = [
        f"{counted(count, 'point')}: {figures} with figures, {swept.misfits} with a message "
        f"instead, {swept.failed} failed"
    ]
    reasons = Counter(zip(columns["code"], columns["error"], strict=True))
    del reasons[None, None]
    for (code, error), times in reasons.most_common(_MOST_REASONS):
        lines.append(f"  {times} x {code}: {error}")
    if len(reasons) > _MOST_REASONS:
        lines.append(f"  and {counted(len(reasons) - _MOST_REASONS, 'other message')}")
    return [*lines, "wrote " + ", ".join(path.as_posix() for path in swept.files)]


def failures(swept: Swept) -> Rejected:
    """NS0833 for the points that failed."""
    columns = swept.table.columns
    errors = [
        e for e, code in zip(columns["error"], columns["code"], strict=True) if code == FAILED
    ]
    return rejected(
        FAILED,
        f"{counted(swept.failed, 'point')} of {len(swept.table)} failed",
        notes=tuple(dict.fromkeys(errors))[:_MOST_REASONS],
        helps=("the same command with --again computes them again",),
        status=1,
    )


def _keys(grid: Grid, threads: int) -> dict[Point, str]:
    """The key of every point; those of one key count once."""
    with chdir(grid.folder):
        return {point: key_of(point, threads) for point in grid.points}


def _is_known(row: Row | None, how: How, left: Path | None) -> bool:
    """Whether a point has a row, and what it `left` is still there."""
    if row is None or (row.code == FAILED and how.again):
        return False
    return bool(row.code) or left is None or left.exists()


def _task(point: Point, keys: Mapping[Point, str], grid: Grid, out: Path, how: How) -> Task:
    key = keys[point]
    runs = {f"{OF_RUN}{run.name}": _left(out, run, keys[run]) for run in point.after}
    files = _left(out, point, key) or out.resolve() / _POINTS / key
    return Task(point, key, grid.folder.resolve(), files, how.threads, runs)


def _left(out: Path, point: Point, key: str) -> Path | None:
    """The file or folder that a point leaves; None where its kind leaves none."""
    ending = KINDS[point.kind].leaves
    return None if ending is None else out.resolve() / _POINTS / (key[:16] + ending)


def _compute(
    tasks: Sequence[Task], keys: Mapping[Point, str], store: ExperimentStore, how: How,
    track: Progress,
) -> None:  # fmt: skip
    """Compute the tasks, those first whose runs others name."""
    out = tasks[0].files.parent
    if any(KINDS[task.point.kind].leaves is not None for task in tasks):
        out.mkdir(exist_ok=True)
    with _executor(how, len(tasks)) as execute:

        def every() -> Iterator[Done]:
            pending = {task.key: task for task in tasks}
            while pending:
                # What the point names is computed before: one round for each step of the way.
                ready = [
                    task for task in pending.values()
                    if not any(keys[run] in pending for run in task.point.after)
                ]  # fmt: skip
                able = []
                for task in ready:
                    without = _without_run(task, keys, store)
                    able += [] if without else [task]
                    yield from [without] if without else []
                yield from _shared(store, able, execute)
                for task in ready:
                    del pending[task.key]

        for done in track(every(), "computing points", len(tasks)):
            if done.other_key:
                raise _differs(done)
            put_row(store, done.row, done.task.point.name, done.seconds, done.worker)


def _shared(
    store: ExperimentStore, tasks: Sequence[Task], execute: Callable[..., Iterator[Done]]
) -> Iterator[Done]:
    """Yield what comes of tasks; those that another process computes are waited for.

    A task whose process ended without a result is taken over.
    """
    left = [*tasks]
    while left:
        taken: list[Task] = []

        def claimed(taken: list[Task] = taken, left: Sequence[Task] = left) -> Iterator[Task]:
            for task in left:
                if store.claim(POINTS, task.key):
                    taken.append(task)
                    if store.get(POINTS, task.key) is None:
                        yield task

        for done in execute(claimed()):
            yield done
            store.release(POINTS, done.task.key)
        for task in taken:
            store.release(POINTS, task.key)
        mine = {task.key for task in taken}
        others = (task for task in left if task.key not in mine)
        left = [task for task in others if store.get(POINTS, task.key) is None]
        if left:
            sleep(_POLL_S)


def _without_run(task: Task, keys: Mapping[Point, str], store: ExperimentStore) -> Done | None:
    """What comes of a task if a run that it names came to nothing; None where there are all."""
    for run in task.point.after:
        row = store.get(POINTS, keys[run])
        assert row is not None  # runs are computed first
        if row["code"]:
            error = f"its run {run.name} has none: {row['error']}"
            return Done(task, Row(task.key, code=row["code"], error=error), 0.0, "")
    return None


def _executor(how: How, count: int) -> AbstractContextManager[Callable[..., Iterator[Done]]]:
    if how.scheduler is not None:
        from nscc_training.sweep.cluster import at

        return at(how.scheduler)
    if how.workers:
        from nscc_training.sweep.cluster import here

        return here(min(how.workers, count), how.threads)
    return nullcontext(serially)


def _differs(done: Done) -> Rejected:
    return rejected(
        "NS0836",
        f"the worker {done.worker} would compute another point than {done.task.point.name}",
        notes=(
            "its nscc, its Python or the files that the grid names are not those of this process, "
            "or they changed after the sweep began",
        ),
        helps=("install the same versions everywhere, on a file system that all share",),
        status=3,
    )


def _write(grid: Grid, table: Table, out: Path, times: str, *, parquet: bool) -> tuple[Path, ...]:
    """The products, all or none."""
    from nscc_training.sweep.report import diagram_of, report_html

    diagram = diagram_of(grid, table)
    products: dict[Path, Product] = {out / TABLE: csv_text(table).encode()}
    if parquet:
        products[out / PARQUET] = parquet_bytes(table)
    if diagram is not None:
        products[out / DIAGRAM] = diagram
    products[out / REPORT] = report_html(grid, table, diagram).encode()
    write_together({**products, out / TIMES: times.encode()})
    return tuple(products)


def _name(out: Path, keys: Mapping[Point, str]) -> None:
    """Links to what the grid's points left, by their names; those of another grid go."""
    for name in _NAMED.values():
        for old in [path for path in (out / name).rglob("*") if path.is_symlink()]:
            old.unlink()
    taken: set[Path] = set()
    for point, key in keys.items():
        left = _left(out, point, key)
        if left is None or not left.exists():
            continue
        link = out / _NAMED[point.kind] / (point.name + left.suffix)
        if link in taken:
            link = link.with_name(f"{link.stem}_{key[:8]}{left.suffix}")
        taken.add(link)
        link.parent.mkdir(parents=True, exist_ok=True)
        os.symlink(os.path.relpath(left, link.parent.resolve()), link)
