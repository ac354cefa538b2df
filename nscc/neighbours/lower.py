"""Lower images and planes to words, in the order of the program text.

A register holds a value or its negative, because every word inverts. `nscc.neighbours.synthesis`
finds the words of convolution kernels, `nscc.neighbours.choice_words` emits choices, and this
module emits sums."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import sqrt
from types import MappingProxyType

from nscc.neighbours.choice_words import ChoiceEmitter
from nscc.neighbours.count_words import split
from nscc.neighbours.held import Held, Level, PictureRefused
from nscc.neighbours.last_use import names_read
from nscc.neighbours.loops import emit_loop, store_at_once
from nscc.neighbours.programs import UNIT, Program, Taps, added, exact_taps, moved, noise_gain
from nscc.neighbours.synthesis import Synthesis, gains
from nscc.operations import WordEffect, op
from nscc.words import pictures as p
from nscc.words.container import Container

Weights = dict[tuple[int, int], Fraction]


class Lowering(ChoiceEmitter):
    """Emits the words of all images and planes of a program.

    After `run`, `registers` maps the name of each output and state to its register. `costs` has the
    cost of each image and plane, `next_values` the next values of kept images by name, and `loops`
    the words of loops."""

    def __init__(
        self,
        pictures: p.Pictures,
        container: Container,
        synthesis: Synthesis,
        kept_ranges: Mapping[str, tuple[float, float]] = MappingProxyType({}),
    ) -> None:
        """Prepare to compile the images and planes of a program after the exposure of `container`;
        `run` emits the words.

        `synthesis` finds the words of convolution kernels. `kept_ranges` gives the (least, largest
        value) of each kept image before a frame, in electrons. Raises PictureRefused if the chip
        has too few registers for kept images and planes."""
        super().__init__(pictures, container, kept_ranges)
        self.synthesis, self.is_output = synthesis, False
        self.registers: dict[str, str] = {}
        self.next_values: dict[str, Held] = {}
        self.costs: list[p.PictureCost] = []

    def run(self) -> None:
        """Emit the words of all images and planes in order, then those that give the states their
        next values.

        Call it once. Raises PictureRefused if they do not fit the chip."""
        for position, item in enumerate(self.pictures.items):
            self.now, before = item.name, len(self.words)
            if isinstance(item.node, p.Repeated):
                if item.node.leader == item.name:
                    self._repeat(self.pictures.loop_of(item.name))
                continue
            self.is_output = item.name in self.pictures.outputs
            self.bits.begin(item.name)
            self.count_ahead(position)
            if isinstance(item.node, p.Condition):
                self.bits.declare(item.name, item.node)
                self._add_cost(item.name, before)
            else:
                value = self.value(item.node)
                value = self.positive(value) if self.is_output else value
                if value.name is not None:  # a second name for a named value gets a copy
                    value = self.negated(self.negated(value))
                value = self.held[item.name] = replace(value, name=item.name)
                # `give` takes back one use, and so frees the register of an unread image.
                self.uses[item.name] += 1
                self.give(value)
                self._add_cost(item.name, before, value)
        before = len(self.words)
        nexts = self.bits.next_bits(self.pictures.states)
        kept = {image.name: image.next for image in self.pictures.kept_images}
        self.next_values = store_at_once(self, kept)
        for name in kept:
            self._add_cost(name, before, self.next_values[name])
            self.registers[name], before = self.held[name].register, len(self.words)
        self.bits.step(nexts)
        for state in self.pictures.states:
            self._add_cost(state.name, before)
            before = len(self.words)
            self.registers[state.name] = self.bits.planes[state.name]
        for plane in self.pictures.inputs:
            self.bits.refresh(plane.name)
            self.registers[plane.name] = self.bits.planes[plane.name]
        for name in self.pictures.outputs:
            result = self.held.get(name)
            self.registers[name] = result.register if result else self.bits.planes[name]
        self.everywhere()
        first = self.words[1][0].operation.effect if len(self.words) > 1 else None
        obeys = self.target.where_obeys_flag
        if self.saves_words and first is WordEffect.FLAG_ANALOG and not obeys:
            # The first comparison writes FLAG in every pixel.
            del self.words[0]
            self.loops = [
                replace(loop, begin=loop.begin - 1, end=loop.end - 1) for loop in self.loops
            ]

    def _add_cost(self, name: str, before: int, value: Held | None = None) -> None:
        """Add the cost of the image or plane `name` to `costs`: the number of words since there
        were `before`, and the gains of its `value`; None for a plane, whose gains are 0.

        The peak gain is the largest absolute value, divided by the largest assumed exposure."""
        peak_gain = noise_gain = 0.0
        if value is not None:
            most_e = max(abs(value.low), abs(value.high))
            peak_gain = most_e / max(self.pictures.limits_e.values())
            noise_gain = sqrt(value.variance)
        words = len(self.words) - before
        self.costs.append(p.PictureCost(name, words, peak_gain, noise_gain))

    def _repeat(self, names: Sequence[str]) -> None:
        """Emit the words of the repeated images and planes `names`, which step together.

        The cost of the first one includes the words of all, with every step, if parameters have
        their starts."""
        before, repeated = len(self.words), self.pictures.repeated
        for name in names:  # never freed before the end of the loop
            uses = self.bits.uses if isinstance(repeated[name], p.Condition) else self.uses
            uses[name] = uses.get(name, 0) + 1
        emit_loop(self, [p.Picture(name, repeated[name]) for name in names])
        loop = self.loops[-1]
        steps = loop.times.at({param.name: param.start for param in self.pictures.params})
        # The words of one step are counted already.
        before -= (steps - 1) * (loop.end - loop.begin)
        for name in names:
            value = self.held.get(name)
            if value is None:
                self.bits.give((self.bits.planes[name], name))
            else:
                self.give(value)
            self._add_cost(name, before, value)
            before = len(self.words)  # the first name has all words

    def value(self, node: p.Value) -> Held:
        """Emit the words that compute the image `node`, and return the register that holds it.

        An image with a name needs no words. Raises PictureRefused if the words do not fit the chip.
        """
        match node:
            case p.Source():
                return self.held[node.name]
            case p.RepeatedImage():
                raise AssertionError("a repeated image is not part of another expression")
            case p.Filtered() | p.Shifted():
                taps, inner = merged(node, self.weights)
                return self.filtered(self.value(inner), taps)
            case p.Sum():
                return self.sum(node)
            case p.Absolute():
                return self.absolute(self.value(node.value))
            case p.Chosen():
                return self.chosen(node)
            case p.Agreement():
                return self.counted(split(node)[0])
            case p.Larger():
                first, second = node.first, node.second
                if len([*p.subexpressions(second)]) > len([*p.subexpressions(first)]):
                    first, second = second, first  # the one that needs more registers
                return self.larger(self.value(first), self.value(second))
            case p.Uniform():
                return self._level(Fraction(1), node.param)
            case p.Largest():
                return self.largest(self.value(node.value), list(self.weights[node.kernel].taps))

    def filtered(self, value: Held, weights: Weights) -> Held:
        """Emit the convolution of a value with `weights` by offset, and return the register that
        holds it.

        The value has then been read, so that its register may become free. The first program of
        `synthesis` for which there are enough registers is used. The weights {(0, 0): 1} and {(0,
        0): -1} need no words; without weights, the result is 0. Raises PictureRefused if no program
        fits, if values exceed the range of registers, or if weights are finer than 2^-40."""
        # Some kernels need no word: the identity, no weights at all, and a change of sign.
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
        except ValueError:  # weights are multiples of 1 / UNIT = 2^-40
            raise PictureRefused("halvings", self.now, needed=41, available=40) from None
        low, high = value.scaled(*gains(taps))
        # The error of the input adds up over the squared weights, and the words add errors of
        # their own.
        squares = sum(float(weight) ** 2 for weight in weights.values())
        refused: PictureRefused | None = None
        for program, sign in programs:
            state = self.state()
            try:
                register = self.run_program(program, value)
            except PictureRefused as error:
                refused = refused or error
                self.restore(state)
                continue
            variance = value.variance * squares + noise_gain(program) ** 2
            return Held(register, value.sign * sign, low, high, variance=variance)
        if self.contents:  # retry without values kept for reuse
            self.contents = {}
            return self.filtered(value, weights)
        assert refused is not None
        raise refused

    def _programs(self, taps: Taps, value: Held) -> list[tuple[Program, int]]:
        """Return programs (program, sign) for a convolution kernel whose values fit the range of
        registers, best first.

        `taps` are the weights by offset, in units of 1 / UNIT; `value` is what the programs read.
        The sign of a program is -1 if it computes the negative. Programs are sorted by the words
        that remain after reuse of values in registers, then by their largest value; equally good
        first programs by noise. Raises PictureRefused ("range") if no program fits."""
        least, ranked = float("inf"), []
        for sign in (1, -1):
            for candidate in self.synthesis.variants(added((sign, taps))):
                # The largest result of a word, as a multiple of the registers' range.
                over = 0.0
                for up, down in candidate.weights:
                    ends = value.scaled(Fraction(up, UNIT), Fraction(down, UNIT))
                    low, high = ends if value.sign > 0 else (-ends[1], -ends[0])
                    target = self.target
                    over = max(over, high / target.register_max_e, low / target.register_min_e)
                least = min(least, over)
                if over <= 1 + 1e-9:  # up to rounding
                    left = self.reuse_of(candidate.program, value)
                    # The readout takes a positive value: one more word for a negative one.
                    inverted = self.is_output and value.sign * sign < 0
                    words = len(left.words) + inverted
                    ranked.append((words, candidate.peak, candidate.program, sign))
        if not ranked:
            raise PictureRefused("range", self.now, least, available=1.0)
        ranked.sort(key=lambda entry: entry[:2])  # by words, then by largest value
        # Only the equally good first ones are sorted by noise, which takes time to compute.
        best = [entry for entry in ranked if entry[:2] == ranked[0][:2]]
        best.sort(key=lambda entry: noise_gain(entry[2]))
        ranked[: len(best)] = best
        return [(program, sign) for *_, program, sign in ranked]

    def sum(self, node: p.Sum) -> Held:
        """Emit the words of a sum of images and return the register of the result.

        Terms that are counts (calls of `agree`) are counted together, and the other terms are added
        to the count. If all terms are kernels of one image, the sum is one convolution, or is added
        term by term if that needs fewer words. Raises PictureRefused if the words do not fit the
        chip."""
        agreements, others = split(node)
        if agreements.terms:
            count = self.counted(agreements)
            if not others:
                return count
            return self.added([(1, count), (1, self.value(p.Sum(tuple(others))))])
        if any(isinstance(value, p.Uniform) for _, value in node.terms):
            return self._with_level(node)
        taps, inner = merged(node, self.weights)
        if inner is not node:
            ways = (
                lambda: self._merged_sum(node, inner, taps),
                lambda: self._term_by_term(node),
            )
            return self.do_shortest(ways, (1, 1))
        return self._term_by_term(node)

    def _merged_sum(self, node: p.Sum, inner: p.Value, taps: Weights) -> Held:
        """Emit a sum as one convolution of `inner` with `taps`, and return the register of the
        result.

        What the sum reads several times is then read once, so that its register becomes free.
        Words of programs before version 4 stay as they are. Raises PictureRefused if the words do
        not fit the chip."""
        if self.saves_words:
            fewer = Counter(names_read(node)) - Counter(names_read(inner))
            for name, count in fewer.items():
                (self.uses if name in self.uses else self.bits.uses)[name] -= count
        return self.filtered(self.value(inner), taps)

    def _term_by_term(self, node: p.Sum) -> Held:
        """Emit the words of a sum, term after term, and return the register of the result; it is 0
        without terms.

        Raises PictureRefused if the words do not fit the chip."""
        if not node.terms:
            return self._nothing()
        common = abs(node.terms[0][0])
        # A factor that all terms have is applied once, to their sum.
        if common != 1 and all(abs(factor) == common for factor, _ in node.terms):
            plain = p.Sum(tuple((factor / common, value) for factor, value in node.terms))
            state = self.state()
            try:
                return self.filtered(self.value(plain), {(0, 0): common})
            except PictureRefused as refused:
                if refused.kind != "range":
                    raise
                self.restore(state)  # the sum of whole terms may be beyond the range
        return self.weighted_sum((factor, self.value(value)) for factor, value in node.terms)

    def _with_level(self, node: p.Sum) -> Held:
        """Emit the words of a sum that contains levels (values equal in all pixels), and return the
        register of the result.

        The words that add the other terms also add up to two levels with integer factors, by IN
        (the level sent to all pixels). Further levels are values of their own."""
        uniform = [(f, term) for f, term in node.terms if isinstance(term, p.Uniform)]
        other = tuple(term for term in node.terms if not isinstance(term[1], p.Uniform))
        terms = [(1, self.value(p.Sum(other)))] if other else []
        levels: list[tuple[int, str]] = []
        for factor, level in uniform:
            if factor.denominator == 1 and len(levels) < 2:
                levels.append((int(factor), level.param))
            else:
                terms.append((1, self._level(factor, level.param)))
        return self.added(terms, levels) if levels or len(terms) > 1 else terms[0][1]

    def _level(self, factor: Fraction, param: str) -> Held:
        """Emit a value that is equal in all pixels, and return its register.

        It is `factor` times one step of IN (the level sent to all pixels) or, if `param` is not "",
        `factor` times this parameter of the host. Raises PictureRefused if it leaves the range of
        IN."""
        whole = self.added([], [(factor.numerator, param)])
        return self.filtered(whole, {(0, 0): Fraction(1, factor.denominator)})

    def _nothing(self) -> Held:
        """Emit a word that writes 0 in all pixels and return its register; raise PictureRefused if
        none is free."""
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register]))
        return Held(register, sign=1, low=0.0, high=0.0)

    def added(
        self, signed_terms: list[tuple[int, Held]], levels: Sequence[tuple[int, str]] = ()
    ) -> Held:
        """Emit the sum of values, each with its sign 1 or -1, and return the register of the
        result.

        `levels` are up to two terms (factor, parameter): multiples of that parameter of the host
        or, if its name is "", of a step of IN (the level sent to all pixels). One word suffices, or
        two if some registers hold their term and others its negative, or if there are two levels.
        Sums of more sources than a word has are added in parts. The values have then been read.
        Without terms, the result is 0. Raises PictureRefused if the sum exceeds the range of
        registers or of IN, no register is free, or before version 4, if one word has too few
        sources."""
        low = sum(v.low if sign > 0 else -v.high for sign, v in signed_terms)
        high = sum(v.high if sign > 0 else -v.low for sign, v in signed_terms)
        for level in levels:
            least, most = self.steps_range(*level)
            low, high = low + least, high + most
        self.checked(low, high)
        # Registers that hold their term, and registers that hold its negative.
        plus = [v for sign, v in signed_terms if sign * v.sign > 0]
        minus = [v for sign, v in signed_terms if sign * v.sign < 0]
        # One word inverts the smaller group of values. A word adds at most four sources.
        total, inverted = (1, minus) if len(plus) >= len(minus) else (-1, plus)
        direct = plus if total > 0 else minus
        signs = (total, -total)  # of the levels in the last word and in the first word
        steps: list[Level] = [
            (param, sign * factor) if param else sign * factor
            for sign, (factor, param) in zip(signs[: len(levels)], levels, strict=True)
        ]
        steps += [None] * (2 - len(steps))
        read = [v.register for v in inverted] + ["IN"] * (steps[1] is not None)
        sources = [*(v.register for v in direct), *(["NEWS"] if read else [])]
        sources += ["IN"] * (steps[0] is not None)
        if len(sources) > 4 or len(read) > 4:
            if not self.saves_words:  # other sums of programs before version 4 keep their words
                raise PictureRefused("registers", self.now, len(signed_terms), available=4)
            part = [(sign, v) for sign, v in signed_terms if sign * v.sign == total][:3]
            others = [term for term in signed_terms if term not in part]
            return self.added([(1, self.added(part)), *others], levels)
        if read:
            self.everywhere()
            self.word(op("bus", ["NEWS"], read), steps[1])
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register], sources), steps[0])
        self.give(*(v for _, v in signed_terms))
        # Each word adds a variance of 1. The last word inverts, hence the sign -total.
        variance = sum(v.variance for _, v in signed_terms) + 1 + bool(inverted)
        return Held(register, sign=-total, low=low, high=high, variance=variance)


def merged(node: p.Value, kernels: Mapping[str, p.Weights]) -> tuple[Weights, p.Value]:
    """Return nested convolution kernels, shifts and factors as one kernel, and the image that it
    applies to.

    The kernel has the nonzero weights by offset. For any other image, also for a sum of different
    images, the kernel is {(0, 0): 1} and the image is `node`. `kernels` has the convolution kernels
    by name."""
    if isinstance(node, p.Filtered):
        taps, inner = merged(node.value, kernels)
        outer = kernels[node.kernel].taps.items()
        return added(*((weight, moved(taps, x, y)) for (x, y), weight in outer)), inner
    if isinstance(node, p.Shifted):
        taps, inner = merged(node.value, kernels)
        return moved(taps, node.right, node.down), inner
    if isinstance(node, p.Sum):
        terms = [(factor, *merged(term, kernels)) for factor, term in node.terms]
        if terms and all(inner == terms[0][2] for _, _, inner in terms):
            return added(*((factor, taps) for factor, taps, _ in terms)), terms[0][2]
    return {(0, 0): Fraction(1)}, node
