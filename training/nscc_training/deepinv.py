"""Pixel-wise shutters as a forward operator of DeepInverse (deepinv.github.io), in electrons.

    import nscc
    import torch
    from nscc_training.deepinv import PixelShutters, SensorNoise

    p = nscc.compile("examples/flutter.nsl")
    physics = PixelShutters(p, noise_model=SensorNoise.of(p))
    x = 300 * torch.rand(1, *physics.img_size)      # electrons a slot (batch, 1, N, rows, cols)
    y = physics(x)                                  # electrons (batch, buckets, rows, cols)
    x_hat = physics.A_dagger(y)

Needs `nscc[deepinv]`. Clips have the layout of deepinv's other dynamic operators (batch, channels,
time, rows, cols). Therefore operators for four-dimensional pictures, such as
`LinearPhysicsMultiScaler`, accept stills only."""

from __future__ import annotations

from typing import Any

import torch
from deepinv.physics import LinearPhysics, ZeroNoise
from deepinv.physics.noise import NoiseModel
from torch import Tensor

from nscc.diagnostics.arguments import shown, wrong_argument
from nscc.shutter_program import ShutterProgram
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.python_arguments import SensorLike, sensor_of
from nscc_training.encoders.base import Encoder
from nscc_training.sensor_model import SensorModel, laid, read_out, shared_out


