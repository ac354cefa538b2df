"""The light of slots as an argument of compiled loops."""

from __future__ import annotations

from typing import Annotated, NamedTuple

from nscc_runtime.loop import Floats, Floats32, Ints, Ints32


class LightMatrix(NamedTuple):
    """The frames and weights of `nscc_runtime.light.Light`, with its names."""

    frames: Annotated[Floats32, "frames pixels"]
    row_start: Annotated[Ints, "slots+1"]
    frame_index: Annotated[Ints32, "entries"]
    weight: Annotated[Floats, "entries"]
