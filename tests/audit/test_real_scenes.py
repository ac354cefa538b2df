"""Errors of plans stay within the tolerance on real panoramas and clips, if these are there."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import pytest
from checkout import ROOT
from one_scene import load_scene
from plan_cases import case
from promise import POOLED, Outcome, full_frames, outcome
from reference_programs import sensor_of

from nscc_runtime.light import Light
from nscc_runtime.scenes import ExposureLevel

DATA = Path(os.environ.get("NSCC_DATA") or ROOT.parent / "shared" / "data")
FILES = sorted(
    path
    for path in DATA.rglob("*")
    if path.suffix in (".hdr", ".exr", ".mat", ".mp4") and path.is_file()
)
ROWS = COLS = 64
SLOTS = 8
PROGRAMS = ("b edges", "c accumulate", "d edges", "two buckets")

pytestmark = pytest.mark.skipif(
    not FILES, reason=f"no scenes in {DATA}: set NSCC_DATA to the folder that holds them"
)


def measured(
    path: Path, program: str, electrons: float, tolerances: tuple[float, ...]
) -> list[tuple[str, Outcome]]:
    """A part from the middle of the scene, `electrons` at the 99th percentile of the frame."""
    container = case(program, SLOTS, "2ms", ROWS, COLS)
    sensor = sensor_of(container)
    whole = load_scene(
        str(path),
        slot_us=container.slot_us,
        rows=192,
        cols=192,
        exposure=ExposureLevel(electrons),
        warn=lambda _: None,
    )
    frames = np.ascontiguousarray(whole.dense()[:, 64:128, 64:128])
    light = Light.of_clip(frames)
    full = full_frames(container, light, sensor, math.ceil(POOLED / (ROWS * COLS)))
    return [
        (f"{path.name}, {program}, {electrons:g} e, {tolerance} e", found)
        for tolerance in tolerances
        for found in [outcome(container, light, sensor, tolerance, full)]
    ]


def check(found: list[tuple[str, Outcome]]) -> None:
    said = [f"{at}: err {each.err:.4g}, {each.plan.predicted_e:.4g}" for at, each in found]
    kinds = [(text, each) for text, (_, each) in zip(said, found, strict=True)]
    assert [text for text, each in kinds if not each.kept] == []
    assert [text for text, each in kinds if each.needless] == []
    judged = [(text, each) for text, each in kinds if each.counts]
    wrong = [text for text, each in judged if not each.foreseen]
    assert len(wrong) <= 0.1 * len(judged), wrong


def test_errors_of_plans_stay_within_the_tolerance_on_two_real_scenes() -> None:
    check(
        [
            each
            for path, program in zip(FILES[:: max(1, len(FILES) - 1)], PROGRAMS, strict=False)
            for each in measured(path, program, 20_000.0, (0.5, 5.0, 50.0))
        ]
    )


@pytest.mark.slow
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_errors_of_plans_stay_within_the_tolerance_on_every_real_scene(path: Path) -> None:
    number = FILES.index(path)
    check(
        [
            each
            for shift, electrons in enumerate((500.0, 8000.0, 60_000.0))
            for each in measured(
                path,
                PROGRAMS[(number + shift) % len(PROGRAMS)],
                electrons,
                (0.5, 2.0, 5.0, 15.0, 50.0),
            )
        ]
    )
