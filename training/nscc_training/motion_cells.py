"""The cell of `examples/direction.nsl`, and its decoder; `docs/motion_cells.py` trained it."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from nscc.arrays import Bools, Floats32
from nscc_training.cells import PixelCell
from nscc_training.imported_networks import read_cell
from nscc_training.made_scenes import DIRECTIONS

DECODER, STATE = "direction.decoder.safetensors", "direction.pt"
"""Names of the files of a trained cell."""


class LinearDecoder(NamedTuple):
    """A linear classifier of the direction of motion from a cell's output bits. The scores are
    `weight` (directions, outputs) times the fraction of 1 bits of each output over a film, plus
    `bias` (directions,)."""

    weight: Floats32
    bias: Floats32

    def direction(self, bits: Bools) -> str:
        """Return the name of the direction with the largest score, from a film's output bits
        (frames, outputs, rows, cols); of equal scores, the first in `DIRECTIONS`. A film has at
        least one frame."""
        return DIRECTIONS[int((self.weight @ bits.mean((0, 2, 3)) + self.bias).argmax())]


def shipped_cell() -> tuple[PixelCell, LinearDecoder]:
    """Return the cell of `examples/direction.nsl`, and the decoder of its bits that was trained
    under every sensor effect."""
    from safetensors.numpy import load_file

    folder = Path(__file__).with_name("shipped_cell")
    return read_cell(folder / STATE), LinearDecoder(**load_file(folder / DECODER))
