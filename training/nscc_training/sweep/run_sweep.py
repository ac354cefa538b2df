"""A sweep from its grid to its table; points with stored results are not computed again."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, chdir, nullcontext, suppress
from pathlib import Path
from typing import NamedTuple

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.experiment_store import STORE, ExperimentStore
from nscc.files import Product, write_together
from nscc.program.problems import counted
from nscc_runtime.pool import processors
from nscc_runtime.progress import Progress, unseen
from nscc_training.command_settings import SweepSettings
from nscc_training.experiments.engine import Done, Executor, PointRow, keep, results, rows_in
from nscc_training.experiments.study_table import csv_of
from nscc_training.sweep.grid import Grid, of_parts
from nscc_training.sweep.kinds import KINDS, key_of
from nscc_training.sweep.point import OF_RUN, GridPoint, PointTask
from nscc_training.sweep.sweep_report import (
    Table,
    csv_text,
    diagram_of,
    parquet_bytes,
    report_html,
    table_of,
)
from nscc_training.sweep.work import FAILED, local_workers, scheduler_workers, serially

TABLE, PARQUET, REPORT, DIAGRAM = "table.csv", "table.parquet", "report.html", "diagram.png"
"""The files of a sweep: its table, the table for other programs, the report, and the diagram in
it."""
TIMES = "times.csv"
"""The file with the time of each point."""
POINTS = "points"
"""The folder of outputs, and the store's experiment that contains all rows."""
_MOST_REASONS = 5
"""Most reasons for missing results that are printed."""


class Swept(NamedTuple):
    """The outcome of a sweep.

    `table` has a row for each point. `misfits` is the number of points with a message of nscc in
    place of figures, `failed` the number of points that failed for another reason. `files` are
    those that were written."""

    table: Table
    misfits: int
    failed: int
    files: tuple[Path, ...]


def known(grid: Grid, out: Path, how: SweepSettings) -> tuple[int, int]:
    """Return the number of points of a grid, and how many have stored results in the folder `out`.
    Nothing is computed or created. Points with equal keys count each."""
    keys = _keys(grid, how.threads)
    if not out.is_dir():
        return len(keys), 0
    with store_in(out) as store:
        rows = rows_in(store)
    known_flags = (
        _is_known(rows.get(key), how, _output_path(out, p, key)) for p, key in keys.items()
    )
    return len(keys), sum(known_flags)


def work_text(count: int, todo: int) -> str:
    """Return a line on how many of `count` points have results and how many are to be computed."""
    return f"{counted(count, 'point')}: {count - todo} known, {todo} to compute"


def sweep(
    grid: Grid,
    out: Path,
    how: SweepSettings,
    *,
    grid_parts: Sequence[str] = (),
    parquet: bool = False,
    track: Progress = unseen,
    report: Callable[[str], None] = lambda _text: None,
) -> Swept:
    """Compute the missing points of a grid, or of the parts `grid_parts` of it, and write table,
    report and diagram to the folder `out`.

    Each result is stored at once, so that an interrupted sweep resumes, and two sweeps with the
    same `out` share the work. Paths in the grid, and in the files that it names, are relative to
    its folder. `parquet` writes the table as Parquet, too. `track` receives the results and may
    draw progress; `report` receives a text on the work to do. Raises Rejected: NS0834 for a damaged
    store in `out`, NS0835 if the scheduler does not answer, NS0836 if workers have other files or
    another version of nscc."""
    keys = _keys(grid, how.threads)
    points = of_parts(grid, grid_parts).points
    with store_in(out, report) as store:
        rows = rows_in(store)
        todo = {
            keys[point]: point
            for point in dict.fromkeys(points)
            if not _is_known(rows.get(keys[point]), how, _output_path(out, point, keys[point]))
        }
        count = len({keys[point] for point in points})
        report(work_text(count, len(todo)))
        store.forget(*(todo.keys() & rows.keys()))  # they failed before or lost their output
        tasks = [_task(point, keys, grid, out, how) for point in todo.values()]
        if tasks:
            _compute(tasks, keys, store, how, track)
        rows, times = rows_in(store), times_csv(store)
    # The table has all points with a row, also those of parts that this call left out.
    keys = {point: key for point, key in keys.items() if key in rows}
    point_rows = [(point, rows[key]) for point, key in keys.items()]
    grid = grid._replace(points=tuple(keys))
    table = table_of(grid, point_rows)
    diagram = diagram_of(grid, table)
    products: dict[Path, Product] = {out / TABLE: csv_text(table).encode()}
    if parquet:
        products[out / PARQUET] = parquet_bytes(table)
    if diagram is not None:
        products[out / DIAGRAM] = diagram
    products[out / REPORT] = report_html(grid, table, diagram).encode()
    write_together({**products, out / TIMES: times.encode()})
    _name(out, keys)
    codes = [row.code for _, row in point_rows if row.code]
    failed = codes.count(FAILED)
    return Swept(table, len(codes) - failed, failed, tuple(products))


