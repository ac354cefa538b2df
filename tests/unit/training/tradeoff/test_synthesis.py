"""`nscc tradeoff synthesis`: its points are what the compiler gives, without the cache."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import pytest
from nscc_command import invoke
from PIL import Image

from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Rejected
from nscc.lower.exposure_plan import LOWERINGS, Lowering
from nscc.pipeline import Options
from nscc.source import Source
from nscc_training.command_settings import Count, SynthesisStudySettings
from nscc_training.experiments.study import StudyResult, measure
from nscc_training.tradeoff.synthesis import (
    StudiedProgram,
    builtin_programs,
    synthesis_study,
)

STOPS = "nsl 1 frame 8 slots of 1ms code stop : 0..7 open when n < stop "
BUMPS = "nsl 1 frame 8 slots of 1ms code a : 0..7 code b : 1..8 require a < b open when a <= n < b "


def program(text: str, name: str = "p") -> StudiedProgram:
    return StudiedProgram(name, Source("p.nsl", text), Path(), "open")


def measured(text: str, lowering: Lowering, count: Count, level: int = 1) -> StudyResult:
    settings = SynthesisStudySettings((level,), (lowering,), 1, count)
    return measure(synthesis_study([program(text)], settings))


def test_points_of_the_study_have_the_results_of_the_compiler_without_its_cache(
    tmp_path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("NSCC_CACHE_DIR", str(tmp_path / "cache"))
    programs = [program(STOPS, "b"), program(BUMPS, "d")]
    study = synthesis_study(programs, SynthesisStudySettings((0, 1)))
    ways = [(point.case, point.method, point.setting) for point in study.points]
    assert len(ways) == len(set(ways)) == 2 * 3 * 2
    seen = []

    def track(turns, _label, total):
        assert total == 3 * len(ways)
        for done in turns:
            seen.append((done.task.point.case, done.task.point.method, done.task.point.setting))
            yield done

    found = measure(study, track=track)
    kept = {path.name for path in (tmp_path / "cache").glob("*")}
    assert kept <= {"grammar"}, "what is measured is not read from the cache"
    served = [way for way in ways if way[:2] != ("d", "latch")]
    assert seen == ways + 2 * served, "the repeats go round"
    refused = [(each.case, each.method, each.setting) for each in found.refused]
    assert refused == [way for way in ways if way not in served]
    assert {each.code for each in found.refused} == {"NS0414"}
    assert [(p.case, p.method, p.setting) for p in found.points] == served
    sources = {each.name: each.source for each in programs}
    for point in found.points:
        assert point.error_unit == "words_per_frame"
        assert len(point.times_ms) == 3
        assert min(point.times_ms) > 0
        level = int(point.setting[2:])
        options = Options(level=level, lowering=point.method, codes="open", cache=False)
        compiled = compile_source(sources[point.case], Path(), options)
        assert point.error == compiled.lowered.schedule.words_total


def test_bounds_of_words_equal_those_counted_by_hand() -> None:
    """Class b with stops 0..N-1 needs at least 2 (N - 1) - 13 operations. A slot with light takes
    five analog words: bus, bus, rpix, rpix, nop. The first boundary takes two buses for A, three
    words to reset and two for the reference. No pixel is open in the last slot, and none is read at
    boundary 0."""
    slots = 20
    text = STOPS.replace("frame 8", f"frame {slots}").replace("0..7", f"0..{slots - 1}")
    [logic] = measured(text, "accumulate", "logic").points
    assert logic.error_unit == "logic_words_per_frame"
    assert logic.bound == 2 * (slots - 1) - 13
    assert logic.error >= logic.bound
    [words] = measured(text, "accumulate", "all").points
    lit = slots - 1
    assert words.bound == logic.bound + 2 + 3 + 2 + lit * 2 + (lit - 1) * 3
    assert words.error >= words.bound
    [other] = measured(text, "edges", "all").points
    assert other.bound is None


def test_a_program_that_is_wrong_is_rejected() -> None:
    with pytest.raises(Rejected):
        measured("nsl 1 frame", "edges", "all")


def test_builtin_programs_have_all_classes() -> None:
    """Each class but a occurs. The codebook has 64 different rows of 16 bits, about half of them
    1."""
    classes = {
        compile_source(c.source, c.base, Options(level=0, codes=c.codes)).program.class_name
        for c in builtin_programs()
    }
    assert classes == {"b", "c", "d", "e", "codebook"}
    assert len({c.name for c in builtin_programs()}) == len(builtin_programs())
    book = re.findall(r"\b[01]{16}\b", builtin_programs()[-1].source.text)
    assert len(set(book)) == len(book) == 64
    # Rows of a codebook are random bits.
    assert 0.4 < "".join(book).count("1") / (64 * 16) < 0.6


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with two programs."""
    (tmp_path / "stops.nsl").write_text(STOPS + "pixels stop = x % 8")
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "stops.nsl").write_text(STOPS)
    return tmp_path


