"""Images and planes of a program of version 3, computed from its exposures.

An image is a value of every pixel, a plane a bit of every pixel. Both are evaluated once, after the
last slot. The expressions are trees of frozen nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Annotated, Any, Literal

from nscc.codec import LATER, KeyName, Within
from nscc.operations import Word
from nscc.record import Record
from nscc.words.machine import Length, OneBit

Offset = tuple[int, int]
"""An offset: columns to the right and rows down."""
_MOST = 1 << 16
"""Most rows, and columns, of a convolution kernel in a file."""


class Weights(Record):
    """A convolution kernel.

    `rows` contain the numerators of the weights; all are divided by `divisor`. The weight in (row
    i, column j) belongs to the pixel that is j minus the centre column to the right and i minus the
    centre row down."""

    name: str
    rows: Annotated[tuple[Annotated[tuple[int, ...], Within(1, _MOST)], ...], Within(1, _MOST)]
    divisor: Annotated[int, Within(1, 1 << 62)]

    @cached_property
    def taps(self) -> dict[Offset, Fraction]:
        """The nonzero weights by the offsets of their pixels."""
        down, right = len(self.rows) // 2, len(self.rows[0]) // 2
        return {
            (j - right, i - down): Fraction(weight, self.divisor)
            for i, row in enumerate(self.rows)
            for j, weight in enumerate(row)
            if weight
        }


# --- images ---------------------------------------------------------------------------------------


class Source(Record):
    """The exposure of a bucket, or an image that was computed before."""

    name: str


class Sum(Record):
    """A sum of images; `terms` are pairs (factor, image)."""

    terms: tuple[tuple[Fraction, Value], ...]


class Filtered(Record):
    """The convolution of the image `value` with the convolution kernel named `kernel`."""

    kernel: str
    value: Value


class Absolute(Record):
    """The absolute value of an image."""

    value: Value


class Chosen(Record):
    """`then` where `condition` is 1, else `otherwise`."""

    condition: Condition
    then: Value
    otherwise: Value


class Largest(Record):
    """The largest value of the neighbours of `value` that have a weight other than 0."""

    value: Value
    kernel: str


class Agreement(Record):
    """A count: the sum of +1 or -1 for each pixel with a weight other than 0.

    A pixel adds +1 if its bit is 1 and its weight positive, or its bit 0 and its weight negative;
    else -1. Bits beyond the array are the program's `outside`."""

    condition: Condition
    kernel: str


# --- planes ---------------------------------------------------------------------------------------


class Bit(Record):
    """A plane that was computed before."""

    name: str


class Constant(Record):
    """A constant bit, equal in all pixels."""

    bit: bool


class Above(Record):
    """A condition: an image is above a level (steps of IN)."""

    value: Value
    steps: int


class Exceeds(Record):
    """A condition: a count is above `level`, half-way between two attainable counts."""

    value: Value
    level: Fraction


class Inverse(Record):
    """The negation (`not`) of a condition."""

    condition: Condition


class Joined(Record):
    """`and`, `or` or `xor` of two conditions."""

    op: Literal["and", "or", "xor"]
    first: Condition
    second: Condition


class Near(Record):
    """A condition: any, or all, of a pixel's neighbours under a convolution kernel have a 1.

    Bits outside the array are the program's `outside`."""

    kind: Literal["any", "all"]
    condition: Condition
    kernel: str


class At(Record):
    """The bit of the pixel at an offset of columns to the right and rows down."""

    condition: Condition
    right: int
    down: int


Value = Source | Sum | Filtered | Absolute | Chosen | Largest | Agreement
Condition = Bit | Constant | Above | Exceeds | Inverse | Joined | Near | At
Node = Value | Condition


class Picture(Record):
    """An image or a plane, with its name."""

    name: str
    node: Node

    @property
    def is_plane(self) -> bool:
        return isinstance(self.node, Condition)


class KeptPlane(Record):
    """A state: a plane that is kept from frame to frame.

    `start`: its bit in all pixels before the first frame. Images and planes read the bit that the
    previous frame left. `next` is evaluated after all images and planes."""

    name: str
    start: OneBit
    next: Condition


