"""Decoders as a tradeoff compares them: each makes light of the same captures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import torch
from numpy.typing import NDArray

from nscc_training.any_code.decode import decoded_clip, decoded_still
from nscc_training.any_code.measured import Measured
from nscc_training.any_code.stills import STILL_STAGES
from nscc_training.baselines.hdr import merged
from nscc_training.baselines.sci import adjoint, admm_tv, from_dictionary, gap_tv
from nscc_training.baselines.sparse_coding import coded_still
from nscc_training.decoders.blocks import BlockNet
from nscc_training.evaluation.hdr import Crop
from nscc_training.run_folder import RunFolder
from nscc_training.sensor_model import SensorModel
from nscc_training.tradeoff.scenes import Kind, Scene

Light = NDArray[np.float64]
Loop = Callable[..., NDArray[np.float32]]
"""Makes a clip of a measurement and a mask."""
TV_ITERATIONS = (5, 10, 20, 40, 80)
SPARSE_ITERATIONS = (15, 60)
ANY_STAGES = (2, 4, 8, 12)
_OVERLAPS = {1: (False, False), 2: (True, False), 4: (True, True)}
"""Which directions blocks overlap in, by how many blocks then hold a pixel."""


@dataclass(frozen=True, eq=False)
class Taken:
    """A scene captured: `frame` (rows, cols) in codes above the offset, `saturated` of them,
    `mask` (N, rows, cols)."""

    scene: Scene
    frame: NDArray[np.float32]
    saturated: NDArray[np.bool_]
    mask: NDArray[np.float32]
    model: SensorModel

    def corner(self, size: int) -> Taken:
        """The same capture, its upper left corner only."""
        part = np.s_[..., :size, :size]
        return replace(
            self, frame=self.frame[part], saturated=self.saturated[part], mask=self.mask[part]
        )


@dataclass(frozen=True, eq=False)
class Way:
    """A decoder with its settings. `run` gives electrons over the frame (rows, cols) of a still,
    electrons a slot (N, rows, cols) of a clip. `device`: where that is not the processor. `loads`
    tells settings apart that do not load and compile the same things."""

    method: str
    setting: str
    run: Callable[[Taken], Light]
    device: str = ""
    loads: str = ""


def baselines(kind: Kind) -> list[Way]:
    """What needs no training."""
    if kind == "clips":
        loops: list[tuple[str, str, Loop]] = [("adjoint", "S^T E", adjoint)]
        for name, loop in (("gap-tv", gap_tv), ("admm-tv", admm_tv)):
            loops += [(name, f"{n}", partial(loop, iterations=n)) for n in TV_ITERATIONS]
        loops.append(("dictionary", "learned", from_dictionary))
        ways = [Way(name, setting, partial(clip_light, loop)) for name, setting, loop in loops]
        return [*ways, *(Way("any", f"{n}", partial(_any_clip, count=n)) for n in ANY_STAGES)]
    sparse = [
        Way("sparse-coding", f"{n}", partial(_sparse, iterations=n)) for n in SPARSE_ITERATIONS
    ]
    return [
        Way("merged", "neighbours", merged_still),
        *sparse,
        Way("any", f"{STILL_STAGES}", _any_still),
    ]


def networks(folder: RunFolder, name: str) -> list[Way]:
    """A run's decoder in both number formats, FC-net also with fewer blocks."""
    parts = folder.parts
    chosen = parts.settings.decoder
    method = f"{chosen.name} {chosen.sized}{name}"
    device = torch.cuda.get_device_name(parts.device) if parts.device.type == "cuda" else ""
    found = []
    for dtype in ("f32", "bf16"):
        if isinstance(parts.decoder, BlockNet):
            for blocks, overlapping in _OVERLAPS.items():
                net = copy(parts.decoder)
                net.overlapping = overlapping
                run = _network(folder, net, dtype)
                setting = f"x{blocks} {dtype}"
                found.append(Way(method, setting, run, device, loads=setting))
        else:
            run = _network(folder, parts.decoder, dtype)
            found.append(Way(method, dtype, run, device, loads=dtype))
    return found


def clip_light(loop: Loop, taken: Taken) -> Light:
    """Electrons a slot by a decoder of clips, in whose unit 1 is the source's white a slot."""
    assert not isinstance(taken.scene, Crop)
    slots, frames = len(taken.mask), len(taken.scene.light_e)
    # Total variation is weighed for values on 0..1 a slot, however many of the source's frames
    # that is.
    white_e = taken.scene.scale_e * frames / slots
    measurement = (taken.frame * (taken.model.electrons_per_lsb / white_e)).astype(np.float32)
    return np.asarray(loop(measurement, taken.mask), np.float64) * white_e


def merged_still(taken: Taken) -> Light:
    """Electrons over the frame from the neighbours' codes that are not saturated."""
    model = taken.model
    return merged(
        taken.frame, _share(taken), model.electrons_per_lsb, taken.saturated,
        model.adc_noise_lsb * model.electrons_per_lsb,
    )  # fmt: skip


def _share(taken: Taken) -> Light:
    return np.asarray(taken.mask.mean(axis=0, dtype=np.float64))


def _sparse(taken: Taken, iterations: int) -> Light:
    model = taken.model
    return coded_still(
        taken.frame, _share(taken), merged_still(taken), model.electrons_per_lsb,
        taken.saturated, model.full_well_e, iterations,
    )  # fmt: skip


def _any_clip(taken: Taken, count: int) -> Light:
    found = decoded_clip(Measured.read(taken.frame, taken.mask, taken.model), count)
    return np.asarray(found[0].numpy(), np.float64)


def _any_still(taken: Taken) -> Light:
    share = taken.mask.mean(axis=0, keepdims=True)
    found = decoded_still(Measured.read(taken.frame, share, taken.model))
    return np.asarray(found[0].numpy(), np.float64)


def _network(folder: RunFolder, net: torch.nn.Module, dtype: str) -> Callable[[Taken], Light]:
    parts = folder.parts
    slot_e = parts.model.full_e / (1 if parts.still else parts.slots)

    @torch.no_grad()
    def run(taken: Taken) -> Light:
        frame = parts.model.relative(torch.from_numpy(taken.frame))
        shutters = torch.from_numpy(np.ascontiguousarray(taken.mask))
        with torch.autocast(parts.device.type, torch.bfloat16, enabled=dtype == "bf16"):
            made = net(frame[None].to(parts.device), shutters.to(parts.device))
        return np.asarray(made[0].float().cpu().numpy().astype(np.float64) * slot_e)

    return run


def names_of(folders: Sequence[RunFolder]) -> list[str]:
    """What tells runs apart whose decoders have one name and size: their folders' names."""
    kinds = [(f.parts.settings.decoder.name, f.parts.settings.decoder.sized) for f in folders]
    return [
        f" ({folder.path.resolve().name})" if kinds.count(kind) > 1 else ""
        for folder, kind in zip(folders, kinds, strict=True)
    ]
