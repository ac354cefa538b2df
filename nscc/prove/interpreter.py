"""What both proofs do with a word: which part of the pixel it changes, by its effect."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from nscc.chips.target import Target
from nscc.operations import Effect, Op, Phase

Bits = TypeVar("Bits")
"""The bit of a register in every lane, which may be unknown."""


class Interpreter(ABC, Generic[Bits]):
    """Runs words on the registers of `target`, one bit of every lane at a time.

    A word that reads and one that writes hold the bit between them in the register `bus`.
    """

    target: Target

    def _run(self, word: Op) -> None:
        match word.operation.effect:
            case Effect.RESET_PIX:
                self._reset(word)
            case Effect.BUS:
                self._bus(word)
            case Effect.FLAG_ALL:
                self._write("FLAG", self._ones())
            case Effect.FLAG_ANALOG:
                self._compare(word)
            case Effect.FLAG_DIGITAL:
                self._write("FLAG", self._some(word))
            case Effect.DIGITAL:
                self._digital(word)

    def _digital(self, word: Op) -> None:
        row = word.operation
        if row.phase is Phase.WRITE:
            value = self._read("bus")
        else:
            value = self._some(word)
            if row.inverted:
                value = self._inverse(value)
            if row.phase is Phase.READ:
                self._write("bus", value)
                return
        # The mask decides as it stands before the word: the word may write the mask as well.
        for name in sorted(word.destinations, key=lambda name: name != self.target.masked_register):
            if name == self.target.masked_register:
                self._write_masked(name, value)
            else:
                self._write(name, value)

    @abstractmethod
    def _reset(self, word: Op) -> None:
        """Resets PIX."""

    @abstractmethod
    def _bus(self, word: Op) -> None:
        """Copies a sum of analog registers."""

    @abstractmethod
    def _compare(self, word: Op) -> None:
        """Sets FLAG by a sum of analog registers."""

    @abstractmethod
    def _ones(self) -> Bits:
        """The bit that is 1 in every lane."""

    @abstractmethod
    def _inverse(self, value: Bits) -> Bits:
        """The inverse of a bit."""

    @abstractmethod
    def _some(self, word: Op) -> Bits:
        """The OR of a word's sources."""

    @abstractmethod
    def _read(self, name: str) -> Bits:
        """What a register holds; unknown once it has decayed."""

    @abstractmethod
    def _write(self, name: str, value: Bits) -> None:
        """Writes a register in every lane."""

    @abstractmethod
    def _write_masked(self, name: str, value: Bits) -> None:
        """Writes a register where the mask is 1."""