class PixelShutters(LinearPhysics):  # type: ignore[misc]  # deepinv has no types
    """Every pixel sums the light of the slots in which its shutter is open.

    From a clip x (batch, 1, N, rows, cols), electrons per slot, to y (batch, buckets, rows, cols),
    electrons; with `still`, from a picture x (batch, 1, rows, cols), electrons over the frame.

    The pseudo-inverse and the proximal step of the L2 fidelity are exact and cost one pass, because
    pixels do not mix.

    Parameters
    ----------
    shutters : ShutterProgram, Container, Encoder or Tensor
        A program with data, compiled or loaded; an encoder, whose codes get gradients; or a tensor
        (N, rows, cols) or (buckets, N, rows, cols) of 0..1. They are a tile, repeated over the
        array from its top left corner and cut at its edges. A call of `A` may replace the buffer
        `shutters`, as for deepinv's parameters of physics.
    size : tuple of int, optional
        Rows and columns of the array.
    still : bool
    slot_share : Tensor, optional
        (N,): the fraction of a still's light in each slot; by default that of the program's slots,
        else 1 / N.
    noise_model : NoiseModel, optional
    device : torch.device or str
    **options
        Those of `LinearPhysics`.

    Raises
    ------
    WrongArgument
        For other arguments.
    """

    def __init__(
        self,
        shutters: ShutterProgram | Container | Encoder | Tensor,
        *,
        size: tuple[int, int] | None = None,
        still: bool = False,
        slot_share: Tensor | None = None,
        noise_model: NoiseModel | None = None,
        device: torch.device | str = "cpu",
        **options: Any,
    ) -> None:
        """Lay the shutters over an array of `size` (rows, cols), by default one tile.

        `still` images one picture instead of a clip. `slot_share` (slots,) is the fraction of a
        still's light in each slot; None takes that of the program's slots, or equal parts.
        `noise_model` None adds no noise. `options` go to DeepInverse. Raises WrongArgument for a
        wrong shape."""
        encoder = shutters if isinstance(shutters, Encoder) else None
        tile = _tile(shutters)
        rows, cols = tile.shape[-2:] if size is None else size
        slots = tile.shape[1]
        if slot_share is None:
            slot_share = _shares(shutters, slots)
        elif slot_share.shape != (slots,):
            raise wrong_argument(
                f"PixelShutters: slot_share is ({slots},), not {tuple(slot_share.shape)}"
            )
        img_size = (1, rows, cols) if still else (1, slots, rows, cols)
        super().__init__(
            img_size=img_size, noise_model=noise_model or ZeroNoise(), device=device, **options
        )
        self.still = still
        self.encoder = encoder
        self.register_buffer("slot_share", slot_share.float())
        self.register_buffer("shutters", None if encoder else laid(tile.float(), rows, cols))
        self.to(device)

    def A(self, x: Tensor, shutters: Tensor | None = None, **parameters: Any) -> Tensor:  # noqa: N802 (deepinv's)
        """Return the electrons (batch, buckets, rows, cols) that each bucket collects from light x,
        of the shape (batch, *img_size).

        If `shutters` (buckets, N, rows, cols) are given, they replace the buffer of the same name,
        also for later calls; None keeps it. Raises WrongArgument for light of another shape."""
        self.update_parameters(shutters=shutters, **parameters)
        if x.shape[1:] != self.img_size:
            raise wrong_argument(
                f"PixelShutters takes light (batch, {', '.join(map(str, self.img_size))}), "
                f"not {shown(x)}"
            )
        light = x if self.still else x[:, 0]
        buckets = self._weights(x)
        return torch.stack([(light * bucket).sum(dim=1) for bucket in buckets], dim=1)

    def A_adjoint(self, y: Tensor, shutters: Tensor | None = None, **parameters: Any) -> Tensor:  # noqa: N802
        """Return the frames copied to their open slots and added up: from y (batch, buckets, rows,
        cols) to the shape of x.

        If `shutters` (buckets, N, rows, cols) are given, they replace the buffer of the same name,
        also for later calls; None keeps it."""
        self.update_parameters(shutters=shutters, **parameters)
        light = (y.unsqueeze(2) * self._weights(y)).sum(dim=1)
        return light if self.still else light.unsqueeze(1)

    def A_A_adjoint(self, y: Tensor, **parameters: Any) -> Tensor:  # noqa: N802
        """Return `A(A_adjoint(y))`, of the shape of y, in closed form: the matrix of common open
        times of each pixel's buckets, times its values."""
        self.update_parameters(**parameters)
        return _times(self._overlap(y), y)

    def A_dagger(self, y: Tensor, *_solver: Any, **options: Any) -> Tensor:  # noqa: N802
        """Return the light of the shape of x with the smallest norm that fits y (batch, buckets,
        rows, cols) best by least squares, in closed form. Pixels that never open get 0. Arguments
        for an iterative solver are ignored."""
        return self.A_adjoint(_times(_inverse(self._overlap(y)), y))

    def prox_l2(self, z: Any, y: Tensor, gamma: Any, *solver: Any, **options: Any) -> Tensor:
        """Return the x that minimises gamma / 2 |A x - y|^2 + 1 / 2 |x - z|^2.

        x and z have the shape of light, y that of frames. For one number `gamma` the result is
        exact and in closed form. For several, DeepInverse iterates. `z` may be a number, also None
        for 0."""
        if isinstance(gamma, Tensor) and gamma.numel() > 1:
            result: Tensor = super().prox_l2(z, y, gamma, *solver, **options)
            return result
        x = z if isinstance(z, Tensor) else torch.full_like(self.A_adjoint(y), z or 0.0)
        inverse = _inverse(self._overlap(y), 1.0 / gamma)
        return x + self.A_adjoint(_times(inverse, y - self.A(x)))

    def _weights(self, like: Tensor) -> Tensor:
        """Return the fraction of a slot's light that each bucket collects, (buckets, slots, rows,
        cols), in dtype and device of `like`.

        A still has one slot, the frame. The shutters of an encoder are computed at each call and
        pass gradients."""
        weights: Tensor = self.shutters
        if self.encoder is not None:
            weights = laid(_of_buckets(self.encoder(), self.encoder), *self.img_size[-2:])
        if self.still:
            weights = torch.einsum("kthw,t->khw", weights, self.slot_share.to(weights)).unsqueeze(1)
        return weights.to(like)

    def _overlap(self, like: Tensor) -> Tensor:
        """Return for each pixel the inner products of two buckets' weights over the slots, (rows,
        cols, buckets, buckets), in dtype and device of `like`."""
        weights = self._weights(like)
        return torch.einsum("ithw,jthw->hwij", weights, weights)


