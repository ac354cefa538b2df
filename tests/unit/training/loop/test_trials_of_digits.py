"""Digits and choices learned by trial, against all codes of small problems, one by one."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from math import prod, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from marks import slow
from nscc_command import invoke
from numpy.typing import NDArray
from scipy.stats import norm
from training_oracle import shutters_of

torch = pytest.importorskip("torch")

from safetensors.torch import load_file  # noqa: E402
from trial_problems import (  # noqa: E402
    CPU,
    Alone,
    Share,
    batch_of,
    open_share,
    parts_of,
    tried_gradients,
)

from nscc_training.draws import generator_of  # noqa: E402
from nscc_training.encoders.base import decided  # noqa: E402
from nscc_training.loop.setup import TrainingSetup  # noqa: E402
from nscc_training.loop.steps import (  # noqa: E402
    decoded,
    pull,
    trial_of,
)
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

SHAPE = (1, 2)
"""Of the patches whose codes are all counted out."""
Law = dict[tuple[int, ...], float]
"""Chances of the shutters of one pixel."""


class Mixed(torch.nn.Module):
    """Every pixel's prediction hangs on all digits of all pixels, crookedly."""

    def __init__(self, digits: int) -> None:
        super().__init__()
        rng = np.random.default_rng(4)
        self.weights = rng.normal(0, 1, (digits, digits, SHAPE[1])) / digits

    def predicted(self, digits: NDArray[np.float64]) -> NDArray[np.float64]:
        """(pixels,) of digits (N, pixels)."""
        flat = digits.reshape(-1)
        return np.asarray(0.5 + np.einsum("i,j,ijp->p", flat, flat, self.weights))

    def forward(self, frame: Any, shutters: Any) -> Any:
        made = self.predicted(shutters.reshape(len(shutters), -1).double().numpy())
        return torch.from_numpy(made).reshape(1, *SHAPE)


def law_of_bits(logits: NDArray[np.float64], spread: float) -> Law:
    """Independent digits, each 1 with the chance that noise leaves it above 0."""
    chance = norm.cdf(logits / spread)
    return {
        bits: prod(p if bit else 1 - p for bit, p in zip(bits, chance, strict=True))
        for bits in product((0, 1), repeat=len(logits))
    }


def law_of_choice(
    shapes: NDArray[np.float64], scores: NDArray[np.float64], spread: float, own: int
) -> Law:
    """A pixel's own shape with digits tried, or another one as it is."""
    found: Law = dict.fromkeys(product((0, 1), repeat=shapes.shape[1]), 0.0)
    others = [k for k in range(len(shapes)) if k != own]
    for k in others:
        stay = norm.cdf((scores[own] - scores[k]) / (sqrt(2) * spread)) / len(others)
        for bits, p in law_of_bits(shapes[own], spread).items():
            found[bits] += stay * p
        found[tuple(int(x > 0) for x in shapes[k])] += 1 / len(others) - stay
    return found


def mean_loss(
    parts: TrainingSetup, truth: NDArray[np.float64], laws: list[Law], words: float
) -> float:
    """The loss in the mean over all codes of all pixels; squares, and changes between slots."""
    total = 0.0
    for chosen in product(*(law.items() for law in laws)):
        digits = np.array([bits for bits, _ in chosen], float).T
        loss = float(np.mean((parts.decoder.predicted(digits) - truth) ** 2))
        loss += words * float(np.mean(np.abs(np.diff(digits, axis=0))))
        total += loss * prod(p for _, p in chosen)
    return total


