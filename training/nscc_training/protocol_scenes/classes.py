"""Protocol class-v1: a decoder classifies windows of clips. The class of a file is the name of its
folder."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array, Floats32
from nscc.diagnostics.diagnostic import rejected
from nscc_training import made_scenes
from nscc_training.protocol_scenes.protocol_scene import ProtocolScene, Unusable, in_files
from nscc_training.protocol_scenes.video import ClipWindow, exposed_window, windows
from nscc_training.protocols import Protocol
from nscc_training.random_streams import DrawStream


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

    def scores(self, result_e: Array) -> dict[str, Any]:
        """Return whether the class with the highest score (of equal ones the first) is right
        (`correct`, 1 or 0), the `cross_entropy` in nats, and the names of both classes.

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


def class_folders(folder: Path) -> Path:
    """Return the pattern with which `files_in` finds the files of all classes in a folder; a path
    that is no folder is returned as it is."""
    return folder / "*" if folder.is_dir() else folder


def class_of(path: Path, classes: Sequence[str]) -> str:
    """Return which of `classes` the file `path` belongs to: the name of its folder. Raises Rejected
    (NS0811) for another name."""
    name = path.parent.name
    if name not in classes:
        raise rejected(
            "NS0811",
            f"the folder of '{path}' is not named after a class",
            notes=(f"the classes are {', '.join(classes)[:200]}",),
            helps=(
                "put the clips of each class into a folder of its name, or change [data] classes",
            ),
        )
    return name


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