def summary_lines(swept: Swept) -> list[str]:
    """Return the outcome of a sweep as lines: numbers of points, the `_MOST_REASONS` most frequent
    reasons for missing results, and the files that were written."""
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
    """Return the error (NS0833) that points of a sweep failed, with the first different reasons,
    for the caller to raise."""
    columns = swept.table.columns
    errors = [
        e for e, code in zip(columns["error"], columns["code"], strict=True) if code == FAILED
    ]
    return rejected(
        FAILED,
        f"{counted(swept.failed, 'point')} of {len(swept.table)} failed",
        notes=tuple(dict.fromkeys(errors))[:_MOST_REASONS],
        helps=("the same command with --again computes the failed points again",),
        status=1,
    )


def _keys(grid: Grid, threads: int) -> dict[GridPoint, str]:
    """Return the key of every point: a digest of all that its result depends on. The files that
    points name are found from the grid's folder."""
    with chdir(grid.folder):
        return {point: key_of(point, threads) for point in grid.points}


def _is_known(row: PointRow | None, how: SweepSettings, output_path: Path | None) -> bool:
    """Return whether a point has a stored result that need not be computed again.

    `row` is its stored row, None without one. `output_path` is where its output should be, None if
    it has none; a point with figures whose output is missing is computed again."""
    if row is None or (row.code == FAILED and how.again):
        return False
    return bool(row.code) or output_path is None or output_path.exists()


def _task(
    point: GridPoint, keys: Mapping[GridPoint, str], grid: Grid, out: Path, how: SweepSettings
) -> PointTask:
    """Return the task of a point: its values, the place of its output, and the outputs of the runs
    that it names.

    `keys` are the keys of all points, which name their outputs in the folder `out`."""
    key = keys[point]
    runs = {f"{OF_RUN}{run.name}": _output_path(out, run, keys[run]) for run in point.after}
    files = _output_path(out, point, key) or out.resolve() / POINTS / key
    return PointTask(point, key, grid.folder.resolve(), files, how.threads, runs)


def _output_path(out: Path, point: GridPoint, key: str) -> Path | None:
    """Return the path of the output of a point with this `key`, or None if points of its kind have
    no output."""
    ending = KINDS[point.kind].leaves
    # Sixteen hexadecimal digits tell points apart, and keep names short.
    return None if ending is None else out.resolve() / POINTS / (key[:16] + ending)


