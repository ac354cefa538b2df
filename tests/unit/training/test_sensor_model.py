"""The differentiable capture beside the emulator, which executes compiled words."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc.chips.load import load_target  # noqa: E402
from nscc.diagnostics.arguments import WrongArgument  # noqa: E402
from nscc_runtime.emulator import expose  # noqa: E402
from nscc_runtime.frame_file import read_out as emulated_read_out  # noqa: E402
from nscc_runtime.light import Light  # noqa: E402
from nscc_runtime.sensor import default_sensor  # noqa: E402
from nscc_training.encoders import ShutterSpec, make_encoder  # noqa: E402
from nscc_training.programs import Chip, compiled, program_of  # noqa: E402
from nscc_training.sensor_model import (  # noqa: E402
    SensorModel,
    differentiable_capture,
    exposed,
    filled,
    laid,
    lifted,
    read_out,
)

SPECS = [
    ShutterSpec("a", 6, (1, 1)),
    ShutterSpec("b", 64, (4, 4)),
    ShutterSpec("c", 16, (3, 5), length=4),
    ShutterSpec("d", 12, (4, 4)),
    ShutterSpec("e", 13, (8, 8)),
    ShutterSpec("codebook", 20, (4, 4), rows=16),
]


def sensor_model() -> tuple[SensorModel, object, object]:
    from pathlib import Path

    target = load_target("scamp5", Path())
    sensor = default_sensor(target)
    return SensorModel.of(sensor, target).noiseless(), sensor, target


@pytest.mark.parametrize("still", [False, True])
@pytest.mark.parametrize("spec", SPECS, ids=lambda spec: spec.kind)
def test_a_hard_capture_equals_the_frame_of_the_emulator(spec: ShutterSpec, still: bool) -> None:
    """Values before the converter agree to 1e-6. Codes are equal unless a value is within 1e-6 of a
    tie."""
    model, sensor, target = sensor_model()
    encoder = make_encoder(spec, "random", seed=8)
    container = compiled(program_of(encoder, Chip()), Chip()).container
    assert container is not None
    rng = np.random.default_rng(1)
    shape = (target.rows, target.cols)  # type: ignore[attr-defined]
    if still:
        # six decades, so that some pixels saturate and most hold a few codes
        picture = np.exp(rng.uniform(-2, 12, shape)).astype(np.float32)
        light = Light.of_still(picture, np.full(spec.slots, 1.0 / spec.slots))
        given = torch.as_tensor(picture)[None]
    else:
        clip = np.exp(rng.uniform(-4, 10, (spec.slots, *shape))).astype(np.float32)
        light = Light.of_clip(clip)
        given = torch.as_tensor(clip)[None]
    exact = expose(container, light)
    frame = emulated_read_out(exact, target, sensor).frame[0]  # type: ignore[arg-type]
    found = differentiable_capture(given, encoder.hard(), model)
    np.testing.assert_allclose(found.exposure_e[0].numpy(), exact.exposure_e[0], rtol=1e-6)
    scaled = exact.exposure_e[0] / model.electrons_per_lsb
    tie = np.abs(scaled - np.floor(scaled) - 0.5) <= 1e-6 * np.maximum(scaled, 1)
    assert ((found.frame[0].numpy() == frame) | tie).all()
    assert tie.mean() < 0.01
    assert (frame == 255).any()


def test_tiles_are_laid_from_the_corner() -> None:
    tile = torch.arange(6.0).reshape(1, 2, 3)
    wanted = [[float(3 * (r % 2) + c % 3) for c in range(7)] for r in range(5)]
    assert laid(tile, 5, 7)[0].tolist() == wanted


def test_unequal_slots_weigh_a_still_by_their_length() -> None:
    model, _, _ = sensor_model()
    shutters = torch.tensor([1.0, 0.0, 1.0]).reshape(3, 1, 1)
    share = torch.tensor([0.5, 0.3, 0.2], dtype=torch.float64)
    found = differentiable_capture(torch.full((1, 2, 2), 1000.0), shutters, model, slot_share=share)
    # Open in the first and the last slot: 0.5 + 0.2 of the light.
    assert torch.allclose(found.exposure_e, torch.full((1, 2, 2), 700.0, dtype=torch.float64))


def test_saturation_has_a_stand_in_slope() -> None:
    model = SensorModel(full_well_e=255.0, electrons_per_lsb=1.0, slope=0.25)
    exposure = torch.tensor([100.0, 255.0, 256.0, 1e6], dtype=torch.float64, requires_grad=True)
    frame = read_out(exposure, model)
    assert frame.tolist() == [100.0, 255.0, 255.0, 255.0]
    frame.sum().backward()
    assert exposure.grad.tolist() == [1.0, 1.0, 0.25, 0.25]


@pytest.mark.parametrize(
    ("values", "full_e", "full_code"),
    [
        ({}, 30000.0, 255),
        ({"electrons_per_lsb": 150.0}, 30000.0, 200),
        ({"electrons_per_lsb": 149.7}, 30000.0, 200),
        ({"adc_offset_lsb": 128.0}, 127 * 30000 / 255, 127),
        ({"adc_offset_lsb": 10.0, "electrons_per_lsb": 100.0}, 24500.0, 245),
    ],
)
def test_decoders_see_1_where_a_pixel_is_saturated(
    values: dict[str, float], full_e: float, full_code: int
) -> None:
    """The pixel saturates at its full well or at the end of the converter, whichever is lower."""
    model = SensorModel(**{"full_well_e": 30000.0, "electrons_per_lsb": 30000 / 255, **values})
    assert model.full_e == pytest.approx(full_e)
    assert model.full_code == full_code
    exposure = torch.tensor([0.0, 0.5, 0.98, 1.01, 50.0], dtype=torch.float64) * full_e
    seen = model.relative(read_out(exposure, model) - model.adc_offset_lsb)
    assert seen[:3].tolist() == pytest.approx([0.0, 0.5, 0.98], abs=0.006)
    assert (seen[3:] >= 1).all()
    assert (seen[:3] < 1).all()


def test_saturated_pixels_are_at_least_what_steady_light_would_leave() -> None:
    """Light so bright that PIX is just full when the shutter closes: slot by slot."""
    shutters = torch.tensor([[1, 1, 0, 0], [0, 0, 1, 0], [0, 1, 0, 1], [0, 0, 0, 0]]).T.float()
    shutters = shutters.reshape(4, 2, 2)
    exposed_e = []
    for opened in shutters.reshape(4, 4).T:
        last = int(opened.nonzero().max()) + 1 if opened.any() else 1
        slot_e = 30000.0 / last
        exposed_e.append(float(sum(slot_e for n in range(last) if opened[n])) / 30000.0)
    nothing, every = torch.zeros(1, 2, 2), torch.ones(2, 2, dtype=torch.bool)
    found = filled(nothing, every, shutters).reshape(-1)
    assert found.tolist() == pytest.approx(exposed_e)
    assert torch.equal(filled(nothing, ~every, shutters), nothing)
    bright = torch.full((1, 2, 2), 1.5)
    assert torch.equal(filled(bright, every, shutters), bright)


def test_noise_has_the_variance_of_photons() -> None:
    model = SensorModel(1e9, 1.0, adc_bits=16, shot_noise=True)
    light = torch.full((1, 1, 200, 200), 10000.0)
    shutters = torch.ones(1, 1, 1)
    generator = torch.Generator().manual_seed(3)
    frame = differentiable_capture(light, shutters, model, generator=generator).frame
    assert abs(frame.mean().item() - 10000) < 5 * 100 / 200
    # a variance of 40000 numbers is known to 0.7 %
    assert frame.var().item() == pytest.approx(10000, rel=0.035)
    again = differentiable_capture(
        light, shutters, model, generator=torch.Generator().manual_seed(3)
    ).frame
    assert torch.equal(frame, again)
    assert differentiable_capture(light, shutters, model).frame.var() == 0


def test_a_factor_of_noise_is_of_both_noises() -> None:
    """Variances of photons (n, in codes of an electron), readout, and rounding (1 / 12) add up."""
    light = torch.full((1, 1, 200, 200), 400.0)
    for factor in (1.0, 2.0, 3.0):
        for shot, readout in ((True, 0.0), (False, 7.0), (True, 7.0)):
            model = SensorModel(
                1e9, 1.0, adc_bits=16, adc_noise_lsb=readout, shot_noise=shot, noise_factor=factor
            )
            generator = torch.Generator().manual_seed(4)
            frame = differentiable_capture(
                light, torch.ones(1, 1, 1), model, generator=generator
            ).frame.double()
            wanted = factor**2 * (400.0 * shot + readout**2) + 1 / 12
            # a variance of 40000 numbers is known to 0.7 %, a mean to a 200th of the spread
            assert frame.var().item() == pytest.approx(wanted, rel=0.03)
            assert abs(frame.mean().item() - 400) < 5 * wanted**0.5 / 200
            assert differentiable_capture(light, torch.ones(1, 1, 1), model).frame.var() == 0
            still = model.noiseless()
            generator = torch.Generator().manual_seed(4)
            assert (
                differentiable_capture(
                    light, torch.ones(1, 1, 1), still, generator=generator
                ).frame.var()
                == 0
            )


def test_gradients_of_exposing_and_lifting_equal_finite_differences() -> None:
    """The gradients by light and by soft shutters, for clips and stills, pass torch's gradcheck in
    float64. Shutters of another number of slots raise."""
    generator = torch.Generator().manual_seed(1)
    light = torch.rand(2, 3, 4, 6, generator=generator, dtype=torch.float64, requires_grad=True)
    still = torch.rand(2, 4, 6, generator=generator, dtype=torch.float64, requires_grad=True)
    soft = torch.rand(3, 2, 3, generator=generator, dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(exposed, (light, soft))
    assert torch.autograd.gradcheck(exposed, (still, soft))
    assert torch.autograd.gradcheck(lambda e, s: lifted(e, s)[0], (still, soft))
    with pytest.raises(ValueError, match="slots"):
        exposed(light, soft[:2])


def test_gradients_of_the_whole_capture_equal_finite_differences() -> None:
    """Soft shutters, unrounded readout: finite differences agree in float64."""
    encoder = make_encoder(ShutterSpec("d", 6, (2, 2)), "random", 1, "sigmoid")
    light = torch.rand(2, 6, 4, 4, dtype=torch.float64) * 100

    def exposures(start: torch.Tensor, stop: torch.Tensor) -> torch.Tensor:
        fields = torch.stack([start, stop])
        begin, end = encoder.edges(fields)
        middle = torch.arange(6, dtype=torch.float64).reshape(-1, 1, 1) + 0.5
        soft = torch.sigmoid(middle - begin) * torch.sigmoid(end - middle)
        return (light * laid(soft, 4, 4)).sum(dim=1)

    start = torch.tensor([[0.3, 1.2], [2.1, 0.7]], dtype=torch.float64, requires_grad=True)
    stop = torch.tensor([[3.3, 4.2], [5.1, 2.7]], dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(exposures, (start, stop))


@pytest.mark.parametrize(
    ("light", "shutters", "share"),
    [
        ((8, 8), (8, 2, 2), None),
        ((1, 1, 8, 8, 8), (8, 2, 2), None),
        ((1, 7, 8, 8), (8, 2, 2), None),
        ((1, 8, 8, 8), (8, 2), None),
        ((1, 8, 8, 8), (1, 1, 8, 2, 2), None),
        ((1, 8, 8, 8), (8, 0, 2), None),
        ((1, 8, 8), (8, 2, 2), 1),
        ((1, 8, 8), (8, 2, 2), 7),
        ((1, 8, 8, 8), (8, 2, 2), 8),
    ],
)
def test_other_shapes_are_refused_and_not_broadcast(
    light: tuple[int, ...], shutters: tuple[int, ...], share: int | None
) -> None:
    weights = None if share is None else torch.ones(share)
    with pytest.raises(ValueError, match=r"light|shutters|slots"):
        differentiable_capture(
            torch.ones(light),
            torch.ones(shutters),
            SensorModel(30000.0, 30000.0 / 255),
            slot_share=weights,
        )


MODEL = SensorModel(30000.0, 30000.0 / 255)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: SensorModel(0.0, 1.0), "full_well_e must be finite and above 0"),
        (
            lambda: SensorModel(1.0, 1.0, adc_noise_lsb=-1),
            "must be finite and not below 0",
        ),
        (lambda: SensorModel(1.0, 1.0, adc_bits=0), "adc_bits is a whole number from 1"),
        (lambda: SensorModel.of(None, None), "sensor of type Sensor, not None"),
        (
            lambda: differentiable_capture(np.ones((1, 2, 2)), torch.ones(8, 2, 2), MODEL),
            r"light of type Tensor, not an array \(1, 2, 2\)",
        ),
        (
            lambda: differentiable_capture(torch.ones(1, 2, 2), np.ones((8, 2, 2)), MODEL),
            "codes of type Tensor, not an array",
        ),
        (
            lambda: differentiable_capture(torch.ones(1, 2, 2), torch.ones(8, 2, 2), None),
            "sensor of type SensorModel, not None",
        ),
        (lambda: lifted(torch.ones(1, 8, 2, 2), torch.ones(8, 2, 2)), "exposure has three axes"),
    ],
)
def test_arguments_of_other_types_are_refused(call: Any, words: str) -> None:
    with pytest.raises(WrongArgument, match=words):
        call()
