"""Frames drawn by torch: those of the compiled loops, to rounding."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_counts import by_plan
from plan_cases import case, moving_light

from nscc.diagnostics.arguments import WrongArgument
from nscc_runtime import capture
from nscc_runtime.noise import RATE_CAP, key, normals, uniforms
from nscc_runtime.python_arguments import check_device

torch = pytest.importorskip("torch")

ROWS, COLS = 12, 16


def test_numbers_are_those_of_the_loops() -> None:
    from nscc_runtime.noise import on_torch

    keys = [key(3, 1, 2, 4, 5), key(2**64 - 1, 7)]
    places = np.array([0, 1, 77, 2**33 + 5, 123_456_789])
    given = on_torch.key_tensor(keys, "cpu"), torch.from_numpy(places)
    found = on_torch.uniforms(*given).numpy()
    np.testing.assert_array_equal(found, [uniforms(each, places) for each in keys])
    wanted = [normals(each, places) for each in keys]
    np.testing.assert_allclose(on_torch.normals(*given).numpy(), wanted, rtol=1e-11)


def test_counts_are_those_of_the_loops() -> None:
    from nscc_runtime.noise import on_torch

    places = np.arange(20_000)
    rates = np.geomspace(1e-3, 1e7, len(places))
    rates[:2] = -1.0, np.nan
    stream = key(9, 1)
    given = on_torch.key_tensor([stream], "cpu"), torch.from_numpy(places)
    found = on_torch.poisson(*given, torch.from_numpy(rates), RATE_CAP).numpy()[0]
    wanted = by_plan(stream, places, rates)
    assert (found == wanted).mean() > 0.9999
    np.testing.assert_allclose(found, wanted, atol=1.0, rtol=1e-9)


@pytest.mark.parametrize(
    ("effects", "most_e"),
    [("all", 400.0), ("all", 60_000.0), ("all,-register", 60_000.0), ("shot,read,full_well", 90.0),
     ("all,-crosstalk", 900.0), ("dark,analog", 90.0)],
)  # fmt: skip
@pytest.mark.parametrize("name", ["b edges", "two buckets"])
def test_frames_are_those_of_the_loops(name: str, effects: str, most_e: float) -> None:
    program = case(name, 8, rows=ROWS, cols=COLS)
    clip = moving_light((8, ROWS, COLS), most_e).frames
    given = {"effects": effects, "seed": 4, "device_seed": 2, "repeat": 3}
    loops = capture(program, clip, **given)
    drawn = capture(program, clip, torch_device="cpu", **given)
    assert loops.plan == drawn.plan
    np.testing.assert_allclose(drawn.exposure_e, loops.exposure_e, atol=0.02, rtol=1e-7)
    assert (drawn.frame == loops.frame).mean() > 0.999
    np.testing.assert_array_equal(drawn.saturated_by, loops.saturated_by)
    np.testing.assert_array_equal(drawn.valid, loops.valid)


@pytest.mark.parametrize("device", ["abacus", "meta", 3])
def test_a_device_that_is_none_is_told(device: object) -> None:
    program = case("b edges", 8, rows=ROWS, cols=COLS)
    with pytest.raises(WrongArgument, match="torch"):
        capture(program, np.ones((8, ROWS, COLS), np.float32), torch_device=device)


def test_the_reason_why_torch_cannot_use_a_device_is_told() -> None:
    with pytest.raises(WrongArgument, match="= Expected one of cpu"):
        check_device("nscc_runtime.capture", "abacus")


@pytest.mark.parametrize("rate", [16.0, 40.0, 1000.0, 3e5])
def test_the_formula_of_counts_is_that_of_arrays(rate: float) -> None:
    from nscc_runtime.noise import on_torch, poisson_law

    z = np.linspace(-5, 5, 41)
    expected = [poisson_law.quantile(float(value), rate) for value in z]
    found = on_torch._quantile(torch.from_numpy(z), torch.tensor(rate, dtype=torch.float64))
    np.testing.assert_allclose(found.numpy(), expected, rtol=1e-12)
