"""Values in registers while images are lowered, and the interface of the lowering to its parts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TypeVar

from nscc.operations import Op, WordEffect, op
from nscc.record import Record
from nscc.words import pictures as p
from nscc.words.picture_launches import LoopValue, Times

Result = TypeVar("Result")
Level = int | tuple[str, int] | None
"""Steps of IN, a parameter with a factor, or None for a word that does not read IN."""
Leveled = tuple[Op, Level]
"""A word and the level of IN that it needs."""


class LoopWords(Record):
    """The words of one step of a loop: those with the indices from `begin` up to `end`, without
    `end`, which are executed `times` times.

    `values` are the registers of the names that change from step to step."""

    begin: int
    end: int
    times: Times
    values: tuple[LoopValue, ...]


class PictureRefused(Exception):
    """Raised if an image or plane does not fit the chip.

    `kind` says what is lacking: "registers" (analog), "planes" or "steering" (digital registers),
    "halvings", "store" (words), "range" or "steps" (of a search). `name` is the image or plane, ""
    for "steps". `needed` and `available` are numbers of what is lacking. For "range", `needed` is
    the largest value relative to the range, and `available` is 1."""

    def __init__(self, kind: str, name: str, needed: float, available: float) -> None:
        """Store that the image or plane `name` needs `needed` of something, but only `available`
        are available.

        `kind` says of what; the class lists its values."""
        super().__init__(kind, name, needed, available)
        self.kind, self.name, self.needed, self.available = kind, name, needed, available


class Held(Record):
    """A register that holds a value times `sign`, 1 or -1; the value itself lies in `low` to `high`
    electrons.

    `name` is the image or bucket, or None for an intermediate result that is read once. `variance`
    is the variance of the value's error, in units of the variance of one word's error. If
    `register` is "IN" (the level sent to all pixels), the value is equal in all pixels, and `level`
    is what IN has; otherwise `level` is None."""

    register: str
    sign: int
    low: float
    high: float
    name: str | None = None
    variance: float = 0.0
    level: Level = None

    def scaled(self, up: Fraction, down: Fraction) -> tuple[float, float]:
        """Return the range (low, high) of the value after a convolution, in electrons.

        The positive weights of the convolution kernel sum to `up`, the negative ones to -`down`;
        both are at least 0."""
        return (
            float(up) * self.low - float(down) * self.high,
            float(up) * self.high - float(down) * self.low,
        )


class Emitter(ABC):
    """Words under construction, in `words`; `now` is the name of the image or plane that they
    compute.

    `words` are pairs (word, level of IN that it needs). `masked` tells whether FLAG (the bit that
    lets a pixel act) may be 0 in some pixels; analog words have no effect there. `weights` are the
    program's convolution kernels by name. `held` has the register of each value, and `uses` the
    number of its reads that are left, by name. `saves_words` tells whether the program is of
    version 4 or later; the words of other programs stay as they are. IN is the level sent to all
    pixels."""

    held: dict[str, Held]
    uses: dict[str, int]

    def __init__(self, pictures: p.Pictures) -> None:
        """Begin with a word that sets FLAG (the bit that lets a pixel act) in all pixels, so that
        analog words act everywhere."""
        self.pictures, self.saves_words = pictures, pictures.is_of_version_4
        self.weights = pictures.weights_by_name
        self.words: list[Leveled] = [(op("all"), None)]
        self.masked = False
        self.now = ""

    def word(self, op: Op, level: Level = None) -> None:
        """Append a word; `level` is the value of IN (the level sent to all pixels) that it needs.

        `level` is a number of steps, a pair (parameter, factor) or, if the word does not read IN,
        None. A word that writes the answer of a comparison or a register to FLAG (the bit that lets
        a pixel act) sets `masked`, because FLAG may then be 0 in some pixels. A word that sets FLAG
        in all pixels clears it."""
        effect = op.operation.effect
        if effect in (WordEffect.FLAG_ANALOG, WordEffect.FLAG_DIGITAL):
            self.masked = True
        elif effect is WordEffect.FLAG_ALL:
            self.masked = False
        self.words.append((op, level))

    def everywhere(self) -> None:
        """Emit `all`, which sets FLAG (the bit that lets a pixel act) to 1 in every pixel, unless
        FLAG is 1 everywhere already."""
        if self.masked:
            self.word(op("all"))

    @abstractmethod
    def value(self, node: p.Value) -> Held:
        """Emit the words that compute an image expression, and return the register that holds it.

        Raises PictureRefused if it does not fit the chip."""

    @abstractmethod
    def give(self, *values: Held) -> None:
        """Note that values have been read once, so that registers which nothing else reads become
        free.

        A value without a name is read only once."""

    @abstractmethod
    def do_shortest(self, ways: Sequence[Callable[[], Result]], shares: Sequence[int]) -> Result:
        """Emit the words of the one of `ways` that has the fewest words per share, and return its
        result; of equals, the first.

        `shares` has a number of images for each way; the words of the way are divided by it. Raises
        PictureRefused if no way fits the chip."""
