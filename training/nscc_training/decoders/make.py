"""Decoders by name and size, and what they cost."""

from __future__ import annotations

from dataclasses import dataclass

import torch
from torch import nn

from nscc_training.decoders.blocks import BlockNet
from nscc_training.decoders.names import DECODERS, SIZES
from nscc_training.decoders.unet import ClipUNet, StillUNet
from nscc_training.decoders.unrolled import Unrolled
from nscc_training.import_paths import imported, is_import_path

_WIDTHS = {
    ("unet2d", "paper"): (32, 64, 128, 256, 512, 1024),
    ("unet2d", "small"): (16, 32, 64, 128),
    # The paper says "24 up to 768", doubling; five levels end at 384.
    ("unet3d", "paper"): (24, 48, 96, 192, 384),
    ("unet3d", "small"): (8, 16, 32, 64),
    ("unrolled", "paper"): (64, 128, 256),
    ("unrolled", "small"): (24, 48, 64),
}
_STAGES = {"paper": 9, "small": 3}
_TV_ITERATIONS = 20
_HIDDEN = {"paper": 4096, "small": 96}


@dataclass(frozen=True)
class Task:
    """What a decoder is for: stills or clips of `slots`, coded by a `tile`; what it may see."""

    kind: str
    slots: int
    tile: tuple[int, int]
    sees_code: bool = True


def make_decoder(name: str, size: str, task: Task) -> nn.Module:
    """A decoder of `DECODERS` in a size of `SIZES`, or one of the user's own, `module:name`.

    The user's is called as name(size=.., kind=.., slots=.., tile=.., sees_code=..). ValueError for
    what a decoder cannot be.
    """
    if is_import_path(name):
        made = imported(name, "decoder")(
            size=size, kind=task.kind, slots=task.slots, tile=task.tile, sees_code=task.sees_code
        )
        if not isinstance(made, nn.Module):
            raise ValueError(f"'{name}' gave a {type(made).__name__}, not a torch module")
        return made
    if name not in DECODERS or size not in SIZES:
        raise ValueError(f"{name!r} {size!r} is none of {DECODERS} in the sizes {SIZES}")
    still = task.kind == "still"
    # The paper's networks begin with nothing; the small ones have no time for that.
    guesses = size == "small"
    if name == "unet2d":
        return StillUNet(
            _WIDTHS[name, size], None if still else task.slots, task.sees_code, guesses
        )
    if still:
        raise ValueError(f"{name} reconstructs clips, not stills")
    if name == "unet3d":
        if not task.sees_code:
            raise ValueError("unet3d is fed with S^T E, which holds the code: it cannot do without")
        return ClipUNet(_WIDTHS[name, size], task.slots, guesses)
    if name in ("unrolled", "refined"):
        if not task.sees_code:
            raise ValueError(f"{name} projects with the code: it cannot do without")
        iterations = _TV_ITERATIONS if name == "refined" else 0
        return Unrolled(_WIDTHS["unrolled", size], task.slots, _STAGES[size], iterations)
    return BlockNet(_HIDDEN[size], task.slots, task.tile)


def parameter_count(module: nn.Module) -> int:
    """How many numbers a module has learned."""
    return sum(p.numel() for p in module.parameters())


def flops(module: nn.Module, slots: int, rows: int, cols: int) -> int:
    """Floating-point operations, multiplications and additions each, for one frame of that size."""
    from torch.utils.flop_counter import FlopCounterMode

    device = next(module.parameters()).device
    with FlopCounterMode(display=False) as counter, torch.no_grad():
        module(
            torch.zeros(1, rows, cols, device=device),
            torch.ones(slots, rows, cols, device=device),
        )
    return int(counter.get_total_flops())
