"""Studies: points whose time is measured, a table and a diagram.

Each repeat of a study measures all points in turn, so that disturbances of the machine are spread
over all of them."""

from __future__ import annotations

import platform
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

from nscc.diagnostics.diagnostic import Rejected
from nscc.experiment_store import ExperimentStore
from nscc.requirements import line_for
from nscc_runtime.pictures.precision import Point
from nscc_runtime.progress import Progress, unseen
from nscc_training.experiments.engine import Done, Figures, PointRow, results, rows_in
from nscc_training.experiments.study_table import Refused

if TYPE_CHECKING:
    from matplotlib.figure import Figure


_CPUINFO = Path("/proc/cpuinfo")
"""Where Linux describes the processor."""


def processor_name() -> str:
    """Return the name of this machine's processor; its architecture if the system does not tell the
    name."""
    try:
        lines = _CPUINFO.read_text(errors="replace").splitlines()
    except OSError:
        lines = []
    for line in lines:
        name, _, value = line.partition(":")
        if name.strip() == "model name" and value.strip():
            return " ".join(value.split())
    return platform.processor() or platform.machine() or "unknown processor"


T = TypeVar("T")

SHORT_MS = 500.0
"""First runs shorter than this are repeated, because they may mainly consist of filling caches."""


class Stopwatch:
    """A stopwatch that leaves out first runs, in which code is compiled and data is loaded.

    Runs of one `kind`, such as one method on data of one shape, share this overhead. `setting`
    distinguishes the runs of a kind. `clock` returns seconds; tests replace it."""

    def __init__(self, clock: Callable[[], float] = perf_counter) -> None:
        """Begin with nothing loaded."""
        self._clock = clock
        self._seen: set[Hashable] = set()

    def ran(self, kind: Hashable, *settings: Hashable) -> None:
        """Record that a kind and these settings of it have already run, so that `ms` does not run
        them twice."""
        self._seen.update((kind, *((kind, setting) for setting in settings)))

    def ms(
        self,
        kind: Hashable,
        setting: Hashable,
        run: Callable[[], T],
        first: Callable[[], Any] | None = None,
    ) -> tuple[T, float]:
        """Call `run` and return its result and its time in milliseconds.

        Before the first run of a `kind`, `first` is called (None: `run`), and its time is dropped.
        If the first run of a `setting` takes less than `SHORT_MS`, it is repeated, and the second
        result counts. So a long run is repeated at most once for its kind, and not at all if
        `first` is shorter."""
        if kind not in self._seen:
            if first is None:
                run()
                self.ran(kind, setting)
            else:
                first()
                self.ran(kind)
        result, taken_ms = timed_ms(run, self._clock)
        if (kind, setting) not in self._seen:
            self.ran(kind, setting)
            if taken_ms < SHORT_MS:
                result, taken_ms = timed_ms(run, self._clock)
        return result, taken_ms


def timed_ms(run: Callable[[], T], clock: Callable[[], float] = perf_counter) -> tuple[T, float]:
    """Call `run` once and return its result and its time in milliseconds. `clock` returns
    seconds."""
    begin = clock()
    result = run()
    return result, (clock() - begin) * 1e3


DOES_NOT_FIT = ("NS04", "NS05", "NS06")
"""Codes of programs that do not fit a chip, by their first characters."""
_NO_CODE = "-"
"""Code of the row of a setting that is refused without a message of its own."""
_MORE_IS_BETTER = ("psnr_db", "ssim")


class NotMeasured(Exception):
    """Raised by `StudyPoint.run` if a setting cannot be measured. The text is the reason, which the
    table shows."""


