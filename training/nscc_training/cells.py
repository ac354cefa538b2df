"""Recurrent networks of bits in the pixels, as torch modules that compile to programs."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, sqrt
from typing import TYPE_CHECKING, Literal, get_args

import torch
from torch import Tensor, nn
from torch.nn import functional

from nscc_training.draws import normal
from nscc_training.gradients import opened, replaced

if TYPE_CHECKING:
    from nscc.shutter_program import ShutterProgram

Update = Literal["flip", "replace"]
MOST_KERNEL, MOST_STATES, MOST_OUTPUTS = 9, 2, 8
"""Limits of a cell: the size of kernels and pools, and the number of states and outputs."""


@dataclass(frozen=True)
class CellNoise:
    """Noise of a cell's comparisons, for training.

    Parameters
    ----------
    exposure : float
        Standard deviation of the comparison of an exposure with its level, in full wells.
    count : float
        Standard deviation of the comparison of a gate with its threshold, in counts.
    """

    exposure: float
    count: float

    @classmethod
    def of(cls, program: ShutterProgram) -> CellNoise:
        """Return the noise that the emulator gives the compiled program of a cell, from the default
        sensor of its chip.

        The errors of words and comparators are independent. A word of a count is an addition in
        half of the pixels, and a move in the others. The fixed offsets of comparators are included
        as noise, so that a cell is trained for every device. The gain of words is not included."""
        from nscc_runtime.exposing import sensor_for

        values = sensor_for(program).values
        pictures, target = program.container.pictures, program.container.target
        unit_e = pictures.count_steps * target.electrons_per_step
        words = max(image["noise_gain"] for image in program.report["images"].values())
        addition_e = values["analog_noise_lsb"] * values["analog_lsb_e"]
        word_e = addition_e * hypot(1.0, values["analog_move_noise"]) / sqrt(2)
        comparator = hypot(
            values["comparator_noise_fraction"], values["comparator_offset_fraction"]
        )
        comparator_e = comparator * values["full_well_e"]
        return cls(comparator, hypot(words * word_e, comparator_e) / unit_e)


class PixelCell(nn.Module):
    """A recurrent cell of one-bit states and one-bit outputs in every pixel.

    A bit is +1 or -1. Each gate counts agreements: for the bit x of the exposure and the states h,
    its count is the sum of weight * bit over the neighbourhood, with weights of +1 and -1 (a weight
    of 0 leaves its place out). The gate is +1 where its count exceeds its threshold, else -1. All
    gates see the old states. The first gates update the states: `flip` multiplies a state by its
    gate, as PixelRNN does, and `replace` sets it to its gate. The other gates are outputs. An
    output is pooled by the maximum over squares of `pool` x `pool` pixels.

    The parameter `weight` (gates, 1 + states, kernel, kernel) has the weights' signs; `threshold`
    is (gates,), in counts. The state dict also has the settings, so that it describes the cell.

    Parameters
    ----------
    kernel : int
        Rows and columns of kernels: odd, 3 to 9.
    states, outputs : int
        Number of one-bit states (1 or 2) and of outputs (1 to 8).
    pool : int
        Side of the squares: odd, 1 (no pooling) to 9.
    update : {"flip", "replace"}
    level : float
        Exposures above this part of a full well are +1.
    outside : {0, 1}
        Bits beyond the array: -1 or +1.
    """

    is_binary: bool = True
    """If False, the cell has real weights, and tanh instead of comparisons."""
    level: Tensor
    outside: Tensor
    pool_size: Tensor
    flips: Tensor

    def __init__(
        self,
        *,
        kernel: int = 3,
        states: int = 1,
        outputs: int = 1,
        pool: int = 1,
        update: Update = "flip",
        level: float = 0.5,
        outside: int = 0,
    ) -> None:
        """Build a cell with random weights and thresholds of 0. Raise ValueError for settings that
        a program cannot have.

        `kernel` and `pool` are odd sizes in pixels, `level` is the light above which a bit of the
        exposure is set, as a part of a full well, and `outside` is the bit beyond the array."""
        super().__init__()
        for name, value, low, high, step in (
            ("kernel", kernel, 3, MOST_KERNEL, 2),
            ("pool", pool, 1, MOST_KERNEL, 2),
            ("states", states, 1, MOST_STATES, 1),
            ("outputs", outputs, 1, MOST_OUTPUTS, 1),
            ("outside", outside, 0, 1, 1),
        ):
            if value not in range(low, high + 1, step):
                odd = "an odd number" if step == 2 else "a whole number"
                raise ValueError(f"{name} is {value}, but must be {odd} from {low} to {high}")
        if update not in get_args(Update):
            raise ValueError(f'update is {update!r}, but must be "flip" or "replace"')
        if not 0 < level < 1:
            raise ValueError(f"level is {level:g}, but must be between 0 and 1 full well")
        self.kernel, self.states, self.outputs = kernel, states, outputs
        gates = states + outputs
        taps = (1 + states) * kernel * kernel
        self.weight = nn.Parameter(torch.randn(gates, 1 + states, kernel, kernel) / sqrt(taps))
        self.threshold = nn.Parameter(torch.zeros(gates))
        self.register_buffer("level", torch.tensor(level, dtype=torch.float64))
        for name, value in ("pool_size", pool), ("outside", outside), ("flips", update == "flip"):
            self.register_buffer(name, torch.tensor(int(value)))
        # Bits 0 and 1 are -1 and +1 in the network.
        self.pool, self.update, self.beyond = pool, update, 2.0 * outside - 1.0
        self.register_load_state_dict_post_hook(_read_settings)  # type: ignore[no-untyped-call]

    def kernels(self) -> Tensor:
        """Return the signs of the weights: int64 (gates, 1 + states, kernel, kernel), with values
        -1, 0 and 1. Index 0 of the second axis weights the exposure's bit, the others weight the
        states."""
        return torch.sign(self.weight.detach()).long()

    def thresholds(self) -> Tensor:
        """Return the largest attainable count of each gate that does not exceed its threshold,
        int64 (gates,).

        Attainable counts are -places, -places + 2, .., places, where places is the number of
        weights that are not 0. The smallest and the second largest are the limits, so that each
        gate can be +1 and -1; a gate without weights has 0."""
        taps = self.kernels().abs().sum((1, 2, 3))
        steps = torch.floor((self.threshold.detach() + taps) / 2).long()
        # At least one attainable count is above the result, and at least one is not.
        return 2 * torch.minimum(steps.clamp(min=0), (taps - 1).clamp(min=0)) - taps

    def counts(self, bits: Tensor) -> Tensor:
        """Return the counts of all gates (batch, gates, rows, cols).

        `bits` (batch, 1 + states, rows, cols), +1 or -1, are those of the exposure and the states.
        A binary cell counts with the signs of its weights, but their gradients are those of real
        weights. Real weights are divided by their mean size, so that counts have the same unit."""
        size = self.weight.detach().abs().mean((1, 2, 3), keepdim=True)
        weights = self.weight / size
        if self.is_binary:
            weights = replaced(weights, torch.sign(self.weight.detach()))
        padded = functional.pad(bits, [self.kernel // 2] * 4, value=self.beyond)
        return functional.conv2d(padded, weights.to(bits))

    def forward(
        self,
        bits: Tensor,
        state: Tensor,
        *,
        noise_counts: float = 0.0,
        generator: torch.Generator | None = None,
    ) -> tuple[Tensor, Tensor]:
        """Compute one frame: return the outputs (batch, outputs, rows // pool, cols // pool) and
        the new states, all +1 or -1.

        `bits` (batch, 1, rows, cols) are +1 where the exposure is above `level`, else -1. `state`
        (batch, states, rows, cols) is +1 before the first frame. `noise_counts` is the standard
        deviation of each comparison; there is no noise without a generator."""
        threshold: Tensor = self.threshold
        # Attainable counts are 2 apart: + 1 is half-way to the next. The gradient goes to
        # `self.threshold`.
        if self.is_binary:
            threshold = replaced(threshold, self.thresholds().to(threshold) + 1)
        margins = self.counts(torch.cat([bits, state], 1)) - threshold.reshape(-1, 1, 1).to(bits)
        if generator is not None and noise_counts:
            margins = margins + noise_counts * normal(margins, generator)
        gates, outputs = margins[:, : self.states], margins[:, self.states :]
        if self.pool > 1:
            outputs = functional.max_pool2d(outputs, self.pool)
        update = self._compared(gates)
        return self._compared(outputs), update * state if self.update == "flip" else update

    def film(
        self,
        exposure: Tensor,
        *,
        noise: CellNoise | None = None,
        generator: torch.Generator | None = None,
    ) -> Tensor:
        """Return the outputs of films, +1 or -1: (batch, frames, outputs, rows // pool, cols //
        pool).

        `exposure` (batch, frames, rows, cols) is in full wells. All states are +1 before the first
        frame. Without `generator` or without `noise` there is no noise."""
        batch, frames, rows, cols = exposure.shape
        state = self.weight.new_ones(batch, self.states, rows, cols)
        noise = noise or CellNoise(exposure=0.0, count=0.0)
        frame_outputs = []
        for number in range(frames):
            light = exposure[:, number : number + 1]
            if generator is not None and noise.exposure:
                light = light + noise.exposure * normal(light, generator)
            bits = torch.where(light > self.level, 1.0, -1.0).to(state)
            outputs, state = self(bits, state, noise_counts=noise.count, generator=generator)
            frame_outputs.append(outputs)
        return torch.stack(frame_outputs, 1)

    def _compared(self, margins: Tensor) -> Tensor:
        """Return +1 where one of `margins` (counts minus thresholds, of any shape) is positive,
        else -1. Without binary weights, return tanh.

        The gradient of the comparison is that of a smooth step, as wide as the standard deviation
        of counts of random bits."""
        # A sum of n random bits has the standard deviation sqrt(n).
        width = sqrt(self.weight[0].numel())
        if self.is_binary:
            return 2 * opened(margins, width) - 1
        return torch.tanh(margins / width)


def _read_settings(cell: PixelCell, _keys: object) -> None:
    """Set the attributes of a cell from its loaded buffers. Attributes are numbers, not tensors,
    because the ONNX export needs constants."""
    cell.pool = int(cell.pool_size)
    cell.update = "flip" if cell.flips else "replace"
    cell.beyond = 2.0 * float(cell.outside) - 1.0


def set_moving_edges(cell: PixelCell) -> None:
    """Set the weights of a cell in place to detectors of moving edges, one direction for each
    output, evenly around the circle from the right; their sizes stay.

    The weights of the exposure detect an edge at its present position, those of the states detect
    the same edge one frame earlier. The gate of a state becomes a majority of the exposure's bits.
    Training from these weights gives better results than training from random weights."""
    offsets = torch.arange(cell.kernel) - cell.kernel // 2
    with torch.no_grad():
        cell.weight[: cell.states, 0] = cell.weight[: cell.states, 0].abs()
        for output in range(cell.outputs):
            angle = torch.tensor(2 * torch.pi * output / cell.outputs)
            ahead = torch.cos(angle) * offsets[None, :] + torch.sin(angle) * offsets[:, None]
            size = cell.weight[cell.states + output].abs()
            # The edge is half a pixel ahead of the centre now, and half a pixel behind it one frame
            # ago.
            side = torch.where(torch.arange(1 + cell.states).reshape(-1, 1, 1) == 0, 0.5, -0.5)
            cell.weight[cell.states + output] = size * torch.sign(side - ahead)
            # A count above half of the places means that three quarters of the bits agree.
            cell.threshold[cell.states + output] = size.numel() / 2
