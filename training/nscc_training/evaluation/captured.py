"""Captured frames of a scene, the input of decoders without training."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocol_scenes.sci import SciClip
from nscc_training.protocol_scenes.video import ClipWindow

if TYPE_CHECKING:
    from torch import Tensor

    from nscc_training.measured import Measured
    from nscc_training.sensor_model import SensorModel

Frames = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class CapturedScene:
    """Captured frames of one scene.

    `codes` (frames, rows, cols) are above the converter's offset. `tile` (frames, slots, r, c)
    contains the shutters, which repeat over the array. `saturated` (frames, rows, cols) marks
    saturated codes. `model` is the sensor, None for exact measurements."""

    scene: ProtocolScene
    codes: Frames
    tile: Frames
    saturated: NDArray[np.bool_]
    model: SensorModel | None

    @classmethod
    def of_benchmark(cls, clip: SciClip) -> CapturedScene:
        """Return the measurement of a benchmark clip."""
        codes = clip.measurement[None]
        return cls(clip, codes, clip.mask[None], np.zeros(codes.shape, np.bool_), None)

    @property
    def is_still(self) -> bool:
        return self.scene.light_e.ndim == 2

    @cached_property
    def masks(self) -> Frames:
        """The shutters over the frame, (frames, slots, rows, cols)."""
        return self._over_frame(self.tile)

    @cached_property
    def share(self) -> NDArray[np.float64]:
        """The fraction of the first frame for which each pixel is open, (rows, cols)."""
        return self._over_frame(self.tile[0].mean(axis=0, dtype=np.float64))

    @property
    def code_e(self) -> float:
        """Electrons per code."""
        return 1.0 if self.model is None else self.model.electrons_per_lsb

    @property
    def white_e(self) -> float:
        """Electrons per slot of the source's white, the unit of total variation."""
        scene, slots = self.scene, self.tile.shape[1]
        scale_e = scene.scale_e if isinstance(scene, ClipWindow) else 1.0
        return float(scale_e * len(scene.light_e) / slots)

    def measured(self) -> Measured[Tensor]:
        """Return the frames as a measurement in electrons, for the decoder for any code."""
        from nscc_training.measured import Measured

        if self.model is None:
            return Measured.exact(self.codes, self.tile).tensors()
        masks = self.share[None, None].astype(np.float32) if self.is_still else self.masks
        return Measured.read(self.codes, masks, self.model).tensors()

    def corner(self, size: int) -> CapturedScene:
        """Return the upper left corner, `size` x `size`, of the frames."""
        region = np.s_[..., :size, :size]
        return replace(self, codes=self.codes[region], saturated=self.saturated[region])

    def frame(self, number: int) -> CapturedScene:
        """Return one frame, with only the slots in which it is exposed."""
        slots = np.flatnonzero(self.tile[number].any(axis=(1, 2)))
        frame_slice = slice(number, number + 1)
        tile = self.tile[frame_slice, slots[0] : slots[-1] + 1]
        return replace(
            self, codes=self.codes[frame_slice], tile=tile, saturated=self.saturated[frame_slice]
        )

    def _over_frame(self, tile: NDArray[Any]) -> NDArray[Any]:
        rows, cols = self.codes.shape[-2:]
        repeats = (-(-rows // tile.shape[-2]), -(-cols // tile.shape[-1]))
        return np.tile(tile, (1,) * (tile.ndim - 2) + repeats)[..., :rows, :cols]


def captured(scene: ProtocolScene, tile: Tensor, model: SensorModel, seed: int) -> CapturedScene:
    """Expose a scene through a tile of shutters ([frames,] slots, r, c), with noise of the seed."""
    from nscc_training.sensor_model import frame_of

    tiles = tile if tile.ndim == 4 else tile[None]
    codes = np.stack([
        frame_of(scene.light_e, frame_tile, model, seed * len(tiles) + k).numpy()
        for k, frame_tile in enumerate(tiles)
    ])  # fmt: skip
    return CapturedScene(scene, codes, tiles.float().numpy(), codes >= model.full_code, model)