@dataclass(frozen=True, eq=False)
class StudyPoint:
    """One method at one setting on one case.

    Attributes
    ----------
    case, method, setting : str
        The names in the table. Together they are unique in a study.
    run : callable
        Runs what is timed. Without `figures` it returns the figures itself, with their time `ms`,
        and is run once.
    figures : callable, optional
        Returns the figures of the first result of `run`. A figure is an error, named by its unit
        ("words_per_frame", "psnr_db"). Some names have a meaning: `ms` is a time in milliseconds,
        or a list of times, that replaces the measured time; `bound` is a lower bound of the error
        for all settings of the method; `method` and `setting` replace the names.
    first : callable, optional
        Is run before the first run of points with the same `loads`, by default `run`.
    loads : hashable
        Differs with what the first run of a method compiles and loads.
    device : str
        The device, if it is not the processor.
    count : int
        How many times a run does what the time is of.
    """

    case: str
    method: str
    setting: str
    run: Callable[[], Any]
    figures: Callable[[Any], Figures] | None = None
    first: Callable[[], Any] | None = None
    loads: Hashable = ""
    device: str = ""
    count: int = 1


class StudyResult(NamedTuple):
    """The result of a study: its points with figures and times, the settings that were refused, and
    how often each point was timed (`repeats`)."""

    points: tuple[Point, ...]
    refused: tuple[Refused, ...] = ()
    repeats: int = 1

    @property
    def times(self) -> str:
        """The meaning of the times, as text."""
        return "one run" if self.repeats == 1 else f"median and range of {self.repeats} runs"


@dataclass(frozen=True, eq=False)
class Study:
    """A grid of points, and the declaration of its table and diagrams.

    Attributes
    ----------
    points : sequence of StudyPoint
        The grid: products of axes (`itertools.product`), one after the other. `synthesis` is one
        product: programs, lowerings, levels. `sensor` has one for shutters, one for looks and one
        for readouts, and `emulator` one for methods with a tolerance and one without, because a
        tolerance means nothing to the reference. In `decoder` and in the stages of a program,
        each method has settings of its own, such as iterations, stages or number formats.
    text : callable
        Returns the table and further lines for the terminal.
    diagrams : mapping
        Functions that draw the results, given these and the device, by name of the picture; the
        main diagram is `png`.
    repeats : int
        How often each point is timed.
    budget_s : float
        No repeat starts if it would end later than this after the first.
    refuses : tuple of str
        Codes of points that may be refused, by their first characters.
    device : str
        What the times are of, if not of this processor.
    lists_refused : bool
        Whether the CSV file lists refused settings.
    csv_of : callable
        Returns the points of the CSV file, by default all.
    """

    points: Sequence[StudyPoint]
    text: Callable[[StudyResult], str]
    diagrams: Mapping[str, Callable[[StudyResult, str], Figure]]
    repeats: int = 1
    budget_s: float = float("inf")
    refuses: tuple[str, ...] = DOES_NOT_FIT
    device: str = ""
    lists_refused: bool = False
    csv_of: Callable[[Sequence[Point]], Sequence[Point]] = tuple


def measure(
    study: Study, store: ExperimentStore | None = None, track: Progress = unseen
) -> StudyResult:
    """Measure all points of a study, once for each repeat, and return their figures and times.

    Rows that `store` already has are not measured again; None keeps rows in memory only. `track`
    receives the measurements and may show a bar. Points that the study may refuse become rows with
    a reason; other errors are raised."""
    rows_store, watch = store or ExperimentStore(), Stopwatch()
    turns = [0]

    def measured() -> Iterator[Done]:
        """Yield the rows of all points, once for each repeat. No repeat begins if one as long as
        the last would exceed the budget of the study."""
        begin = perf_counter()
        for turn in range(study.repeats):
            before, rows = perf_counter(), rows_in(rows_store)
            tasks = [
                _Turn(point, turn=turn)
                for point in study.points
                if turn == 0 or _is_timed(point, rows)
            ]
            yield from results(rows_store, tasks, lambda tasks: _executed(tasks, study, watch))
            turns[0] = turn + 1
            now = perf_counter()
            if now - begin + (now - before) > study.budget_s:
                return

    for _ in track(measured(), "measuring", len(study.points) * study.repeats):
        pass
    return _gathered(study.points, rows_in(rows_store), turns[0])


