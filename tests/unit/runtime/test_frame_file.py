"""The frame file: readout, layout, kept arrays, identity of bytes; what pictures read from it."""

from __future__ import annotations

import hashlib
import io
import json
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.words.container import Container, DecodeTable, packed_shutters, tile_of
from nscc.words.shutters import shutters_of
from nscc_runtime.effects import selected
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.frame_file import (
    FrameFile,
    Provenance,
    meta,
    read_out,
    repeated,
)
from nscc_runtime.light import Light
from nscc_runtime.merge import light_estimate, readouts
from nscc_runtime.response import response_of
from nscc_runtime.sensor import default_sensor

NONE = selected("none")
ROWS, COLS, SLOTS = 6, 8, 11
TARGET = replace(builtin_target("scamp5"), rows=ROWS, cols=COLS)


def container(buckets: int = 2, slots: int = SLOTS, target: Any = TARGET) -> Container:
    """Four codes on a 2 x 2 tile, random shutters; no words: only pictures and files look at it."""
    shutters = np.random.default_rng(0).random((4, buckets, slots)) < 0.5
    y, x = np.mgrid[: target.rows, : target.cols]
    return Container(
        target=target,
        slot_us=tuple(100.0 + n for n in range(slots)),
        buckets=tuple(f"bucket{b}" for b in range(buckets)),
        table=DecodeTable(
            ("id", "twice"),
            np.array([[n, 2 * n] for n in range(4)]),
            np.array([2, 0, 3, 1], np.int32),
            shutters,
        ),
        kernels=(),
        launches=(),
        code_registers=(),
        encoding=np.zeros((4, 13), bool),
        pixel_codes=(x % 2 + 2 * (y % 2)).astype(np.int32),
        readouts=(),
        notes={"lowering": "edges"},
    )


def exposure(values: np.ndarray) -> Exposure:
    return Exposure(values, np.isfinite(values))


def light(kind: str = "clip") -> Light:
    rng = np.random.default_rng(1)
    if kind == "still":
        return Light.of_still(rng.random((ROWS, COLS), np.float32), rng.random(SLOTS))
    return Light.of_clip(rng.random((SLOTS, ROWS, COLS), np.float32) * 100)


def written(keep: tuple[str, ...] = (), repeat: int = 0, kind: str = "clip") -> bytes:
    program, scene = container(), light(kind)
    values = np.random.default_rng(2).random((2, ROWS, COLS)) * 40000
    frame = read_out(exposure(values), program.target)
    frame = repeated(frame, repeat) if repeat else frame
    file = io.BytesIO()
    digest = hashlib.sha256(b"program").hexdigest()
    origin = Provenance(digest, default_sensor(program.target), 3, 4, plan={"effects": []})
    information = meta(program, scene, frame, origin)
    shutters = program.table.shutters
    FrameFile.of(program, scene, frame, information, keep, shutters).write(file)
    return file.getvalue()


def test_readout_rounds_half_to_even_and_clips() -> None:
    lsb = TARGET.electrons_per_lsb
    codes = np.array([0.0, 0.5, 1.5, 2.5, 0.49999997, 254.4, 255.0, 256.0, 300.0, 1e15, -1.0])
    known = np.array([0, 0, 2, 2, 0, 254, 255, 255, 255, 255, 0])
    half = lsb * codes  # lsb is no power of two: products may round, which half-way cases show
    expected = np.clip(np.rint(half / lsb), 0, 255)
    np.testing.assert_array_equal(
        expected[[0, 4, 5, 6, 7, 8, 9, 10]], known[[0, 4, 5, 6, 7, 8, 9, 10]]
    )
    frame = read_out(exposure(half.reshape(1, 1, -1)), TARGET)
    np.testing.assert_array_equal(frame.frame.ravel(), expected)
    # A full well is a step of IN: exposures are spread over the codes without a rest.
    reach = {"register_max_e": 127 * 255.0, "register_min_e": -127 * 255.0}
    exact = replace(TARGET, full_well_e=255.0, adc_offset_lsb=10.0, **reach)
    frame = read_out(exposure(codes.reshape(1, 1, -1)), exact)
    np.testing.assert_array_equal(frame.frame.ravel(), np.clip(np.rint(codes) + 10, 0, 255))


def test_values_that_are_not_numbers_read_zero_and_are_invalid() -> None:
    """NaN and minus infinity read code 0, infinity the last code 255. All three are invalid, and
    5.0 is valid."""
    frame = read_out(exposure(np.array([[[np.nan, np.inf, -np.inf, 5.0]]])), TARGET)
    np.testing.assert_array_equal(frame.frame, [[[0, 255, 0, 0]]])
    np.testing.assert_array_equal(frame.valid, [[[False, False, False, True]]])


def test_a_converter_of_six_bits_clips_and_one_of_ten_bits_is_refused() -> None:
    """1e9 electrons read code 63 of 64. Ten bits do not fit the bytes of a frame file: NS0742."""
    six = replace(TARGET, adc_bits=6)
    frame = read_out(exposure(np.full((1, 1, 1), 1e9)), six)
    # The last of 64 codes.
    assert frame.frame[0, 0, 0] == 63
    with pytest.raises(Rejected) as caught:
        read_out(exposure(np.zeros((1, 1, 1))), replace(TARGET, adc_bits=10))
    assert caught.value.diagnostics[0].code == "NS0742"


