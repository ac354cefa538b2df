"""Codes learned by trial, against gradients that are known without any trial."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from numpy.typing import NDArray
from scipy.stats import norm
from training_oracle import small_target

torch = pytest.importorskip("torch")

from safetensors.torch import load_file  # noqa: E402
from trial_problems import (  # noqa: E402
    CPU,
    Alone,
    Share,
    batch_of,
    open_share,
    parts_of,
    squared,
    tried_gradients,
)

from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_training.data import Batch  # noqa: E402
from nscc_training.draws import generator_of  # noqa: E402
from nscc_training.loop.setup import TrainingSetup  # noqa: E402
from nscc_training.loop.steps import decoded, pull, trial_of, window  # noqa: E402  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402
from nscc_training.sensor_model import laid  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

SLOTS, SIDE = 64, 20


def fourth(prediction: Any, truth: Any) -> Any:
    """No trapezoid is exact for it."""
    return (prediction - truth).pow(4).mean()


def smoothed(loss: Any, field: NDArray[np.float64], spread: NDArray[np.float64]) -> Any:
    """The mean of loss(stop) over stops rounded from normal noise around a field, exactly."""
    stops = np.arange(1, SLOTS + 1).reshape(-1, 1, 1)
    ends = np.arange(1.5, SLOTS).reshape(-1, 1, 1)
    below = norm.cdf((ends - field) / spread)
    ones = np.ones((1, *field.shape))
    chance = np.diff(np.concatenate([0 * ones, below, ones]), axis=0)
    return (chance * loss(stops)).sum(axis=0)


@pytest.mark.parametrize(
    ("loss", "power", "noise", "bias", "share"),
    [
        (squared, 2, 1.0, 0.0, 1.0),
        (squared, 2, 6.0, 0.0, 1.0),
        (squared, 2, 6.0, 0.0, 0.3),
        (fourth, 4, 1.0, 0.02, 1.0),
        (fourth, 4, 3.0, 0.2, 1.0),
    ],
)
def test_trials_find_the_slope_of_the_smoothed_loss(
    loss: Any, power: int, noise: float, bias: float, share: float
) -> None:
    """Each place has a best stop of its own; the slope by finite differences of exact means.

    One place is short, so that it moves by a quarter of itself, and one at its limit. For a fourth
    power at a distance d the trapezoid says 2 h^2 / d^2 more, with h^2 about 3 spread^2.
    """
    best = np.array([[10.0, 50.0], [60.0, 30.0]])
    fields = np.array([[30.0, 20.0], [40.0, 62.0]])
    parts = parts_of(Share(), loss, tried_share=share)
    parts.encoder.noise = noise
    parts.encoder.fill(fields)
    batch = batch_of(parts, 0.5, np.tile(best / SLOTS, (SIDE // 2, SIDE // 2)))
    found = tried_gradients(parts, batch, 400)[0]
    spread = np.minimum(noise, fields / 4)

    def at(values: NDArray[np.float64]) -> Any:
        # a quarter of the pixels is at each place
        return smoothed(lambda s: (s - best) ** power / SLOTS**power, values, spread) / 4

    # Parameters are octaves.
    wanted = (at(fields + 0.01) - at(fields - 0.01)) / 0.02 * fields * np.log(2)
    error = found.std(axis=0, ddof=1) / np.sqrt(len(found))
    assert (np.sign(found.mean(axis=0)) == np.sign(fields - best)).all()
    assert (np.abs(wanted) > 8 * error).all()
    assert (np.abs(found.mean(axis=0) - wanted) < 5 * error + bias * np.abs(wanted)).all()


def test_a_single_trial_is_the_difference_of_the_losses_around() -> None:
    """The loss is a sum of squared errors of pixels, so each pixel can be checked."""
    parts = parts_of(Share(), tile=[SIDE, SIDE], init="random")
    parts.encoder.noise = 3.0
    wish = np.random.default_rng(1).random((SIDE, SIDE))
    found = tried_gradients(parts, batch_of(parts, 0.5, wish), 1)[0][0]
    trial = trial_of(parts.encoder, SIDE, SIDE, (1, 0), (2, 0))
    one, two = ((s.mean(dim=0).double().numpy() - wish) ** 2 / SIDE**2 for s in trial.shutters)
    for row, col in ((0, 0), (0, 9), (7, 12), (19, 19), (18, 3)):
        around = np.s_[max(0, row - 2) : row + 3, max(0, col - 2) : col + 3]
        moved, spread = (float(x[0, row, col]) for x in (trial.moved, trial.spread))
        octave = float(trial.fields.detach()[0, row, col]) * np.log(2)
        wanted = moved * (one[around].sum() - two[around].sum()) / (2 * spread**2) * octave
        assert found[row, col] == pytest.approx(wanted, rel=1e-3, abs=1e-8)


def test_only_a_share_of_the_pixels_is_tried() -> None:
    """About a tenth of the pixels get another code, the same ones on both sides of the trial.
    Others keep their shutter."""
    parts = parts_of(Share(), tile=[60, 60], tried_share=0.1, **{"class": "d"})
    parts.encoder.noise = 8.0
    trial = trial_of(parts.encoder, 60, 60, (1,), (2,))
    moved = (trial.moved != 0).numpy()
    assert (moved[0] == moved[1]).all()
    # `tried_share`, with a margin for chance.
    assert 0.07 < moved.mean() < 0.13
    hard = parts.encoder.hard()
    for side in trial.shutters:
        changed = (side != hard).any(dim=0).numpy()
        assert changed.any()
        assert not changed[~moved[0]].any()


@pytest.mark.parametrize(("noise", "wanted"), [(0.0, [0.25] * 4), (6.0, [0.5, 2, 5, 6])])
def test_short_exposures_are_tried_in_small_steps(noise: float, wanted: list[float]) -> None:
    """Without noise each stop is spread by 0.25. With noise of 6 slots a stop of 2 is spread by
    0.5, and 64 by the whole 6."""
    parts = parts_of(Share())
    parts.encoder.noise = noise
    parts.encoder.fill(np.array([[2.0, 8.0], [20.0, 64.0]]))
    trial = trial_of(parts.encoder, SIDE, SIDE, (1,), (2,))
    assert trial.spread[0, :2, :2].reshape(-1).tolist() == wanted


def test_the_gradient_of_a_trial_is_limited_to_5_by_5_pixels() -> None:
    """One pixel alone has a loss: only places within two pixels of it get a gradient."""
    parts = parts_of(Share(), tile=[SIDE, SIDE])
    seen = torch.zeros(SIDE, SIDE)
    seen[9, 6] = 1.0
    parts.encoder.noise = 1.0
    one = replace(parts, loss=lambda p, t: ((p - t).square() * seen).sum())
    found = tried_gradients(one, batch_of(parts, 0.5, 0.9), 1)[0][0]
    rows, cols = np.nonzero(found)
    assert (set(rows), set(cols)) == (set(range(7, 12)), set(range(4, 9)))
    # 5 x 5 pixels around the one with a loss.
    assert len(rows) == 25


@pytest.mark.parametrize("kind", ["b", "c", "d"])
def test_both_sides_are_tried_symmetrically(kind: str) -> None:
    parts = parts_of(Share(), **{"class": kind}, noise=5.0)
    parts.encoder.noise = 2.0
    middle = {"b": [32.0], "c": [30.0], "d": [16.0, 48.0]}[kind]
    parts.encoder.fill(*(np.full((2, 2), x) for x in middle))
    trial = trial_of(parts.encoder, SIDE, SIDE, (1,), (2,))
    assert trial.fields.shape == (len(middle), SIDE, SIDE)
    assert torch.equal(trial.spread, torch.full_like(trial.spread, 2.0))
    assert trial.moved.std().item() == pytest.approx(2.0, rel=0.15)
    for sign, shutters in zip((1, -1), trial.shutters, strict=True):
        assert not shutters.requires_grad
        edges = torch.round(trial.fields + sign * trial.moved).detach()
        start = {"b": 0 * edges[0], "c": edges[0], "d": edges[0]}[kind]
        stop = {"b": edges[0], "c": start + 4, "d": edges[-1]}[kind]
        n = torch.arange(SLOTS).reshape(-1, 1, 1)
        assert torch.equal(shutters, ((n >= start) & (n < stop)).float())


def test_the_same_seed_is_the_same_trial() -> None:
    """A trial of the same seed moves the same codes in the same way. Another seed moves others."""
    parts = parts_of(Share())
    one, two, other = (trial_of(parts.encoder, SIDE, SIDE, (s,), (2,)) for s in (1, 1, 5))
    assert torch.equal(one.moved, two.moved)
    assert not torch.equal(one.moved, other.moved)


def bright(relaxation: str) -> tuple[TrainingSetup, Batch]:
    """Light of eight full wells a frame: a stop of 8 of 64 fills the well. Half the peak."""
    parts = parts_of(Alone(), sensor_noise=True, relaxation=relaxation)
    return parts, replace(batch_of(parts, 8.0, 8.0), peak=torch.tensor([16.0]))


def test_the_slope_includes_what_saturation_takes_away() -> None:
    """The expected slope comes from losses of the noisy sensor, simulated at every stop."""
    parts, batch = bright("tried")
    losses = []
    for stop in range(1, SLOTS + 1):
        light = 8 * 30000 * stop / SLOTS
        rng = np.random.default_rng(stop)
        charge = np.clip(light + np.sqrt(light) * rng.standard_normal(20_000), 0, 30000)
        codes = charge / 30000 * 255 + parts.model.adc_noise_lsb * rng.standard_normal(20_000)
        made = np.clip(np.rint(codes), 0, 255) / 255 * SLOTS / stop
        losses.append(np.mean((made / 16 - 0.5) ** 2))
    table = np.array(losses).reshape(-1, 1, 1)
    for stop, sign in ((3.0, -1), (8.0, 1), (12.0, 1), (30.0, 1)):
        parts.encoder.noise = 1.0
        parts.encoder.fill(np.full((2, 2), stop))
        found = tried_gradients(parts, batch, 100)[0].mean(axis=(1, 2))
        spread = np.full((1, 1), min(1.0, stop / 4))

        def at(value: float, spread: Any = spread) -> float:
            mean = smoothed(lambda _: table, np.full((1, 1), value), spread)
            return float(mean[0, 0]) / 4

        wanted = (at(stop + 0.01) - at(stop - 0.01)) / 0.02 * stop * np.log(2)
        error = found.std(ddof=1) / 10
        assert np.sign(wanted) == np.sign(found.mean()) == sign
        assert abs(found.mean() - wanted) < 5 * error + 0.1 * abs(wanted)
        assert abs(wanted) > 10 * error


def learned(relaxation: str, steps: int) -> float:
    """The mean stop after so many steps from always open."""
    parts, batch = bright(relaxation)
    parts.encoder.fill(np.full((2, 2), float(SLOTS)))
    return SLOTS * open_share(parts, batch, steps, 1.0)


def test_trials_leave_saturation_where_straight_through_does_not() -> None:
    """Saturated pixels say too little, so a gradient through the capture wants more of them."""
    assert 3 <= learned("tried", 200) <= 8
    assert learned("straight-through", 200) == SLOTS


def test_trials_choose_only_codes_that_the_rule_allows() -> None:
    """Stops of 9 to 40 are forbidden. In five trials over 20 of the other stops occur, and none of
    those."""
    parts = parts_of(Share(), require="stop < 9 or stop > 40", init="quad", noise=8.0)
    parts.encoder.noise = 8.0
    parts.encoder.fill(np.array([[8.0, 41.0], [1.0, 64.0]]))
    legal = {*range(1, 9), *range(41, SLOTS + 1)}
    seen: set[int] = set()
    for seed in range(5):
        trial = trial_of(parts.encoder, SIDE, SIDE, (seed,), (2,))
        for shutters in trial.shutters:
            seen |= {int(stop) for stop in shutters.sum(dim=0).unique()}
    assert seen <= legal
    assert len(seen) > 20


def window_of(gradient: NDArray[np.float64]) -> tuple[slice, slice]:
    """The rectangle outside of which a gradient is 0; inside it is not."""
    rows, cols = np.nonzero(gradient)
    found = slice(rows.min(), rows.max() + 1), slice(cols.min(), cols.max() + 1)
    assert (gradient[found] != 0).all()
    return found


@pytest.mark.parametrize("tile", [(48, 56), (48, 4), (4, 56)])
def test_codes_learn_in_the_window_of_the_patch_alone(tile: tuple[int, int]) -> None:
    parts = parts_of(Share(), tile=list(tile), init="random")
    parts.encoder.noise = 2.0
    places = set()
    for seed in range(4):
        parts.encoder.zero_grad()
        trial = trial_of(parts.encoder, SIDE, SIDE, (1, seed), (2, seed))
        batch = batch_of(parts, 0.5, 0.99)
        made = decoded(parts, batch.light, trial.shutters[0], parts.model, None)
        pull(parts, batch, trial, made, generator_of(CPU, 3)).backward()
        found = window_of(parts.encoder.stop.grad.numpy())
        sides = [part.stop - part.start for part in found]
        assert sides == [min(SIDE, side) for side in tile]
        # the codes tried are those of that very part
        stops = torch.from_numpy(parts.encoder.codes()["stop"].astype(float))
        assert torch.equal(trial.fields.detach()[0], laid(stops[found], SIDE, SIDE))
        hard = window(parts.encoder.hard(), SIDE, SIDE, (2, seed))
        assert torch.equal(laid(hard.sum(dim=0), SIDE, SIDE).double(), trial.fields.detach()[0])
        places.add((found[0].start, found[1].start))
    assert len(places) > 1


SMALL: dict[str, dict[str, Any]] = {
    "shutter": {
        "class": "b",
        "slots": 16,
        "tile": [4, 4],
        "init": "random",
        "noise": 2.0,
        "relaxation": "tried",
    },
    "data": {"patch": 16, "scenes": 3, "val_items": 1, "together": 2},
    "loss": {"name": "psnr+psnr-mu"},
    "train": {"steps": 4, "batch": 2, "validate_every": 2, "code_rate": 0.05},
}


def run(out: Path, shutter: dict[str, Any], **more: Any) -> None:
    values = {**SMALL, "shutter": {**SMALL["shutter"], **shutter}}
    train(settings_of(values), out, **more)


@pytest.mark.parametrize("kind", ["b", "d"])
def test_a_resumed_run_equals_one_that_never_stopped(kind: str, tmp_path: Path) -> None:
    run(tmp_path / "whole", {"class": kind})
    run(tmp_path / "stopped", {"class": kind}, stop_after=2)
    run(tmp_path / "stopped", {"class": kind})
    for path in (tmp_path / "whole").iterdir():
        if path.name != "checkpoint.safetensors":
            assert path.read_bytes() == (tmp_path / "stopped" / path.name).read_bytes(), path.name
    first, second = (
        load_file(tmp_path / k / "checkpoint.safetensors") for k in ("whole", "stopped")
    )
    assert first.keys() == second.keys()
    assert all(torch.equal(first[key], second[key]) for key in first)
    run(tmp_path / "frozen", {"class": kind, "learn": False})
    codes = [np.load(tmp_path / k / "codes.npz")["stop"] for k in ("whole", "frozen")]
    assert not np.array_equal(*codes)


def test_free_codes_of_a_small_chip_learn_by_trial(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every pixel has a code of its own; those that no patch ever met stay."""
    text = invoke(["targets", "scamp5", "--toml"], tmp_path).out
    (tmp_path / "small.toml").write_text(small_target(text, 64, 64))
    monkeypatch.chdir(tmp_path)
    free = {"free": True, "target": "small.toml", "tile": [8, 8]}
    for name, learn in (("learned", True), ("frozen", False)):
        run(tmp_path / name, {**free, "learn": learn})
    stops = [np.load(tmp_path / k / "codes.npz")["stop"] for k in ("learned", "frozen")]
    assert stops[0].shape == (64, 64)
    moved = float(np.mean(stops[0] != stops[1]))
    # four windows of a sixteenth of the array
    assert 0 < moved <= 4 / 16