@dataclass(frozen=True)
class _Turn:
    """One measurement of a point. `turn` is the number of the repeat, which makes its key in the
    store different from that of the other repeats."""

    point: StudyPoint
    turn: int

    @property
    def label(self) -> str:
        """The case, method, setting and turn as text. It also identifies the measurement in the
        store."""
        return f"{self.point.case}, {self.point.method}, {self.point.setting}, {self.turn}"

    key = label


def _executed(tasks: Iterable[_Turn], study: Study, watch: Stopwatch) -> Iterator[Done]:
    """Measure each task and yield its row. A refusal that the study allows becomes a row with code
    and text instead of figures; others are raised.

    Figures other than the time are computed in the first repeat only."""
    for task in tasks:
        point, key = task.point, task.key
        try:
            if point.figures is None:
                row = PointRow(key, point.run())
            else:
                kind = point.case, point.method, point.loads
                result, ms = watch.ms(kind, point.setting, point.run, point.first)
                figures = point.figures(result) if task.turn == 0 else {}
                row = PointRow(key, {"ms": ms / point.count, **figures})
        except (Rejected, NotMeasured, ModuleNotFoundError) as why:
            code, text = _reason(why)
            if code != _NO_CODE and not code.startswith(study.refuses):
                raise
            row = PointRow(key, code=code, error=text)
        yield Done(task, row)


def _reason(why: Exception) -> tuple[str, str]:
    """Return the code and the text of the reason why a point cannot be measured; the code is
    `_NO_CODE` without a message of nscc. Of several messages the last counts."""
    if isinstance(why, Rejected):
        return why.diagnostics[-1].code, why.diagnostics[-1].message
    if isinstance(why, ModuleNotFoundError):
        name = why.name or "a package"
        return "NS0904", f"{name} is missing: {line_for(name)}"
    return _NO_CODE, str(why)


def _is_timed(point: StudyPoint, rows: Mapping[str, PointRow]) -> bool:
    """Return whether a point is repeated for its time.

    Points that were refused in the first repeat, or that measure their times themselves, are not.
    `rows` contains the rows of the first repeat of all points."""
    row = rows[_Turn(point, turn=0).key]
    return point.figures is not None and not row.code and not isinstance(row.figures["ms"], list)


def _gathered(
    points: Sequence[StudyPoint], rows: Mapping[str, PointRow], turns: int
) -> StudyResult:
    """Return the rows of all repeats as points of the table: one point for each figure, with the
    times of all repeats.

    `turns` is the number of repeats that were measured, and `rows` are their rows by key. Points
    without figures are listed as refused."""
    made: list[Point] = []
    refused = []
    for point in points:
        # The rows of those repeats of the point that are stored.
        point_rows = [rows[key] for n in range(turns) if (key := _Turn(point, turn=n).key) in rows]
        names = {"method": point.method, "setting": point.setting, "bound": None}
        figures: Figures = {**names, **point_rows[0].figures}
        if code := point_rows[0].code:
            reason = point_rows[0].error
            refused.append(
                Refused(point.case, point.method, point.setting, code.strip(_NO_CODE), reason)
            )
            continue
        ms = figures.pop("ms")
        # A method may measure several times itself; otherwise each repeat has one time.
        times_ms = ms if isinstance(ms, list) else [row.figures["ms"] for row in point_rows]
        method, setting, bound = (figures.pop(name) for name in names)
        made += [
            Point(
                point.case,
                method,
                setting,
                error,
                unit,
                tuple(times_ms),
                bound,
                more_is_better=unit in _MORE_IS_BETTER,
                device=point.device,
            )
            for unit, error in figures.items()
        ]
    return StudyResult(tuple(made), tuple(refused), turns)
