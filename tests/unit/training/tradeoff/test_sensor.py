"""`nscc tradeoff sensor`: the compiler's slots, the emulator's captures, what does not fit."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from PIL import Image

torch = pytest.importorskip("torch")


from nscc_training.command_settings import SensorStudySettings  # noqa: E402
from nscc_training.experiments.study import StudyResult  # noqa: E402
from nscc_training.experiments.study import measure as measure_study  # noqa: E402
from nscc_training.tradeoff.sensor import sensor_points, sensor_study  # noqa: E402

SMALL = SensorStudySettings(
    classes=("c",),
    slots=(4, 8),
    stop_slots=(8,),
    looks=(),
    codes=("fixed",),
    lowerings=("edges",),
    level=0,
    effects="none",
    readouts=(),
)


def settings(**changes: Any) -> SensorStudySettings:
    return replace(SMALL, **changes)


def measure(options: SensorStudySettings) -> StudyResult:
    return measure_study(sensor_study(options))


def test_the_study_has_every_configuration_once() -> None:
    asked = settings(classes=("b", "e"), codes=("fixed", "open"), lowerings=("accumulate", "edges"))
    found = [(each.case, each.method, each.setting) for each in sensor_points(asked)]
    assert len(found) == len(set(found)) == (2 * 2 + 1) * 2 * 2


def test_slot_times_of_the_study_equal_those_of_the_report(tmp_path: Path) -> None:
    """The program is of class b with open codes."""
    asked = settings(classes=("b",), slots=(8,), codes=("open",), lowerings=("latch",))
    [clip, still] = measure(asked).points
    (tmp_path / "p.nsl").write_text(
        "nsl 1 target scamp5 frame 8 slots of 10us code stop : 1..N open when n < stop "
        "pixels stop = tile [[1, 2], [4, 8]]"
    )
    done = invoke(
        [
            "build",
            "p.nsl",
            "-O",
            "0",
            "--codes",
            "open",
            "--lowering",
            "latch",
            "--emit",
            "report=-",
        ],
        tmp_path,
    )
    assert done.status == 0, done.err
    slot_us = json.loads(done.out)["shortest_slot_us"]
    assert clip.time_ms * 1e3 == pytest.approx(slot_us)
    assert still.time_ms * 1e3 == pytest.approx(slot_us)
    assert (clip.case, still.case) == ("clips", "stills")


def test_without_effects_words_with_equal_shutters_have_equal_errors() -> None:
    """Two lowerings of the same shutters differ in time. Effects change the errors."""
    ways = {"classes": ("b",), "slots": (8,), "lowerings": ("accumulate", "edges")}
    points = measure(settings(**ways)).points
    clips = [p for p in points if p.case == "clips"]
    assert len({round(p.error, 9) for p in clips}) == 1
    assert len({p.time_ms for p in clips}) == 2
    real = [p for p in measure(settings(**ways, effects="auto")).points if p.case == "clips"]
    assert all(p.error < clips[0].error for p in real)


def test_programs_that_do_not_fit_are_listed_with_their_error() -> None:
    """For clips of class e, both lowerings are refused with NS0412. The two points of stills are
    measured."""
    asked = settings(
        classes=("e",), slots=(16,), stop_slots=(8,), codes=("open",), lowerings=("latch", "edges")
    )
    found = measure(asked)
    assert [(each.case, each.code) for each in found.refused] == [("clips", "NS0412")] * 2
    assert [p.case for p in found.points] == ["stills"] * 2


def test_other_seeds_are_other_scenes_and_the_same_seed_the_same() -> None:
    first, again, other = (
        [p.error for p in measure(settings(seed=seed)).points] for seed in (0, 0, 1)
    )
    assert first == again != other


def test_tradeoff_sensor_writes_table_and_diagram(tmp_path: Path) -> None:
    arguments = ["tradeoff", "sensor", "--classes", "c,e", "--slots", "4,16", "--stop-slots", "8",
                 "--looks", "2", "--codes", "open", "--lowerings", "edges", "-O", "0", "--effects",
                 "none", "--readouts", "none"]  # fmt: skip
    for name in ("one", "two"):
        done = invoke([*arguments, "-o", name], tmp_path)
        assert done.status == 0, done.err
    for ending in ("csv", "png"):
        assert (tmp_path / f"one.{ending}").read_bytes() == (
            tmp_path / f"two.{ending}"
        ).read_bytes()  # nothing is timed, so nothing differs
    rows = list(csv.DictReader(io.StringIO((tmp_path / "one.csv").read_text())))
    refused = [row for row in rows if not row["error"]]
    assert [(r["method"], r["setting"], r["error_unit"], r["time_ms"]) for r in refused] == [
        ("clips, e, open codes, edges", "16 slots", "NS0412", "")
    ]
    measured = [row for row in rows if row["error"]]
    assert {row["error_unit"] for row in measured} == {"psnr_db"}
    assert {row["device"] for row in rows} == {"scamp5"}
    assert all(
        0 < float(row["time_ms"]) < 1 and np.isfinite(float(row["error"])) for row in measured
    )
    assert "does not fit" in done.out
    Image.open(tmp_path / "one.png").verify()


def test_a_study_without_points_that_fit_is_refused(tmp_path: Path) -> None:
    done = invoke(
        [
            "tradeoff",
            "sensor",
            "--classes",
            "c",
            "--slots",
            "4",
            "--stop-slots",
            "3000",
            "--looks",
            "none",
            "--readouts",
            "none",
            "--codes",
            "open",
            "--lowerings",
            "latch",
            "--slot-us",
            "0.01",
            "-O",
            "0",
            "-o",
            "o",
        ],
        tmp_path,
    )
    assert done.status == 1
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["--classes", "f"], "NS0783"),
        (["--slots", "3,8"], "NS0783"),
        (["--slots", "0"], "NS0783"),
        (["--slots", ""], "NS0783"),
        (["--slot-us", "0"], "NS0783"),
        (["--looks", "1"], "NS0783"),
        (["--readouts", "5"], "NS0783"),
        (["--data", "."], "NS0811"),
        (["--effects", "nonsense"], "NS0756"),
        (["--csv", "a", "--png", "a"], "NS0745"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_tradeoff_sensor_refuses_wrong_usage(
    tmp_path: Path, arguments: list[str], code: str
) -> None:
    done = invoke(["tradeoff", "sensor", *arguments], tmp_path)
    assert (done.status, done.codes) == (2, [code])
    assert not list(tmp_path.iterdir())


def measured_readouts(options: SensorStudySettings) -> tuple[list[Any], list[Any]]:
    """Only the points and refused settings of readouts."""
    found = measure(replace(options, stop_slots=()))
    return tuple(
        [p for p in each if p.case == "readouts"] for each in (found.points, found.refused)
    )


def test_more_readouts_take_longer(tmp_path: Path) -> None:
    """On a chip with few registers, the searched bits of one readout do not fit."""
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    changes = {
        "rows": "rows = 48",
        "cols": "cols = 64",
        "name": 'name = "mine"',
        "digital": 'digital = ["R0", "R1", "R2", "R12"]',
    }
    lines = [changes.get(line.split(" =")[0], line) for line in text.splitlines()]
    (tmp_path / "mine.toml").write_text("\n".join(lines))
    asked = settings(target=str(tmp_path / "mine.toml"))
    points, refused = measured_readouts(replace(asked, readouts=(1, 3)))
    # A readout lasts 16.7 ms.
    assert [(p.method, round(p.time_ms, 3)) for p in points] == [
        ("burst", 16.7),
        ("burst", 50.1),
        ("coded", 50.1),
    ]
    assert [(each.method, each.setting, each.code) for each in refused] == [
        ("coded", "1", "NS0412")
    ]
    points, refused = measured_readouts(settings(effects="auto", readouts=(2,)))
    burst, coded = points
    assert not refused
    assert coded.error > burst.error
    assert coded.time_ms == burst.time_ms == pytest.approx(33.4)


def test_an_unknown_target_of_a_tradeoff_is_refused(tmp_path: Path) -> None:
    done = invoke(["tradeoff", "sensor", "--target", "nochip"], tmp_path)
    assert (done.status, done.codes) == (2, ["NS0230"])


def test_the_study_takes_a_target_file(tmp_path: Path) -> None:
    """A target with fewer registers refuses a program that fits SCAMP-5. Its array need not be
    square."""
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    changes = {
        "digital": 'digital = ["R0", "R1", "R2", "R12"]',
        "rows": "rows = 48",
        "cols": "cols = 64",
        "name": 'name = "mine"',
    }
    lines = [changes.get(line.split(" =")[0], line) for line in text.splitlines()]
    (tmp_path / "mine.toml").write_text("\n".join(lines))
    asked = settings(
        classes=("e",),
        slots=(8,),
        stop_slots=(2,),
        codes=("open",),
        target=str(tmp_path / "mine.toml"),
    )
    found = measure(asked)
    assert [each.code for each in found.refused] == ["NS0412"]
    assert [point.case for point in found.points] == ["stills"]
    assert sensor_study(asked).device == "mine"