def _compute(
    tasks: Sequence[PointTask],
    keys: Mapping[GridPoint, str],
    store: ExperimentStore,
    how: SweepSettings,
    track: Progress,
) -> None:
    """Compute the tasks and store their results. Runs are computed before the points that name
    them.

    `keys` are the keys of all points. Raises Rejected (NS0836) if a worker runs other code than
    this process."""
    out = tasks[0].files.parent
    if any(KINDS[task.point.kind].leaves is not None for task in tasks):
        out.mkdir(exist_ok=True)
    with _executor(how, len(tasks)) as execute:

        def checked(tasks: Iterable[PointTask]) -> Iterator[Done]:
            """Compute `tasks` and yield their results. Raise Rejected (NS0836) if a worker runs
            other code than this process."""
            for done in execute(tasks):
                if done.other_key:
                    raise rejected(
                        "NS0836",
                        f"the worker {done.worker} has other code or data than the process that "
                        f"requested {done.task.label}",
                        notes=(
                            "its nscc, its Python or the files of the grid differ from those of "
                            "this process, or they changed during the sweep",
                        ),
                        helps=(
                            "install the same versions on all machines, and use a shared file "
                            "system",
                        ),
                        status=3,
                    )
                yield done

        def all_results() -> Iterator[Done]:
            """Yield the results of all tasks. Points that evaluate a training run wait for it; if
            it has no result, they get its error without being computed."""
            pending = {task.key: task for task in tasks}
            while pending:
                # Runs that a point names come first: one round per level of dependency.
                ready = [
                    task
                    for task in pending.values()
                    if not any(keys[run] in pending for run in task.point.after)
                ]
                without = {task.key: _without_run(task, keys, store) for task in ready}
                for done in filter(None, without.values()):
                    keep(store, done)
                    yield done
                able = [task for task in ready if without[task.key] is None]
                yield from results(store, able, checked)
                for task in ready:
                    del pending[task.key]

        for _ in track(all_results(), "computing points", len(tasks)):
            pass


def _without_run(
    task: PointTask, keys: Mapping[GridPoint, str], store: ExperimentStore
) -> Done | None:
    """Return a result with the error of a run, if `task` needs a run that has no result; else None.

    `keys` gives the key in `store` of each run."""
    for run in task.point.after:
        row = store.get(keys[run])
        assert row is not None  # runs are computed first
        if row["code"]:
            error = f"its run {run.name} has none: {row['error']}"
            return Done(task, PointRow(task.key, code=row["code"], error=error))
    return None


def _executor(how: SweepSettings, count: int) -> AbstractContextManager[Executor[PointTask]]:
    """Return the context in which points are computed, as the settings `how` say: by workers of a
    scheduler, by processes on this machine (at most `count`), or in this process."""
    if how.scheduler is not None:
        return scheduler_workers(how.scheduler)
    workers = processors() if how.workers is None else how.workers
    if workers:
        return local_workers(min(workers, count), how.threads)
    return nullcontext(serially)


def _name(out: Path, keys: Mapping[GridPoint, str]) -> None:
    """Make links to the outputs of the grid's points, named after the points, in the folder of
    their kind below `out`, and remove links to other outputs. Of points with one name, later ones
    have a part of their key added.

    Other processes may do the same at the same time."""
    links: dict[Path, str] = {}
    for point, key in keys.items():
        output_path = _output_path(out, point, key)
        if output_path is None or not output_path.exists():
            continue
        link = out / KINDS[point.kind].folder / (point.name + output_path.suffix)
        if link in links:
            link = link.with_name(f"{link.stem}_{key[:8]}{output_path.suffix}")
        link.parent.mkdir(parents=True, exist_ok=True)
        links[link] = os.path.relpath(output_path, link.parent.resolve())
    for name in filter(None, {kind.folder for kind in KINDS.values()}):
        for old in [path for path in (out / name).rglob("*") if path.is_symlink()]:
            with suppress(FileNotFoundError):  # another process removed it
                if links.get(old) != os.readlink(old):
                    old.unlink()
    for link, target in links.items():
        with suppress(FileExistsError):
            os.symlink(target, link)


def store_in(folder: Path, report: Callable[[str], object] = lambda _text: None) -> ExperimentStore:
    """Open the store of a sweep's results in `folder`, created if needed. `report` receives a text
    if another process holds it locked."""
    return ExperimentStore(folder / STORE, POINTS, report)


def times_csv(store: ExperimentStore) -> str:
    """Return the seconds, the end and the worker of each computed point in `store` as CSV. The
    columns are key (12 digits), name, seconds, ended_s and worker. The end is in seconds after the
    first point began."""
    timings = store.timings()
    begin = min((timing.ended - timing.seconds for timing in timings), default=0.0)
    rows = (
        (
            timing.name[:12],
            timing.label,
            f"{timing.seconds:.3f}",
            f"{timing.ended - begin:.3f}",
            timing.worker,
        )
        for timing in timings
    )
    return csv_of(("key", "name", "seconds", "ended_s", "worker"), rows)