class SensorNoise(NoiseModel):  # type: ignore[misc]
    """The sensor noise of training: photons, full well, readout noise, converter.

    It maps exact electrons to the electrons that a frame file gives: `(frame - adc_offset) *
    electrons_per_lsb`. The converter codes `frame` are integers, and the largest code means
    saturated. Gradients pass as in `nscc_training.differentiable_capture`.

    Parameters
    ----------
    sensor : SensorModel
    rng : torch.Generator, optional
        Without it the noise follows `torch.manual_seed`.
    """

    def __init__(self, sensor: SensorModel, rng: torch.Generator | None = None) -> None:
        """Store the sensor, and the generator of random numbers for DeepInverse; None lets the
        noise follow `torch.manual_seed`."""
        super().__init__(rng=rng)
        self.sensor = sensor

    @classmethod
    def of(
        cls, program: ShutterProgram, sensor: SensorLike = None, rng: torch.Generator | None = None
    ) -> SensorNoise:
        """Return the noise of the chip that `program` is compiled for.

        `sensor` replaces its properties, as the argument of that name of `nscc_runtime.capture`.
        `rng` is the generator of the noise; None lets it follow `torch.manual_seed`."""
        chip = sensor_of("SensorNoise.of", sensor, converter_of(program.container))
        return cls(SensorModel.of(chip, program.container.target), rng)

    def forward(self, input: Tensor, seed: int | None = None, **_parameters: Any) -> Tensor:
        """Return the electrons that one readout with noise gives for the exact electrons `input`,
        in the same shape and dtype. A `seed` restarts the generator; None continues it."""
        self.rng_manual_seed(seed)
        generator = self.rng
        if generator is None:
            generator = torch.Generator().manual_seed(int(torch.randint(2**62, ())))
        codes = read_out(input.double(), self.sensor, generator)
        electrons = (codes - self.sensor.adc_offset_lsb) * self.sensor.electrons_per_lsb
        return electrons.to(input.dtype)


def _tile(shutters: object) -> Tensor:
    """Return the shutters (buckets, N, rows, cols) of a program, a container, an encoder (its
    current codes), or a tensor with or without an axis of buckets.

    Raises WrongArgument for anything else. A container is a compiled program."""
    if isinstance(shutters, Encoder):
        return _of_buckets(shutters.hard(), shutters)
    if isinstance(shutters, Container):
        shutters = ShutterProgram("the program", shutters)
    if isinstance(shutters, ShutterProgram):
        return torch.from_numpy(shutters.shutters(pixels=True))
    if isinstance(shutters, Tensor) and shutters.ndim in (3, 4):
        return shutters if shutters.ndim == 4 else shutters.unsqueeze(0)
    raise wrong_argument(
        f"PixelShutters takes a program, an Encoder or a tensor (N, rows, cols), "
        f"not {shown(shutters)}",
        helps=("nscc.compile gives programs, nscc_training.make_encoder encoders",),
    )


def _of_buckets(shutters: Tensor, encoder: Encoder) -> Tensor:
    """Return an encoder's shutters (N, rows, cols), those of the first bucket, as the shutters of
    all its buckets (buckets, N, rows, cols)."""
    bucket_shutters = shared_out(shutters, encoder.spec.buckets)
    return bucket_shutters if bucket_shutters.ndim == 4 else bucket_shutters.unsqueeze(0)


def _shares(shutters: object, slots: int) -> Tensor:
    """Return the fraction of the frame that each slot lasts, (slots,). Shutters from a tensor or an
    encoder have no slot lengths: their slots are equal."""
    if not isinstance(shutters, ShutterProgram | Container):
        return torch.full((slots,), 1.0 / slots)
    lengths = torch.tensor(shutters.slot_us, dtype=torch.float64)
    return lengths / lengths.sum()


def _times(matrix: Tensor, y: Tensor) -> Tensor:
    """Return the product of each pixel's `matrix` (rows, cols, buckets, buckets) and its values in
    `y` (batch, buckets, rows, cols), in the shape of `y`."""
    return torch.einsum("hwij,bjhw->bihw", matrix, y)


def _inverse(matrix: Tensor, damping: Any = 0.0) -> Tensor:
    """Return the inverse of matrix + damping * identity for each pixel, (rows, cols, buckets,
    buckets); the pseudo-inverse where it is singular."""
    count = matrix.shape[-1]
    damped = matrix + damping * torch.eye(count).to(matrix)
    if count == 1:
        opened = damped > 0  # a pixel that never opens has the inverse 0, with a finite gradient
        return torch.where(opened, 1.0 / torch.where(opened, damped, 1.0), 0.0)
    inverse: Tensor = torch.linalg.pinv(damped, hermitian=True)
    return inverse