def test_codes_that_are_always_open_are_not_tried() -> None:
    """Class a has no codes, so trials are refused with NS0815."""
    with pytest.raises(Rejected, match="NS0815") as caught:
        parts_of(Share(), **{"class": "a", "slots": 8})
    assert "no parameters to try" in caught.value.diagnostics[0].message


def test_gradients_of_words_equal_finite_differences() -> None:
    """A stop of all slots is the one that never changes; the slope by finite differences."""
    parts = parts_of(Share(), lambda p, t: 0 * p.sum(), words_weight=0.7)
    fields = np.array([[63.0, 20.0], [64.0, 60.0]])
    parts.encoder.noise = 2.0
    parts.encoder.fill(fields)
    (found,) = tried_gradients(parts, batch_of(parts, 0.5, 0.5), 200)
    error = found.std(axis=0, ddof=1) / np.sqrt(len(found))

    def at(values: NDArray[np.float64]) -> Any:
        words = smoothed(lambda s: (s < SLOTS) / (SLOTS - 1.0), values, np.full((2, 2), 2.0))
        return 0.7 * words / 4

    wanted = (at(fields + 0.01) - at(fields - 0.01)) / 0.02 * fields * np.log(2)
    assert (np.abs(found.mean(axis=0) - wanted) <= 4 * error + 1e-12).all()
    assert wanted[1, 0] < -20 * error[1, 0]
    assert not found[:, 0, 1].any()
