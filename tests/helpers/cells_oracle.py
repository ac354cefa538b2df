"""Random recurrent cells beside what SciPy makes of them: counts, states, films.

As in `neighbours_oracle`, a program is text, every piece of which comes with a function on arrays.
Counts are integers here, and comparisons of counts are those of integers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from neighbours_oracle import STEP_E
from numpy.typing import NDArray
from scipy.ndimage import correlate

Arrays = dict[str, NDArray[Any]]
Maker = Callable[[Arrays], NDArray[Any]]


def agreement(
    bits: NDArray[np.bool_], weights: NDArray[np.int64], outside: int
) -> NDArray[np.int64]:
    """By its definition: +1 or -1 for each weight that is not 0."""
    rows, cols = weights.shape[0] // 2, weights.shape[1] // 2
    padded = np.pad(bits, ((rows, rows), (cols, cols)), constant_values=bool(outside))
    total = np.zeros(bits.shape, np.int64)
    for (i, j), weight in np.ndenumerate(weights):
        if weight:
            seen = padded[i : i + bits.shape[0], j : j + bits.shape[1]]
            total += np.where(seen == (weight > 0), 1, -1)
    return total


@dataclass
class Cell:
    """Its text, how its images and planes follow from the exposure and the states, and how the
    states then step."""

    lines: list[str]
    start: dict[str, bool] = field(default_factory=dict)
    items: list[tuple[str, Maker]] = field(default_factory=list)
    nexts: list[tuple[str, Maker]] = field(default_factory=list)
    counts: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        return "\n".join(self.lines) + "\n"

    def step(self, exposure: NDArray[np.float64], states: Arrays) -> tuple[Arrays, Arrays]:
        """The images and planes of a frame, and the states after it."""
        known: Arrays = {"exposure": exposure, **states}
        for name, make in self.items:
            known[name] = make(known)
        return known, {name: make(known) for name, make in self.nexts}


class CellWriter:
    """Writes a random cell."""

    def __init__(self, rng: np.random.Generator, most_side: int) -> None:
        self.rng, self.most_side = rng, most_side
        self.outside = int(rng.integers(2))
        self.cell = Cell(
            ["nsl 3", "frame 1 slots of 33ms", "open when true", f"outside {self.outside}"]
        )
        self.kernels: dict[str, NDArray[np.int64]] = {}
        self.planes: list[str] = []
        self.peaks: dict[str, int] = {}
        self.absolute: set[str] = set()

    def kernel(self) -> str:
        """A new kernel of random signs, now and then with zeros."""
        rng, name = self.rng, f"k{len(self.kernels)}"
        shape = rng.choice(np.arange(3, self.most_side + 1, 2), 2)
        weights = rng.choice([-1, 1], shape)
        if rng.random() < 0.4:
            weights *= rng.random(shape) < 0.6
        if rng.random() < 0.2:
            weights *= rng.integers(1, 4)  # only signs count
        if not weights.any():
            weights.flat[int(rng.integers(weights.size))] = -1
        self.kernels[name] = weights
        self.cell.lines.append(f"kernel {name} = {weights.tolist()}")
        return name

    def agreements(self, planes: list[str]) -> tuple[str, Maker, int]:
        """A sum of agreements, and the largest count that it may have."""
        terms, makers, peak = [], [], 0
        for plane in planes:
            kernel = self.kernel()
            weights, sign = self.kernels[kernel], int(self.rng.choice([1, 1, 1, -1]))
            most = int(np.count_nonzero(weights))
            if peak + most > 120:
                break
            peak += most
            terms.append(f"{'-' if sign < 0 else '+'} agree({plane}, {kernel})")
            makers.append(
                lambda known, plane=plane, weights=weights, sign=sign: (
                    sign * agreement(known[plane], weights, self.outside)
                )
            )
        text = " ".join(terms).removeprefix("+ ")
        return text, lambda known: sum(make(known) for make in makers), peak

    def comparison(self) -> tuple[str, Maker]:
        """A comparison of a count with a number that some counts are above, and some below."""
        name = str(self.rng.choice(list(self.peaks)))
        most = max(1, self.peaks[name] - 2)
        level = int(self.rng.integers(-min(6, most), min(6, most)))
        if name in self.absolute:
            level = max(2, abs(level))
        sign = str(self.rng.choice([">", "<", ">=", "<="]))
        compare = {">": np.greater, "<": np.less, ">=": np.greater_equal, "<=": np.less_equal}[sign]
        return f"{name} {sign} {level}", lambda known: compare(known[name], level)

    def condition(self, depth: int) -> tuple[str, Maker]:
        """Logic over states, planes, neighbours' bits and comparisons of counts."""
        kind = self.rng.integers(6) if depth else self.rng.integers(2)
        if kind == 0 or (kind == 1 and not self.peaks):
            name = str(self.rng.choice(self.planes))
            return name, lambda known: known[name]
        if kind == 1:
            return self.comparison()
        if kind == 2:
            name, (right, down) = str(self.rng.choice(self.planes)), self.rng.integers(-2, 3, 2)
            mask = np.zeros((5, 5))
            mask[2 + down, 2 + right] = 1
            outside = float(self.outside)
            return (
                f"{name}[{right}, {down}]",
                lambda known: (
                    correlate(known[name].astype(float), mask, mode="constant", cval=outside) > 0.5
                ),
            )
        text, make = self.condition(depth - 1)
        if kind == 3:
            return f"not ({text})", lambda known: ~make(known)
        other, other_make = self.condition(depth - 1)
        op = str(self.rng.choice(["and", "or", "xor"]))
        join = {"and": np.logical_and, "or": np.logical_or, "xor": np.logical_xor}[op]
        return f"({text}) {op} ({other})", lambda known: join(make(known), other_make(known))

    def write(self) -> Cell:
        """The cell: one or two states, a plane of the exposure, and counts of all of them."""
        rng, cell = self.rng, self.cell
        states = ["h", "g"][: int(rng.integers(1, 3))]
        for name in states:
            cell.start[name] = bool(rng.integers(2))
            kept = rng.random() < 0.5
            text = f"state {'kept ' * kept}{name} : bit = {int(cell.start[name])}"
            cell.lines.append(text + " kept" * (not kept))
        steps = int(rng.integers(20, 90))
        cell.lines.append(f"plane x = exposure > {steps * STEP_E:.3f}e")
        cell.items.append(("x", lambda known: known["exposure"] > steps * STEP_E))
        self.planes = ["x", *states]
        for name in ("f", "o", "e")[: int(rng.integers(1, 4))]:
            read = [plane for plane in self.planes if rng.random() < 0.7] or ["x"]
            text, make, peak = self.agreements(read)
            if rng.random() < 0.2:
                self.absolute.add(name)
                text, inner = f"abs({text})", make
                make = lambda known, inner=inner: np.abs(inner(known))  # noqa: E731
            cell.lines.append(f"image {name} = {text}")
            cell.items.append((name, make))
            self.peaks[name] = peak
            cell.counts.append(name)
            if rng.random() < 0.3:
                text, make = self.condition(1)
                cell.lines.append(f"plane p{name} = {text}")
                cell.items.append((f"p{name}", make))
                self.planes.append(f"p{name}")
        for name in states:
            text, make = self.condition(2)
            if rng.random() < 0.3:
                when, when_make = self.condition(1)
                cell.lines.append(f"next {name} = {text} when {when}")
                cell.nexts.append(
                    (
                        name,
                        lambda known, name=name, make=make, when=when_make: np.where(
                            when(known), make(known), known[name]
                        ),
                    )
                )
            else:
                cell.lines.append(f"next {name} = {text}")
                cell.nexts.append((name, make))
        cell.lines.append(f"read {', '.join([*states, *cell.counts[-1:], *cell.counts[:1]])}")
        return cell


def random_cell(seed: int, most_side: int) -> Cell:
    """The cell of a seed."""
    return CellWriter(np.random.default_rng(seed), most_side).write()