def slopes(at: Any, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The gradient of at(values) by differences."""
    found = np.zeros_like(values)
    for place in np.ndindex(values.shape):
        ends = []
        for sign in (1, -1):
            moved = values.copy()
            moved[place] += sign * 1e-4
            ends.append(at(moved))
        found[place] = (ends[0] - ends[1]) / 2e-4
    return found


def check(found: NDArray[np.float64], wanted: NDArray[np.float64], seen: int) -> None:
    """Means of trials are what is wanted within their errors, and `seen` of them above those."""
    error = found.std(axis=0, ddof=1) / np.sqrt(len(found))
    away = (found.mean(axis=0) - wanted) / error
    assert np.abs(away).max() < 4
    assert np.sqrt(np.mean(away**2)) < 1.6
    assert int((np.abs(wanted) > 5 * error).sum()) >= seen


@pytest.mark.parametrize(
    ("tile", "noise", "words"), [slow((1, 2), 0.4, 0.0), ((1, 2), 1.0, 0.5), slow((1, 1), 0.1, 0.5)]
)
def test_bits_follow_the_slope_of_the_mean_over_all_codes(
    tile: tuple[int, int], noise: float, words: float
) -> None:
    """Pixels of one place try codes of their own; a noise of 0.1 is a quarter at least."""
    parts = parts_of(Mixed(6), slots=3, tile=list(tile), words_weight=words, **{"class": "e"})
    rng = np.random.default_rng(8)
    logits = rng.uniform(-0.9, 0.9, (3, *tile)) * max(noise, 0.4)
    with torch.no_grad():
        parts.encoder.logits.copy_(torch.from_numpy(logits))
    parts.encoder.noise = noise
    truth = rng.uniform(0.2, 0.8, SHAPE[1])
    (found,) = tried_gradients(parts, batch_of(parts, 0.5, truth, SHAPE), 1500)

    def at(values: NDArray[np.float64]) -> float:
        columns = np.broadcast_to(values, (3, *SHAPE))[:, 0].T
        laws = [law_of_bits(column, max(noise, 0.25)) for column in columns]
        return mean_loss(parts, truth, laws, words)

    check(found, slopes(at, logits), 4 if tile == SHAPE else 2)


@pytest.mark.parametrize(
    ("tile", "rows", "noise", "words"),
    [slow((1, 2), 3, 0.5, 0.0), ((1, 1), 3, 0.7, 0.4), slow((1, 2), 2, 1.0, 0.4)],
)
def test_codebooks_follow_the_slope_of_the_mean_over_all_codes(
    tile: tuple[int, int], rows: int, noise: float, words: float
) -> None:
    """Shapes are tried by every pixel that has them, choices against every other one."""
    parts = parts_of(
        Mixed(4), slots=2, rows=rows, tile=list(tile), words_weight=words, **{"class": "codebook"}
    )
    rng = np.random.default_rng(3)
    shapes, choice = rng.uniform(-0.6, 0.6, (rows, 2)), rng.uniform(-0.5, 0.5, (*tile, rows))
    own = np.broadcast_to(choice.argmax(axis=-1), SHAPE)[0]
    with torch.no_grad():
        parts.encoder.shapes.copy_(torch.from_numpy(shapes))
        parts.encoder.choice.copy_(torch.from_numpy(choice))
    parts.encoder.noise = noise
    truth = rng.uniform(0.2, 0.8, SHAPE[1])
    found = tried_gradients(parts, batch_of(parts, 0.5, truth, SHAPE), 1500)

    def at(shapes: NDArray[np.float64], choice: NDArray[np.float64]) -> float:
        scores = np.broadcast_to(choice, (*SHAPE, rows))[0]
        laws = [law_of_choice(shapes, s, noise, k) for s, k in zip(scores, own, strict=True)]
        return mean_loss(parts, truth, laws, words)

    used = np.unique(own)
    wanted = slopes(lambda values: at(values, choice), shapes)
    check(found[0][:, used], wanted[used], len(used))
    assert not np.delete(found[0], used, axis=1).any()
    check(found[1], slopes(lambda values: at(shapes, values), choice), choice.size // 2)


def test_a_decision_moved_by_the_mean_of_the_draws_that_make_it() -> None:
    """The expected mean comes from the same draws, grouped by their decisions. Margins far from 0
    do not overflow."""
    margins = torch.tensor([0.0, 0.3, -0.7, 60.0]).reshape(-1, 1, 1).expand(4, 400, 400)
    spread = torch.full_like(margins, 0.5)
    first, second, moved = decided(margins, spread, torch.Generator().manual_seed(1), 1.0)
    draws = 0.5 * torch.randn(margins.shape, generator=torch.Generator().manual_seed(1))
    assert torch.equal(first, margins + draws > 0)
    assert torch.equal(second, margins - draws > 0)
    for index in range(3):
        for one, two in ((True, False), (False, True)):
            alike = (first[index] == one) & (second[index] == two)
            same = moved[index][alike]
            assert (same == same[0]).all()
            scatter = draws[index][alike].std().item() / alike.sum().item() ** 0.5
            assert abs(draws[index][alike].mean().item() - same[0].item()) < 4 * scatter
    assert not moved[first == second].any()
    assert torch.isfinite(moved).all()
    assert not moved[3].any()


def test_gradients_of_trials_scatter_less_than_with_the_single_draws() -> None:
    """Both gradients use the same trials; one replaces the mean movement of a code by the single
    draw."""
    parts = parts_of(Share(), slots=8, tile=[20, 20], init="random", **{"class": "e"})
    batch = batch_of(parts, 0.5, 0.3)
    squares = np.zeros(2)
    for seed in range(20):
        trial = trial_of(parts.encoder, 20, 20, (1, seed), (2,))
        made = decoded(parts, batch.light, trial.shutters[0], parts.model, generator_of(CPU, 3))
        draws = 0.25 * torch.randn(trial.fields.shape, generator=generator_of(CPU, 1, seed))
        for index, moved in enumerate((trial.moved, draws)):
            parts.encoder.zero_grad()
            pull(parts, batch, replace(trial, moved=moved), made, generator_of(CPU, 3)).backward()
            squares[index] += parts.encoder.logits.grad.square().sum().item()
    assert squares[0] < 0.4 * squares[1]


@pytest.mark.parametrize("kind", ["e", "codebook"])
def test_digits_leave_saturation_where_straight_through_does_not(kind: str) -> None:
    """The light is four full wells in a frame of eight slots, so that two slots fill the well. All
    shutters start open."""

    def learned(relaxation: str) -> float:
        parts = parts_of(
            Alone(),
            sensor_noise=True,
            slots=8,
            rows=4,
            init="uniform",
            relaxation=relaxation,
            noise=0.5,
            **{"class": kind},
        )
        parts.encoder.noise = 0.5
        batch = replace(batch_of(parts, 4.0, 4.0), peak=torch.tensor([8.0]))
        return open_share(parts, batch, 150, 0.05)

    assert 1 / 8 <= learned("tried") <= 2 / 8
    assert learned("straight-through") == 1


def test_each_place_learns_the_shape_of_least_loss() -> None:
    """Shapes as they are, two of which are wanted in turn; each place finds its own."""
    parts = parts_of(Share(), slots=8, rows=4, tile=[2, 2], init="random", **{"class": "codebook"})
    book = np.arange(8)[None] < np.arange(1, 9, 2)[:, None]
    start = {"id": np.full((2, 2), 2), "book": book.astype(np.int64)}
    parts.encoder.load_codes(start)
    with torch.no_grad():
        parts.encoder.shapes *= 2
    wish = np.where(np.arange(20) % 2, 3.0, 7.0)
    batch = batch_of(parts, 0.5, wish / 8)
    optimiser = torch.optim.Adam([parts.encoder.choice], lr=0.05)
    for step in range(200):
        parts.encoder.noise = 0.5 * (1 - step / 200)
        optimiser.zero_grad()
        trial = trial_of(parts.encoder, 20, 20, (1, step), (2,))
        made = decoded(parts, batch.light, trial.shutters[0], parts.model, generator_of(CPU, 3))
        pull(parts, batch, trial, made, generator_of(CPU, 3)).backward()
        optimiser.step()
    assert np.array_equal(2 * parts.encoder.codes()["id"] + 1, np.tile(wish[:2], (2, 1)))


def test_a_codebook_of_one_shape_has_nothing_else_to_choose() -> None:
    """With a single shape no pixel has a choice: its gradient is 0. Every slot of the shape has a
    positive one."""
    parts = parts_of(Share(), slots=8, rows=1, init="uniform", **{"class": "codebook"})
    parts.encoder.noise = 0.5
    shapes, choice = tried_gradients(parts, batch_of(parts, 0.5, 0.2), 40)
    assert not choice.any()
    assert (shapes.mean(axis=0) > 0).all()


@pytest.mark.parametrize("kind", ["e", "codebook"])
def test_digits_learn_in_the_window_of_the_patch_alone(kind: str) -> None:
    parts = parts_of(Share(), slots=8, tile=[32, 40], init="random", **{"class": kind})
    parts.encoder.noise = 1.0
    places = set()
    for seed in range(4):
        parts.encoder.zero_grad()
        trial = trial_of(parts.encoder, 20, 20, (1, seed), (2, seed))
        batch = batch_of(parts, 0.5, 0.99)
        made = decoded(parts, batch.light, trial.shutters[0], parts.model, None)
        pull(parts, batch, trial, made, generator_of(CPU, 3)).backward()
        grads = parts.encoder.logits.grad if kind == "e" else parts.encoder.choice.grad
        rows, cols = np.nonzero(grads.abs().sum(dim=0 if kind == "e" else -1).numpy())
        assert (np.ptp(rows), np.ptp(cols)) == (19, 19)
        places.add((rows.min(), cols.min()))
    assert len(places) > 1


@pytest.mark.parametrize("kind", ["e", "codebook"])
def test_the_gradient_of_a_digit_is_limited_to_3_by_3_pixels(kind: str) -> None:
    """One pixel alone has a loss: only it and its eight neighbours get a gradient."""
    parts = parts_of(Share(), slots=8, tile=[20, 20], init="random", **{"class": kind})
    seen = torch.zeros(20, 20)
    seen[9, 6] = 1.0
    one = replace(parts, loss=lambda p, t: ((p - t).square() * seen).sum())
    one.encoder.noise = 2.0
    found = tried_gradients(one, batch_of(parts, 0.5, 0.9), 12)
    grads = found[0].any(axis=(0, 1)) if kind == "e" else found[1].any(axis=(0, 3))
    rows, cols = np.nonzero(grads)
    assert (set(rows), set(cols)) == (set(range(8, 11)), set(range(5, 8)))
    assert len(rows) == 9


def test_shutters_of_a_trial_with_little_noise_mostly_equal_those_of_the_codes() -> None:
    """Between 1 and 10 % of the bits differ."""
    for kind in ("e", "codebook"):
        parts = parts_of(Share(), slots=8, rows=6, tile=[4, 4], init="random", **{"class": kind})
        trial = trial_of(parts.encoder, 20, 20, (1,), (2,))
        hard = torch.from_numpy(np.tile(parts.encoder.hard().numpy(), (1, 5, 5)))
        for shutters in trial.shutters:
            assert 0.01 < (shutters != hard).float().mean().item() < 0.1
            assert set(shutters.unique().tolist()) == {0, 1}
            assert not shutters.requires_grad


SMALL: dict[str, dict[str, Any]] = {
    "shutter": {
        "slots": 8,
        "tile": [4, 4],
        "rows": 6,
        "init": "random",
        "noise": 0.5,
        "relaxation": "tried",
        "words_weight": 0.01,
    },
    "data": {"protocol": "video-v1", "patch": 16, "scenes": 3, "val_items": 1, "together": 2},
    "loss": {"name": "psnr-display"},
    "train": {"steps": 4, "batch": 2, "validate_every": 2, "code_rate": 0.5},
}


@pytest.mark.parametrize("kind", ["e", "codebook"])
def test_a_resumed_run_equals_an_uninterrupted_one_and_compiles(kind: str, tmp_path: Path) -> None:
    def run(name: str, stop_after: int | None = None, **shutter: Any) -> None:
        values = {**SMALL, "shutter": {**SMALL["shutter"], "class": kind, **shutter}}
        out = tmp_path / name
        train(settings_of(values), out, stop_after=stop_after)

    run("whole")
    run("stopped", stop_after=2)
    run("stopped")
    for path in (tmp_path / "whole").iterdir():
        if path.name != "checkpoint.safetensors":
            assert path.read_bytes() == (tmp_path / "stopped" / path.name).read_bytes(), path.name
    first, second = (
        load_file(tmp_path / k / "checkpoint.safetensors") for k in ("whole", "stopped")
    )
    assert first.keys() == second.keys()
    assert all(torch.equal(first[key], second[key]) for key in first)
    run("frozen", learn=False)
    shutters = []
    for name in ("whole", "frozen"):
        with np.load(tmp_path / name / "codes.npz") as file:
            shutters.append(shutters_of(kind, 8, dict(file)))
    assert not np.array_equal(*shutters)
    built = invoke(["build", "shutter.nsl", "-o", str(tmp_path / "s.icw")], tmp_path / "whole")
    assert built.status == 0, built.err
