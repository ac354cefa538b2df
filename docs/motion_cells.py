"""Train cells that tell the direction of motion, and print the tables of docs/networks.md.

    python docs/motion_cells.py [direction]

The files and the figures of each cell are stored in build/cells; stored figures are not computed
again. Without an argument, prints a table of all cells, else the accuracies of one."""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn.functional import cross_entropy

from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.files import write_together
from nscc.shutter_program import ShutterProgram
from nscc_runtime.progress import Progress, unseen
from nscc_training.cell_programs import (
    CellFiles,
    cell_files,
    cell_film,
    compiled_cell,
    level_on_chip,
)
from nscc_training.cells import CellNoise, PixelCell, Update, set_moving_edges
from nscc_training.draws import generator_of
from nscc_training.made_scenes import DIRECTIONS, moving_texture
from nscc_training.motion_cells import DECODER, STATE, LinearDecoder

PROGRAM, KERNELS = "direction.nsl", "direction.kernels.npz"
FOLDER = Path(__file__).resolve().parents[1] / "build/cells"
CELLS: dict[str, dict[str, Any]] = {
    "direction": {},
    "kernel_5": {"kernel": 5},
    "outputs_1": {"outputs": 1},
    "outputs_2": {"outputs": 2},
    "noise_0": {"noise": 0.0},
    "noise_2": {"noise": 2.0},
}
"""Settings of the cells of the table, where they differ from the defaults."""
ACCURACIES = {
    "real": "real weights, torch",
    "binary": "binary, torch",
    "noisy": "binary, torch with noise",
    "exact": "emulated, no effects",
    "effects": "emulated, every effect",
    "tuned": "the same, decoder fitted to emulated films",
}
COLUMNS = {
    "kernel": "kernel",
    "outputs": "outputs",
    "noise": "noise",
    "words": "words",
    "us": "us",
    "bits_per_frame": "bits",
    "binary": "binary",
    "effects": "effects",
    "tuned": "tuned",
}
_RATE = 0.02
_BLOCK = 32
"""Number of films that torch computes at once."""


class CellStream(IntEnum):
    """The second number of the seeds of cells."""

    TRAINING_FILMS = 0
    TEST_FILMS = 1
    BATCHES = 2
    NOISE = 3


@dataclass(frozen=True)
class MotionSettings:
    """The settings of a cell, its films and its training.

    `kernel` to `update` are arguments of `PixelCell`. Films have `frames` frames of `size` x `size`
    pixels, and show textures that move by `speed` pixels per frame in one of eight directions.
    `noise` is a factor on the noise during training; 0 trains without noise. `films` are for
    training, `test_films` for the accuracies; the first `tuned_films` training films are emulated
    to fit the decoder `tuned`. `real_steps` are training steps with real weights, `binary_steps`
    with binary weights, each with `batch` films."""

    kernel: int = 3
    states: int = 1
    outputs: int = 3
    pool: int = 5
    update: Update = "replace"
    size: int = 32
    frames: int = 8
    speed: float = 1.5
    noise: float = 1.0
    films: int = 192
    tuned_films: int = 64
    test_films: int = 80
    real_steps: int = 40
    binary_steps: int = 80
    batch: int = 16
    target: str = "scamp5"
    seed: int = 0


def accuracy(decoder: LinearDecoder, shares: Tensor, directions: Tensor) -> float:
    """Return the share of right directions, given `shares` (films, outputs)."""
    scores = shares @ torch.from_numpy(decoder.weight).T + torch.from_numpy(decoder.bias)
    return float((scores.argmax(1) == directions).float().mean())


