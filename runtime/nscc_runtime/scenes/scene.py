"""A scene before it is loaded, for programs with any slots."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.scenes.bracket import parse_times
from nscc_runtime.scenes.colour import Transfer
from nscc_runtime.scenes.exposure import parse_exposure
from nscc_runtime.scenes.load import FramesAre, PlacedLight, laid_scene
from nscc_runtime.scenes.placement import Fit, no_colours, parse_crop


@dataclass(frozen=True)
class Scene:
    """A scene, with the scene options of `nscc run`; None for an option that is not set.

    Parameters
    ----------
    name : str
        A file, a folder or `builtin:NAME`.
    exposure : str or float, optional
        Electrons over the frame for percentile 99 of the scene, or text `E@P` with a percentile.
    transfer : {"linear", "srgb", "pq", "hlg"}, optional
        The transfer curve of the samples, instead of the curve of the file.
    fps : float, optional
        Frames per second of a clip; None for one frame per slot.
    crop : str, optional
        Row and column of the top left corner of the part that is exposed, `R,C`.
    frames_are : {"integrals", "samples"}
        Whether a frame of a clip is the light of its whole time, or of one moment.
    fit : {"crop", "scale", "tiles"}
        How a picture of another size is placed on the array.
    color : bool
        Expose red, green and blue one after the other.
    first : int
        Number of the frame that a clip begins with.
    single : bool
        Expose one frame of a clip as a still.
    white : float, optional
        The sample value of white.
    skip : bool
        Leave out frames that are missing from a folder.
    bracket : bool
        Merge the photos of a folder or pattern, which differ in exposure.
    times : str, optional
        Exposure times of the photos in seconds, `1/250,1/60`, instead of the times in their EXIF.
    """

    name: str
    exposure: str | float | None = None
    transfer: Transfer | None = None
    fps: float | None = None
    crop: str | None = None
    frames_are: FramesAre = "integrals"
    fit: Fit = "crop"
    color: bool = False
    first: int = 0
    single: bool = False
    white: float | None = None
    skip: bool = False
    bracket: bool = False
    times: str | None = None

    def light(
        self,
        slot_us: Sequence[float],
        target: Target,
        warn: Callable[[Diagnostic], None] = lambda _: None,
        progress: Progress = unseen,
    ) -> Light:
        """Return the light on one array. The scene must not need several arrays or colours."""
        return self.laid(slot_us, target, warn, progress)[0].light

    def laid(
        self,
        slot_us: Sequence[float],
        target: Target,
        warn: Callable[[Diagnostic], None] = lambda _: None,
        progress: Progress = unseen,
    ) -> tuple[PlacedLight, ...]:
        """Return the light in slots of these lengths on the array of `target`.

        It is the luminance, or three lights (red, green and blue) at the exposure of the luminance.
        Raises Rejected like `laid_scene`."""

        options = vars(self) | {
            "exposure": None if self.exposure is None else parse_exposure(self.exposure),
            "crop": None if self.crop is None else parse_crop(self.crop),
            "times": None if self.times is None else parse_times(self.times),
            "slot_us": slot_us, "rows": target.rows, "cols": target.cols, "progress": progress,
        }  # fmt: skip
        del options["name"], options["color"]
        load = partial(laid_scene, self.name, **options)
        diagnostics: list[Diagnostic] = []
        grey = load(warn=diagnostics.append)
        in_colours = self.color and grey.colour
        if self.color and not grey.colour:
            diagnostics.append(no_colours(self.name))
        for diagnostic in diagnostics:
            if not (in_colours and diagnostic.data.get("grey")):
                warn(diagnostic)
        if not in_colours:
            return (grey,)
        factor = grey.light.exposure_scale_e
        return tuple(load(channel=k, factor=factor) for k in range(3))
