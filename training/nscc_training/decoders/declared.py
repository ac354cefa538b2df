"""What decoders there are: each declared here once, whole, without loading a network."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from nscc.plugins import added, unusable

SIZES = ("paper", "small")


@dataclass(frozen=True)
class Task:
    """What a decoder is for: stills or clips of `slots`, coded by a `tile`, in one bucket or two;
    what it may see, and whether a U-Net improves on a first guess (None: its size says)."""

    kind: str
    slots: int
    tile: tuple[int, int]
    sees_code: bool = True
    buckets: int = 1
    guess: bool | None = None


@dataclass(frozen=True)
class Decoder:
    """A decoder of nscc's own.

    `network` is the `module:function` that makes it, called with its layers' channels, a `Task` and
    the size, and loaded only then. `channels` has those of each size. `stills`, `clips`: whether it
    reconstructs those. `needs_code` says why it cannot do without the code, ""
    if it can. `any_code`: whether it decodes codes that it was not trained with. `given`: whether
    it has the declared channels alone, for it begins with weights that come with nscc, or has none.
    `guesses`: whether it can begin with a first guess, or without.
    `two_buckets`: whether it takes frames (batch, 2, rows, cols) of clips, with the shutters of the
    first bucket.
    """

    name: str
    network: str
    channels: Mapping[str, tuple[int, ...]]
    stills: bool = False
    clips: bool = True
    needs_code: str = ""
    any_code: bool = True
    given: bool = False
    guesses: bool = False
    two_buckets: bool = False


_HERE = "nscc_training.decoders"
_PROJECTS = "projects with the code: it cannot do without"
_UNROLLED = {"paper": (64, 128, 256), "small": (24, 48, 64)}

_OWN = (
    Decoder(
        "unet2d",
        f"{_HERE}.unet:flat",
        {"paper": (32, 64, 128, 256, 512, 1024), "small": (16, 32, 64, 128)},
        stills=True,
        guesses=True,
        two_buckets=True,
    ),
    # The paper says "24 up to 768", doubling; five levels end at 384.
    Decoder(
        "unet3d",
        f"{_HERE}.unet:deep",
        {"paper": (24, 48, 96, 192, 384), "small": (8, 16, 32, 64)},
        needs_code="is fed with S^T E, which holds the code: it cannot do without",
        guesses=True,
        two_buckets=True,
    ),
    Decoder("fcnet", f"{_HERE}.blocks:fcnet", {"paper": (4096,), "small": (96,)}, any_code=False),
    Decoder("unrolled", f"{_HERE}.unrolled:unrolled", _UNROLLED, needs_code=_PROJECTS),
    Decoder(
        "any",
        "nscc_training.any_code.decoder:any_code",
        {"paper": (32, 64, 96), "small": (32, 64, 96)},
        stills=True,
        needs_code="asks what a clip would have given behind its code: it cannot do without",
        given=True,
        two_buckets=True,
    ),
    Decoder(
        "divided",
        f"{_HERE}.divided:divided",
        {"paper": (1,), "small": (1,)},
        stills=True,
        clips=False,
        given=True,
        needs_code="divides by the time that a code is open: it cannot do without",
    ),
    Decoder("refined", f"{_HERE}.unrolled:refined", _UNROLLED, needs_code=_PROJECTS),
)
DECODERS = {decoder.name: decoder for decoder in _OWN}


def others() -> dict[str, Callable[..., Any]]:
    """What makes the decoders that other distributions add, by name; called as a user's own is.

    Raises Rejected (NS0905) for what cannot be called or has a name of `DECODERS`.
    """
    found = added("nscc.decoders", DECODERS)
    for name, make in found.items():
        if not callable(make):
            raise unusable("nscc.decoders", name, f"a {type(make).__name__} makes no decoder")
    return found
