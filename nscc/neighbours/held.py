"""Values in registers while images are lowered, and what both halves of the lowering share."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction

from nscc.operations import Op, WordEffect, op
from nscc.words import pictures as p

Leveled = tuple[Op, int | None]
"""A word and the steps of IN that it needs."""


class PictureRefused(Exception):
    """An image does not fit the chip: `kind` is "registers", "range" or "planes"; `name` is the
    image or plane, `needed` and `available` are numbers of what `kind` says."""

    def __init__(self, kind: str, name: str, needed: float, available: float) -> None:
        super().__init__(kind, name, needed, available)
        self.kind, self.name, self.needed, self.available = kind, name, needed, available


@dataclass(frozen=True)
class Held:
    """A register that holds a value times `sign`, somewhere from `low` to `high` electrons.

    `name` is that of an image or a bucket, which others may read as well; None for a value that
    only whoever has it reads. `variance` is that of its error, in variances of a word's error.
    """

    register: str
    sign: int
    low: float
    high: float
    name: str | None = None
    variance: float = 0.0

    def scaled(self, up: Fraction, down: Fraction) -> tuple[float, float]:
        """The range of what a kernel makes of the value, whose weights add and take so much."""
        return (
            float(up) * self.low - float(down) * self.high,
            float(up) * self.high - float(down) * self.low,
        )


class Emitter(ABC):
    """Words that are emitted one after the other; `now` is the image or plane that they compute."""

    def __init__(self, pictures: p.Pictures) -> None:
        self.pictures = pictures
        self.weights = pictures.weights_by_name
        self.words: list[Leveled] = [(op("all"), None)]
        self.masked = False
        self.now = ""

    def word(self, op: Op, level: int | None = None) -> None:
        """Emits the next word."""
        effect = op.operation.effect
        if effect in (WordEffect.FLAG_ANALOG, WordEffect.FLAG_DIGITAL):
            self.masked = True
        elif effect is WordEffect.FLAG_ALL:
            self.masked = False
        self.words.append((op, level))

    def everywhere(self) -> None:
        """FLAG is 1 in all pixels from here on."""
        if self.masked:
            self.word(op("all"))

    @abstractmethod
    def value(self, node: p.Value) -> Held:
        """Emits the words that compute a value; returns where it then is."""

    @abstractmethod
    def give(self, *values: Held) -> None:
        """Takes note that values have been read."""
