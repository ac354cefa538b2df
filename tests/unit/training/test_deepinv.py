"""Shutters as an operator of DeepInverse: against the emulator, and by deepinv's own tests."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from cpu_torchvision import declare_operators  # noqa: E402

declare_operators()
pytest.importorskip("deepinv")

import nscc  # noqa: E402
import nscc_runtime  # noqa: E402
from nscc.chips.load import builtin_target  # noqa: E402
from nscc_training import SensorModel, ShutterSpec, make_encoder  # noqa: E402
from nscc_training.deepinv import PixelShutters, SensorNoise  # noqa: E402

ROWS, COLS = 12, 10
TARGET = replace(builtin_target("scamp5"), rows=ROWS, cols=COLS)
TEXTS = {
    "clip": "frame 8 slots of 1ms\ncode stop : 1..8\nopen when n < stop\n"
    "pixels stop = 1 + (x + 3 * y) % 8\n",
    "still": "frame slots [1ms, 2ms, 4ms]\ncode stop : 1..3\nopen when n < stop\n"
    "pixels stop = 1 + (x + y) % 3\n",
    "buckets": "frame 6 slots of 1ms\ncode split : 1..5\nbucket early open when n < split\n"
    "bucket late open when n >= split - 1\npixels split = 1 + (x + y) % 5\n",
}


def program(kind: str) -> nscc.ShutterProgram:
    return nscc.compile("nsl 1\n" + TEXTS[kind], target=TARGET, level=1)


def physics(kind: str, **options: Any) -> PixelShutters:
    if kind == "encoder":
        encoder = make_encoder(ShutterSpec("d", 8, (4, 4)), "random", seed=3)
        return PixelShutters(encoder, size=(ROWS, COLS), **options)
    return PixelShutters(program(kind), still=kind == "still", **options)


def light(kind: str, batch: int = 2) -> torch.Tensor:
    shape = physics(kind).img_size
    return 500 * torch.rand(batch, *shape, generator=torch.Generator().manual_seed(1))


@pytest.mark.parametrize("kind", TEXTS)
def test_the_physics_equals_the_emulator(kind: str) -> None:
    """For a clip, a still and others of `TEXTS`, the operator's measurement is the exposure of the
    emulator, to 1e-5."""
    x, p = light(kind), program(kind)
    y = physics(kind).A(x)
    assert y.shape == (2, len(p.buckets), ROWS, COLS)
    for scene, found in zip(x, y, strict=True):
        values = scene[0].numpy()
        if kind == "still":  # the emulator takes electrons a second
            values = values / (sum(p.slot_us) * 1e-6)
        taken = nscc_runtime.capture(p, values)
        np.testing.assert_allclose(found.numpy(), taken.exposure_e, rtol=1e-5)


@pytest.mark.parametrize("kind", [*TEXTS, "encoder"])
def test_inverse_and_proximal_step_are_the_matrix_ones(kind: str) -> None:
    """The expected values come from dense matrices of single pixels, in float64."""
    operator = physics(kind).double()
    x = light(kind, 1).double()
    y = operator.A(x)
    slots = 1 if kind == "still" else x.shape[2]
    columns = []
    for n in range(slots):
        unit = torch.zeros_like(x)
        unit[(0, 0) if kind == "still" else (0, 0, n)] = 1.0
        columns.append(operator.A(unit)[0])
    matrix = torch.stack(columns, dim=-1).permute(1, 2, 0, 3)  # rows, cols, buckets, slots
    pixels = y[0].permute(1, 2, 0)[..., None]
    expected = (torch.linalg.pinv(matrix) @ pixels)[..., 0].permute(2, 0, 1)
    found = operator.A_dagger(y)
    torch.testing.assert_close(found.reshape(expected.shape), expected)
    z = torch.full_like(x, 7.0)
    gamma = 0.3
    left = gamma * matrix.mT @ matrix + torch.eye(slots).double()
    wanted = torch.linalg.solve(left, gamma * matrix.mT @ pixels + 7.0)[..., 0].permute(2, 0, 1)
    torch.testing.assert_close(operator.prox_l2(z, y, gamma).reshape(wanted.shape), wanted)


def test_gradients_reach_the_codes() -> None:
    """The operator's parameters are those of its encoder. Each has a gradient that is not 0."""
    encoder = make_encoder(ShutterSpec("d", 8, (4, 4)), "random", seed=3)
    operator = PixelShutters(encoder, size=(ROWS, COLS))
    operator.A(light("encoder")).square().mean().backward()
    grads = [parameter.grad for parameter in encoder.parameters()]
    assert grads
    assert all(grad is not None and grad.abs().sum() > 0 for grad in grads)
    assert {name for name, _ in operator.named_parameters()} == {
        f"encoder.{name}" for name, _ in encoder.named_parameters()
    }


