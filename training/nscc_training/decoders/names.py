"""The decoders' names, without the networks."""

from __future__ import annotations

DECODERS = ("unet2d", "unet3d", "fcnet", "unrolled", "refined")
SIZES = ("paper", "small")
