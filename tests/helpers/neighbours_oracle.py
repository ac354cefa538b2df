"""Random programs of version 3 beside what SciPy makes of them, on whole arrays.

Nothing here is shared with the compiler: a program is text, and every piece of text comes with a
function on arrays. A value is an array with a second one that says where it is not known: it hangs
on what lies beyond the array, or on a comparison that is a tie.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import correlate

FULL_WELL_E, STEP_E = 30000.0, 30000.0 / 127


@dataclass(frozen=True)
class Known:
    """`values` where they are not `unknown`."""

    values: NDArray[Any]
    unknown: NDArray[np.bool_]

    def joined(self, other: Known, values: NDArray[Any]) -> Known:
        """Values made of two."""
        return Known(values, self.unknown | other.unknown)


def filtered(value: Known, weights: NDArray[np.float64]) -> Known:
    """What a kernel makes of an image; beyond the array nothing is known."""
    values = np.where(value.unknown, 0.0, value.values)
    touched = correlate(
        value.unknown.astype(float), (weights != 0).astype(float), mode="constant", cval=1.0
    )
    return Known(correlate(values, weights, mode="constant", cval=0.0), touched > 0.5)


def above(value: Known, level_e: float) -> Known:
    """A comparison with a level."""
    tie = np.abs(value.values - level_e) < 1e-6
    return Known(value.values > level_e, value.unknown | tie)


def near(bits: Known, mask: NDArray[np.bool_], every: bool, outside: int) -> Known:
    """Whether every, or any, bit under a mask is 1."""
    count = correlate(
        bits.values.astype(float), mask.astype(float), mode="constant", cval=float(outside)
    )
    touched = correlate(bits.unknown.astype(float), mask.astype(float), mode="constant", cval=0.0)
    most = mask.sum()
    return Known(count > (most - 0.5 if every else 0.5), touched > 0.5)


Exposures = dict[str, NDArray[np.float64]]
Maker = Callable[[dict[str, Known]], Known]


@dataclass
class Program:
    """Its text, line by line, and how each image and plane follows from those before it."""

    lines: list[str]
    items: list[tuple[str, Maker]] = field(default_factory=list)
    reads: list[str] = field(default_factory=list)
    reported: str | None = None

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"

    def evaluate(self, exposures: Exposures) -> dict[str, Known]:
        known = {
            name: Known(values, np.zeros(values.shape, np.bool_))
            for name, values in exposures.items()
        }
        for name, make in self.items:
            known[name] = make(known)
        return known


class Writer:
    """Writes a random program."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng = rng
        self.outside = int(rng.integers(2))
        two = rng.random() < 0.4
        self.images = ["early", "late"] if two else ["exposure"]
        self.planes: list[str] = []
        head = ["nsl 3", "frame 2 slots of 1ms", f"outside {self.outside}"]
        if two:
            head += ["bucket early open when n == 0", "bucket late open when n == 1"]
        else:
            head += ["open when true"]
        head += ["assume exposure <= 2%"]
        self.program = Program(head)
        self.kernels: dict[str, NDArray[np.float64]] = {}
        for number in range(int(rng.integers(1, 4))):
            self._kernel(f"k{number}")

    def _kernel(self, name: str) -> None:
        rng = self.rng
        shape = [(3, 3), (3, 3), (1, 3), (3, 1), (5, 1), (1, 5)][rng.integers(6)]
        weights = rng.integers(-2, 3, shape)
        if rng.random() < 0.4:
            column = rng.choice([[1, 2, 1], [1, 1, 1], [1, 0, -1]])
            weights = np.outer(column, rng.choice([[1, 2, 1], [1, 0, -1], [1, 1, 1]]))
        if not weights.any():
            weights.flat[0] = 1
        divisor = int(2 ** rng.integers(0, 4))
        self.program.lines.append(f"kernel {name} = {weights.tolist()} / {divisor}")
        self.kernels[name] = weights / divisor

    def image(self, depth: int) -> tuple[str, Maker]:
        """An image's expression."""
        rng = self.rng
        kind = rng.integers(7) if depth else 0
        if kind == 0:
            name = str(rng.choice(self.images))
            return name, lambda known: known[name]
        text, make = self.image(depth - 1)
        if kind in (1, 2):
            kernel = str(rng.choice(list(self.kernels)))
            weights = self.kernels[kernel]
            return f"{kernel}({text})", lambda known: filtered(make(known), weights)
        if kind == 3:
            factor = int(rng.integers(1, 4)) * int(rng.choice([-1, 1]))
            divisor = int(2 ** rng.integers(0, 3))
            return f"({text}) * {factor} / {divisor}", lambda known: _scaled(
                make(known), factor / divisor
            )
        if kind == 4:
            return f"abs({text})", lambda known: _absolute(make(known))
        other, other_make = self.image(depth - 1)
        if kind == 5 or not self.planes:
            sign = int(rng.choice([-1, 1]))
            both = f"({text}) {'+' if sign > 0 else '-'} ({other})"
            return both, lambda known: _added(make(known), other_make(known), sign)
        plane = str(rng.choice(self.planes))
        return f"({text}) if {plane} else ({other})", lambda known: _chosen(
            known[plane], make(known), other_make(known)
        )

    def plane(self, depth: int) -> tuple[str, Maker]:
        """A plane's expression."""
        rng = self.rng
        kind = rng.integers(6) if depth else rng.integers(2)
        if kind == 1 and self.planes:
            name = str(rng.choice(self.planes))
            return name, lambda known: known[name]
        if kind <= 1:
            text, make = self.image(1)
            steps = int(rng.integers(-40, 60))
            sign = str(rng.choice(["<", ">"]))
            # A level that rounds to so many steps of IN.
            level = f"{'-' if steps < 0 else ''}{abs(steps) * STEP_E:.3f}e" if steps else "0"
            return f"({text}) {sign} {level}", lambda known: _compared(
                above(make(known), steps * STEP_E), sign
            )
        text, make = self.plane(depth - 1)
        if kind == 2:
            return f"not ({text})", lambda known: _inverse(make(known))
        if kind == 3:
            kernel, every = str(rng.choice(list(self.kernels))), bool(rng.integers(2))
            mask, outside = self.kernels[kernel] != 0, self.outside
            name = "all" if every else "any"
            return f"{name}({text}, {kernel})", lambda known: near(
                make(known), mask, every, outside
            )
        if kind == 4 and self.planes:
            name, outside = str(rng.choice(self.planes)), self.outside
            right, down = (int(step) for step in rng.integers(-2, 3, 2))
            mask = np.zeros((5, 5), np.bool_)
            mask[2 + down, 2 + right] = True
            return f"{name}[{right}, {down}]", lambda known: near(known[name], mask, True, outside)
        other, other_make = self.plane(depth - 1)
        op = str(rng.choice(["and", "or", "xor"]))
        return f"({text}) {op} ({other})", lambda known: _logic(op, make(known), other_make(known))

    def write(self) -> Program:
        """The program."""
        rng, program = self.rng, self.program
        for number in range(int(rng.integers(2, 5))):
            name = f"v{number}"
            if rng.random() < 0.5:
                text, make = self.image(int(rng.integers(1, 3)))
                program.lines.append(f"image {name} = {text}")
                program.items.append((name, make))
                self.images.append(name)
            else:
                text, make = self.plane(int(rng.integers(0, 3)))
                program.lines.append(f"plane {name} = {text}")
                program.items.append((name, make))
                self.planes.append(name)
        program.reads = [program.items[-1][0], program.items[0][0]]
        program.lines.append(f"read {', '.join(dict.fromkeys(program.reads))}")
        if self.planes:
            program.reported = self.planes[-1]
            program.lines.append(f"report events {program.reported} at most 20")
        return program


def _scaled(value: Known, factor: float) -> Known:
    return Known(value.values * factor, value.unknown)


def _absolute(value: Known) -> Known:
    return Known(np.abs(value.values), value.unknown)


def _added(a: Known, b: Known, sign: int) -> Known:
    return a.joined(b, a.values + sign * b.values)


def _chosen(bits: Known, a: Known, b: Known) -> Known:
    return Known(
        np.where(bits.values, a.values, b.values),
        bits.unknown | np.where(bits.values, a.unknown, b.unknown),
    )


def _compared(answer: Known, sign: str) -> Known:
    return answer if sign == ">" else _inverse(answer)


def _inverse(bits: Known) -> Known:
    return Known(~bits.values, bits.unknown)


def _logic(op: str, a: Known, b: Known) -> Known:
    made = {"and": np.logical_and, "or": np.logical_or, "xor": np.logical_xor}[op]
    return a.joined(b, made(a.values, b.values))


def random_program(seed: int) -> Program:
    """The program of a seed."""
    return Writer(np.random.default_rng(seed)).write()
