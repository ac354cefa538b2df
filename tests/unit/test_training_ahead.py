"""Batches made ahead: the same batches, errors where they are needed, no thread left over."""

from __future__ import annotations

import threading
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest

torch = pytest.importorskip("torch")

from nscc_training.config import settings_of  # noqa: E402
from nscc_training.data import Ahead, Batch, Batches  # noqa: E402
from nscc_training.loop.steps import compared  # noqa: E402
from nscc_training.loop.train import train  # noqa: E402

VALUES = {
    "shutter": {"class": "b", "slots": 16, "tile": [2, 2]},
    "data": {"patch": 16, "scenes": 3, "val_items": 1},
    "train": {"steps": 6, "batch": 2, "validate_every": 2},
}


def numbered(step: int) -> Batch:
    value = torch.full((1, 2, 2), float(step))
    return Batch(value, value, torch.ones(1), (str(step),))


def workers() -> list[threading.Thread]:
    return [thread for thread in threading.enumerate() if thread.name.startswith("nscc-batches")]


def test_batches_are_those_of_their_steps_whether_begun_or_not() -> None:
    made: list[tuple[int, bool]] = []

    def make(step: int) -> Batch:
        made.append((step, threading.current_thread() is threading.main_thread()))
        return numbered(step)

    with Ahead(make, 5) as ahead:
        for begun, taken in ((1, 1), (2, 3), (4, 4), (5, 5), (None, 0)):
            if begun is not None:
                ahead.begin(begun)
            assert ahead.take(taken).names == (str(taken),)
    # 5 is beyond the end: nobody is expected to take it
    assert sorted(made) == [(0, True), (1, False), (2, False), (3, True), (4, False), (5, True)]


def test_an_error_is_of_the_step_that_takes_it() -> None:
    def make(step: int) -> Batch:
        if step == 2:
            raise ValueError("the batch of step 2")
        return numbered(step)

    with Ahead(make, 9) as ahead:
        ahead.begin(1)
        ahead.begin(2)
        assert ahead.take(1).names == ("1",)
        ahead.begin(2)
        with pytest.raises(ValueError, match="step 2"):
            ahead.take(2)


@pytest.mark.parametrize("error", [KeyboardInterrupt, RuntimeError, None])
def test_no_thread_outlives_it(error: type[BaseException] | None) -> None:
    going, leave = threading.Event(), threading.Event()

    def make(step: int) -> Batch:
        going.set()
        assert leave.wait(30)
        return numbered(step)

    def interrupted() -> None:
        with Ahead(make, 9) as ahead:
            ahead.begin(1)
            assert going.wait(30)
            assert workers()
            leave.set()
            if error is not None:
                raise error

    if error is None:
        interrupted()
    else:
        with pytest.raises(error):
            interrupted()
    assert not workers()


def test_an_interrupted_run_leaves_no_thread_and_goes_on(tmp_path: Path) -> None:
    def interrupting(steps: Iterable[int], _label: str, _total: int) -> Iterable[int]:
        for step in steps:
            if step == 3:
                raise KeyboardInterrupt
            yield step

    settings = settings_of(VALUES)
    with pytest.raises(KeyboardInterrupt):
        train(settings, tmp_path / "r", track=interrupting)
    assert not workers()
    train(settings, tmp_path / "r")
    train(settings, tmp_path / "whole")
    assert not workers()
    for name in ("metrics.csv", "decoder.safetensors", "codes.npz", "result.json"):
        again, whole = ((tmp_path / run / name).read_bytes() for run in ("r", "whole"))
        assert again == whole, name


def test_a_batch_that_fails_stops_the_run_at_its_step(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What came before it is done and kept."""
    make = Batches.train

    def failing(self: Batches, step: int) -> Batch:
        if step == 2:
            raise MemoryError("step 2")
        return make(self, step)

    monkeypatch.setattr(Batches, "train", failing)
    with pytest.raises(MemoryError, match="step 2"):
        train(settings_of(VALUES), tmp_path / "r")
    assert not workers()
    assert (tmp_path / "r" / "metrics.csv").read_text().splitlines()[-1].startswith("2,val,")


@pytest.mark.parametrize("brightest", [0.9, 1.7])
def test_predictions_are_compared_as_in_metrics(brightest: float) -> None:
    """Over the peak of each patch; light above it counts as the peak where the truth is above."""
    rng = np.random.default_rng(3)
    peak = np.array([0.5, 2.0], np.float32)
    truth = rng.uniform(0, brightest, (2, 5, 4, 4)).astype(np.float32) * peak[:, None, None, None]
    made = rng.uniform(0, 2, truth.shape).astype(np.float32) * peak[:, None, None, None]
    batch = Batch(*(torch.from_numpy(x) for x in (truth, truth, peak)), ("one", "two"))
    prediction = torch.from_numpy(made).requires_grad_()
    found, goal = compared(prediction, batch)
    relative, wanted = truth / peak[:, None, None, None], made / peak[:, None, None, None]
    assert (relative >= 1).any() == (brightest > 1)
    cut = (relative >= 1) & (wanted > 1)
    np.testing.assert_allclose(found.detach(), np.where(cut, 1, wanted), rtol=1e-6)
    np.testing.assert_allclose(goal, np.minimum(relative, 1), rtol=1e-6)
    found.sum().backward()
    slope = np.where(cut, 0, np.broadcast_to(1 / peak[:, None, None, None], cut.shape))
    np.testing.assert_allclose(prediction.grad, slope, rtol=1e-6)
