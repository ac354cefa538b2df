"""Classes a to d: one open interval (bump) per frame, whose edges are learned."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import torch
from torch import Tensor, nn

from nscc.arrays import Floats, Ints
from nscc_training.encoders.base import Codes, CodeTrial, Encoder, Over, Ranges, ShutterSpec, drawn
from nscc_training.gradients import opened, replaced, rounded

_FAR = 1e6
"""Distance in slots before the frame at which a fixed edge lies."""
_FINEST = 2.0**-20
"""Exposure times are multiples of this, in slots, so that whole numbers stay whole."""
_MOST_DISTANCES = 1 << 24
"""Most distances between codes and legal codes that are computed at once, to limit memory."""


class AlwaysOpen(Encoder):
    """Class a: pixels that are always open, with no codes to learn."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin; there is nothing to learn. A buffer follows the module to its device."""
        super().__init__(spec, relaxation)
        self.always: Tensor
        self.register_buffer("always", torch.ones(()), persistent=False)

    def codes(self) -> Codes:
        """Return no fields."""
        return {}

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Accept codes without fields, and raise ValueError for any field."""
        if codes:
            raise ValueError(f"class a has no fields: leave {', '.join(sorted(codes))} out")

    def start_random(self, generator: np.random.Generator) -> None: ...

    def start_uniform(self) -> None: ...

    def start_quad(self) -> None: ...

    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return shutters (N, rows, cols) that are 1 everywhere. The arguments have no effect."""
        return self.always.expand(self.spec.slots, *self.spec.tile)

    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Raise ValueError: there is nothing to try."""
        raise ValueError("class a has no parameters to try")


class Bump(Encoder):
    """The base of classes b to d: open between two edges, either of which may be fixed.

    Edges are boundaries 0..N between slots: real parameters in float64, precise for thousands of
    slots. The gradient of an edge is the light that flows through the slots beside it.

    `limits` are the legal values of each field in slots; each field is a parameter of that name.
    `legal` (codes, fields), if set, lists the codes that `require` of a program allows: codes snap
    to the nearest.

    A pixel of class d whose edges are at the boundaries 1 and 3 of four slots. A gradient step that
    moves its stop to 3.6 rounds to the boundary 4:

        >>> bump = StartStop(ShutterSpec("d", 4, (1, 1)))
        >>> bump.load_codes({"start": np.array([[1]]), "stop": np.array([[3]])})
        >>> bump.hard()[:, 0, 0].tolist()
        [0.0, 1.0, 1.0, 0.0]
        >>> bump.fill(np.array([[1.0]]), np.array([[3.6]]))
        >>> bump.hard()[:, 0, 0].tolist()
        [0.0, 1.0, 1.0, 1.0]
    """

    jitter_unit = 1.0
    width = 1.0
    """Width in slots of the surrogate gradient of an edge; 1 is the physical width."""
    reach = 2

    def __init__(
        self, spec: ShutterSpec, relaxation: str, limits: dict[str, tuple[int, int]]
    ) -> None:
        """Create a parameter for each field, all at their lowest value.

        `spec` gives the number of slots and the tile. `relaxation` names the method by which
        gradients pass the rounding of edges (see `Encoder`). `limits` are the lowest and the
        highest value of each field, in slots, by the field's name ("start", "stop")."""
        super().__init__(spec, relaxation)
        self.limits = limits
        self.legal: Tensor | None = None
        for name, (low, _) in limits.items():
            lowest = torch.full(spec.tile, float(low), dtype=torch.float64)
            self.register_parameter(name, nn.Parameter(self.parameter_of(lowest)))

    def restrict(self, legal: Ints, generator: np.random.Generator | None = None) -> None:
        """Allow only the codes `legal` (codes, fields in the order of `limits`), which `require` of
        a program permits; there is at least one.

        With a generator, the code of every pixel is drawn anew from them; with None, it moves to
        the nearest legal code. The limits of the fields become those of the legal codes."""
        self.legal = torch.as_tensor(legal, dtype=torch.float64)
        if generator is None:
            self.fill(*self.codes().values())
        else:
            drawn = legal[generator.integers(len(legal), size=self.spec.tile)]
            self.fill(*np.moveaxis(drawn, -1, 0))
        for name, values in zip(self.limits, legal.T, strict=True):
            self.limits[name] = (int(values.min()), int(values.max()))

    def edges(self, fields: Tensor) -> tuple[Tensor, Tensor]:
        """Return the opening and the closing boundary of each pixel, both (rows, cols), for the
        values of its fields (fields, rows, cols). Each class of bumps defines it; here it raises
        NotImplementedError."""
        raise NotImplementedError

    def shutters(self, generator: torch.Generator | None, soft: bool) -> Tensor:
        """Return the shutters (N, rows, cols) of the present fields: exactly 0 and 1, or if `soft`,
        values between them.

        A generator adds noise of the standard deviation `noise` to the fields; None adds none."""
        return self.opened_by(self.fields(generator), soft)

    def opened_by(self, fields: Tensor, soft: bool = False) -> Tensor:
        """Return the shutters (N, rows, cols) of field values (fields, rows, cols) in slots, in the
        order of `limits` and within them.

        If `soft`, the edges are sigmoids of the width `temperature`, and codes are not rounded.
        Otherwise the shutters are 0 and 1, and pass the gradient of an edge of the width `width`.
        """
        start, stop = self.edges(fields if soft else self.snapped(fields))
        n = torch.arange(self.spec.slots, dtype=torch.float64, device=stop.device)
        # A slot is open if its middle is between the edges.
        middle = n.reshape(-1, 1, 1) + 0.5
        if not soft and not torch.is_grad_enabled():
            return ((middle > start) & (middle < stop)).float()
        after, before = middle - start, stop - middle
        if soft:
            scale = 1.0 / self.temperature
            return (torch.sigmoid(after * scale) * torch.sigmoid(before * scale)).float()
        return (opened(after, self.width) * opened(before, self.width)).float()

    def trial(self, over: Over, generator: torch.Generator) -> CodeTrial:
        """Return shutters for two versions of the codes, moved by the same random steps in opposite
        directions.

        `over` lays the tile over a patch, so that each pixel of the patch moves on its own. Only
        the fraction `tried_share` of the pixels moves. The moves are drawn from `generator`."""
        fields = over(self.fields(None))
        with torch.no_grad():
            spread = self.trial_spread(fields)
            moved = spread * drawn(fields, generator, self.tried_share)
            first, second = (self.opened_by(self.within(fields + sign * moved)) for sign in (1, -1))
        return CodeTrial(fields, moved, spread, (first, second))

    def trial_spread(self, fields: Tensor) -> Tensor:
        """Return the standard deviation of trials around fields (fields, rows, cols), in slots and
        of the same shape."""
        return torch.full_like(fields, max(self.noise, self.least_tried))

    @property
    def least_tried(self) -> float:
        """Minimum standard deviation of trials, in slots; with less, codes round back to
        themselves."""
        return max(0.25, self.spec.slots / 256)

    def fields(self, generator: torch.Generator | None) -> Tensor:
        """Return the real values of the fields (fields, rows, cols) in slots, clipped to their
        limits. A generator adds noise of the standard deviation `noise`; None adds none."""
        slots = (self.slots_of(self.get_parameter(name)) for name in self.limits)
        return self.within(torch.stack([self.noisy(field, generator) for field in slots]))

    def slots_of(self, parameter: Tensor) -> Tensor:
        """Return the edge in slots that a parameter means. Here they are equal; a class with
        another unit overrides it."""
        return parameter

    def parameter_of(self, slots: Tensor) -> Tensor:
        """Return the parameter for an edge in slots: the inverse of `slots_of`."""
        return slots

    def bound_of(self, slots: int) -> float:
        """Return the parameter for a limit in slots, both numbers. Here they are equal; a class
        with another unit overrides it."""
        return slots

    def within(self, fields: Tensor) -> Tensor:
        """Return fields (fields, rows, cols) clipped to their limits. The gradient is 0 outside the
        limits."""
        return torch.stack(
            [
                torch.clamp(field, *limits)
                for field, limits in zip(fields, self.limits.values(), strict=True)
            ]
        )

    def snapped(self, fields: Tensor) -> Tensor:
        """Return the legal code nearest to each pixel's `fields` (fields, rows, cols), by the sum
        of absolute differences. Of equally near codes, the first in `legal` is returned.

        Without a list of legal codes, every whole number is legal. The gradient passes as if
        nothing was rounded."""
        if self.legal is None:
            return rounded(fields)
        legal = self.legal.to(fields)
        flat = fields.detach().reshape(len(fields), -1).T
        nearest = [
            (chunk[:, None] - legal[None]).abs().sum(dim=-1).argmin(dim=1)
            for chunk in torch.split(flat, max(1, _MOST_DISTANCES // legal.numel()))
        ]
        return replaced(fields, legal[torch.cat(nearest)].T.reshape(fields.shape))

    def ranges(self) -> Ranges:
        """Return each field's parameter with its lowest and highest value, both in the unit of the
        parameter."""
        return [
            (self.get_parameter(name), (self.bound_of(low), self.bound_of(high)))
            for name, (low, high) in self.limits.items()
        ]

    def codes(self) -> Codes:
        """Return the fields rounded to legal codes, int64 (rows, cols) by name. Raise ValueError if
        a parameter is not finite."""
        self.check_finite()
        with torch.no_grad():
            values = self.snapped(self.fields(None)).to("cpu", torch.int64).numpy()
        return dict(zip(self.limits, values, strict=True))

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the parameters to these codes, (rows, cols) by field. Raise ValueError if they are
        out of range, or not legal."""
        self.fill(*(values.numpy() for values in self.checked(codes, self.limits)))
        # Reading the codes rounds them to legal ones, which shows codes that are not legal.
        if any((values != codes[name]).any() for name, values in self.codes().items()):
            raise ValueError("some of its codes are not allowed by `require`")

    def fill(self, *fields: Floats | Ints) -> None:
        """Set the values (rows, cols) of all fields in slots, given in the order of `limits`. They
        are not checked, and may be fractions of a slot."""
        with torch.no_grad():
            for name, values in zip(self.limits, fields, strict=True):
                slots = torch.as_tensor(np.asarray(values, np.float64))
                self.get_parameter(name).copy_(self.parameter_of(slots))


class Stop(Bump):
    """Class b: open from slot 0 to a stop, a boundary 1..N between slots; so a shutter opens for at
    least one slot.

    The parameter is the stop in octaves (its base-2 logarithm): a training step changes all
    exposure times by the same ratio."""

    jitter_unit = 0.25

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with all pixels open for one slot."""
        super().__init__(spec, relaxation, {"stop": (1, spec.slots)})

    def slots_of(self, parameter: Tensor) -> Tensor:
        """Return stops in slots for stops in octaves: 2 to their power, in steps of `_FINEST`. The
        gradient is that of the exponential."""
        stop = torch.exp2(parameter)
        return replaced(stop, torch.round(stop.detach() / _FINEST) * _FINEST)

    def parameter_of(self, slots: Tensor) -> Tensor:
        """Return stops in octaves from slots."""
        return torch.log2(slots)

    def bound_of(self, slots: int) -> float:
        """Return a limit in octaves from slots."""
        return math.log2(slots)

    def edges(self, fields: Tensor) -> tuple[Tensor, Tensor]:
        """Return a boundary far before the frame for every opening, so that it has no gradient, and
        the stops."""
        return torch.full_like(fields[0].detach(), -_FAR), fields[0]

    def trial_spread(self, fields: Tensor) -> Tensor:
        """Return the standard deviation of trials in slots: at most a quarter of the exposure, and
        at least `least_tried`."""
        # The ratio of exposures matters, so short exposures are changed in small steps.
        return torch.minimum(super().trial_spread(fields), fields / 4).clamp(min=self.least_tried)

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw the stop of each pixel, 1 to N with equal probability."""
        self.fill(generator.integers(1, self.spec.slots, self.spec.tile, endpoint=True))

    def start_uniform(self) -> None:
        """Set all stops to the square root of N: the middle of the range in octaves."""
        self.fill(np.full(self.spec.tile, max(1.0, np.rint(self.spec.slots**0.5))))

    def start_quad(self) -> None:
        """Set stops N, N / 4, N / 16 and N / 64, rounded and at least 1, in each 2 x 2 pixels, row
        by row."""
        self.fill(np.maximum(1, np.rint(self.spec.slots / 4.0 ** self.quad_ranks())))


class Start(Bump):
    """Class c: one bump (consecutive open slots) of a fixed length, which opens at a boundary from
    0 to N - length."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with all bumps at slot 0. Raise ValueError if the length in `spec` is missing or
        does not fit the frame."""
        if spec.length is None or not 1 <= spec.length <= spec.slots:
            raise ValueError(
                f"class c needs the length of its bumps, 1 to {spec.slots} slots, not {spec.length}"
            )
        self.length, self.last = spec.length, spec.slots - spec.length
        super().__init__(spec, relaxation, {"start": (0, self.last)})

    def edges(self, fields: Tensor) -> tuple[Tensor, Tensor]:
        """Return the starts, and the boundaries `length` later."""
        return fields[0], fields[0] + self.length

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw the start of each pixel, with equal probability for all at which the bump fits."""
        self.fill(generator.integers(0, self.last, self.spec.tile, endpoint=True))

    def start_uniform(self) -> None:
        """Set all bumps to the middle of the frame, half a slot earlier if they cannot be
        centred."""
        self.fill(np.full(self.spec.tile, self.last // 2))

    def start_quad(self) -> None:
        """Set four evenly spaced starts in each 2 x 2 pixels."""
        self.fill(np.rint(self.quad_ranks() * (self.last / 3)))


class StartStop(Bump):
    """Class d: one bump (consecutive open slots) in each frame. It opens at the boundary `start`
    and closes at `stop`, at least a slot later; both are learned."""

    def __init__(self, spec: ShutterSpec, relaxation: str = "straight-through") -> None:
        """Begin with all pixels open in slot 0."""
        super().__init__(spec, relaxation, {"start": (0, spec.slots - 1), "stop": (1, spec.slots)})

    def edges(self, fields: Tensor) -> tuple[Tensor, Tensor]:
        """Return starts and stops, each stop at least a slot after its start."""
        return fields[0], torch.maximum(fields[1], fields[0] + 1)

    def codes(self) -> Codes:
        """Return starts and stops, int64 (rows, cols), each stop at least one slot after its start.
        Raise ValueError if a parameter is not finite."""
        codes = super().codes()
        # Start and stop are rounded independently, so that they may meet.
        codes["stop"] = np.maximum(codes["stop"], codes["start"] + 1)
        return codes

    def load_codes(self, codes: Mapping[str, Ints]) -> None:
        """Set the parameters to these codes. Raise ValueError if they are out of range or not
        legal, or if a stop is not after its start."""
        start, stop = self.checked(codes, self.limits)
        if not bool((start < stop).all()):
            raise ValueError(
                "a bump stops before it starts: each `stop` must be larger than its `start`"
            )
        super().load_codes(codes)

    def start_random(self, generator: np.random.Generator) -> None:
        """Draw the bump of each pixel, every legal pair of start and stop with the same
        probability."""
        first, last = np.triu_indices(self.spec.slots)
        drawn = generator.integers(0, len(first), self.spec.tile)
        self.fill(first[drawn], last[drawn] + 1)

    def start_uniform(self) -> None:
        """Open all pixels in the middle half of the frame, in at least one slot."""
        quarter = self.spec.slots // 4
        stop = max(self.spec.slots - quarter, quarter + 1)
        self.fill(np.full(self.spec.tile, quarter), np.full(self.spec.tile, stop))

    def start_quad(self) -> None:
        """Open each of the pixels of a 2 x 2 square in another quarter of the frame, in at least
        one slot."""
        n, rank = self.spec.slots, self.quad_ranks()
        start = np.minimum(np.rint(rank * n / 4), n - 1)
        self.fill(start, np.maximum(np.rint((rank + 1) * n / 4), start + 1))
