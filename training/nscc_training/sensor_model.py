"""A differentiable capture from light and shutters to a frame.

Light is float32; sums and all steps up to the ADC are float64, whatever the network's precision."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import torch
from torch import Tensor

from nscc.arrays import Array
from nscc.chips.target import Target
from nscc.diagnostics.arguments import (
    require_type,
    shown,
    wrong_argument,
)
from nscc.toml.arguments import argument
from nscc.toml.kinds import ANY_NUMBER, Flag, Integer
from nscc_runtime.effects import everything
from nscc_runtime.sensor import Sensor
from nscc_training.draws import normal
from nscc_training.encoders.base import Encoder
from nscc_training.gradients import rounded, saturated
from nscc_training.protocols import Protocol

_POSITIVE = ("full_well_e", "electrons_per_lsb")
_NUMBERS = (
    *_POSITIVE,
    "adc_noise_lsb",
    "noise_factor",
    "slope",
    "comparator_noise",
    "comparator_offset",
)


@dataclass(frozen=True)
class SensorModel:
    """The part of a sensor that training simulates.

    Parameters
    ----------
    full_well_e : float
        Electrons at which a pixel saturates.
    electrons_per_lsb : float
        Electrons for one converter code.
    adc_offset_lsb : float
        The converter code of no light.
    adc_bits : int
        Bits of the converter.
    adc_noise_lsb : float
        Standard deviation of the readout noise in converter codes.
    shot_noise : bool
        Add Gaussian noise with the variance of photons.
    noise_factor : float
        Multiplies shot noise and readout noise.
    slope : float
        Replaces the gradient 0 of saturated pixels.
    comparator_noise, comparator_offset : float
        Standard deviations in full wells, for pixels that look.
    """

    full_well_e: float
    electrons_per_lsb: float
    adc_offset_lsb: float = 0.0
    adc_bits: int = 8
    adc_noise_lsb: float = 0.0
    shot_noise: bool = False
    noise_factor: float = 1.0
    slope: float = 0.1
    comparator_noise: float = 0.0
    comparator_offset: float = 0.0

    def __post_init__(self) -> None:
        """Raise WrongArgument for a value of the wrong type, below 0 or not finite."""
        argument("SensorModel", "adc_bits", Integer(1, 32), self.adc_bits)
        argument("SensorModel", "shot_noise", Flag(), self.shot_noise)
        for name in _NUMBERS:
            value, positive = getattr(self, name), name in _POSITIVE
            argument("SensorModel", name, ANY_NUMBER, value)
            if value < 0 or (positive and not value):
                limit = "above 0" if positive else "not below 0"
                raise wrong_argument(
                    f"SensorModel: {name} must be finite and {limit}, but is {value:g}"
                )

    @classmethod
    def of(cls, sensor: Sensor, target: Target) -> SensorModel:
        """Return the model of a chip's sensor, with photon noise and the converter's noise.

        Parameters
        ----------
        sensor : Sensor
            Full well, electrons per code, offset of the converter, and noise.
        target : Target
            The chip; it gives the number of bits of the converter.

        Returns
        -------
        SensorModel
        """
        require_type("SensorModel.of", "sensor", sensor, Sensor, "nscc_runtime.sensor_for(program)")
        require_type("SensorModel.of", "target", target, Target, "program.target")
        return cls(
            full_well_e=sensor.full_well_e,
            electrons_per_lsb=sensor.electrons_per_lsb,
            adc_offset_lsb=sensor.adc_offset_lsb,
            adc_bits=target.code_bits,
            adc_noise_lsb=everything().converter_lsb(sensor),
            shot_noise=True,
        )

    @classmethod
    def of_protocol(cls, protocol: Protocol) -> SensorModel:
        """Return the sensor that a protocol defines: the largest converter code is a full well.

        Parameters
        ----------
        protocol : Protocol
            One that defines `full_well_e`, `adc_bits`, `read_noise_lsb` and `shot_noise`;
            others raise KeyError.

        Returns
        -------
        SensorModel
        """
        well_e, bits = float(protocol["full_well_e"]), int(protocol["adc_bits"])
        return cls(
            full_well_e=well_e,
            electrons_per_lsb=well_e / ((1 << bits) - 1),
            adc_bits=bits,
            adc_noise_lsb=float(protocol["read_noise_lsb"]),
            shot_noise=bool(protocol["shot_noise"]),
        )

    def noiseless(self) -> SensorModel:
        """Return the same sensor without noise.

        Returns
        -------
        SensorModel
        """
        return replace(
            self, adc_noise_lsb=0.0, shot_noise=False, comparator_noise=0.0, comparator_offset=0.0
        )

    def counted(self) -> SensorModel:
        """Return the same sensor without shot noise, for charge whose photons have been counted.

        Returns
        -------
        SensorModel
        """
        return replace(self, shot_noise=False)

    @property
    def top_code(self) -> int:
        """The largest converter code."""
        return (1 << self.adc_bits) - 1

    @property
    def full_e(self) -> float:
        """The electrons at which a pixel saturates: a full well, or the converter's range if that
        is less. Decoders represent this light as 1."""
        codes = max(self.top_code - self.adc_offset_lsb, 1.0)
        end_e = codes * self.electrons_per_lsb
        # Where both are equal but for rounding, it is the full well exactly.
        return self.full_well_e if end_e > self.full_well_e * (1 - 1e-9) else end_e

    @property
    def full_code(self) -> int:
        """The converter code of saturated pixels, above the offset and without noise."""
        return round(self.full_e / self.electrons_per_lsb)

    def relative(self, codes: Tensor) -> Tensor:
        """Convert converter codes to the unit of decoders.

        Parameters
        ----------
        codes : Tensor
            Converter codes above the offset, of any shape.

        Returns
        -------
        Tensor
            The codes divided by the code of `full_e`; at least 1 for saturated pixels.
        """
        relative_codes = codes / (self.full_e / self.electrons_per_lsb)
        return torch.where(codes >= self.full_code, relative_codes.clamp(min=1), relative_codes)


class Captured(NamedTuple):
    """The result of a capture: electrons before saturation and noise, and the converter codes of
    the frame.

    Both are (batch, rows, cols), for two buckets (batch, 2, rows, cols). `exposure_e` is float64,
    `frame` is float32 with whole numbers from 0 to the largest converter code."""

    exposure_e: Tensor
    frame: Tensor


def differentiable_capture(
    light: Tensor,
    codes: Encoder | Tensor,
    sensor: SensorModel,
    *,
    generator: torch.Generator | None = None,
    slot_share: Tensor | None = None,
) -> Captured:
    """Expose a batch of scenes so that gradients reach light and shutters.

    Parameters
    ----------
    light : Tensor
        (batch, N, rows, cols) electrons of each slot, or (batch, rows, cols) electrons of a still
        over the whole frame.
    codes : Encoder or Tensor
        An encoder, or shutters (N, rows, cols) or (buckets, N, rows, cols). A tile is repeated
        over the array from its top left corner.
    sensor : SensorModel
    generator : torch.Generator, optional
        Source of the noise of sensor and encoder; no noise without it.
    slot_share : Tensor, optional
        (N,): the part of a still's light in each slot, by default 1 / N.

    Returns
    -------
    Captured
        Electrons before saturation and noise, and codes of the frame.

    Raises
    ------
    ValueError
        For arrays of other shapes or numbers of slots, and for light that is complex, negative
        or not finite.
    WrongArgument
        For arguments of other types; it is a ValueError, too.
    """
    call = "differentiable_capture"
    require_type(call, "light", light, Tensor, "torch.from_numpy(array)")
    require_type(call, "sensor", sensor, SensorModel, "SensorModel.of(sensor, target)")
    if not isinstance(codes, Encoder):
        require_type(
            call, "codes", codes, Tensor, "torch.from_numpy(program.shutters(pixels=True))"
        )
    if generator is not None:
        require_type(call, "generator", generator, torch.Generator, "torch.Generator()")
    check_light(light)
    with torch.autocast(light.device.type, enabled=False):
        if isinstance(codes, Encoder):
            shutters = shared_out(codes(generator), codes.spec.buckets)
        else:
            shutters = codes
        _check_shapes(light, shutters, slot_share)
        exposure = exposed(light.float(), shutters.to(light.device), slot_share)
        return Captured(exposure, read_out(exposure, sensor, generator))


def check_light(light: Tensor) -> None:
    """Raise ValueError if the light has values that are complex, negative or not finite, with their
    number."""
    if light.is_complex():
        reason = "light is complex, but must contain real values: the electrons of each slot"
        raise ValueError(reason)
    values = light.detach()
    count, negative = int((~torch.isfinite(values)).sum()), int((values < 0).sum())
    if not count and not negative:
        return
    raise ValueError(
        f"{count} of {values.numel()} values of the light are not finite, {negative} are negative; "
        f"{values.dtype} holds numbers up to {torch.finfo(values.dtype).max:g}"
        if values.is_floating_point()
        else f"{negative} of {values.numel()} values of the light are negative"
    )


def frame_of(light: Array, tile: Tensor, sensor: SensorModel, seed: int) -> Tensor:
    """Return the frame of one scene as float32 converter codes above the offset, ([buckets,] rows,
    cols).

    `light` is in electrons: (rows, cols) of a still over the frame, or (N, rows, cols) of each
    slot. `tile` ([buckets,] N, r, c) are the shutters, which repeat over the scene, and `seed` is
    that of the noise. Raises ValueError for other shapes, and for light that is negative or not
    finite."""
    light_batch = torch.as_tensor(light, dtype=torch.float32)[None]
    generator = torch.Generator().manual_seed(seed)
    frame = differentiable_capture(light_batch, tile, sensor, generator=generator).frame[0]
    return frame - sensor.adc_offset_lsb


def _check_shapes(light: Tensor, shutters: Tensor, slot_share: Tensor | None) -> None:
    """Raise ValueError for shapes that torch would broadcast to an unintended capture: of the
    shutters, of the light, or of `slot_share` (None: equal shares), which only stills may have. The
    message says the expected shape."""
    if shutters.ndim not in (3, 4) or 0 in shutters.shape:
        raise ValueError(f"shutters are ([buckets,] N, rows, cols), not {tuple(shutters.shape)}")
    if light.ndim not in (3, 4):
        expected = "(batch, N, rows, cols), or of stills (batch, rows, cols)"
        raise ValueError(f"light must have shape {expected}, not {tuple(light.shape)}")
    if slot_share is None:
        return
    if light.ndim == 4:
        raise ValueError(
            "slot_share applies only to stills, because light per slot already has its share of "
            "the frame"
        )
    slots = shutters.shape[-3]
    if slot_share.shape != (slots,):
        raise ValueError(
            f"slot_share has shape {tuple(slot_share.shape)}, but the shutters have {slots} slots"
        )


def laid(tile: Tensor, rows: int, cols: int) -> Tensor:
    """Return a tile (.., r, c), repeated from the top left corner and cut to (.., rows, cols).
    Gradients pass; a tile of this size is returned itself."""
    if tile.shape[-2:] == (rows, cols):
        return tile
    down, across = -(-rows // tile.shape[-2]), -(-cols // tile.shape[-1])
    return tile.repeat(*[1] * (tile.ndim - 2), down, across)[..., :rows, :cols]


def shared_out(shutters: Tensor, buckets: int) -> Tensor:
    """Return the shutters of all buckets from those of the first, (N, rows, cols). One bucket has
    the same shape; for two it is (2, N, rows, cols), the second bucket open where the first is
    closed."""
    return shutters if buckets == 1 else torch.stack([shutters, 1 - shutters])


def exposed(light: Tensor, shutters: Tensor, slot_share: Tensor | None = None) -> Tensor:
    """Return the electrons (batch, [buckets,] rows, cols) of open slots, float64.

    `light` is (batch, N, rows, cols) in electrons per slot, or (batch, rows, cols) over the frame.
    `shutters` ([buckets,] N, r, c) are a repeating tile. `slot_share` (N,) is the part of a still's
    light in each slot; None means equal parts. Raises ValueError for another number of slots."""
    if shutters.ndim == 4:
        return torch.stack(
            [exposed(light, bucket_shutters, slot_share) for bucket_shutters in shutters], dim=1
        )
    slots = shutters.shape[0]
    rows, cols = light.shape[-2:]
    if light.ndim == 3:
        if slot_share is None:
            opened = shutters.sum(dim=0, dtype=torch.float64) / slots
        else:
            weights = slot_share.to(shutters.device, torch.float64).reshape(-1, 1, 1)
            opened = (shutters.double() * weights).sum(dim=0)
        return light.double() * laid(opened, rows, cols)
    if light.shape[1] != slots:
        raise ValueError(f"the light has {light.shape[1]} slots, but the shutters have {slots}")
    return (light * laid(shutters, rows, cols)).sum(dim=1, dtype=torch.float64)


def read_out(
    exposure: Tensor, sensor: SensorModel, generator: torch.Generator | None = None
) -> Tensor:
    """Return the converter codes of a frame, float32, from the electrons `exposure` (float64, of
    any shape).

    The steps are noise, saturation, rounding half to even, and clipping to the range of codes, each
    with the values of `sensor`. Without a generator there is no noise. Gradients pass."""
    charge = exposure
    if generator is not None and sensor.shot_noise:
        drawn = normal(charge, generator, torch.float32)
        # The noise is detached: its gradient is infinite in the dark.
        photons = torch.sqrt(charge.detach().clamp(min=0))
        charge = charge + sensor.noise_factor * photons * drawn
    charge = saturated(charge, low=-sensor.full_well_e, high=sensor.full_well_e, slope=sensor.slope)
    codes = charge / sensor.electrons_per_lsb
    if generator is not None and sensor.adc_noise_lsb:
        readout = sensor.noise_factor * sensor.adc_noise_lsb
        codes = codes + readout * normal(codes, generator, torch.float32)
    codes = rounded(codes) + sensor.adc_offset_lsb
    return saturated(codes, low=0.0, high=float(sensor.top_code), slope=sensor.slope).float()


def filled(frame: Tensor, saturated: Tensor, shutters: Tensor) -> Tensor:
    """Return a frame in which saturated pixels are raised to the smallest value that a full pixel
    can have.

    `frame` (.., rows, cols) is in full wells, from `SensorModel.relative`; `saturated` is bool of
    its shape; `shutters` ([buckets,] N, r, c) is a repeating tile. The photodiode also fills while
    a shutter is not yet open. If constant light fills it just when the shutter closes for the last
    time, the frame contains only the open fraction of a full well."""
    slots = torch.arange(1, shutters.shape[-3] + 1, device=shutters.device).reshape(-1, 1, 1)
    opened = shutters > 0.5
    least = opened.sum(dim=-3) / (opened * slots).amax(dim=-3).clamp(min=1)
    least = laid(least, *frame.shape[-2:]).to(frame)
    return torch.where(saturated, torch.maximum(frame, least), frame)


def lifted(exposure: Tensor, shutters: Tensor) -> tuple[Tensor, Tensor]:
    """Apply the transposed shutters: copy a frame to the slots in which each pixel was open.

    Parameters
    ----------
    exposure : Tensor
        (batch, rows, cols).
    shutters : Tensor
        (N, r, c), a tile that repeats.

    Returns
    -------
    lifted : Tensor
        (batch, N, rows, cols), in light per slot.
    valid : Tensor
        (rows, cols), False for pixels that never open; these are 0 and have no gradient.

    Raises
    ------
    WrongArgument
        For arguments that are not tensors of three axes.
    """
    for name, value in (("exposure", exposure), ("shutters", shutters)):
        require_type("lifted", name, value, Tensor, "torch.from_numpy(array)")
        if value.ndim != 3:
            raise wrong_argument(f"lifted: {name} has three axes, but it is {shown(value)}")
    shutters = laid(shutters, *exposure.shape[-2:])
    count = shutters.sum(dim=0)
    valid = count > 0
    mean = torch.where(valid, exposure, torch.zeros_like(exposure))
    mean = mean / torch.where(valid, count, torch.ones_like(count))
    return mean.unsqueeze(1) * shutters.unsqueeze(0), valid
