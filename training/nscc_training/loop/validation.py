"""Scores of a run on its validation scenes, computed as `nscc evaluate` does."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import torch

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import rejected
from nscc_runtime.sensor import Sensor
from nscc_training.data import Scenes
from nscc_training.loop.decoding import Decode, by_chip, by_model
from nscc_training.loop.setup import TrainingSetup
from nscc_training.measures import decibels, number
from nscc_training.metrics import finite_mean
from nscc_training.protocol_scenes.clips import ClipWindow, with_class
from nscc_training.protocol_scenes.file_scenes import exposed_arrays
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocols import Protocol


class Validation(NamedTuple):
    """The mean loss over validation scenes, and the means of metrics as JSON values ("inf" if
    infinite). The first mean is the score."""

    loss: float
    means: dict[str, float | str]

    @property
    def score(self) -> float | str:
        """The mean, over the validation scenes, of the metric that the protocol lists first."""
        return next(iter(self.means.values()))


def validation_scenes(setup: TrainingSetup, scenes: Scenes) -> list[ProtocolScene]:
    """Return at most `val_items` validation scenes of `scenes`, the first of each before the
    second, exposed by the run's protocol and not larger than its chip.

    Clips have as many frames as the run has slots. Raises Rejected (NS0811) if no scene can be
    exposed."""
    protocol: Protocol = setup.protocol
    key = "crop_size" if setup.still else "size"
    side = min(int(protocol[key]), setup.target.rows, setup.target.cols)
    protocol = protocol.changed(**{key: side} | ({} if setup.still else {"frames": setup.slots}))
    lights = [(scene.name, scene.light) for scene in scenes.val]
    srgb = setup.settings.data.transfer != "linear"
    shown = exposed_arrays(lights, srgb, protocol, setup.settings.data.val_items)
    if setup.classes:
        labels = {scene.name: scene.label for scene in scenes.val}
        shown = [
            with_class(scene, labels[str(scene.file)], setup.classes)
            for scene in shown
            if isinstance(scene, ClipWindow)
        ]
    if not shown:
        raise rejected(
            "NS0811",
            f"protocol {protocol.name} cannot expose any of the validation scenes",
            notes=(f"they are {', '.join(scene.name for scene in scenes.val)[:200]}",),
            helps=("name other scenes in [data] val",),
        )
    return shown


def validated(
    setup: TrainingSetup,
    shown: Sequence[ProtocolScene],
    decode: Decode | None = None,
    exposure: float = 1.0,
) -> Validation:
    """Score the decoder on the scenes `shown`.

    `shown` has at least one scene. `decode` captures and decodes a scene; None does it under the
    conditions of the training (`as_trained`). The light is multiplied by `exposure`, and the result
    divided by it."""
    decode = decode or as_trained(setup)
    losses: list[float] = []
    scores: dict[str, list[float]] = {name: [] for name in setup.protocol.metrics}
    for index, scene in enumerate(shown):
        result_e = decode(scene.light_e * exposure, index)[0] / exposure
        scene_scores = scene.scores(result_e)
        for name, values in scores.items():
            values.append(number(scene_scores[name]))
        losses.append(_loss(setup, scene, result_e))
    means = {name: float(np.mean(values)) for name, values in scores.items()}
    name, *_ = scores
    # The first metric may be infinite for single scenes, which its mean leaves out.
    means[name] = finite_mean(scores[name])
    return Validation(
        float(np.mean(losses)), {name: decibels(value) for name, value in means.items()}
    )


def as_trained(setup: TrainingSetup, sensor: Sensor | None = None) -> Decode:
    """Return a function that captures and decodes a scene under the conditions of the training: on
    the emulated chip if the run has effects, else by the sensor model.

    `sensor` replaces the sensor of the emulated chip; None keeps the run's."""
    effects = setup.settings.sensor.effects
    return by_chip(setup, effects, sensor) if effects else by_model(setup)


def _loss(setup: TrainingSetup, scene: ProtocolScene, result_e: Array) -> float:
    """Return the loss of a decoder's result for a scene: light in electrons, or the scores of
    classes. The light is relative to the scene's peak; results above it are clipped where the truth
    reaches it, as in training."""
    if setup.classes:
        scores, truth = (torch.from_numpy(values)[None] for values in (result_e, scene.truth_e))
        return float(setup.loss(scores, truth))
    truth, result = (
        torch.from_numpy(np.asarray(light_e / scene.peak_e, np.float32))[None]
        for light_e in (scene.light_e, result_e)
    )
    result = torch.where(truth >= 1, result.clamp(max=1), result)
    return float(setup.loss(result, truth.clamp(max=1)))
