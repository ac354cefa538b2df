"""The random streams of trainings, scenes and cells: one number a stream, which its seeds contain.

Random numbers are drawn from generators seeded by (seed, stream, index ...), so that streams with
one seed are independent. Values stay as they are: other values give other results."""

from __future__ import annotations

from enum import IntEnum


class DrawStream(IntEnum):
    """The second number of the seeds of a training and of synthetic scenes: with it, draws for
    different purposes are independent although the first number, the user's seed, is the same."""

    TRAINING_SCENES = 1
    """Synthetic scenes for training, by index."""
    VALIDATION_SCENES = 2
    """Synthetic scenes for validation, by index."""
    EVALUATION_SCENES = 3
    """Synthetic scenes and textures of evaluations and tradeoffs, by index."""
    CAMERA_PATHS = 3
    """Paths of virtual cameras, by the digest of their file and their index."""
    PATCHES = 4
    """Scene, place and augmentation of the patches of a step, by step and place in the batch."""
    RELAXED_CODES = 6
    """Samples of relaxed codes, by step and process."""
    TILE_WINDOWS = 7
    """The part of a large tile that a patch sees, by step."""
    READOUT_NOISE = 10
    """Noise of the frames of a step, by step and process."""
    SEARCH_MOVES = 11
    """Moves of a search over codes, by step."""
    LESSONS = 12
    """Codes and light of lessons for a decoder, by step."""
    LESSON_NOISE = 13
    """Noise of the frames of lessons, by step."""
    JITTER = 14
    """Moves of the initial codes."""
    RANDOM_CODES = 15
    """Random codes of restarts and of decoders for random codes, by step or number."""
