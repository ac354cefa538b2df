"""Emit the words that compare images and choose between them: absolute values, the larger one of
two or more images, and choices by a condition."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from nscc.neighbours.held import Held, Level, PictureRefused
from nscc.neighbours.registers import RegisterEmitter
from nscc.operations import op
from nscc.words import pictures as p


class ChoiceEmitter(RegisterEmitter):
    """Emits the words of choices between images."""

    def absolute(self, value: Held) -> Held:
        """Emit an absolute value and return the register of the result; `value` has then been read.

        Two words write the negative to NEWS (the register that neighbours can read) and to the
        result. Where the register of the value is above 0, a third word inverts the result again.
        Raises PictureRefused if no register is free."""
        self.everywhere()
        register = self.take()
        self.word(op("bus", ["NEWS"], [value.register]))
        self.word(op("bus", [register], [value.register]))
        self.word(op("where", [], [value.register]))
        self.word(op("bus", [register], ["NEWS"]))
        self.everywhere()
        self.give(value)
        most = max(abs(value.low), abs(value.high))
        least = 0.0 if value.low <= 0 <= value.high else min(abs(value.low), abs(value.high))
        return Held(register, sign=1, low=least, high=most, variance=value.variance + 2)

    def largest(self, value: Held, offsets: Sequence[tuple[int, int]]) -> Held:
        """Emit the largest of the values of the pixels at these offsets (columns right, rows down),
        and return its register.

        There is at least one offset. The register holds the negative of the largest value so far; a
        larger value replaces it. Raises PictureRefused if registers run out."""
        value = self.positive(value)
        # The value is read once for each offset, instead of once.
        name, uses = value.name or f"largest {len(self.words)}", len(offsets)
        self.uses[name] = self.uses[name] - 1 + uses if value.name else uses
        value = self.held[name] = replace(value, name=name)
        register, variance = "", 0.0
        for at in offsets:
            neighbour = self.positive(self.filtered(value, {at: Fraction(1)}))
            variance = max(variance, neighbour.variance + 1)
            self.everywhere()
            if register:
                self.word(op("where", [], [register, neighbour.register]))
            else:
                register = self.take()
            self.word(op("bus", [register], [neighbour.register]))
            self.everywhere()
            self.give(neighbour)
        return Held(register, sign=-1, low=value.low, high=value.high, variance=variance)

    def larger(self, first: Held, second: Held) -> Held:
        """Emit the larger one of two values at each pixel, and return its register: the second
        value, overwritten where the first is larger.

        Both values have then been read, and may be exchanged before. The register of the second is
        overwritten if it holds the negative, and nothing reads it later; otherwise a copy is. Of
        two negatives, NEWS (the register that neighbours can read) has the first with its own sign.
        Raises PictureRefused if no register is free."""
        negative = first.sign == second.sign < 0
        # Either may be the second: the one that holds the negative or, of two negatives, one that
        # nothing reads later.
        if first.sign < 0 < second.sign or (negative and self._ends(first)):
            first, second = second, first
        in_place = second.sign < 0 and self._ends(second)
        self.everywhere()
        one, start = first.register, second.register
        if second.sign < 0 and (negative or not in_place):
            self.word(op("bus", ["NEWS"], [one if negative else start]))
        compared = ["NEWS" if negative else one, second.register]
        if in_place:
            register, one = second.register, compared[0]
            if second.name is not None:
                self.hand_over(second.name)
        else:
            register = self.take()
            self.word(op("bus", [register], ["NEWS" if first.sign > second.sign else start]))
            compared[1] = register if second.sign > 0 else start
        self.word(op("where", [], compared))
        self.word(op("bus", [register], [one]))
        self.everywhere()
        self.give(first, *([] if in_place else [second]))
        low, high = max(first.low, second.low), max(first.high, second.high)
        variance = max(first.variance, second.variance) + 1
        sign = -1 if in_place else -first.sign
        return Held(register, sign, low, high, variance=variance)

    def _ends(self, value: Held) -> bool:
        """Return whether the next read of a value is its last; True for an intermediate result,
        which is read once."""
        return value.name is None or self.uses[value.name] == 1

    def chosen(self, node: p.Chosen) -> Held:
        """Emit a choice between two images by a condition, and return the register of the result.

        FLAG (the bit that lets a pixel act) is 1 in all pixels afterwards. Raises PictureRefused if
        registers run out."""
        if self.saves_words:
            return self._chosen_by_flag(node)
        then, otherwise = self.value(node.then), self.value(node.otherwise)
        if then.sign != otherwise.sign:
            then = self.negated(then)
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register], [otherwise.register]))
        self.bits.to_flag(node.condition)
        self.word(op("bus", [register], [then.register]))
        self.everywhere()
        self.give(then, otherwise)
        return _either(register, -then.sign, then, otherwise)

    def _chosen_by_flag(self, node: p.Chosen) -> Held:
        """Emit a choice between two images by a condition, as version 4 does, and return its
        register.

        The register of the image that is chosen where FLAG (the bit that lets a pixel act) is 0 is
        used if nothing reads that image later. A level needs no register, and the answer of a
        comparison stays in FLAG. FLAG is 1 in all pixels afterwards. Raises PictureRefused if
        registers run out."""
        then, otherwise = self._value_or_level(node.then), self._value_or_level(node.otherwise)
        condition, compared, bit = node.condition, None, None
        if isinstance(condition, p.Comparison):
            compared = self.value(condition.value)
            if compared.sign < 0:  # FLAG is the inverse of the answer
                then, otherwise = otherwise, then
        else:
            bit = self.bits.bit(condition)
        self.everywhere()
        # The second value may stay where it is if this is its last read.
        in_place = otherwise.register != "IN" and self._ends(otherwise)
        if in_place:
            register, sign = otherwise.register, otherwise.sign
            if otherwise.name is not None:
                self.hand_over(otherwise.name)
        else:
            sign = -(then if otherwise.register == "IN" else otherwise).sign
            register = self.take()
            self._copy(register, sign, otherwise)
        source = then
        # The word that copies inverts, so the value must have the other sign before.
        if then.register != "IN" and then.sign == sign:
            self.word(op("bus", ["NEWS"], [then.register]))
            source = replace(then, register="NEWS", sign=-then.sign)
        if compared is not None and isinstance(condition, p.Comparison):
            self.bits.compare(condition, compared)
            self.give(compared)
        elif bit is not None:
            self.word(op("WHERE", [], [bit[0]]))
            self.bits.give(bit)
        self._copy(register, sign, source)
        self.everywhere()
        self.give(*(v for v in (then, *([] if in_place else [otherwise])) if v.register != "IN"))
        return _either(register, sign, then, otherwise)

    def _value_or_level(self, node: p.Value) -> Held:
        """Return the register of an image or, if the image is a level, IN (the level sent to all
        pixels) with its level.

        A level is 0, or an integer times a step of IN or a parameter. Raises PictureRefused if it
        leaves the range of IN, or if the words of an image do not fit."""
        terms = node.terms if isinstance(node, p.Sum) else ((Fraction(1), node),)
        if not terms:
            return Held("IN", sign=1, low=0.0, high=0.0, level=0)
        if len(terms) > 1 or not isinstance(terms[0][1], p.Uniform) or terms[0][0].denominator > 1:
            return self.value(node)
        factor, param = int(terms[0][0]), terms[0][1].param
        level: Level = (param, factor) if param else factor
        return Held("IN", 1, *self.steps_range(factor, param), level=level)

    def _copy(self, register: str, sign: int, value: Held) -> None:
        """Emit the word that writes `sign` (1 or -1) times a value, or a level, to a register.

        The register of a value must hold it with the other sign, because the word inverts. `value`
        is not given back."""
        if value.register != "IN":
            assert value.sign == -sign
            self.word(op("bus", [register], [value.register]))
            return
        level = value.level
        signed = (level[0], -sign * level[1]) if isinstance(level, tuple) else -sign * (level or 0)
        self.word(op("bus", [register], ["IN"] if signed else []), signed or None)

    def steps_range(self, factor: int, param: str) -> tuple[float, float]:
        """Return the range (low, high), in electrons, of `factor` steps of IN (the level sent to
        all pixels).

        If `param` is not "", it is the range of `factor` times this parameter of the host. Raises
        PictureRefused if it leaves the range of IN."""
        ends = [factor]
        if param:
            of_param = next(each for each in self.pictures.params if each.name == param)
            ends = [factor * of_param.low, factor * of_param.high]
        # A sum may need the level or its negative, so both must be possible.
        most = min(self.target.in_high, -self.target.in_low)
        if max(map(abs, ends)) > most:
            raise PictureRefused("range", self.now, max(map(abs, ends)) / most, available=1.0)
        step_e = self.target.electrons_per_step
        return min(ends) * step_e, max(ends) * step_e


def _either(register: str, sign: int, first: Held, second: Held) -> Held:
    """Return the value in `register`, times `sign`, that is one of two values in each pixel; a word
    has copied it."""
    low, high = min(first.low, second.low), max(first.high, second.high)
    variance = max(first.variance, second.variance) + 1
    return Held(register, sign, low, high, variance=variance)
