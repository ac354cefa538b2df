"""Images and planes of a program of version 3 or 4, computed from its exposures.

An image is a value of every pixel, a plane a bit of every pixel. Both are evaluated once, after the
last slot. The expressions are trees of frozen nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType
from typing import Annotated, Any, Literal

from nscc.codec import HEX, LATER, KeyName, Within
from nscc.operations import Word
from nscc.record import Record
from nscc.words.machine import Length, OneBit
from nscc.words.picture_launches import (
    HostParam,
    LaunchLoop,
    LevelOf,
    SteeredLaunch,
    TailLaunch,
    Times,
    every_step,
)

Offset = tuple[int, int]
"""An offset: columns to the right and rows down."""
_MOST = 1 << 16
"""Most rows, and columns, of a convolution kernel in a file."""


class Weights(Record):
    """A convolution kernel.

    `rows` contain the numerators of the weights, from the top, each row from the left; all are
    divided by `divisor`. The weight in (row i, column j) belongs to the pixel that is j minus the
    centre column to the right and i minus the centre row down. The centre is entry n // 2 of n."""

    name: str
    rows: Annotated[tuple[Annotated[tuple[int, ...], Within(1, _MOST)], ...], Within(1, _MOST)]
    divisor: Annotated[int, Within(1, 1 << 62)]

    @cached_property
    def taps(self) -> dict[Offset, Fraction]:
        """The nonzero weights by the offsets (columns right, rows down) of their pixels."""
        down, right = len(self.rows) // 2, len(self.rows[0]) // 2
        return {
            (j - right, i - down): Fraction(weight, self.divisor)
            for i, row in enumerate(self.rows)
            for j, weight in enumerate(row)
            if weight
        }


# --- images ---------------------------------------------------------------------------------------


class Source(Record):
    """The exposure of a bucket, or an image that was computed before, by its name."""

    name: str


class Sum(Record):
    """A sum of images; `terms` are pairs (factor, image)."""

    terms: tuple[tuple[Fraction, Value], ...]


class Filtered(Record):
    """The convolution of the image `value` with the convolution kernel named `kernel`: the sum of
    each weight times the value of its pixel."""

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
    """The largest value among the pixels to which the convolution kernel named `kernel` gives a
    weight other than 0."""

    value: Value
    kernel: str


class Uniform(Record):
    """A value that is equal in all pixels: one step of IN (the level sent to all pixels), or as
    many as the parameter `param` says.

    `param` is "" for one step."""

    param: str = ""


class Larger(Record):
    """The larger one of two images."""

    first: Value
    second: Value


class Shifted(Record):
    """The value of the pixel that is `right` columns to the right and `down` rows down; negative
    numbers point to the left and up."""

    value: Value
    right: int
    down: int


class RepeatedImage(Record):
    """An image that is `start` first; each of `times` steps replaces it by `step`.

    In `step`, its own name is its value before the step. Consecutive items with the same `leader`,
    the name of the first, step together."""

    start: Value
    step: Value
    times: Times
    leader: str


class Agreement(Record):
    """A count: the sum of +1 or -1 for each pixel with a weight other than 0 in the convolution
    kernel named `kernel`.

    A pixel adds +1 if its bit of `condition` is 1 and its weight positive, or its bit 0 and its
    weight negative; else -1. Bits beyond the array are the program's `outside`."""

    condition: Condition
    kernel: str


# --- planes ---------------------------------------------------------------------------------------


class Bit(Record):
    """A plane that was computed before, a state or an input plane, by its name."""

    name: str


class Constant(Record):
    """A constant bit, equal in all pixels."""

    bit: bool


class Above(Record):
    """A condition: the image `value` is above the level `steps`, in steps of IN (the level sent to
    all pixels)."""

    value: Value
    steps: int


class AboveParam(Record):
    """A condition: the image `value` is above `factor` times the parameter `param`, in steps of IN
    (the level sent to all pixels)."""

    value: Value
    param: str
    factor: int


class Exceeds(Record):
    """A condition: the count `value` is above `level`, half-way between two attainable counts, so
    that it never equals the level."""

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
    """A condition: any, or all (`kind`), of the pixels with a weight other than 0 in the
    convolution kernel named `kernel` have a 1 of `condition`.

    Bits outside the array are the program's `outside`."""

    kind: Literal["any", "all"]
    condition: Condition
    kernel: str


