"""The base class of the scenes of all protocols."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from nscc.arrays import Array
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_training.protocols import Protocol
from nscc_training.scene_files import names_of

Item = dict[str, Any]
"""A scored picture or frame as JSON values: its file, its place in the file, and its metrics."""


@dataclass(frozen=True, eq=False)
class ProtocolScene(ABC):
    """A scene of a protocol: its light, and its place in a file.

    `file` is the name of the file as `names_of` returns it. `light_e` is in electrons over the
    frame (rows, cols), or per slot (N, rows, cols). `crop` is the corner (row, column) of a crop in
    its picture, `frame` the first frame of a window in its clip; both are None where they do not
    apply."""

    file: Path
    crop: tuple[int, int] | None
    frame: int | None
    light_e: Array
    protocol: Protocol

    @property
    def truth_e(self) -> Array:
        """The ideal reconstruction in electrons, by default the light."""
        return self.light_e

    @property
    @abstractmethod
    def peak_e(self) -> float:
        """The light in electrons that losses count as 1."""

    @abstractmethod
    def scores(self, result_e: Array) -> Item:
        """Return the protocol's metrics of a reconstruction, by name, as JSON values. `result_e` is
        in electrons, in the shape of the truth."""

    def result(self, result_e: Array) -> Array:
        """Return a reconstruction in the form that is scored, by default unchanged."""
        return result_e

    def items(self, result_e: Array) -> list[Item]:
        """Return the scored items of a reconstruction as JSON values: one for the scene, or one for
        each frame, with file, place and metrics."""
        crop = None if self.crop is None else list(self.crop)
        place = {"file": self.file.as_posix(), "crop": crop, "frame": self.frame}
        return [{**place, **self.scores(result_e)}]


@dataclass(frozen=True)
class Unusable:
    """A scene that the protocol cannot expose: its file, its place in the file, and the reason.

    `damage` is the error of a file that cannot be read; None if only the content of the scene is
    unsuitable."""

    file: Path
    place: Mapping[str, Any]
    reason: str
    damage: Diagnostic | None = None


def in_files(
    files: Sequence[Path], scenes_of: Callable[[Path, int], Iterable[ProtocolScene | Unusable]]
) -> Iterator[ProtocolScene | Unusable]:
    """Yield the scenes that `scenes_of` returns for each file and its index, under the names of
    `names_of`.

    A file for which it raises Rejected is `Unusable`, with the first error, and the next file
    follows."""
    names = names_of(files)
    for index, path in enumerate(files):
        try:
            for scene in scenes_of(path, index):
                yield replace(scene, file=names[path])
        except Rejected as rejected:
            error = rejected.diagnostics[0]
            yield Unusable(names[path], {}, error.message, error)


def on_unit_range(light_e: Array, result_e: Array, peak_e: float) -> tuple[Array, Array]:
    """Return true light and reconstruction, both in electrons, divided by the peak (above 0) and
    clipped to 0..1. Both have one shape."""
    return np.clip(light_e / peak_e, 0.0, 1.0), np.clip(result_e / peak_e, 0.0, 1.0)
