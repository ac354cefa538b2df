"""Lower images and planes to words, and assign registers, in the order of the program text.

A register holds a value or its negative, because every word inverts. `nscc.neighbours.synthesis`
finds the words of convolution kernels; this module emits sums, absolute values and choices. A value
stays in its register until the last word that reads it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from fractions import Fraction
from math import sqrt
from typing import Any

from nscc.chips.target import Target
from nscc.neighbours.bits import BitWords
from nscc.neighbours.count_words import CountEmitter, Result, split
from nscc.neighbours.held import Held, PictureRefused
from nscc.neighbours.programs import Program, Taps, added, exact_taps, moved, values_of
from nscc.neighbours.reuse import Contents, Reuse, reuse
from nscc.neighbours.synthesis import Synthesis, gains, noise_gain
from nscc.operations import NEIGHBOURS, Op, op
from nscc.words import pictures as p

Weights = dict[tuple[int, int], Fraction]
_MOST_TRIED = 8
"""Largest number of programs of a kernel that are tried until one fits the free registers."""


class Lowering(CountEmitter):
    """Emits the words of all items. After `run`, `registers` maps each output to its register."""

    def __init__(
        self,
        pictures: p.Pictures,
        target: Target,
        buckets: dict[str, tuple[str, int]],
        digital: Sequence[str],
        unwritten: Collection[str],
        synthesis: Synthesis,
    ) -> None:
        super().__init__(pictures)
        self.target, self.synthesis = target, synthesis
        bucket_registers = {register for register, _ in buckets.values()}
        self.free = [name for name in target.analog_available if name not in bucket_registers]
        self.registers: dict[str, str] = {}
        self.contents: dict[str, Contents] = {}
        self.is_output = False
        self.held = {
            name: Held(register, sign, 0.0, pictures.limits_e[name], name)
            for name, (register, sign) in buckets.items()
        }
        self.bits = BitWords(self, digital, unwritten)
        self.count_e = pictures.count_steps * target.electrons_per_step
        self.costs: list[p.PictureCost] = []
        self.uses = self._uses()
        for name, value in list(self.held.items()):
            self.uses[name] += 1
            self.give(value)

    def _uses(self) -> dict[str, int]:
        """Return how often each image and bucket is read; an output counts once more."""
        uses: dict[str, int] = dict.fromkeys(self.held, 0)
        for name, expression in self.pictures.expressions.items():
            uses[name] = 0
            for node in p.subexpressions(expression):
                if isinstance(node, p.Source):
                    uses[node.name] += 1
        for name in self.pictures.outputs:
            uses[name] = uses.get(name, 0) + 1
        return uses

    def run(self) -> None:
        """Emit the words of every item, then those of the states."""
        for position, item in enumerate(self.pictures.items):
            self.now, before = item.name, len(self.words)
            self.is_output = item.name in self.pictures.outputs
            self.bits.begin(item.name)
            self.count_ahead(position)
            if isinstance(item.node, p.Condition):
                self.bits.declare(item.name, item.node)
                self.costs.append(p.PictureCost(item.name, len(self.words) - before, 0.0, 0.0))
            else:
                value = self.value(item.node)
                if self.is_output and value.sign < 0:
                    value = self.negated(value)
                if value.name is not None:  # a second name for a named value
                    value = self.negated(self.negated(value))
                value = self.held[item.name] = replace(value, name=item.name)
                self.uses[item.name] += 1
                self.give(value)
                most = max(abs(value.low), abs(value.high))
                gain = most / max(self.pictures.limits_e.values())
                words, noise = len(self.words) - before, sqrt(value.variance)
                self.costs.append(p.PictureCost(item.name, words, gain, noise))
        before = len(self.words)
        self.bits.step(self.pictures.states)
        for state in self.pictures.states:
            self.costs.append(p.PictureCost(state.name, len(self.words) - before, 0.0, 0.0))
            before = len(self.words)
            self.registers[state.name] = self.bits.planes[state.name]
        for name in self.pictures.outputs:
            result = self.held.get(name)
            self.registers[name] = result.register if result else self.bits.planes[name]
        self.everywhere()

    # --- registers

    def take(self) -> str:
        if not self.free:
            count = len(self.target.analog_available)
            raise PictureRefused("registers", self.now, count + 1, count)
        # Contents with the most weights are the least likely to be read again.
        sizes = {name: len(taps) for name, (_, taps) in self.contents.items()}
        register = min(self.free, key=lambda name: (name in sizes, -sizes.get(name, 0)))
        self.free.remove(register)
        return register

    def word(self, op: Op, level: int | None = None) -> None:
        super().word(op, level)
        for name in op.destinations:
            self.contents.pop("NEWS" if name in NEIGHBOURS else name, None)

    def give(self, *values: Held) -> None:
        """Note that values have been read, and free each register that no later word reads."""
        for value in values:
            if value.name is not None:
                self.uses[value.name] -= 1
                if self.uses[value.name]:
                    continue
                del self.held[value.name]
            self.free.append(value.register)
            self.free.sort(key=self.target.analog_available.index)

    def checked(self, low: float, high: float) -> None:
        target, slack = self.target, 1 + 1e-9
        if high > target.register_max_e * slack or low < target.register_min_e * slack:
            over = max(high / target.register_max_e, low / target.register_min_e)
            raise PictureRefused("range", self.now, over, 1.0)

    # --- values

    def value(self, node: p.Value) -> Held:
        """Emit the words that compute a value, and return its register."""
        match node:
            case p.Source():
                return self.held[node.name]
            case p.Filtered():
                taps, inner = self._merged(node)
                return self.filtered(self.value(inner), taps)
            case p.Sum():
                return self.sum(node)
            case p.Absolute():
                return self.absolute(self.value(node.value))
            case p.Chosen():
                return self.chosen(node)
            case p.Agreement():
                return self.counted(split(node)[0])
            case p.Largest():
                return self.largest(self.value(node.value), list(self.weights[node.kernel].taps))

    def _merged(self, node: p.Value) -> tuple[Weights, p.Value]:
        """Combine nested kernels and factors; return one kernel and the value it applies to."""
        if isinstance(node, p.Filtered):
            taps, inner = self._merged(node.value)
            return _after(self.weights[node.kernel].taps, taps), inner
        if isinstance(node, p.Sum):
            terms = [(factor, *self._merged(term)) for factor, term in node.terms]
            if terms and all(inner == terms[0][2] for _, _, inner in terms):
                return added(*((factor, taps) for factor, taps, _ in terms)), terms[0][2]
        return {(0, 0): Fraction(1)}, node

    def filtered(self, value: Held, weights: Weights) -> Held:
        if weights == {(0, 0): 1}:
            return value
        if not weights:
            self.give(value)
            return self._nothing()
        if weights == {(0, 0): -1}:
            return replace(value, sign=-value.sign, low=-value.high, high=-value.low)
        try:
            taps = exact_taps(weights)
            programs = self._programs(taps, value)
        except ValueError:
            raise PictureRefused("registers", self.now, 41, 40) from None
        low, high = value.scaled(*gains(taps))
        squares = sum(float(weight) ** 2 for weight in weights.values())
        refused: PictureRefused | None = None
        for program, sign in programs:
            state = self._state()
            try:
                register = self.run_program(program, value)
            except PictureRefused as error:
                refused = refused or error
                self._restore(state)
                continue
            variance = value.variance * squares + noise_gain(program) ** 2
            return Held(register, value.sign * sign, low, high, variance=variance)
        if self.contents:  # retry without values kept for reuse
            self.contents = {}
            return self.filtered(value, weights)
        assert refused is not None
        raise refused

    def _programs(self, taps: Taps, value: Held) -> list[tuple[Program, int]]:
        """Return programs of a kernel (with sign 1) or of its negative (-1) that fit the range.

        They are sorted by the words that remain after reuse, then by their largest value; equally
        good first programs by noise. Raise `PictureRefused` if no program fits."""
        least, ranked = float("inf"), []
        for sign in (1, -1):
            for candidate in self.synthesis.variants(added((sign, taps))):
                over = max(self._excess(value, taps_) for taps_ in values_of(candidate.program))
                least = min(least, over)
                if over <= 1 + 1e-9:
                    left = self._reuse(candidate.program, value)
                    inverted = self.is_output and value.sign * sign < 0
                    words = len(left.words) + inverted
                    ranked.append((words, candidate.peak, candidate.program, sign))
        if not ranked:
            raise PictureRefused("range", self.now, least, 1.0)
        ranked.sort(key=lambda each: each[:2])
        best = ranked[: 1 + max(n for n, each in enumerate(ranked) if each[:2] == ranked[0][:2])]
        best.sort(key=lambda each: noise_gain(each[2]))
        ranked[: len(best)] = best
        return [(program, sign) for *_, program, sign in ranked[:_MOST_TRIED]]

    def _excess(self, value: Held, taps: Taps) -> float:
        """Return the largest result of a kernel, as a multiple of the registers' range."""
        low, high = value.scaled(*gains(taps))
        ends = (low, high) if value.sign > 0 else (-high, -low)
        return max(ends[1] / self.target.register_max_e, ends[0] / self.target.register_min_e)

    def _reuse(self, program: Program, value: Held) -> Reuse:
        keeps = self.target.news_read_keeps
        return reuse(program, _base(value), self.contents, self.free, keeps)

    def run_program(self, program: Program, value: Held) -> str:
        """Emit the words of a program, and return the register of its result."""
        self.everywhere()
        left = self._reuse(program, value)
        last: dict[str, int] = {}
        for number in left.words:
            for name in (*program[number].sources, *program[number].destinations):
                last[name] = number
        result = program[-1].destinations[0]
        places = {"x": value.register, **left.held}
        reserved = {*left.held.values()} & {*self.free}
        self.free = [name for name in self.free if name not in reserved]
        if "x" not in last:
            self.give(value)
        for number in left.words:
            word, names = program[number], []
            for name in word.destinations:
                if name != "NEWS" and name not in NEIGHBOURS and name not in places:
                    places[name] = self.take()
                names.append(places.get(name, name))
            sources = [places.get(name, name) for name in word.sources]
            self.word(op("bus2" if word.halves else "bus", names, sources))
            for name, contents in left.contents[number].items():
                self.contents[places.get(name, "NEWS")] = contents
            for name, at in last.items():
                if at == number and name in places and name != result:
                    if name == "x":
                        self.give(value)
                    elif name not in left.held or places[name] in reserved:
                        self.give(replace(value, register=places[name], name=None))
        unread = [places[name] for name in left.held if name not in last and name != result]
        self.free += [name for name in unread if name in reserved]
        return places[result]

    def negated(self, value: Held) -> Held:
        """Emit the word that inverts the sign in which a value is held."""
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register], [value.register]))
        self.give(value)
        variance = value.variance + 1
        return Held(register, -value.sign, value.low, value.high, variance=variance)

    def sum(self, node: p.Sum) -> Held:
        """Emit a sum: agreements are counted together, terms of one value become one kernel."""
        agreements, others = split(node)
        if agreements.terms:
            count = self.counted(agreements)
            if not others:
                return count
            return self.added([(1, count), (1, self.value(p.Sum(tuple(others))))])
        taps, inner = self._merged(node)
        if inner is not node:
            return self._shortest(
                lambda: self.filtered(self.value(inner), taps), lambda: self._term_by_term(node)
            )
        return self._term_by_term(node)

    def _shortest(self, *ways: Callable[[], Held]) -> Held:
        """Return the value computed by the way with the fewest words."""
        return self.do_shortest(ways, [1] * len(ways))

    def do_shortest(self, ways: Sequence[Callable[[], Result]], shares: Sequence[int]) -> Result:
        """Follow the way with the fewest words per share, and return its result.

        Raise the first `PictureRefused` if no way fits the registers."""
        best: tuple[float, int] | None = None
        refused: PictureRefused | None = None
        before = len(self.words)
        for number, (way, share) in enumerate(zip(ways, shares, strict=True)):
            state = self._state()
            try:
                way()
            except PictureRefused as error:
                refused = refused or error
            else:
                words = (len(self.words) - before) / share
                best = min(best or (words, number), (words, number))
            self._restore(state)
        if best is None:
            assert refused is not None
            raise refused
        return ways[best[1]]()

    def _state(self) -> tuple[Any, ...]:
        bits = self.bits
        return (
            len(self.words), self.free[:], dict(self.held), dict(self.uses), self.masked,
            dict(self.contents),
            bits.free[:], dict(bits.planes), dict(bits.uses), bits.steered,
            {name: terms[:] for name, terms in self.ready.items()}, self.walks,
        )  # fmt: skip

    def _restore(self, state: tuple[Any, ...]) -> None:
        bits = self.bits
        words, self.free, self.held, self.uses, self.masked, self.contents, *of_bits = state
        del self.words[words:]
        bits.free, bits.planes, bits.uses, bits.steered, *of_counting = of_bits
        self.ready, self.walks = of_counting

    def _term_by_term(self, node: p.Sum) -> Held:
        """Emit a sum whose terms are computed one after the other."""
        if not node.terms:
            return self._nothing()
        common = abs(node.terms[0][0])
        if common != 1 and all(abs(factor) == common for factor, _ in node.terms):
            plain = p.Sum(tuple((factor / common, value) for factor, value in node.terms))
            return self.filtered(self.value(plain), {(0, 0): common})
        signed_terms = []
        for factor, value in node.terms:
            term = self.filtered(self.value(value), {(0, 0): abs(factor)})
            signed_terms.append((1 if factor > 0 else -1, term))
        return self.added(signed_terms)

    def _nothing(self) -> Held:
        """Emit a value of 0."""
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register]))
        return Held(register, 1, 0.0, 0.0)

    def added(self, signed_terms: list[tuple[int, Held]]) -> Held:
        low = sum(v.low if sign > 0 else -v.high for sign, v in signed_terms)
        high = sum(v.high if sign > 0 else -v.low for sign, v in signed_terms)
        self.checked(low, high)
        plus = [v for sign, v in signed_terms if sign * v.sign > 0]
        minus = [v for sign, v in signed_terms if sign * v.sign < 0]
        # One word inverts the smaller group of values. A word adds at most four sources.
        total, inverted = (1, minus) if len(plus) >= len(minus) else (-1, plus)
        direct = plus if total > 0 else minus
        if inverted:
            self.everywhere()
            self.word(op("bus", ["NEWS"], [v.register for v in inverted[:4]]))
        sources = [*(v.register for v in direct), *(["NEWS"] if inverted else [])]
        if len(sources) > 4 or len(inverted) > 4:
            raise PictureRefused("registers", self.now, len(signed_terms), 4)
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register], sources))
        self.give(*(v for _, v in signed_terms))
        variance = sum(v.variance for _, v in signed_terms) + 1 + bool(inverted)
        return Held(register, -total, low, high, variance=variance)

    def absolute(self, value: Held) -> Held:
        """Emit an absolute value.

        Two words write the negative to NEWS and to the result. Where the register of the value is
        above 0, a third word inverts the result again."""
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
        return Held(register, 1, least, most, variance=value.variance + 2)

    def largest(self, value: Held, places: Sequence[tuple[int, int]]) -> Held:
        """Emit the largest of the values at these places, compared one after the other.

        A register holds the negative of the largest value so far; a larger value replaces it."""
        if value.sign < 0:
            value = self.negated(value)
        name, uses = value.name or f"largest {len(self.words)}", len(places)
        self.uses[name] = self.uses[name] - 1 + uses if value.name else uses
        value = self.held[name] = replace(value, name=name)
        register, variance = "", 0.0
        for at in places:
            neighbour = value if at == (0, 0) else self.filtered(value, {at: Fraction(1)})
            variance = max(variance, neighbour.variance + 1)
            self.everywhere()
            if register:
                self.word(op("where", [], [register, neighbour.register]))
            else:
                register = self.take()
            self.word(op("bus", [register], [neighbour.register]))
            self.everywhere()
            self.give(neighbour)
        return Held(register, -1, value.low, value.high, variance=variance)

    def chosen(self, node: p.Chosen) -> Held:
        """Emit a choice: one value where a condition is 1, another value where it is 0."""
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
        low, high = min(then.low, otherwise.low), max(then.high, otherwise.high)
        variance = max(then.variance, otherwise.variance) + 1
        return Held(register, -then.sign, low, high, variance=variance)


def _base(value: Held) -> str:
    """Return a name for the contents of a value's register, valid until the register is freed."""
    return f"{value.name or value.register} {value.sign}"


def _after(outer: Weights, inner: Weights) -> Weights:
    """Return the kernel that applies `inner`, then `outer`."""
    return added(*((weight, moved(inner, x, y)) for (x, y), weight in outer.items()))