class At(Record):
    """The bit of the pixel that is `right` columns to the right and `down` rows down; negative
    numbers point to the left and up.

    Bits outside the array are the program's `outside`."""

    condition: Condition
    right: int
    down: int


class Neither(Record):
    """The NOR of two conditions: 1 where both are 0."""

    first: Condition
    second: Condition


class Propagated(Record):
    """A condition, and the pixels of `mask` that the chip's propagation connects with it.

    It reaches `pixels` columns and rows; the repeated plane of a flood has several propagations.
    `mask` contains the condition."""

    condition: Condition
    mask: Condition
    pixels: int


class ChosenPlane(Record):
    """`then` where `condition` is 1, else `otherwise`; all are planes."""

    condition: Condition
    then: Condition
    otherwise: Condition


class RepeatedPlane(Record):
    """A plane that is `start` first; each of `times` steps replaces it by `step`.

    In `step`, its own name is its value before the step. Consecutive items with the same `leader`,
    the name of the first, step together."""

    start: Condition
    step: Condition
    times: Times
    leader: str


Value = (
    Source
    | Sum
    | Filtered
    | Absolute
    | Chosen
    | Largest
    | Agreement
    | Shifted
    | RepeatedImage
    | Uniform
    | Larger
)
Condition = (
    Bit
    | Constant
    | Above
    | Exceeds
    | Inverse
    | Joined
    | Near
    | At
    | AboveParam
    | ChosenPlane
    | Neither
    | RepeatedPlane
    | Propagated
)
READS_NEIGHBOURS = Near | At | Agreement | Propagated
"""What needs R1 to R4, which choose neighbours."""
Comparison = Above | AboveParam | Exceeds
"""A condition that compares an image with a number, a parameter or another image."""
Node = Value | Condition
"""An expression for an image or for a plane."""


Repeated = RepeatedImage | RepeatedPlane
"""A definition that is executed several times."""


class Picture(Record):
    """An image or a plane of a program, with its name and its expression."""

    name: str
    node: Node

    @property
    def is_plane(self) -> bool:
        """Whether it is a plane of bits, not an image."""
        return isinstance(self.node, Condition)


class KeptPlane(Record):
    """A state: a plane that is kept from frame to frame.

    `start` is its bit in all pixels before the first frame. Images and planes read the bit that the
    previous frame left. `next` is its new value, evaluated after all images and planes."""

    name: str
    start: OneBit
    next: Condition


class RangeState(Record):
    """A state with the values `low` to `high`, which are kept in planes: each holds a bit of the
    value minus `low`, the lowest first."""

    name: str
    low: int
    high: int

    @property
    def values(self) -> range:
        """All values, in order."""
        return range(self.low, self.high + 1)

    @property
    def bits(self) -> list[str]:
        """The names of the planes of its bits, at least one."""
        return [f"{self.name} {bit}" for bit in range(max(1, (self.high - self.low).bit_length()))]


class InputPlane(Record):
    """A plane that the host loads before a frame, and that no word changes.

    `bits` are its start as one number: bit (row * columns + column) belongs to that pixel.
    `is_open` tells whether the host may load other bits. A plane that the program defines by x and
    y is not open."""

    name: str
    bits: Annotated[int, HEX]
    is_open: bool


class KeptImage(Record):
    """A state that is an image: an analog register that is kept from frame to frame.

    `start_e` is its value in all pixels before the first frame, in electrons. `next` is its new
    value, evaluated after all images and planes, which read the value that the previous frame left.
    """

    name: str
    start_e: float
    next: Value


GROWS = " grows"
"""The end of the name of the pixels that one more step of a flood would reach."""


class PlaneReport(Record):
    """A report about a plane or an image, which the host receives instead of it.

    By `kind`, it tells whether any bit is 1 ("any"), the coordinates of at most `most` bits that
    are 1 ("events"), the box around them, their number ("count"), or the sum of an image. "flood"
    tells whether a flood is complete; `plane` is then the name of a flooded plane with `GROWS`
    after it. `most` is 0 for other kinds."""

    kind: Literal["any", "events", "box", "count", "sum", "flood"]
    plane: str
    most: Length = 0

    @property
    def subject(self) -> str:
        """The name of the reported plane or image in the program; "exposure" for the bucket
        `frame`."""
        name = "exposure" if self.plane == "frame" else self.plane
        return name.removesuffix(GROWS) if self.kind == "flood" else name

    @property
    def key(self) -> str:
        """The name of the report's array in a frame file, such as `report_count_NAME` or
        `flood_complete_NAME`."""
        kind = "flood_complete" if self.kind == "flood" else f"report_{self.kind}"
        return f"{kind}_{self.subject}"


