"""Cells of bits: PyTorch, a direct count, and the emulated words give the same bits."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from numpy.typing import NDArray

from nscc.chips.load import load_target
from nscc_runtime.exposing import film
from nscc_training.cell_programs import cell_files, cell_film, compiled_cell, level_on_chip
from nscc_training.cells import CellNoise, PixelCell, set_moving_edges

TARGET = replace(load_target("scamp5", Path()), rows=20, cols=24)
LEVEL = level_on_chip(0.5, TARGET)
KERNELS = "cell.kernels.npz"
CELLS: tuple[dict[str, Any], ...] = (
    {"kernel": 3},
    {"kernel": 3, "outputs": 3, "pool": 5, "update": "replace"},
    {"kernel": 5, "outside": 1, "outputs": 2},
    {"kernel": 3, "states": 2, "pool": 3, "update": "replace", "outside": 1},
)


def made(settings: dict[str, Any], seed: int) -> PixelCell:
    """A cell with random weights, some of them 0, and random thresholds."""
    torch.manual_seed(seed)
    cell = PixelCell(level=LEVEL, **settings)
    with torch.no_grad():
        cell.weight[torch.rand_like(cell.weight) < 0.1] = 0
        cell.threshold.normal_(0, 4)
    return cell


def counted(cell: PixelCell, exposure: NDArray[np.float32]) -> NDArray[np.bool_]:
    """The bits of a film, counted place by place, as `PixelCell` describes them."""
    weights, thresholds = cell.kernels().numpy(), cell.threshold.detach().numpy()
    reach, states = cell.kernel // 2, cell.states
    rows, cols = exposure.shape[1:]
    state = np.ones((states, rows, cols), int)
    outputs = []
    for frame in exposure:
        planes = np.concatenate([np.where(frame > LEVEL, 1, -1)[None], state])
        beyond = 1 if cell.outside else -1
        wide = np.pad(planes, ((0, 0), (reach, reach), (reach, reach)), constant_values=beyond)
        counts = np.zeros((len(weights), rows, cols), int)
        for gate, plane, i, j in np.ndindex(weights.shape):
            counts[gate] += weights[gate, plane, i, j] * wide[plane, i : i + rows, j : j + cols]
        # Whatever the threshold, some count is above it and some count is not.
        places = np.abs(weights).sum((1, 2, 3))
        limits = np.clip(thresholds, -places, places - 1)
        gates = np.where(counts > limits[:, None, None], 1, -1)
        state = state * gates[:states] if cell.update == "flip" else gates[:states]
        side = cell.pool
        kept = gates[states:, : rows // side * side, : cols // side * side]
        squares = kept.reshape(len(kept), rows // side, side, cols // side, side)
        outputs.append(squares.max((2, 4)) > 0)
    return np.stack(outputs)


def compare(cell: PixelCell, exposure: NDArray[np.float32]) -> None:
    """All three give the same bits."""
    with torch.no_grad():
        in_torch = cell.film(torch.from_numpy(exposure)[None])[0].numpy() > 0
    np.testing.assert_array_equal(in_torch, counted(cell, exposure))
    files = cell_files(cell, KERNELS)
    program = compiled_cell(files, KERNELS, TARGET)
    np.testing.assert_array_equal(cell_film(program, cell, exposure, files.planes), in_torch)


@pytest.mark.parametrize("number", range(len(CELLS)))
def test_emulated_words_give_the_bits_of_torch(number: int) -> None:
    """For nine random frames, the program's words on the emulator give each output bit of the torch
    cell."""
    exposure = np.random.default_rng(number).random((9, TARGET.rows, TARGET.cols), np.float32)
    compare(made(CELLS[number], number), exposure)


@pytest.mark.slow
def test_cells_on_the_chip_equal_cells_in_torch_for_a_thousand_frames() -> None:
    generator = np.random.default_rng(45)
    for number in range(100):
        kernel = int(generator.choice([3, 3, 5, 7]))
        # IN has no step for a count of two states and 7 x 7 weights.
        states = int(generator.choice([1, 2])) if kernel < 7 else 1
        fits_store = (states + 2) * (1 + states) * kernel**2 <= 250  # weights of two outputs
        settings = {
            "kernel": kernel,
            "outside": int(generator.integers(2)),
            "update": ("flip", "replace")[number % 2],
            "pool": int(generator.choice([1, 3, 5])),
            "states": states,
            "outputs": int(generator.choice([1, 2])) if fits_store else 1,
        }
        share = generator.uniform(0.2, 0.8)  # films are darker or brighter
        light = generator.random((10, TARGET.rows, TARGET.cols), np.float32)
        compare(made(settings, number), light ** np.float32(np.log(0.5) / np.log(share)))


def test_the_same_cell_gives_the_same_bytes() -> None:
    """A cell compiled twice gives equal files. A binary state is written as `bit = 1 kept`, and
    weights as `agree`."""
    first, second = (cell_files(made(CELLS[3], 3), KERNELS) for _ in range(2))
    assert (first.text, first.kernels) == (second.text, second.kernels)
    assert "state h1 : bit = 1 kept" in first.text
    assert "agree(h2, uf1_h2)" in first.text


def test_cells_refuse_settings_that_no_program_can_have() -> None:
    for settings, text in (
        ({"kernel": 4}, "kernel is 4, but must be an odd number from 3 to 9"),
        ({"pool": 2}, "pool is 2"),
        ({"states": 3}, "states is 3"),
        ({"outside": 2}, "outside is 2"),
        ({"outputs": 0}, "outputs is 0"),
        ({"level": 1.0}, "level is 1"),
        ({"update": "x"}, "'x'"),
    ):
        with pytest.raises(ValueError, match=text):
            PixelCell(**settings)  # type: ignore[arg-type]


def test_settings_are_part_of_the_state_dict() -> None:
    cell = PixelCell()
    cell.load_state_dict(PixelCell(pool=5, update="replace", outside=1, level=0.25).state_dict())
    assert (cell.pool, cell.update, int(cell.outside), float(cell.level)) == (5, "replace", 1, 0.25)


@pytest.mark.parametrize("is_binary", [True, False])
def test_gradients_reach_all_parameters(is_binary: bool) -> None:
    """Each output's weights and thresholds have a gradient that is not 0, with binary weights and
    without."""
    torch.manual_seed(0)
    cell = PixelCell(outputs=2, pool=3, update="replace")
    cell.is_binary = is_binary
    bits = cell.film(torch.rand(2, 4, 12, 12))
    (bits * torch.randn_like(bits)).sum().backward()
    for parameter in (cell.weight, cell.threshold):
        assert parameter.grad is not None
        assert (
            (parameter.grad.flatten(1).abs().sum(1) > 0).all()
            if parameter.ndim > 1
            else (parameter.grad != 0).all()
        )


def test_moving_edges_prefer_their_direction() -> None:
    cell = PixelCell(outputs=4, update="replace")
    set_moving_edges(cell)
    places = np.arange(40)
    shares = []
    for speed in (1, -1):
        frames = [
            np.tile(((places - speed * n) // 5 % 2).astype(np.float32), (40, 1)) for n in range(8)
        ]
        with torch.no_grad():
            bits = cell.film(torch.from_numpy(np.stack(frames))[None])[0, 2:] > 0
        shares.append(bits.float().mean((0, 2, 3)))
    right, left = shares
    assert right[0] > 2 * left[0]  # the first output: motion to the right
    assert left[2] > 2 * right[2]  # the third one: to the left


def test_noise_of_training_is_that_of_the_emulator() -> None:
    target = replace(TARGET, rows=48, cols=48)
    torch.manual_seed(0)
    cell = PixelCell(kernel=3, update="replace", level=LEVEL)
    files = cell_files(cell, KERNELS)
    files = files._replace(text=files.text.replace("read b", "read b, o"))
    program = compiled_cell(files, KERNELS, target)
    light = np.random.default_rng(0).integers(0, 2, (1, 48, 48)).astype(np.float32) * 28_000
    sensor = {
        "comparator_noise_fraction": 0.0,
        "comparator_offset_fraction": 0.0,
        "analog_pattern_lsb": 0.0,
        "analog_gain": 1.0,
    }
    exact, noisy = (
        film(program, [light], effects=effects, sensor=sensor) for effects in ("none", "analog")
    )
    unit_e = program.container.pictures.count_steps * target.electrons_per_step
    counts, errors = (values.images["o"].ravel() / unit_e for values in (exact, noisy))
    spread = (errors - np.polyval(np.polyfit(counts, errors, 1), counts)).std()
    comparators = CellNoise.of(program).exposure * target.full_well_e / unit_e
    words = np.sqrt(CellNoise.of(program).count ** 2 - comparators**2)
    assert 0.85 * words < spread < 1.1 * words
