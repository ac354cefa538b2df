"""Captured frames of scenes, and decoders that need no training, from coded frames to light."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from nscc.arrays import Bools, Floats, Floats32
from nscc_training.baselines import sci
from nscc_training.baselines.dictionary import made_dictionary
from nscc_training.baselines.merge_loop import merged
from nscc_training.baselines.tv_loop import denoise
from nscc_training.code_choices import over_array
from nscc_training.protocol_scenes.clips import ClipWindow
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene
from nscc_training.protocol_scenes.sci import SciClip

if TYPE_CHECKING:
    from torch import Tensor

    from nscc_training.measured import Measured
    from nscc_training.sensor_model import SensorModel


@dataclass(frozen=True, eq=False)
class CapturedScene:
    """Captured frames of one scene.

    `codes` (frames, rows, cols) are converter codes above the offset. `tile` (frames, slots, r, c)
    contains the shutters, which repeat over the array. `saturated` (frames, rows, cols) marks
    saturated codes. `model` is the sensor, None for exact measurements."""

    scene: ProtocolScene
    codes: Floats32
    tile: Floats32
    saturated: Bools
    model: SensorModel | None

    @classmethod
    def of_benchmark(cls, clip: SciClip) -> CapturedScene:
        """Return the measurement of a benchmark clip, which is exact and not saturated."""
        codes = clip.measurement[None]
        return cls(clip, codes, clip.mask[None], np.zeros(codes.shape, np.bool_), None)

    @property
    def is_still(self) -> bool:
        """Whether the scene is a still."""
        return self.scene.light_e.ndim == 2

    @cached_property
    def masks(self) -> Floats32:
        """The shutters over the frame, (frames, slots, rows, cols)."""
        return over_array(self.tile, *self.codes.shape[-2:])

    @cached_property
    def share(self) -> Floats:
        """The fraction of the first frame for which each pixel is open, (rows, cols)."""
        share = self.tile[0].mean(axis=0, dtype=np.float64)
        return over_array(share, *self.codes.shape[-2:])

    @property
    def code_e(self) -> float:
        """Electrons per code."""
        return 1.0 if self.model is None else self.model.electrons_per_lsb

    @property
    def white_e(self) -> float:
        """Electrons per slot of the source's white, the unit of total variation; 1 for a clip whose
        white is not known."""
        scene, slots = self.scene, self.tile.shape[1]
        scale_e = scene.scale_e if isinstance(scene, ClipWindow) else 1.0
        return float(scale_e * len(scene.light_e) / slots)

    def measured(self) -> Measured[Tensor]:
        """Return the frames as a measurement in electrons, for the decoder for any code: of a still
        with one slot, of a clip with all slots. Of a benchmark clip, light is on 0..1."""
        from nscc_training.measured import Measured

        if self.model is None:
            return Measured.exact(self.codes, self.tile).tensors()
        masks = self.share[None, None].astype(np.float32) if self.is_still else self.masks
        return Measured.read(self.codes, masks, self.model).tensors()

    def corner(self, size: int) -> CapturedScene:
        """Return the upper left corner of the frames, `size` x `size` or smaller. The tile and the
        scene stay whole."""
        region = np.s_[..., :size, :size]
        return replace(self, codes=self.codes[region], saturated=self.saturated[region])

    def frame(self, number: int) -> CapturedScene:
        """Return frame `number` (from 0) alone. Of its slots, only those from the first in which a
        pixel is open to the last are kept; there must be one. The scene stays whole."""
        slots = np.flatnonzero(self.tile[number].any(axis=(1, 2)))
        frame_slice = slice(number, number + 1)
        tile = self.tile[frame_slice, slots[0] : slots[-1] + 1]
        return replace(
            self, codes=self.codes[frame_slice], tile=tile, saturated=self.saturated[frame_slice]
        )


def captured(scene: ProtocolScene, tile: Tensor, model: SensorModel, seed: int) -> CapturedScene:
    """Expose a scene through a tile of shutters ([frames,] slots, r, c), one frame for each tile,
    by the sensor `model`. `seed` is that of the noise."""
    from nscc_training.sensor_model import frame_of

    tiles = tile if tile.ndim == 4 else tile[None]
    codes = np.stack(
        [
            frame_of(scene.light_e, frame_tile, model, seed * len(tiles) + k).numpy()
            for k, frame_tile in enumerate(tiles)
        ]
    )
    return CapturedScene(scene, codes, tiles.float().numpy(), codes >= model.full_code, model)


Light = Floats


class Method(NamedTuple):
    """A decoder without training.

    `decode` returns electrons from a `CapturedScene`. `sees` is "truth" for reference methods,
    which use the ground truth. `settings` are options of `decode` by name, which `nscc tradeoff
    decoder` compares."""

    decode: Callable[..., Light]
    sees: Literal["capture", "truth"] = "capture"
    settings: Mapping[str, Mapping[str, Any]] | None = None


def _clip(loop: Callable[..., Floats32], captured: CapturedScene, **options: Any) -> Light:
    """Return the clip, in electrons per slot, that `loop` reconstructs from the first frame of a
    capture.

    `loop` takes a measurement (rows, cols) in units of white, a mask (N, rows, cols) and `options`,
    and returns a clip (N, rows, cols) in units of white."""
    white_e = captured.white_e
    measurement = (captured.codes[0] * (captured.code_e / white_e)).astype(np.float32)
    return np.asarray(loop(measurement, captured.masks[0], **options), np.float64) * white_e


def _of_truth(loop: Callable[..., Floats32], captured: CapturedScene) -> Light:
    """Return the clip (N, rows, cols), in electrons per slot, that `loop`, a reference method,
    computes from the true clip and the mask of the first frame."""
    truth = captured.scene.light_e.astype(np.float32)
    return np.asarray(loop(truth, captured.masks[0]), np.float64)


def _merged(captured: CapturedScene) -> Light:
    """Return the light over the frame in electrons (rows, cols) that merging neighbours estimates
    from the first frame of `captured`, a still with a sensor model."""
    model = captured.model
    assert model is not None
    noise_e = model.adc_noise_lsb * model.electrons_per_lsb
    return merged(
        captured.codes[0], captured.share, model.electrons_per_lsb, captured.saturated[0], noise_e
    )


def _sparse(captured: CapturedScene, **options: Any) -> Light:
    """Return the light over the frame in electrons (rows, cols) that convolutional sparse coding
    estimates of `captured`, a still, beginning from merged neighbours. `options` (`iterations`) go
    to `coded_still`."""
    from nscc_training.baselines.sparse_coding import coded_still

    model = captured.model
    assert model is not None
    return coded_still(
        captured.codes[0],
        captured.share,
        _merged(captured),
        model.electrons_per_lsb,
        captured.saturated[0],
        model.full_well_e,
        **options,
    )


def _any(captured: CapturedScene, **options: Any) -> Light:
    """Return the light that the decoder for any code estimates, in electrons over the frame for a
    still or per slot for a clip. `options` are those of the decoder."""
    from nscc_training.any_code.decode import decoded_clip, decoded_still

    decode = decoded_still if captured.is_still else decoded_clip
    return np.asarray(decode(captured.measured(), **options)[0].double().numpy())


def _read_out(captured: CapturedScene) -> Light:
    """Return the first frame's measurement of each pixel divided by its open fraction of the frame,
    in electrons over the frame (rows, cols). All pixels must open."""
    return np.asarray(captured.codes[0].astype(np.float64) * captured.code_e / captured.share)


_TV = {f"{n}": {"iterations": n} for n in (5, 10, 20, 40, 80)}
CLIPS: Mapping[str, Method] = {
    "gap-tv": Method(partial(_clip, sci.gap_tv), settings=_TV),
    "admm-tv": Method(partial(_clip, sci.admm_tv), settings=_TV),
    "dictionary": Method(partial(_clip, sci.from_dictionary), settings={"learned": {}}),
    "adjoint": Method(partial(_clip, sci.adjoint), settings={"S^T E": {}}),
    "bilinear": Method(partial(_of_truth, sci.bilinear), "truth"),
    "thin-out": Method(partial(_of_truth, lambda truth, _mask: sci.thin_out(truth)), "truth"),
    "any": Method(_any, settings={f"{n}": {"count": n} for n in (2, 4, 8, 12)}),
}
STILLS: Mapping[str, Method] = {
    "merged": Method(_merged, settings={"neighbours": {}}),
    "sparse-coding": Method(_sparse, settings={f"{n}": {"iterations": n} for n in (15, 60)}),
    "any": Method(_any, settings={"1": {"count": 1}}),
    "read-out": Method(_read_out),
}


def load(method: str, slots: int) -> None:
    """Compile or learn everything that a method needs for clips of `slots` slots, so that measured
    times exclude it. Methods that need nothing are accepted."""
    if method in ("gap-tv", "admm-tv", "any"):
        denoise.load()
    if method == "dictionary":
        made_dictionary(slots)