class PictureCost(Record):
    """The cost of an image or a plane.

    `words` include shared words only for the first image that uses them. `peak_gain` is its largest
    value relative to the largest exposure. `noise_gain` is the standard deviation of its error if
    each word has an error with standard deviation 1. Both gains are 0 for planes."""

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
    are read or reported. `count_steps` are the steps of IN (the level sent to all pixels) for one
    count, 0 if nothing is counted.

    Version 4 adds planes that the host loads (`inputs`), images that are kept from frame to frame,
    and parameters. `launches` contains the launches (starts of kernels) of each loop once, and
    those that set IN to a parameter (`levels_of`) without a level; `executed` returns them all.
    `negated` are the kept images of which registers hold the negative. `version` is 4 for programs
    of `nsl 4`. `ranges` are the states with a range, whose bits are among `states`. A lowering is a
    way to compute the exposure."""

    weights: Annotated[tuple[Weights, ...], KeyName("kernels")]
    items: tuple[Picture, ...]
    outside: OneBit | None
    limits_e: Mapping[str, float]
    reads: tuple[str, ...]
    reports: tuple[PlaneReport, ...]
    kernels: Annotated[tuple[tuple[Word, ...], ...], KeyName("words")] = ()
    launches: tuple[TailLaunch, ...] = ()  # each once: see `executed`
    registers: Mapping[str, str] = field(default_factory=dict)
    costs: tuple[PictureCost, ...] = ()
    states: Annotated[tuple[KeptPlane, ...], LATER] = ()
    count_steps: Annotated[Length, LATER] = 0
    inputs: Annotated[tuple[InputPlane, ...], LATER] = ()
    kept_images: Annotated[tuple[KeptImage, ...], LATER] = ()
    params: Annotated[tuple[HostParam, ...], LATER] = ()
    loops: Annotated[tuple[LaunchLoop, ...], LATER] = ()
    levels_of: Annotated[tuple[LevelOf, ...], LATER] = ()
    negated: Annotated[tuple[str, ...], LATER] = ()
    version: Annotated[Length, LATER] = 3
    ranges: Annotated[tuple[RangeState, ...], LATER] = ()

    @property
    def is_of_version_4(self) -> bool:
        """Whether the program begins with `nsl 4`. Words of other programs stay as they are."""
        return self.version > 3

    @property
    def has_host_values(self) -> bool:
        """Whether the host may set parameters or load planes before a frame."""
        return bool(self.params or any(plane.is_open for plane in self.inputs))

    @property
    def steps_are_set(self) -> bool:
        """Whether a parameter sets the number of steps of a loop."""
        return any(loop.times.param for loop in self.loops)

    def executed(self, params: Mapping[str, int] = MappingProxyType({})) -> list[TailLaunch]:
        """Return all launches (starts of kernels) of a frame in order, with every step of loops and
        the values of IN.

        `params` has values of parameters by name; others have their starts. IN is the level sent to
        all pixels. A kernel is a list of words."""
        values = {param.name: param.start for param in self.params} | {**params}
        return [
            TailLaunch(each.kernel, each.level)
            if each.level_of is None
            else TailLaunch(each.kernel, each.level_of.factor * values[each.level_of.param])
            for each in self.steered(values)
        ]

    def steered(self, params: Mapping[str, int] | None = None) -> Iterator[SteeredLaunch]:
        """Yield all launches (starts of kernels) of a frame in order, with every step of loops.

        `params` has values of parameters by name; None stands for the largest number of steps of
        each loop. A kernel is a list of words."""
        return every_step(self.launches, self.levels_of, self.loops, params)

    @property
    def expressions(self) -> dict[str, Node]:
        """The images, planes and next values of states by name, in evaluation order."""
        items: dict[str, Node] = {item.name: item.node for item in self.items}
        items |= {state.name: state.next for state in self.states}
        return items | {image.name: image.next for image in self.kept_images}

    @property
    def planes(self) -> frozenset[str]:
        """The names of all planes of bits: items, states and input planes."""
        items = self.expressions.items()
        planes = frozenset(name for name, node in items if isinstance(node, Condition))
        return planes | {plane.name for plane in self.inputs}

    @property
    def stepping(self) -> tuple[str, ...]:
        """The names of states, planes first, then images, which take new values once a frame."""
        planes, images = (state.name for state in self.states), (s.name for s in self.kept_images)
        return (*planes, *images)

    @property
    def kept(self) -> tuple[str, ...]:
        """The names of states and input planes, whose registers nothing else may use."""
        return (*self.stepping, *(plane.name for plane in self.inputs))

    @property
    def repeated(self) -> dict[str, RepeatedImage | RepeatedPlane]:
        """The repeated images and planes by name."""
        items = ((item.name, item.node) for item in self.items)
        return {name: node for name, node in items if isinstance(node, Repeated)}

    def loop_of(self, name: str) -> list[str]:
        """Return the names that step together with the repeated image or plane `name`, in order,
        with `name` itself.

        Raises KeyError if `name` is not repeated."""
        leader = self.repeated[name].leader
        return [each for each, node in self.repeated.items() if node.leader == leader]

    @property
    def held_planes(self) -> dict[str, int]:
        """The bits that the host loads before the first frame, by name of state or input plane.

        They are numbers as in `InputPlane.bits`; -1 stands for a 1 in every pixel."""
        bits = {state.name: -state.start for state in self.states}
        return bits | {plane.name: plane.bits for plane in self.inputs}

    @property
    def weights_by_name(self) -> dict[str, Weights]:
        """The convolution kernels by name."""
        return {kernel.name: kernel for kernel in self.weights}

    @property
    def steering(self) -> tuple[str, ...]:
        """The names of images, planes and states whose words read bits of neighbours, in order.

        These words need R1 to R4, which choose the neighbours."""
        return tuple(
            name
            for name, expression in self.expressions.items()
            if any(isinstance(node, READS_NEIGHBOURS) for node in subexpressions(expression))
        )

    @property
    def outputs(self) -> tuple[str, ...]:
        """The names of all images, planes and buckets that are read or reported, each once, those
        that are read first."""
        return tuple(dict.fromkeys((*self.reads, *(r.plane for r in self.reports))))

    @property
    def images_read(self) -> tuple[str, ...]:
        """The names of the images that are read out, in order; buckets and planes are left out."""
        images = {item.name for item in self.items if not item.is_plane}
        images |= {state.name for state in self.kept_images}
        return tuple(name for name in self.reads if name in images)

    @property
    def images_sent(self) -> tuple[str, ...]:
        """The names of the images that a device sends, each once: those that are read out, then
        those whose sum the host computes."""
        summed = (report.plane for report in self.reports if report.kind == "sum")
        return (
            *self.images_read,
            *dict.fromkeys(name for name in summed if name not in self.reads),
        )

    @property
    def words(self) -> int:
        """The number of words executed after the last slot, if parameters have their starts."""
        return sum(len(self.kernels[launch.kernel]) for launch in self.executed())


NO_PICTURES = Pictures(weights=(), items=(), outside=None, limits_e={}, reads=(), reports=())
"""The images and planes of a program without any."""


def operands(node: Node) -> tuple[Node, ...]:
    """Return the direct operands of an expression, in order; () for a leaf. The factors of a sum
    are left out."""
    if isinstance(node, Sum):
        return tuple(value for _, value in node.terms)
    return tuple(value for value in vars(node).values() if isinstance(value, Node))


def with_operands(node: Node, change: Callable[[Any], Any]) -> Node:
    """Return an expression with `change(operand)` in place of each direct operand; the expression
    itself is not changed."""
    if isinstance(node, Sum):
        return Sum(tuple((factor, change(value)) for factor, value in node.terms))
    # A node is made from its fields in order.
    make: Any = type(node)
    changed: Node = make(*(change(v) if isinstance(v, Node) else v for v in vars(node).values()))
    return changed


def inverse_of(node: Condition) -> Condition:
    """Return the inverse of a condition, in a form that needs few words."""
    match node:
        case Inverse():
            return node.condition
        case Constant():
            return Constant(not node.bit)
        case Neither():
            return Joined("or", node.first, node.second)
        case Joined(op="or"):
            return Neither(node.first, node.second)
    return Inverse(node)


def subexpressions(node: Node) -> Iterator[Node]:
    """Yield an expression and all expressions inside it, each before its operands."""
    yield node
    for operand in operands(node):
        yield from subexpressions(operand)
