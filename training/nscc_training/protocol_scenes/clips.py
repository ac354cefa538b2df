"""Scenes of the protocols of clips: windows, with or without a class."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Floats, Floats32
from nscc_training import curves, made_scenes, metrics
from nscc_training.measures import decibels
from nscc_training.metrics import mean_square_error
from nscc_training.protocol_scenes.protocol_scene import Item, ProtocolScene, Unusable, in_files
from nscc_training.protocols import Protocol
from nscc_training.random_streams import DrawStream
from nscc_training.scene_files import centre_of, class_of, frames_in, light_in


@dataclass(frozen=True, eq=False)
class ClipWindow(ProtocolScene):
    """A window of a clip. `scale_e` is the source's white in electrons per slot. With `srgb`,
    errors are measured in display encoding."""

    scale_e: float
    srgb: bool

    @property
    def peak_e(self) -> float:
        """The light that is white in the file."""
        return self.scale_e

    def scores(self, result_e: Floats) -> Item:
        """Return PSNR and SSIM over the frames, and the RMS error of differences between frames, as
        JSON values.

        `result_e` (N, rows, cols) is in electrons per slot. Frames without any error have infinite
        dB and are only counted."""
        truth, result = (encoded(x / self.scale_e, self.srgb) for x in (self.light_e, result_e))
        errors = [mean_square_error(a, b) for a, b in zip(truth, result, strict=True)]
        frame_summary = metrics.frame_scores(errors, 1.0)
        return {
            "psnr_db": decibels(frame_summary.mean),
            "psnr_of_mean_mse_db": decibels(frame_summary.of_mean_mse),
            "infinite_frames": frame_summary.infinite,
            "ssim": metrics.ssim(truth, result, data_range=1.0),
            "temporal_error": metrics.temporal_error(truth, result, data_range=1.0),
        }


def windows(path: Path, protocol: Protocol) -> Iterator[ClipWindow | Unusable]:
    """Yield the windows of the clip in the file `path`, in order and cut to its centre, at most as
    many as the protocol says; `Unusable` for windows that cannot be exposed."""
    known = protocol["transfer"]
    srgb = known.get(path.suffix.lower().lstrip("."), known["other"]) == "srgb"
    size = int(protocol["size"])
    frames: Iterable[Array] = frames_in(path)
    # A frame that is too small stays whole, because the reason names its size.
    cut = (centre_of(f, size) if min(f.shape[:2]) >= size else f for f in frames)
    lights = (light_in(frame, "srgb" if srgb else "linear") for frame in cut)
    clip_windows = windows_of(path, lights, srgb, protocol)
    yield from islice(clip_windows, protocol.values.get("windows"))


def windows_of(
    path: Path, lights: Iterable[Array], srgb: bool, protocol: Protocol
) -> Iterator[ClipWindow | Unusable]:
    """Yield the windows of one clip from the light of its frames, each (rows, cols). A window
    begins where the one before ends.

    `path` names the clip. With `srgb`, errors are measured in display encoding. A clip that is too
    small or too short gives one `Unusable`; frames after the last whole window are left out."""
    size, count, start = int(protocol["size"]), int(protocol["frames"]), {"frame": 0}
    window: list[Array] = []
    number = -1
    for number, light in enumerate(lights):
        rows, cols = light.shape
        if min(rows, cols) < size:
            yield Unusable(path, start, f"{rows} x {cols} is smaller than {size} x {size}")
            return
        window.append(centre_of(light, size))
        if len(window) == count:
            clip = np.stack(window).astype(np.float64)
            yield exposed_window(path, number + 1 - count, clip, srgb, protocol)
            window = []
    if number + 1 < count:
        yield Unusable(path, start, f"it has {number + 1} frames, but a window has {count}")


def exposed_window(
    path: Path, first: int, light: Floats, srgb: bool, protocol: Protocol
) -> ClipWindow | Unusable:
    """Return a window as a scene: its light is scaled so that a percentile of its light over the
    frame fills a well, or the protocol's part of a well.

    `first` is the number of its first frame in the clip `path`, and `light` (N, rows, cols) is 1
    for white. Returns Unusable for a window that is dark at this percentile."""
    level = float(np.percentile(light.sum(axis=0), protocol["full_well_percentile"]))
    if level <= 0:
        return Unusable(
            path, {"frame": first}, "it is dark at the percentile that should fill a well"
        )
    # In a film of several coded frames, each frame fills a well on average.
    scale_e = float(protocol["full_well_e"]) / level * int(protocol.values.get("film", 1))
    scale_e *= protocol.light
    return ClipWindow(path, None, first, light * scale_e, protocol, scale_e, srgb)


def encoded(light: Floats, srgb: bool) -> Floats:
    """Return light, clipped to 0..1, in the encoding in which errors are measured: sRGB with
    `srgb`, else linear. `light` is relative to white, of any shape."""
    clipped = np.clip(light, 0.0, 1.0)
    return curves.srgb(clipped) if srgb else clipped


@dataclass(frozen=True, eq=False)
class ClassWindow(ClipWindow):
    """A window of a clip whose class is `label`, one of `classes`. Its reconstruction is an array
    of scores, one for each class."""

    label: str
    classes: tuple[str, ...]

    @property
    def truth_e(self) -> Array:
        """The truth: 1 for the class of the clip, 0 for the others."""
        return np.array([float(name == self.label) for name in self.classes])

    def scores(self, result_e: Array) -> Item:
        """Return whether the class with the highest score is right (`correct`, 1 or 0), the
        `cross_entropy` in nats, and the names of both classes. Of equal scores, the first is the
        highest.

        `result_e` (classes,) are logarithms of likelihoods, up to a common constant."""
        decoded = self.classes[int(np.argmax(result_e))]
        scores = np.asarray(result_e, np.float64)
        surprise = np.logaddexp.reduce(scores) - scores[self.classes.index(self.label)]
        return {
            "correct": float(decoded == self.label),
            "cross_entropy": float(surprise),
            "class": self.label,
            "decoded": decoded,
        }


def with_class(window: ClipWindow, label: str, classes: Sequence[str]) -> ClassWindow:
    """Return a window with the class `label` of its clip, one of `classes`."""
    return ClassWindow(**vars(window), label=label, classes=tuple(classes))


def class_windows(
    files: Sequence[Path], classes: Sequence[str], protocol: Protocol, seed: int
) -> Iterator[ProtocolScene | Unusable]:
    """Return the windows of the clips in `files`, in order, with the classes that their folders
    name. Without files, return procedural scenes, which `seed` determines. Raises Rejected (NS0811)
    if the folder of a file is not named after one of `classes`."""
    if not files:
        return _moving_textures(classes, protocol, seed)
    labels = [class_of(path, classes) for path in files]

    def of_class(path: Path, index: int) -> Iterator[ProtocolScene | Unusable]:
        """Yield the windows (excerpts with as many frames as the protocol needs) of the clip in
        `path`, each with the class that is `labels[index]`. `Unusable` is passed on."""
        for window in windows(path, protocol):
            if isinstance(window, ClipWindow):
                window = with_class(window, labels[index], classes)
            yield window

    return in_files(files, of_class)


def moving_texture(
    generator: np.random.Generator,
    index: int,
    classes: Sequence[str],
    frames: int,
    size: int,
    protocol: Protocol,
) -> tuple[str, Floats32]:
    """Return the class of procedural scene number `index`, and its light (frames, size, size) on
    0..1. The classes, names of `made_scenes.DIRECTIONS`, alternate, and the protocol limits the
    speed, which is drawn from `generator`."""
    label = classes[index % len(classes)]
    speed = float(np.exp(generator.uniform(*np.log(protocol["speed"]))))
    clip = made_scenes.moving_texture(generator, frames, size, label, speed)
    return label, clip


def _moving_textures(
    classes: Sequence[str], protocol: Protocol, seed: int
) -> Iterator[ClassWindow | Unusable]:
    """Yield windows of synthetic textures that move in the direction of their class, one of
    `classes` in turn. `seed` determines them, and the protocol their number."""
    for index in range(int(protocol["procedural"])):
        generator = np.random.default_rng([seed, DrawStream.EVALUATION_SCENES, index])
        sides = int(protocol["frames"]), int(protocol["size"])
        label, clip = moving_texture(generator, index, classes, *sides, protocol)
        window = exposed_window(
            Path(f"{label}-{index}"),
            first=0,
            light=clip.astype(np.float64),
            srgb=False,
            protocol=protocol,
        )
        yield window if isinstance(window, Unusable) else with_class(window, label, classes)