@dataclass(frozen=True)
class MotionCell:
    """A trained cell, its program, its decoder `tuned`, and accuracies on test films.

    Attributes
    ----------
    accuracies : dict
        Fractions of correct directions. `real`: real weights and tanh. `binary`: the cell in torch
        without noise. `noisy`: in torch with `noise`. `exact`: emulated without effects, with the
        decoder of `binary`. `effects`: emulated with every effect, with the decoder of `noisy`.
        `tuned`: as `effects`, but with a decoder that was fitted to emulated films.
    different_bits : int
        Number of bits of the test films in which `exact` differs from `binary`.
    """

    cell: PixelCell
    program: ShutterProgram
    files: CellFiles
    decoder: LinearDecoder
    noise: CellNoise
    accuracies: dict[str, float]
    different_bits: int

    @property
    def bits_per_frame(self) -> int:
        """The number of bits of a frame that the decoder uses."""
        target = self.program.container.target
        pool = self.cell.pool
        return self.cell.outputs * (target.rows // pool) * (target.cols // pool)

    @property
    def full_frame_bits(self) -> int:
        """The number of bits of a full frame of converter codes."""
        target = self.program.container.target
        return target.rows * target.cols * target.code_bits


def motion_films(settings: MotionSettings, count: int, stream: CellStream) -> tuple[Tensor, Tensor]:
    """Return films (count, frames, size, size) in full wells, and their directions."""
    generator = np.random.default_rng([settings.seed, stream])
    directions = np.arange(count) % len(DIRECTIONS)
    light = np.stack(
        [
            moving_texture(generator, settings.frames, settings.size, DIRECTIONS[k], settings.speed)
            for k in directions
        ]
    )
    return torch.from_numpy(light), torch.from_numpy(directions)


def train_motion_cell(settings: MotionSettings, track: Progress = unseen) -> MotionCell:
    """Train a cell, compile it, and measure it in torch and in the emulator.

    The cell is first trained with real weights, then with their signs and the noise of its compiled
    program. Decoders are fitted to the fractions of 1 bits of training films. Raises Rejected if
    the cell does not fit the chip."""
    target = replace(load_target(settings.target, Path()), rows=settings.size, cols=settings.size)
    torch.manual_seed(settings.seed)
    cell = PixelCell(
        kernel=settings.kernel,
        states=settings.states,
        outputs=settings.outputs,
        pool=settings.pool,
        update=settings.update,
        level=level_on_chip(0.5, target),
    )
    set_moving_edges(cell)
    films, directions = motion_films(settings, settings.films, CellStream.TRAINING_FILMS)
    test_films, test_directions = motion_films(settings, settings.test_films, CellStream.TEST_FILMS)
    # The noise follows from the size of a cell: the program of the untrained cell gives it.
    noise = CellNoise.of(_program(cell, target)[0])
    trained_noise = CellNoise(noise.exposure * settings.noise, noise.count * settings.noise)
    accuracies: dict[str, float] = {}
    fitted: dict[str, LinearDecoder] = {}

    def measure(name: str, shares: Callable[[Tensor], Tensor], decoder: str = "") -> None:
        fitted[name] = fitted.get(decoder) or fit_decoder(shares(films), directions)
        accuracies[name] = accuracy(fitted[name], shares(test_films), test_directions)

    cell.is_binary = False
    _train(cell, settings, films, directions, settings.real_steps, None)
    measure("real", lambda light: _shares(cell, light, None, settings.seed))
    cell.is_binary = True
    _train(cell, settings, films, directions, settings.binary_steps, trained_noise)
    measure("binary", lambda light: _shares(cell, light, None, settings.seed))
    measure("noisy", lambda light: _shares(cell, light, noise, settings.seed))
    program, files = _program(cell, target)

    emulated = partial(_emulated, cell, program, files, settings.seed, track)
    exact = emulated(test_films, "none")
    in_torch = torch.cat([cell.film(part).detach() > 0 for part in torch.split(test_films, _BLOCK)])
    accuracies["exact"] = accuracy(fitted["binary"], _means(exact), test_directions)
    with_effects = _means(emulated(test_films, "all"))
    accuracies["effects"] = accuracy(fitted["noisy"], with_effects, test_directions)
    count = settings.tuned_films
    tuned = fit_decoder(_means(emulated(films[:count], "all")), directions[:count])
    accuracies["tuned"] = accuracy(tuned, with_effects, test_directions)
    return MotionCell(
        cell, program, files, tuned, noise, accuracies, int((exact != in_torch).sum())
    )


def motion_cell_files(trained: MotionCell) -> dict[str, bytes]:
    """Return a trained cell's files: program, kernels, decoder, state dict."""
    from safetensors.numpy import save

    state = io.BytesIO()
    torch.save(trained.cell.state_dict(), state)
    decoder = {"weight": trained.decoder.weight, "bias": trained.decoder.bias}
    return {
        PROGRAM: trained.files.text.encode(),
        KERNELS: trained.files.kernels,
        DECODER: save(decoder),
        STATE: state.getvalue(),
    }


def fit_decoder(shares: Tensor, directions: Tensor) -> LinearDecoder:
    """Fit a linear decoder of `shares` (films, outputs) to directions (films,) by logistic
    regression."""
    mean, spread = shares.mean(0), shares.std(0).clamp(min=1e-6)
    inputs = (shares - mean) / spread
    layer = nn.Linear(shares.shape[1], len(DIRECTIONS))
    nn.init.zeros_(layer.weight)
    nn.init.zeros_(layer.bias)
    optimizer = torch.optim.LBFGS(layer.parameters(), max_iter=200, line_search_fn="strong_wolfe")

    def loss() -> float:
        optimizer.zero_grad()
        value = cross_entropy(layer(inputs), directions) + 1e-4 * layer.weight.square().sum()
        value.backward()  # type: ignore[no-untyped-call]
        return float(value.detach())

    optimizer.step(loss)  # type: ignore[no-untyped-call]
    weight = (layer.weight / spread).detach()
    bias = layer.bias.detach() - weight @ mean
    return LinearDecoder(weight.numpy(), bias.numpy())


def _program(cell: PixelCell, target: Target) -> tuple[ShutterProgram, CellFiles]:
    remark = "The direction of motion: a recurrent cell of bits, trained by nscc."
    files = cell_files(cell, KERNELS, remark=remark)
    return compiled_cell(files, KERNELS, target), files


def _emulated(
    cell: PixelCell,
    program: ShutterProgram,
    files: CellFiles,
    seed: int,
    track: Progress,
    light: Tensor,
    effects: str,
) -> Tensor:
    """Return the bits of emulated films (films, frames, outputs, rows, cols)."""
    return torch.stack(
        [
            torch.from_numpy(
                cell_film(
                    program, cell, film.numpy(), files.planes, effects=effects, seed=seed + number
                )
            )
            for number, film in enumerate(track(light, f"films, effects: {effects}", len(light)))
        ]
    )


def _means(bits: Tensor) -> Tensor:
    """Return the fraction of 1 bits (films, outputs) of (films, frames, outputs, rows, cols)."""
    return bits.float().mean((1, 3, 4))


def _shares(cell: PixelCell, light: Tensor, noise: CellNoise | None, seed: int) -> Tensor:
    """Return the fraction of 1 bits (films, outputs) of films computed in torch."""
    generator = generator_of(light.device, seed, CellStream.NOISE)
    with torch.no_grad():
        return torch.cat(
            [
                (cell.film(part, noise=noise, generator=generator).mean((1, 3, 4)) + 1) / 2
                for part in torch.split(light, _BLOCK)
            ]
        )


def _train(
    cell: PixelCell,
    settings: MotionSettings,
    films: Tensor,
    directions: Tensor,
    steps: int,
    noise: CellNoise | None,
) -> None:
    """Train a cell together with a linear decoder, which is then discarded."""
    generator = generator_of(films.device, settings.seed, CellStream.BATCHES, steps)
    decoder = nn.Sequential(
        nn.BatchNorm1d(cell.outputs, affine=False), nn.Linear(cell.outputs, len(DIRECTIONS))
    )
    # A small rate limits the number of signs that change in one step.
    rate = _RATE / 4 if cell.is_binary else _RATE
    rates = [rate, 5 * rate, 0.05]
    learned = ([cell.weight], [cell.threshold], [*decoder.parameters()])
    optimizer = torch.optim.Adam([{"params": parameters} for parameters in learned])
    schedule = torch.optim.lr_scheduler.OneCycleLR(
        optimizer, rates, total_steps=max(steps, 2), pct_start=0.1
    )
    for _ in range(steps):
        chosen = torch.randint(len(films), (settings.batch,), generator=generator)
        bits = cell.film(films[chosen], noise=noise, generator=generator)
        loss = cross_entropy(decoder(bits.mean((1, 3, 4))), directions[chosen])
        optimizer.zero_grad()
        loss.backward()  # type: ignore[no-untyped-call]
        optimizer.step()
        schedule.step()


def figures_of(name: str) -> dict[str, Any]:
    """Return settings and figures of a cell of the table; train it unless they are stored."""
    folder, settings = FOLDER / name, replace(MotionSettings(), **CELLS[name])
    stored = folder / "figures.json"
    if not stored.is_file():
        folder.mkdir(parents=True, exist_ok=True)
        trained = train_motion_cell(settings)
        report = trained.program.report
        figures = {
            **trained.accuracies,
            "different_bits": trained.different_bits,
            "words": report["images_words_total"],
            "us": report["images_us"],
            "bits_per_frame": trained.bits_per_frame,
            "full_frame_bits": trained.full_frame_bits,
        }
        products = {folder / name: data for name, data in motion_cell_files(trained).items()}
        write_together({**products, stored: json.dumps(figures).encode()})
    return {**vars(settings), **json.loads(stored.read_text())}


def accuracies_text(figures: Mapping[str, Any]) -> str:
    """Return the accuracies, words and bits of one cell as text."""
    bits, full = figures["bits_per_frame"], figures["full_frame_bits"]
    rows = {
        "bits that differ, emulated without effects": str(figures["different_bits"]),
        "words of a frame": f"{figures['words']}, {figures['us']:.0f} us",
        "bits that are read out of a frame": f"{bits}, 1/{full / bits:.0f} of a full frame",
    }
    lines = [f"{text:<44}{100 * figures[name]:6.1f} %" for name, text in ACCURACIES.items()]
    lines += [
        f"{text:<44}{' ' * (6 - len(value.split(',')[0]))}{value}" for text, value in rows.items()
    ]
    return "\n".join(lines)


def table(cells: list[Mapping[str, Any]]) -> str:
    """Return a table with a line for each cell."""
    lines = ["".join(f"{title:>9}" for title in COLUMNS.values())]
    for figures in cells:
        texts = (
            f"{100 * figures[name]:.1f} %" if name in ACCURACIES else f"{round(figures[name], 1):g}"
            for name in COLUMNS
        )
        lines.append("".join(f"{text:>9}" for text in texts))
    return "\n".join(lines)


if __name__ == "__main__":
    chosen = sys.argv[1:]
    found = [figures_of(name) for name in chosen or CELLS]
    print(accuracies_text(found[0]) if chosen else table(found))
