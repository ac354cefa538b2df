"""A scene before it is loaded, for programs with any slots."""

from __future__ import annotations

import os
from dataclasses import dataclass
from math import inf
from typing import Literal, get_args

from nscc.toml.kinds import (
    ANY_NUMBER,
    Flag,
    Instance,
    Integer,
    TextKind,
    TextOrNumbers,
)
from nscc.toml.schema import key

FramesAre = Literal["integrals", "samples"]
Transfer = Literal["linear", "srgb", "pq", "hlg"]
Fit = Literal["crop", "scale", "tiles"]
FITS: tuple[Fit, ...] = get_args(Fit)


@dataclass(frozen=True)
class Scene:
    """A scene and how it is placed on the array; None for an option that is not set.

    The fields are the arguments of `nscc_runtime.scene` and the scene options of `nscc run`."""

    name: str = key(
        Instance(
            (str, os.PathLike),
            "the name of a scene",
            ("an array is already light: capture(program, array)",),
        ),
        "A file, a folder of pictures, or builtin:hdr, builtin:motion, builtin:flat:E, "
        "builtin:dark",
        name="scene",
        required=True,
    )
    exposure: str | float | None = key(
        TextOrNumbers(1),
        "Electrons over the frame at percentile P (99)",
        None,
        notation="E[@P]",
    )
    transfer: Transfer | None = key(TextKind(get_args(Transfer)), "The scene's curve", None)
    white: float | None = key(
        ANY_NUMBER,
        "The sample value of white, such as 4095",
        None,
        notation="W",
        default_text="the largest value of the type",
    )
    skip: bool = key(Flag(), "Leave out missing frames of a folder", False)
    bracket: bool = key(
        Flag(),
        "Merge photos with several exposures, a folder or 'DIR/*.jpg', to one still",
        False,
    )
    times: str | tuple[float, ...] | None = key(
        TextOrNumbers(None),
        "With --bracket: the exposure times in seconds",
        None,
        notation="S,S..",
        default_text="from EXIF data",
    )
    fps: float | None = key(
        ANY_NUMBER,
        "The frame rate of the clip, in the time of the slots",
        None,
        default_text="each slot shows the next frame",
    )
    crop: str | tuple[int, int] | None = key(
        TextOrNumbers(2), "Top left corner of the array in the scene", None, notation="R,C"
    )
    frames_are: FramesAre = key(
        TextKind(get_args(FramesAre)),
        "Whether a clip's frames contain the light of their whole time, or of one instant",
        "integrals",
        default_text="",
    )
    fit: Fit = key(
        TextKind(FITS),
        "For a picture of another size than the array: expose its middle, all of it scaled, or "
        "all of it in parts",
        "crop",
    )
    color: bool = key(Flag(), "Expose red, green and blue, one after the other", False)
    first: int = key(
        Integer(0, inf), "The first frame of the clip, counted from 0", 0, notation="K"
    )
    single: bool = key(Flag(), "Use this frame of a clip as a still", False, name="still")
