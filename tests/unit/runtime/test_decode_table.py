"""What frame files say of shutters, beside frames of the reference emulator."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from marks import slow
from nscc_command import invoke
from plan_cases import CASES, case
from reference_programs import sensor_of

from nscc_runtime.effects import selected
from nscc_runtime.frame_file import unplanned
from nscc_runtime.light import Light
from nscc_runtime.reference import frames
from nscc_runtime.response import decode_arrays

ROWS, COLS, REPEATS = 16, 24, 60
SHORT = {"b latch", "c accumulate", "d edges", "two buckets"}
"""The kinds of class, lowering and number of buckets, once each."""
EFFECTS = "shot,dark,read,reset,analog,leakage,dead_time"


@pytest.mark.parametrize("name", [n if n in SHORT else slow(n) for n in CASES])
def test_gain_bias_and_variance_are_those_of_the_reference(name: str) -> None:
    """Mean and variance of many frames of the words, executed one by one, at three levels."""
    program = case(name, rows=ROWS, cols=COLS)
    sensor = sensor_of(program, leakage_tau_s=0.1, analog_gain=0.99, analog_noise_lsb=0.3)
    chosen = selected(EFFECTS)
    table = decode_arrays(program, sensor, unplanned(chosen, False, ()))
    row = table["decode_row"]
    shutter = np.unpackbits(table["decode_shutter"], axis=-1, count=8, bitorder="little")[row]
    gain, bias, variance = (
        table[f"decode_{part}"][row].transpose(2, 0, 1)
        for part in ("gain", "bias_e", "variance_e2")
    )
    for level in (20.0, 300.0, 1200.0):
        light = Light.of_clip(np.full((8, ROWS, COLS), level, np.float32))
        made = frames(program, light, sensor, chosen, seed=1, device_seed=2, count=REPEATS)
        taken = np.stack([each.exposure_e for each in made])
        expected = bias + gain * level * shutter.sum(axis=-1).transpose(2, 0, 1)
        photons = np.maximum(expected - bias, 0)
        # Rounding comes after the exposure.
        own = variance - sensor.electrons_per_lsb**2 / 12 + photons
        assert abs(taken.mean() - expected.mean()) < 0.1 * np.sqrt(own.mean())
        off = taken - expected
        assert np.mean(off**2) == pytest.approx(own.mean(), rel=0.1)


def test_frames_hold_the_table_of_their_program(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(
        "nsl 1\nframe slots [100us, 300us, 600us]\ncode stop : 0..3\nopen when n < stop\n"
        "pixels stop = x % 3\n"
    )
    line = ["run", "p.nsl", "--scene", "builtin:hdr", "--keep", "shutter", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    with np.load(tmp_path / "f.npz") as file:
        np.testing.assert_array_equal(
            file["decode_shutter"][file["decode_row"]].transpose(2, 0, 1, 3), file["shutter"]
        )
        assert file["decode_slot_us"].tolist() == [100, 300, 600]
        assert len(file["decode_shutter"]) == 3  # a stop of 3 is no pixel's
        np.testing.assert_array_equal(file["decode_gain"], np.ones((3, 1)))
        np.testing.assert_array_equal(file["decode_bias_e"], np.zeros((3, 1)))
