"""Textures that move in eight directions."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("torch", reason="the training package is installed with torch")

from nscc_training.made_scenes import DIRECTIONS, moving_texture

SIZE = 48


def clip_of(direction: str, speed: float = 2.0, seed: int = 3) -> np.ndarray:
    return moving_texture(np.random.default_rng(seed), 16, SIZE, direction, speed)


@pytest.mark.parametrize("direction", DIRECTIONS)
def test_the_texture_moves_at_its_speed_in_its_direction(direction: str) -> None:
    clip = clip_of(direction)
    assert clip.shape == (16, SIZE, SIZE)
    assert clip.dtype == np.float32
    assert clip.min() >= 0
    assert clip.max() <= 1
    first, last = (np.fft.fft2(frame - frame.mean()) for frame in (clip[0], clip[8]))
    likeness = np.fft.ifft2(last * first.conj()).real
    moved = [(int(at) + 24) % SIZE - 24 for at in np.unravel_index(likeness.argmax(), (SIZE, SIZE))]
    steps = {"up": (-1, 0), "down": (1, 0), "left": (0, -1), "right": (0, 1)}
    down, right = np.sum([steps[word] for word in direction.split("-")], axis=0)
    assert moved == [round(16 * side / np.hypot(down, right)) for side in (down, right)]


def test_the_sum_of_all_frames_does_not_tell_a_direction_from_its_opposite() -> None:
    right, left = (clip_of(direction).sum(axis=0) for direction in ("right", "left"))
    assert np.allclose(right, np.roll(left, 32, axis=1), atol=1e-4)
    up = clip_of("up").sum(axis=0)
    assert not any(np.allclose(right, np.roll(up, k, axis=1), atol=0.1) for k in range(SIZE))


def test_the_same_seed_gives_the_same_clip() -> None:
    assert np.array_equal(clip_of("up"), clip_of("up"))
    assert not np.array_equal(clip_of("up"), clip_of("up", seed=4))
