"""Light drawn evenly over bit patterns, through the loaders and `nscc run`: the documented error,
or the right result."""

from __future__ import annotations

import json
import math
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from nscc_command import invoke
from one_scene import load_scene
from reference_programs import program, sensor_of

from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.effects import selected
from nscc_runtime.emulator import expose
from nscc_runtime.frame_file import read_out
from nscc_runtime.light import Light
from nscc_runtime.reference import frames as by_reference
from nscc_runtime.scenes.exposure import ExposureLevel

ROWS, COLS, SLOTS, SLOT_US = 5, 7, 4, 1000.0
TEXT = "nsl 1\nframe 4 slots of 1ms\ncode stop : 0..4\nopen when n < stop\npixels stop = x % 5\n"
FLOAT_MAX = float(np.finfo(np.float32).max)
LEAST = 2.0**-149
KINDS = (np.float16, np.float32, np.float64)
UNSIGNED = {2: np.uint16, 4: np.uint32, 8: np.uint64}


def bits(rng: np.random.Generator, shape: tuple[int, ...], kind: type) -> np.ndarray:
    """Every pattern alike: NaN with any payload, infinities, denormals, both signs."""
    whole = np.frombuffer(rng.bytes(math.prod(shape) * np.dtype(kind).itemsize), kind)
    return whole.reshape(shape).copy()


def is_bad(value: float) -> bool:
    """What the contract calls no light. -0.0 is light."""
    return math.isnan(value) or value < 0 or value > FLOAT_MAX


