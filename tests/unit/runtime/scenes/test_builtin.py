"""The scenes that need no file: what their descriptions promise."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
import pytest
from one_scene import load_scene

import nscc
import nscc_runtime
import nscc_runtime.light as light_module
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.light import DrawnFrames
from nscc_runtime.scenes import ExposureLevel, builtin_motion


def test_hdr_spans_five_decades_at_any_size() -> None:
    """At four sizes the brightest pixel has 100 000 times the light of the darkest. The 99th
    percentile is 30 000 electrons."""
    for shape in ((256, 256), (64, 48), (7, 300), (2, 2)):
        light = load_scene("builtin:hdr", slot_us=(1000.0,) * 4, rows=shape[0], cols=shape[1])
        total = light.total_e()
        assert total.shape == shape
        assert total.max() / total.min() >= 1e5
        # The default exposure of builtin scenes, 30000@99.
        assert np.percentile(total, 99) == pytest.approx(30000.0, rel=1e-6)


@pytest.mark.parametrize("slots", [1, 2, 8, 13, 64, 100, 256, 300, 4096])
def test_motion_fills_any_number_of_slots(slots: int) -> None:
    """From 1 to 4096 slots the scene has light for each, and never more than 256 pictures."""
    light = load_scene("builtin:motion", slot_us=(10.0,) * slots, rows=24, cols=32)
    assert light.slots == slots
    assert len(light.frames) <= 256
    # The default exposure of builtin scenes, 30000@99.
    assert np.percentile(light.total_e(), 99) == pytest.approx(30000.0, rel=1e-5)


def test_motion_moves_from_slot_to_slot() -> None:
    """Each of 64 slots has a picture of its own, and neighbours differ by over 0.3 % of the mean
    light."""
    light = load_scene("builtin:motion", slot_us=(100.0,) * 64, rows=128, cols=128)
    np.testing.assert_array_equal(light.row_start, np.arange(65))
    dense = light.dense()
    change = np.abs(np.diff(dense, axis=0)).mean(axis=(1, 2)) / dense.mean()
    assert change.min() > 0.003
    assert change.mean() > 0.02


@pytest.mark.parametrize("effects", ["none", "all", "auto", "shot,full_well,crosstalk,prnu"])
def test_a_clip_that_is_drawn_in_strips_exposes_the_same_frame(
    monkeypatch: pytest.MonkeyPatch, effects: str
) -> None:
    program = nscc.compile(Path("examples/class_b.nsl"))
    bright = nscc_runtime.scene("builtin:motion", exposure="60000@90")
    held = nscc_runtime.capture(program, bright, effects=effects)
    monkeypatch.setattr(light_module, "_STRIP_BYTES", 1)
    monkeypatch.setattr(builtin_motion, "_MOST_BYTES", 0)
    drawn = nscc_runtime.capture(program, bright, effects=effects)
    assert isinstance(drawn.light.frames, DrawnFrames)
    assert [rows.start for rows, _, _ in drawn.light.strips()] == [0, 64, 128, 192]
    assert drawn.light.sha256() == held.light.sha256()
    np.testing.assert_array_equal(drawn.light.sum_e, held.light.sum_e)
    np.testing.assert_array_equal(drawn.exposure_e, held.exposure_e)
    np.testing.assert_array_equal(drawn.frame, held.frame)
    np.testing.assert_array_equal(drawn.saturated_by, held.saturated_by)


def test_drawn_frames_are_read_like_an_array(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a limit of 0 bytes the frames are drawn when they are read. Any index gives what the
    array in memory gives."""
    held = builtin_motion.frames(5, 24, 32)
    monkeypatch.setattr(builtin_motion, "_MOST_BYTES", 0)
    drawn = builtin_motion.frames(5, 24, 32)
    assert isinstance(drawn, DrawnFrames)
    assert (drawn.shape, len(drawn), drawn.dtype) == (held.shape, 5, held.dtype)
    for key in (3, np.int32(-1), (2, slice(4, 9)), (slice(None), slice(7, 99), slice(1, 3))):
        np.testing.assert_array_equal(drawn[key], held[key])
    np.testing.assert_array_equal(np.stack([*drawn]), held)
    with pytest.raises(IndexError):
        drawn[5]


def test_motion_is_as_bright_as_a_slot_is_long() -> None:
    slot_us = tuple(50.0 * 2**k for k in range(8))
    means = load_scene("builtin:motion", slot_us=slot_us, rows=64, cols=64).dense().mean((1, 2))
    np.testing.assert_allclose(means / means.sum(), np.array(slot_us) / sum(slot_us), rtol=0.4)


def test_flat_and_dark_scenes_have_the_stated_electrons() -> None:
    """1000 electrons are divided by the slots' lengths. A given exposure replaces them, and 0
    electrons are dark."""
    slot_us = (100.0, 300.0)
    flat = load_scene("builtin:flat:1000", slot_us=slot_us, rows=3, cols=4)
    np.testing.assert_allclose(flat.total_e(), 1000.0, rtol=1e-6)
    np.testing.assert_allclose(flat.slot(1), 750.0, rtol=1e-6)
    again = load_scene(
        "builtin:flat:1000", slot_us=slot_us, rows=3, cols=4, exposure=ExposureLevel(20.0)
    )
    np.testing.assert_allclose(again.total_e(), 20.0, rtol=1e-6)
    for name in ("builtin:dark", "builtin:flat:0"):
        assert not load_scene(name, slot_us=slot_us, rows=3, cols=4).dense().any()


@pytest.mark.parametrize(
    ("name", "digest"),
    [("builtin:hdr", "7aac8b7b1b102320"), ("builtin:motion", "2bb858f5b5b9cc93")],
)
def test_pictures_are_the_same_on_every_machine(name: str, digest: str) -> None:
    """The pictures have the recorded SHA-256, so no machine rounds them in another way."""
    frames = load_scene(name, slot_us=(1000.0,) * 4, rows=32, cols=48).frames
    assert hashlib.sha256(frames.tobytes()).hexdigest()[:16] == digest


@pytest.mark.parametrize("spec", ["flat", "flat:1:2", "motion:0.5:1", "hdr:1", "dark:0", "light"])
def test_other_arguments_are_refused(spec: str) -> None:
    """A missing number, too many of them and an unknown name give NS0731."""
    with pytest.raises(Rejected, match="NS0731"):
        load_scene(f"builtin:{spec}", slot_us=(1000.0,), rows=4, cols=4)
