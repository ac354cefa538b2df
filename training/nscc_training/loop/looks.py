"""What a finished run of pixels that look says of itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import torch

from nscc.words.container import Container
from nscc_runtime import capture
from nscc_runtime.light import Light
from nscc_runtime.looked_light import OPEN
from nscc_training.data import Batch
from nscc_training.loop.setup import Parts, started_encoder
from nscc_training.loop.steps import scored
from nscc_training.measures import decibels
from nscc_training.metrics import finite_mean, psnr


def looking_stages(parts: Parts, val: Sequence[Batch], container: Container) -> dict[str, Any]:
    """PSNR by the model of the sensor and by the words that were compiled, without noise."""
    machine = container.machine
    assert machine is not None
    ideal, seed = parts.model.noiseless(), parts.settings.train.seed
    codes = parts.encoder.codes()
    asked = [(each.boundary, each.level) for each in machine.comparisons]
    same = asked == [*zip(codes["at"][0].tolist(), codes["level"][0].tolist(), strict=True)]
    hard = decibels(scored(parts, val, parts.encoder.hard(), ideal, seed).psnr_db)
    return {
        "soft": hard, "hard": hard, "compiled": hard if same else None,
        "emulated": decibels(_emulated(parts, val, container)), "compiled_equals_hard": same,
    }  # fmt: skip


@torch.no_grad()
def _emulated(parts: Parts, val: Sequence[Batch], container: Container) -> float:
    """PSNR from frames that the emulator exposed: the words, on the whole array."""
    rows, cols = container.target.rows, container.target.cols
    share = np.concatenate(([0.0], np.cumsum(container.slot_us))) / sum(container.slot_us)
    values = []
    for batch in (each.part(k, k + 1) for each in val for k in range(len(each.peak))):
        patch = batch.light[0, :rows, :cols].numpy()
        down, across = patch.shape
        whole = np.zeros((rows, cols), np.float32)
        whole[:down, :across] = patch
        light = Light.of_still(whole, np.full(parts.slots, 1.0 / parts.slots))
        taken = capture(container, light)
        frame = torch.from_numpy(taken.frame[0, :down, :across].astype(np.float32))
        frame = parts.model.relative(frame - parts.model.adc_offset_lsb)
        opened = torch.from_numpy(share[taken.told[OPEN][0, :down, :across]].astype(np.float32))
        made = parts.decoder(frame[None].to(parts.device), opened[None].to(parts.device)).float()
        pair = [
            np.clip(x.cpu().numpy() / batch.peak.item(), 0, 1)
            for x in (batch.truth[0, :rows, :cols], made[0])
        ]
        values.append(psnr(pair[0], pair[1], 1.0))
    return finite_mean(values)


def looking_codes(parts: Parts) -> dict[str, Any]:
    """The looks and levels, and how many of them are not those that the run began with."""
    chosen = parts.settings.shutter
    start = started_encoder(chosen, parts.chip, parts.target, parts.settings.train.seed).codes()
    codes = parts.encoder.codes()
    moved = (codes["at"] != start["at"]) | (codes["level"] != start["level"])
    return {
        "places": int(moved.size), "start": chosen.init, "moved": int(moved.sum()),
        "shutters": int(moved.size) + 1, "at": codes["at"][0].tolist(),
        "steps": codes["level"][0].tolist(),
    }  # fmt: skip
