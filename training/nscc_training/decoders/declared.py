"""Declarations of all decoders, without loading a network."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from nscc.plugins import added, unusable

SIZES = ("paper", "small")


@dataclass(frozen=True)
class DecoderTask:
    """What a decoder has to reconstruct, and from what.

    `kind` is "still" or "clip". The frame has `slots` slots, coded by a tile (rows, cols), in one
    or two `buckets`. With `classes`, the decoder names the class of a clip instead. `sees_code`
    means that the network receives the shutters as input. `guess` means that a U-Net starts from a
    first guess; None leaves this to the decoder's size."""

    kind: str
    slots: int
    tile: tuple[int, int]
    sees_code: bool = True
    buckets: int = 1
    guess: bool | None = None
    classes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Decoder:
    """The declaration of a decoder of nscc.

    Attributes
    ----------
    name : str
    network : str
        `module:class` of the network, which takes its channels, a task and the size. The module is
        loaded when the decoder is built.
    channels : mapping of str to tuple of int
        The channels of the layers, by size.
    stills, clips, classifies : bool
        Whether the decoder reconstructs stills, and clips, or names the classes of clips.
    needs_code : str
        Why the decoder needs the shutter code as input; empty if it does not.
    any_code : bool
        Whether it decodes codes that it was not trained with.
    fixed_channels : bool
        Whether its width is fixed: it starts from weights that come with nscc, or has no weights.
    scales : bool
        Whether it also has other widths, which start from random weights.
    guesses : bool
        Whether it can start from a first guess, or without.
    two_buckets : bool
        Whether it takes frames (batch, 2, rows, cols) of clips, and shutters of the first bucket.
    """

    name: str
    network: str
    channels: Mapping[str, tuple[int, ...]]
    stills: bool = False
    clips: bool = True
    classifies: bool = False
    needs_code: str = ""
    any_code: bool = True
    fixed_channels: bool = False
    scales: bool = False
    guesses: bool = False
    two_buckets: bool = False

    @property
    def has_weights(self) -> bool:
        """Whether it has weights that can learn."""
        return self.scales or not self.fixed_channels


_HERE = "nscc_training.decoders"
_PROJECTS = "projects with the code, so it needs the code"
_UNROLLED = {"paper": (64, 128, 256), "small": (24, 48, 64)}

_OWN = (
    Decoder(
        "unet2d", f"{_HERE}.unet:StillUNet",
        {"paper": (32, 64, 128, 256, 512, 1024), "small": (16, 32, 64, 128)},
        stills=True, guesses=True, two_buckets=True,
    ),
    # The paper says "24 up to 768", doubling; five levels end at 384.
    Decoder(
        "unet3d", f"{_HERE}.unet:ClipUNet",
        {"paper": (24, 48, 96, 192, 384), "small": (8, 16, 32, 64)},
        needs_code="receives S^T E, which contains the code, so it needs the code",
        guesses=True, two_buckets=True,
    ),
    Decoder(
        "fcnet", f"{_HERE}.blocks:BlockNet", {"paper": (4096,), "small": (96,)}, any_code=False
    ),
    Decoder("unrolled", f"{_HERE}.unet:Unrolled", _UNROLLED, needs_code=_PROJECTS),
    Decoder(
        "any", "nscc_training.any_code.decode:AnyCode",
        {"paper": (32, 64, 96), "small": (32, 64, 96)}, stills=True,
        needs_code="simulates the capture of a clip with its code, so it needs the code",
        fixed_channels=True, scales=True, two_buckets=True,
    ),
    Decoder(
        "divided", f"{_HERE}.divided:Divided", {"paper": (1,), "small": (1,)}, stills=True,
        clips=False, fixed_channels=True,
        needs_code="divides by the open time of a code, so it needs the code",
    ),
    Decoder(
        "classifier", f"{_HERE}.classifier:Classifier",
        {"paper": (64, 128, 256), "small": (16, 32, 64)}, clips=False, classifies=True,
    ),
    Decoder("refined", f"{_HERE}.unet:Refined", _UNROLLED, needs_code=_PROJECTS),
)  # fmt: skip
DECODERS = {decoder.name: decoder for decoder in _OWN}


def added_decoders() -> dict[str, Callable[..., Any]]:
    """Return the decoders that installed packages add (entry points `nscc.decoders`): a function
    that builds the network, by name.

    Raises Rejected (NS0905) for one that is not callable."""
    makers = added("nscc.decoders", DECODERS)
    for name, make in makers.items():
        if not callable(make):
            raise unusable("nscc.decoders", name, f"a {type(make).__name__} makes no decoder")
    return makers