def test_the_noise_has_the_mean_and_variance_of_the_sensor() -> None:
    """Mean and variance of grey pixels, whole codes, and the end of the scale."""
    model = SensorModel(30000.0, 100.0, adc_noise_lsb=2.0, shot_noise=True)
    noise = SensorNoise(model, torch.Generator().manual_seed(4))
    found = noise(torch.full((1, 1, 300, 300), 12345.0, dtype=torch.float64))
    assert torch.equal(found, (found / 100).round() * 100)
    assert found.mean() == pytest.approx(12345.0, abs=4 * 230 / 300)
    # Photons, the converter's 2 codes of 100 electrons, and rounding to codes.
    variance = 12345.0 + 200.0**2 + 100.0**2 / 12
    assert found.var() == pytest.approx(variance, rel=4 * np.sqrt(2 / 90000))
    # The last code, 255, of 100 electrons each.
    assert noise(torch.full((1, 1, 4, 4), 1e6)).max() == 25500.0
    assert torch.equal(noise(found, seed=9), noise(found, seed=9))


def test_the_sensor_is_that_of_the_program() -> None:
    """`SensorNoise.of` takes the program's sensor with the changed full well. The same torch seed
    gives the same noise."""
    noise = SensorNoise.of(program("clip"), {"full_well_e": 20000.0})
    assert (noise.sensor.full_well_e, noise.sensor.shot_noise) == (20000.0, True)
    torch.manual_seed(5)
    first = physics("clip", noise_model=noise)(light("clip"))
    torch.manual_seed(5)
    assert torch.equal(first, physics("clip", noise_model=noise)(light("clip")))


@pytest.mark.parametrize("wrong", [np.ones((8, 4, 4)), "flutter.nsl", torch.ones(4, 4), None])
def test_invalid_shutters_are_refused(wrong: Any) -> None:
    """An array, a path, a tensor of two axes and None each give a TypeError that names what is
    allowed."""
    with pytest.raises(TypeError, match="PixelShutters takes a program, an Encoder or a tensor"):
        PixelShutters(wrong)


def test_light_of_another_shape_is_refused_with_both_shapes() -> None:
    with pytest.raises(TypeError, match=r"light \(batch, 1, 8, 12, 10\), not a Tensor \(2, 8, 12"):
        physics("clip").A(torch.ones(2, 8, ROWS, COLS))


THEIRS = (
    "test_operators_adjointness",
    "test_operators_norm",
    "test_pseudo_inverse",
    "test_concatenation",
    "test_operators_differentiability",
    "test_device_consistency",
    "test_physics_state_dict",
    "test_adjoint_autograd",
)
THEIRS_OF_PICTURES = ("test_operator_cropper", "test_operator_multiscale_wrapper")
"""Wrappers that pad and resize pictures of four dimensions: a clip has five."""
CASES = [
    *product(THEIRS, [*TEXTS, "encoder"]),
    *product(THEIRS_OF_PICTURES, ["still"]),
]


@pytest.fixture
def their_tests(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    """deepinv's tests of operators, with ours under its names; they leave files behind."""
    module = pytest.importorskip("deepinv.tests.test_physics")

    def find(name: str, device: str, imsize: Any = None, get_physics_param: bool = False) -> Any:
        operator = physics(name).requires_grad_(False)  # theirs take measurements for leaves
        if imsize is not None:
            operator = PixelShutters(operator.shutters, still=name == "still", size=imsize[-2:])
        x = torch.zeros(1, *operator.img_size)
        overlap = operator._overlap(x)
        norm = torch.linalg.eigvalsh(overlap).max()
        parameters = [] if name == "encoder" else ["shutters"]
        found = operator, operator.img_size, norm, torch.float
        return (*found, parameters) if get_physics_param else found

    monkeypatch.setattr(module, "find_operator", find)
    monkeypatch.setattr(module, "OPERATORS", [*TEXTS, "encoder"])
    monkeypatch.chdir(tmp_path)
    return module


@pytest.mark.filterwarnings("ignore:::deepinv", "ignore::UserWarning")
@pytest.mark.parametrize(("test", "kind"), CASES)
def test_the_tests_of_deepinverse_hold(test: str, kind: str, their_tests: Any) -> None:
    """The library's own tests of a physics (adjoint, pseudo-inverse and others) pass with our
    operator."""
    given = {
        "name": kind,
        "device": "cpu",
        "rng": torch.Generator().manual_seed(0),
        "verbose": False,
        "implicit_backward_solver": True,
    }
    run = getattr(their_tests, test)
    wanted = run.__code__.co_varnames[: run.__code__.co_argcount]
    run(**{name: given[name] for name in wanted})
