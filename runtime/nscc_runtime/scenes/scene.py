"""A scene that is named and not loaded yet: one for programs of any slots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.target.target import Target
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.crop import parse_crop
from nscc_runtime.scenes.exposure import parse_exposure
from nscc_runtime.scenes.load import FramesAre, load_scene


@dataclass(frozen=True)
class Scene:
    """A scene as the command line names it, with what it says of it; None: not said.

    `name` is a file, a folder or `builtin:NAME`, `exposure` is text as E[@P], `crop` as R,C.
    """

    name: str
    exposure: str | None = None
    transfer: Transfer | None = None
    fps: float | None = None
    crop: str | None = None
    frames_are: FramesAre = "integrals"

    def light(
        self,
        slot_us: Sequence[float],
        target: Target,
        warn: Callable[[Diagnostic], None] = lambda _: None,
        progress: Progress = unseen,
    ) -> Light:
        """The light in slots of these lengths on the array of `target`; raises as `load_scene`."""
        return load_scene(
            self.name,
            slot_us=slot_us,
            rows=target.rows,
            cols=target.cols,
            exposure=None if self.exposure is None else parse_exposure(self.exposure),
            transfer=self.transfer,
            fps=self.fps,
            crop=None if self.crop is None else parse_crop(self.crop),
            frames_are=self.frames_are,
            warn=warn,
            progress=progress,
        )