@st.composite
def arrays(draw: Any) -> np.ndarray:
    """A clip or a still; half of them with nothing but light, some with a single bad value."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    shape = draw(st.sampled_from([(SLOTS, ROWS, COLS), (ROWS, COLS)]))
    kind = draw(st.sampled_from(KINDS))
    values = bits(rng, shape, kind)
    if draw(st.integers(0, 3)):
        bad = np.array([is_bad(v) for v in values.reshape(-1).tolist()]).reshape(shape)
        values = np.where(bad, kind(draw(st.sampled_from([0.0, -0.0, 1.5, 2.0**-24]))), values)
        if draw(st.booleans()):
            place = draw(st.integers(0, values.size - 1))
            values.reshape(-1)[place] = bits(rng, (1,), kind)[0]
    return values


@contextmanager
def saved(values: np.ndarray, ending: str) -> Iterator[Path]:
    from scipy.io import savemat

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"light{ending}"
        match ending:
            case ".npz":
                np.savez(path, light=values)
            case ".npy":
                np.save(path, values)
            case ".mat":
                savemat(path, {"light": values})
        yield path


def loaded(path: Path, **options: Any) -> Light:
    return load_scene(str(path), slot_us=(SLOT_US,) * SLOTS, rows=ROWS, cols=COLS, **options)


def _attempted(path: Path, exposure: ExposureLevel) -> tuple[Light | None, str]:
    """The light, or the code of the message."""
    try:
        return loaded(path, exposure=exposure), ""
    except Rejected as rejected:
        return None, rejected.diagnostics[0].code


def slots_of(values: np.ndarray) -> list[list[float]]:
    """Electrons of each slot, by pixel, as exact floats: [slot][pixel]."""
    if values.ndim == 3:
        return [[float(np.float32(v)) for v in frame.reshape(-1).tolist()] for frame in values]
    one = [float(np.float32(v)) * SLOT_US * 1e-6 for v in values.reshape(-1).tolist()]
    return [one] * SLOTS


def check(found: np.ndarray, slots: list[list[float]], factor: float = 1.0) -> None:
    """Exposures (rows, cols) of TEXT against fsum, to 1e-6 and the rounding of all the light."""
    for place, value in enumerate(found.reshape(-1)):
        stop = place % COLS % 5
        column = [slot[place] * factor for slot in slots]
        truth, everything = math.fsum(column[:stop]), math.fsum(column)
        # A float32 slot is rounded to a multiple of the least denormal.
        slack = 1e-12 * everything + SLOTS * LEAST
        assert abs(value - truth) <= 1e-6 * truth + slack
        if stop == 0:
            assert value == 0
            assert not math.copysign(1, value) < 0


@settings(max_examples=400, deadline=None)
@given(arrays(), st.sampled_from([".npz", ".npy", ".mat"]))
def test_arrays_are_refused_or_right(values: np.ndarray, ending: str) -> None:
    if ending == ".mat" and values.dtype == np.float16:
        values = values.astype(np.float32)  # MATLAB has none
    bad = [v for v in values.reshape(-1).tolist() if is_bad(v)]
    with saved(values, ending) as path:
        # A single bad value refuses the whole array.
        if bad:
            with pytest.raises(Rejected) as caught:
                loaded(path)
            (diagnostic,) = caught.value.diagnostics
            assert (diagnostic.code, caught.value.status) == ("NS0736", 2)
            assert diagnostic.data["count"] == len(bad)
            return
        light = loaded(path)
    if values.ndim == 3:
        assert light.dense().tobytes() == values.astype(np.float32).tobytes()
    slots = slots_of(values)
    for lowering in ("accumulate", "latch", "edges"):
        found = expose(program(TEXT, lowering, ROWS, COLS), light)
        assert found.valid.all()
        check(found.exposure_e[0], slots)
    codes = read_out(found, program(TEXT, "edges", ROWS, COLS).target).frame[0]
    expected = np.clip(np.rint(found.exposure_e[0] / (30000 / 255)), 0, 255)
    assert np.array_equal(codes, expected)


@settings(max_examples=300, deadline=None)
@given(arrays(), st.sampled_from([0.0, 50.0, 99.0, 100.0]))
def test_any_array_gets_the_exposure_or_is_refused(values: np.ndarray, percentile: float) -> None:
    """The pixel at the percentile gets what was asked for, or the message says why not."""
    bad = any(is_bad(v) for v in values.reshape(-1).tolist())
    with saved(values, ".npz") as path:
        light, code = _attempted(path, ExposureLevel(30_000.0, percentile))
    if light is None:
        assert code == ("NS0736" if bad else "NS0738")
        return
    assert not bad
    total = light.total_e()
    assert np.isfinite(total).all()
    assert float(np.percentile(total, percentile)) == pytest.approx(30_000, rel=1e-5)
    assert math.isfinite(light.exposure_scale_e)
    found = expose(program(TEXT, "accumulate", ROWS, COLS), light)
    assert found.valid.all()
    check(found.exposure_e[0], slots_of(values), light.exposure_scale_e)


def _picture(path: Path, values: np.ndarray) -> None:
    """(rows, cols, 3) as a PFM file, by hand, or as an OpenEXR file of half or float."""
    if path.suffix == ".pfm":
        head = f"PF\n{values.shape[1]} {values.shape[0]}\n-1.0\n".encode()
        path.write_bytes(head + values[::-1].astype("<f4").tobytes())
        return
    import OpenEXR

    header = {"compression": OpenEXR.NO_COMPRESSION, "type": OpenEXR.scanlineimage}
    with OpenEXR.File(header, {"RGB": values}) as file:
        file.write(str(path))


@settings(max_examples=200, deadline=None)
@given(st.integers(0, 2**32), st.sampled_from(["half", "float", "pfm"]), st.booleans())
def test_pictures_are_refused_or_right(seed: int, how: str, lit: bool) -> None:
    rng = np.random.default_rng(seed)
    values = bits(rng, (ROWS, COLS, 3), np.float16 if how == "half" else np.float32)
    if lit:
        values = np.where(np.isfinite(values) & (values >= 0), values, 0).astype(values.dtype)
    exact = [[float(v) for v in pixel] for pixel in values.reshape(-1, 3).tolist()]
    weighted = [0.2126 * r + 0.7152 * g + 0.0722 * b for r, g, b in exact]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / ("a.pfm" if how == "pfm" else "a.exr")
        _picture(path, values)
        light, code = _attempted(path, ExposureLevel(30_000.0, 100.0))
    numbers = [v for v in weighted if math.isfinite(v)]
    if light is None:
        dark = max(numbers, default=0.0) < 1e-33  # no factor of a float32 reaches so far
        assert code == "NS0736" or (code == "NS0738" and dark)
        assert code == "NS0738" or any(is_bad(v) for v in weighted)
        return
    assert len(numbers) == len(weighted)
    # What is left of filters, less than a thousandth of the peak below 0, counts as dark.
    clamped = np.array([max(v, 0.0) for v in weighted]).reshape(ROWS, COLS)
    wanted = clamped / clamped.max() * 30_000
    np.testing.assert_allclose(light.total_e(), wanted, rtol=1e-5, atol=1e-30)


@settings(max_examples=300, deadline=None)
@given(st.integers(0, 2**32))
def test_arrays_in_python_mark_values_that_are_not_numbers(seed: int) -> None:
    """`expose` does not check the values of the light. Exposures that are not finite are marked as
    invalid."""
    patterns = bits(np.random.default_rng(seed), (SLOTS, ROWS, COLS), np.float32).view(np.uint32)
    values = (patterns & 0x7FFF_FFFF).view(np.float32)
    container = program(TEXT, "accumulate", ROWS, COLS)
    found = expose(container, Light.of_clip(values))
    for place in range(ROWS * COLS):
        stop = place % COLS % 5
        column = [float(v) for v in values[:, place // COLS, place % COLS]]
        value = float(found.exposure_e[0].reshape(-1)[place])
        # Only pixels of finite light have a value to compare.
        if all(map(math.isfinite, column)):
            size = math.fsum(column)
            assert found.valid[0].reshape(-1)[place]
            assert abs(value - math.fsum(column[:stop])) <= 1e-12 * size
        elif not all(map(math.isfinite, column[:stop])):
            assert not found.valid[0].reshape(-1)[place]
    frame = read_out(found, container.target)
    assert not frame.valid[np.isnan(found.exposure_e)].any()
    assert not frame.frame[np.isnan(found.exposure_e)].any()


@settings(max_examples=60, deadline=None)
@given(arrays(), st.sampled_from(["all", "all,-crosstalk", "shot,dark,full_well"]))
def test_every_effect_accepts_any_valid_light(values: np.ndarray, effects: str) -> None:
    if any(is_bad(v) for v in values.reshape(-1).tolist()):
        return
    with saved(values, ".npy") as path:
        light = loaded(path)
    container = program(TEXT, "edges", ROWS, COLS)
    (found,) = by_reference(container, light, sensor_of(container), selected(effects))
    assert found.valid.all()
    assert np.isfinite(found.exposure_e).all()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("patterns")
    toml = invoke(["targets", "scamp5", "--toml"], made).out
    toml = toml.replace("\nrows = 256", f"\nrows = {ROWS}").replace(
        "\ncols = 256", f"\ncols = {COLS}"
    )
    (made / "small.toml").write_text(toml)
    (made / "p.nsl").write_text(TEXT)
    build = ["build", "p.nsl", "--target", "small.toml", "-o", "p.icw"]
    assert invoke(build, made).status == 0
    return made


@settings(max_examples=40, deadline=None)
@given(values=arrays(), planned=st.booleans())
def test_run_accepts_light_of_any_bit_pattern(
    folder: Path, values: np.ndarray, planned: bool
) -> None:
    np.save(folder / "light.npy", values)
    (folder / "f.npz").unlink(missing_ok=True)
    words = ["run", "p.icw", "--scene", "light.npy", "-o", "f.npz"]
    more = ["--effects", "none"] if planned else ["--effects", "all", "--fidelity", "reference"]
    found = invoke([*words, *more], folder)
    if any(is_bad(v) for v in values.reshape(-1).tolist()):
        assert (found.status, found.codes) == (2, ["NS0736"])
        assert not (folder / "f.npz").exists()
        return
    assert found.status == 0, found.err
    with np.load(folder / "f.npz") as frame:
        assert frame["valid"].all()
        assert json.loads(str(frame["meta"]))["invalid_pixels"] == 0
        if planned:
            check(frame["exposure_e"][0], slots_of(values))
        else:
            assert np.isfinite(frame["exposure_e"]).all()