@pytest.mark.slow
def test_command_writes_table_csv_and_picture(folder: Path) -> None:
    arguments = ["tradeoff", "synthesis", "stops.nsl", "--repeats", "2", "-o", "out"]
    done = invoke(arguments, folder)
    assert done.status == 0, done.err
    rows = list(csv.DictReader(io.StringIO((folder / "out.csv").read_text())))
    assert [row["setting"] for row in rows] == ["-O0", "-O1", "-O2", "-O3"] * 3
    assert {row["method"] for row in rows} == {f"stops, {name}" for name in LOWERINGS}
    for row in rows:
        assert row["error"] in done.out
        better = [
            other
            for other in rows
            if float(other["error"]) <= float(row["error"])
            and float(other["time_ms"]) <= float(row["time_ms"])
            and (other["error"], other["time_ms"]) != (row["error"], row["time_ms"])
        ]
        assert row["dominated"] == ("yes" if better else "no")
    Image.open(folder / "out.png").load()
    assert "wrote out.csv, out.png" in done.err


def test_tradeoff_synthesis_measures_the_chosen_levels_and_lowerings(folder: Path) -> None:
    arguments = ["tradeoff", "synthesis", "stops.nsl", "other/stops.nsl", "stops.nsl"]
    arguments += ["--levels", "1, 0", "--lowerings", "edges,accumulate", "--repeats", "1"]
    done = invoke([*arguments, "--csv", "a.csv", "--count", "logic"], folder)
    assert done.status == 0, done.err
    rows = list(csv.DictReader(io.StringIO((folder / "a.csv").read_text())))
    assert [(row["method"], row["setting"]) for row in rows] == [
        (f"{name}, {lowering}", level)
        for name in ("stops.nsl", "other/stops.nsl")
        for lowering in ("accumulate", "edges")
        for level in ("-O0", "-O1")
    ]
    assert {row["error_unit"] for row in rows} == {"logic_words_per_frame"}
    assert sorted(path.name for path in folder.iterdir()) == ["a.csv", "other", "stops.nsl"]


def test_tradeoff_synthesis_lists_programs_that_do_not_fit(folder: Path) -> None:
    """The latch cannot lower this program at any level, so the status is 1 and no file is
    written."""
    (folder / "d.nsl").write_text(BUMPS)
    arguments = ["tradeoff", "synthesis", "d.nsl", "--lowerings", "latch", "--repeats", "1"]
    done = invoke([*arguments, "-o", "out"], folder)
    assert done.status == 1
    assert "d, latch, -O0, -O1, -O2, -O3: " in done.out
    assert not (folder / "out.csv").exists()


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["synthesis", "--levels", "4"], "NS0783"),
        (["synthesis", "--levels", ""], "NS0783"),
        (["synthesis", "--lowerings", "auto"], "NS0783"),
        (["synthesis", "--repeats", "0"], "NS0783"),
        (["synthesis", "none.nsl"], "NS0101"),
        (["synthesis", "stops.nsl", "--repeats", "1", "-o", "stops.nsl/where"], "NS0784"),
        (["sinthesis"], "NS0781"),
        (["--frobnicate"], "NS0782"),
        ([], "NS0780"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_tradeoff_synthesis_refuses_wrong_usage(
    folder: Path, arguments: list[str], code: str
) -> None:
    done = invoke(["tradeoff", *arguments], folder)
    assert (done.status, done.codes) == (2, [code])
