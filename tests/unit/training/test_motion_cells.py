"""Cells that tell the direction of motion: the shipped one, decoders, and training."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from checkout import ROOT

from motion_cells import (
    MotionSettings,
    accuracy,
    fit_decoder,
    motion_cell_files,
    motion_films,
    train_motion_cell,
)
from nscc.chips.load import load_target
from nscc_training.cell_programs import cell_files, cell_film, compiled_cell
from nscc_training.made_scenes import DIRECTIONS
from nscc_training.motion_cells import shipped_cell

EXAMPLE = ROOT / "examples" / "direction.nsl"


def test_the_example_is_the_shipped_cell() -> None:
    cell, _ = shipped_cell()
    text = EXAMPLE.read_text()
    assert text.endswith(cell_files(cell, None).text)
    assert text.startswith("# ")


def test_the_shipped_cell_tells_directions_with_every_effect() -> None:
    cell, decoder = shipped_cell()
    files = cell_files(cell, None)
    target = replace(load_target("scamp5", Path()), rows=32, cols=32)
    program = compiled_cell(files, target=target)
    films, directions = motion_films(MotionSettings(seed=77), 16, 0)
    told = [
        decoder.direction(cell_film(program, cell, film.numpy(), files.planes, effects="all"))
        for film in films
    ]
    right = [name == DIRECTIONS[k] for name, k in zip(told, directions, strict=True)]
    # Chance is 2 of 16.
    assert sum(right) >= 11, told


def test_a_linear_decoder_classifies_separable_patterns() -> None:
    angles = torch.arange(64) % 8 * (torch.pi / 4)
    shares = 0.5 + 0.3 * torch.stack([torch.cos(angles), torch.sin(angles)], 1)
    decoder = fit_decoder(shares, torch.arange(64) % 8)
    assert accuracy(decoder, shares, torch.arange(64) % 8) == 1
    bits = np.arange(1000).reshape(1, 1, 10, 100) < 1000 * shares[3].numpy()[:, None, None]
    assert decoder.direction(bits) == DIRECTIONS[3]


def test_training_ends_with_a_program_that_gives_the_bits_of_torch() -> None:
    settings = MotionSettings(
        outputs=2,
        pool=3,
        size=16,
        frames=3,
        films=16,
        tuned_films=8,
        test_films=8,
        real_steps=2,
        binary_steps=2,
        batch=8,
    )
    trained = train_motion_cell(settings)
    assert trained.different_bits == 0
    assert trained.accuracies["exact"] == trained.accuracies["binary"]
    assert (trained.bits_per_frame, trained.full_frame_bits) == (2 * 5 * 5, 16 * 16 * 8)
    assert motion_cell_files(trained) == motion_cell_files(train_motion_cell(settings))
