"""StudyResult points: medians, who dominates whom, the CSV file, the table."""

from __future__ import annotations

import csv
import io
from dataclasses import replace

import pytest

from nscc_runtime.pictures.precision import Point, dominated
from nscc_training.experiments import study
from nscc_training.experiments.study import processor_name
from nscc_training.experiments.study_table import (
    COLUMNS,
    Refused,
    csv_text,
    refusals_text,
    table_text,
)


def point(case: str, setting: str, error: float, *times_ms: float, bound: float | None = None):
    """A point of one method."""
    return Point(case, "m", setting, error, "words_per_frame", times_ms, bound)


def test_times_are_medians_and_spreads() -> None:
    """Of an even number of times, the median is the mean of the middle two. The spread is the
    largest less the least."""
    assert point("a", "0", 1, 5.0, 1.0, 3.0).time_ms == 3.0
    assert point("a", "0", 1, 5.0, 1.0, 3.0, 4.0).time_ms == 3.5
    assert point("a", "0", 1, 5.0, 1.0, 3.0).spread_ms == 4.0
    assert point("a", "0", 1, 5.0).spread_ms == 0.0


def test_a_point_is_dominated_by_one_that_is_better_in_all_units() -> None:
    points = [
        point("a", "fast", 10, 1.0),
        point("a", "between", 8, 5.0),
        point("a", "between, but slower", 8, 6.0),
        point("a", "slow", 2, 9.0),
        point("a", "as slow and worse", 3, 9.0),
        point("a", "worst", 11, 99.0),
        point("a", "the fast one's twin", 10, 1.0),
        point("b", "in another case", 100, 100.0),
    ]
    assert dominated(points) == [False, False, True, False, True, True, False, False]
    assert dominated([]) == []
    other = [replace(each, error_unit="lsb", error=each.error / 100) for each in points]
    assert dominated(points + other) == dominated(points) * 2, "units do not compare"


def test_points_with_higher_scores_dominate() -> None:
    """Only `worse` is dominated: `fast` has a higher score in less time."""
    found = dominated(
        [
            replace(point("a", name, psnr_db, ms), more_is_better=True)
            for name, psnr_db, ms in (("fast", 20, 1.0), ("worse", 19, 2.0), ("slow", 30, 9.0))
        ]
    )
    assert found == [False, True, False]


def test_csv_lists_refused_points_and_the_origin_of_each() -> None:
    """A point has its own device, and a refused one the code in the column of the error and the
    study's device."""
    points = [replace(point("a", "1", 2, 0.0021), device="a card")]
    text = csv_text(points, "chip", [Refused("a", "m", "2", "NS0412", "too many bits")])
    assert list(csv.reader(io.StringIO(text)))[1:] == [
        ["a, m", "1", "2", "words_per_frame", "0.002100", "0.000", "a card", "no"],
        ["a, m", "2", "", "NS0412", "", "", "chip", ""],
    ]


def test_settings_that_are_refused_for_one_reason_share_a_line() -> None:
    """-O1 and -O2, refused for the same reason, share a line. A refusal without method or code has
    a short one."""
    refused = [
        Refused("a", "m", "-O1", "NS0412", "too many bits"),
        Refused("b", "", "", "", "it has none"),
        Refused("a", "m", "-O2", "NS0412", "too many bits"),
    ]
    assert refusals_text(refused) == ["a, m, -O1, -O2: too many bits (NS0412)", "b: it has none"]


def test_csv_has_the_columns_of_the_contract() -> None:
    points = [point("b 64", "-O1", 10, 1.0), point("b 64", "-O2", 12, 3.0, 2.0)]
    rows = list(csv.reader(io.StringIO(csv_text(points, 'A "fast" chip, 2 GHz'))))
    assert rows == [
        ["method", "setting", "error", "error_unit", "time_ms", "spread_ms", "device", "dominated"],
        ["b 64, m", "-O1", "10", "words_per_frame", "1.000", "0.000", 'A "fast" chip, 2 GHz', "no"],
        [
            "b 64, m",
            "-O2",
            "12",
            "words_per_frame",
            "2.500",
            "1.000",
            'A "fast" chip, 2 GHz',
            "yes",
        ],
    ]
    assert tuple(rows[0]) == COLUMNS


def test_the_table_of_a_study_names_each_case_only_in_its_first_row() -> None:
    points = [
        point("b 64", "-O1", 10, 1.0, bound=7),
        point("b 64", "-O2", 9, 2.5),
        point("b 64", "-O3", 9, 1234.5),
        point("c", "-O3", 9, 2.0),
    ]
    lines = table_text(points, ("lowering", "level", "words")).splitlines()
    assert [line.split() for line in lines] == [
        ["case", "lowering", "level", "words", "bound", "ms", "spread"],
        ["b", "64", "m", "-O1", "10", "7", "1", "0"],
        ["-O2", "9", "2.5", "0"],
        ["-O3", "9", "1234", "0", "dominated"],
        ["c", "m", "-O3", "9", "2", "0"],
    ]
    assert len({line.index("-O") for line in lines[1:]}) == 1
    assert all(line == line.rstrip() for line in lines)


def test_the_processor_has_a_name(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The name comes from the first `model name` of the file. Without the file, or a name in it,
    there is a name all the same."""
    assert processor_name()
    info = tmp_path / "cpuinfo"
    monkeypatch.setattr(study, "_CPUINFO", info)
    assert processor_name(), "there is no such file elsewhere"
    info.write_text("processor\t: 0\nmodel name\t: Some   Chip (R) 3 GHz\nmodel name: other\n")
    assert processor_name() == "Some Chip (R) 3 GHz"
    info.write_bytes(b"model name:\n\xff")
    assert processor_name()