class PlaneReport(Record):
    """A report about a plane, which the host receives instead of the plane.

    It tells whether `any` bit is 1, or gives the coordinates of `events` (at most `most`), or the
    `box` around them."""

    kind: Literal["any", "events", "box"]
    plane: str
    most: Length = 0


class TailLaunch(Record):
    """The start of kernel number `kernel` after the exposure, with IN at `level` steps.

    The level is None if the kernel does not read IN."""

    kernel: Length
    level: int | None


class PictureCost(Record):
    """The cost of an image or a plane.

    `words` include shared words only for the first image that uses them. `peak_gain` is its largest
    value relative to the largest exposure. `noise_gain` is the standard deviation of its error if
    each word has an error with standard deviation 1."""

    name: str
    words: Length
    peak_gain: float
    noise_gain: float


@dataclass(frozen=True)
class Pictures:
    """The images and planes of a program, and after lowering their words; empty without them.

    `items` are in evaluation order. `outside` is the bit outside the array, None if no neighbour's
    bit is read. `limits_e` are the largest assumed exposures in electrons, by bucket. `reads` are
    the images, planes and buckets that are read out with the frame. `kernels` run in the order of
    `launches`, after all words of the exposure; `registers` then contain the images and planes that
    are read or reported. `count_steps` are the steps of IN for one count, 0 if nothing is
    counted."""

    weights: Annotated[tuple[Weights, ...], KeyName("kernels")]
    items: tuple[Picture, ...]
    outside: OneBit | None
    limits_e: Mapping[str, float]
    reads: tuple[str, ...]
    reports: tuple[PlaneReport, ...]
    kernels: Annotated[tuple[tuple[Word, ...], ...], KeyName("words")] = ()
    launches: tuple[TailLaunch, ...] = ()
    registers: Mapping[str, str] = field(default_factory=dict)
    costs: tuple[PictureCost, ...] = ()
    states: Annotated[tuple[KeptPlane, ...], LATER] = ()
    count_steps: Annotated[Length, LATER] = 0

    @property
    def expressions(self) -> dict[str, Node]:
        """Return images, planes and next values of states by name, in evaluation order."""
        items: dict[str, Node] = {item.name: item.node for item in self.items}
        return items | {state.name: state.next for state in self.states}

    @property
    def planes(self) -> frozenset[str]:
        """Return the names of planes and states."""
        items = self.expressions.items()
        return frozenset(name for name, node in items if isinstance(node, Condition))

    @property
    def weights_by_name(self) -> dict[str, Weights]:
        return {kernel.name: kernel for kernel in self.weights}

    @property
    def steering(self) -> tuple[str, ...]:
        """The names of images, planes and states that read bits of neighbours."""
        reading = Near | At | Agreement
        return tuple(
            name for name, expression in self.expressions.items()
            if any(isinstance(node, reading) for node in subexpressions(expression))
        )  # fmt: skip

    @property
    def outputs(self) -> tuple[str, ...]:
        """The names of all images, planes and buckets that are read or reported."""
        return tuple(dict.fromkeys((*self.reads, *(r.plane for r in self.reports))))

    @property
    def images_read(self) -> tuple[str, ...]:
        """Return the names of the images that are read out."""
        images = {item.name for item in self.items if not item.is_plane}
        return tuple(name for name in self.reads if name in images)

    @property
    def words(self) -> int:
        """The number of words executed after the last slot."""
        return sum(len(self.kernels[launch.kernel]) for launch in self.launches)


NO_PICTURES = Pictures((), (), None, {}, (), ())
"""The images and planes of a program without any."""


def operands(node: Node) -> tuple[Node, ...]:
    """Return the direct operands of a node."""
    if isinstance(node, Sum):
        return tuple(value for _, value in node.terms)
    return tuple(value for value in vars(node).values() if isinstance(value, Node))


def with_operands(node: Node, change: Callable[[Any], Any]) -> Node:
    """Return a node with `change(operand)` in place of each direct operand."""
    if isinstance(node, Sum):
        return Sum(tuple((factor, change(value)) for factor, value in node.terms))
    make: Any = type(node)
    changed: Node = make(*(change(v) if isinstance(v, Node) else v for v in vars(node).values()))
    return changed


def subexpressions(node: Node) -> Iterator[Node]:
    """Yield a node and all its subexpressions."""
    yield node
    for operand in operands(node):
        yield from subexpressions(operand)