def test_the_file_has_the_documented_arrays() -> None:
    keep = ("light", "truth", "shutter", "codes")
    data = np.load(io.BytesIO(written(keep)))
    assert data["frame"].dtype == np.uint8
    assert data["exposure_e"].dtype == np.float64
    assert data["valid"].dtype == data["saturated"].dtype == np.bool_
    assert data["saturated_by"].dtype == np.uint8
    # 4 is the bit for the converter.
    np.testing.assert_array_equal(data["saturated_by"], np.where(data["frame"] == 255, 4, 0))
    np.testing.assert_array_equal(data["saturated"], data["frame"] == 255)
    for key in ("frame", "exposure_e", "valid", "saturated", "saturated_by"):
        assert data[key].shape == (2, ROWS, COLS)
    np.testing.assert_array_equal(data["light"], light().dense())
    np.testing.assert_array_equal(data["truth_e"], light().dense())
    shape = tuple(data["shutter_shape"])
    assert shape == (2, ROWS, COLS, SLOTS)
    opened = np.unpackbits(data["shutter"], axis=-1, count=SLOTS, bitorder="little")
    table = container().table
    for r, c, b in np.ndindex(ROWS, COLS, 2):
        code = r % 2 * 2 + c % 2
        np.testing.assert_array_equal(
            opened[b, r, c], table.shutters[table.shutter_of_code[code], b]
        )
        assert data["codes_twice"][r, c] == 2 * code
    information = json.loads(str(data["meta"]))
    assert information["program_sha256"] == hashlib.sha256(b"program").hexdigest()
    assert information["seed"] == 3
    assert information["device_seed"] == 4
    assert information["buckets"] == ["bucket0", "bucket1"]
    assert information["lowering"] == "edges"
    assert information["electrons_per_lsb"] == pytest.approx(30000 / 255)
    assert information["plan"]["effects"] == []
    assert information["audit"] is None


def test_truth_of_a_still_is_its_all_open_sum() -> None:
    """The array `truth_e` holds the electrons of a shutter that is always open. The light itself is
    not written unless asked for."""
    data = np.load(io.BytesIO(written(("truth",), kind="still")))
    np.testing.assert_array_equal(data["truth_e"], light("still").total_e())
    assert "light" not in data


def test_repeats_have_an_axis_in_front() -> None:
    """Three equal frames give arrays of 3 x 2 x rows x columns, whose parts are those of one
    frame."""
    once, thrice = np.load(io.BytesIO(written())), np.load(io.BytesIO(written(repeat=3)))
    for key in ("frame", "exposure_e", "valid", "saturated", "saturated_by"):
        assert thrice[key].shape == (3, 2, ROWS, COLS)
        for k in range(3):
            np.testing.assert_array_equal(thrice[key][k], once[key])


def test_equal_frames_give_equal_bytes() -> None:
    keep = ("light", "truth", "shutter", "codes")
    assert written(keep) == written(keep)


def test_shutters_need_pixels() -> None:
    with pytest.raises(ValueError, match="without pixels"):
        packed_shutters(replace(container(), pixel_codes=None), container().table.shutters)


@pytest.mark.parametrize("tile", [(1, 1), (2, 2), (1, 3), (3, 1), (3, 4), (6, 8)])
def test_the_smallest_tile_of_a_pattern_is_found(tile: tuple[int, int]) -> None:
    """A pattern that repeats every a x b pixels of 6 x 8 has the tile a x b, up to the whole
    frame."""
    y, x = np.mgrid[:6, :8]
    assert tile_of(x % tile[1] + 10 * (y % tile[0])) == tile


def test_light_is_estimated_from_unsaturated_neighbours() -> None:
    """Some shutters of each 2 x 2 window saturate. The light of every pixel is still known, within
    1 %."""
    target = replace(TARGET, rows=12, cols=12)
    program = container(1, target=target)
    rate = 5e7  # electrons a second
    slot_s = np.array(program.slot_us) * 1e-6
    shutter = program.table.shutter_of_code[program.pixel_codes]
    exposure_e = (program.table.shutters @ slot_s)[:, 0][shutter] * rate
    frame = read_out(exposure(exposure_e[None]), target)
    assert 0 < frame.saturated.mean() < 1
    (readout,) = readouts(program, frame, response_of(program, default_sensor(target), NONE))
    assert readout.window == (2, 2)
    estimate, known = light_estimate(readout)
    assert known.all()
    np.testing.assert_allclose(estimate, rate, rtol=0.01)


def test_view_orders_shutters_by_opening_and_counts_codes() -> None:
    """Rows begin with the shutter that opens least. A shutter of two codes has the label `(+1)`."""
    stops = np.arange(1, 5)
    opened = np.arange(SLOTS)[None, :] < stops[::-1, None]
    table = DecodeTable(
        ("stop",), np.arange(5)[:, None], np.array([3, 2, 1, 0, 0], np.int32), opened[:, None]
    )
    program = replace(container(1), table=table, pixel_codes=None)
    found = shutters_of(program)
    np.testing.assert_array_equal(found.rows[:, 0].sum(axis=1), stops)
    assert found.labels == ("stop 0", "stop 1", "stop 2", "stop 3  (+1)")
