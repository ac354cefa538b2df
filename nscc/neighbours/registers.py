"""Assign registers while images are lowered: free registers, their contents, and last reads.

A value stays in its register until the last word that reads it. Registers that are free again keep
their contents for reuse until a word overwrites them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

from nscc.neighbours.bits import BitWords
from nscc.neighbours.count_words import CountEmitter
from nscc.neighbours.held import Held, Level, LoopWords, PictureRefused, Result
from nscc.neighbours.programs import Offset, Program, moved, values_of
from nscc.operations import NEIGHBOURS, STEPS, Op, op
from nscc.record import Record
from nscc.words import pictures as p
from nscc.words.container import Container
from nscc.words.encoding import matching

Contents = tuple[str, frozenset[tuple[Offset, int]]]
"""The name of a value, and the convolution kernel that was applied to the value."""


class Reuse(Record):
    """Which words of a program must run, because registers still hold results of earlier words.

    `words` are the indices of the words that must run, in order. `held` maps the program's names of
    registers to the registers that already hold their values. `contents` has, for each word of the
    program, what it writes, by the program's names."""

    words: tuple[int, ...]
    held: Mapping[str, str]
    contents: tuple[dict[str, Contents], ...]


def reuse(
    program: Program,
    base: str,
    contents: Mapping[str, Contents],
    free: Collection[str],
    news_keeps: bool,
) -> Reuse:
    """Return which words of a program must run on the value that is called `base`.

    `contents` is what registers hold: the name of a value and the kernel that was applied to it.
    The program's result is reused only from a `free` register, because the caller owns it. NEWS
    (the register that neighbours can read) is reused only with `news_keeps`. The program must not
    be empty."""
    written = []
    for word, taps in zip(program, values_of(program), strict=True):
        taps_of = {
            name: moved(taps, *(-step for step in STEPS[name])) if name in NEIGHBOURS else taps
            for name in word.destinations
        }
        written.append({name: (base, frozenset(at.items())) for name, at in taps_of.items()})
    where = {value: name for name, value in contents.items() if name != "NEWS"}
    where_free = {value: name for value, name in where.items() if name in free}
    # From the last word back: registers that later words read, and whether they read NEWS.
    needed, news = {program[-1].destinations[0]}, False
    numbers: list[int] = []
    held: dict[str, str] = {}
    last = len(program) - 1
    for number in reversed(range(len(program))):
        word, runs = program[number], False
        for name in word.destinations:
            if _is_news(name):
                runs = runs or news
            elif name in needed:
                # The last word's register becomes the caller's, so nobody else may own it.
                register = (where_free if number == last else where).get(written[number][name])
                if register is None or register in held.values():  # two sources of one word
                    runs = True
                else:
                    held[name] = register
        if runs:
            numbers.append(number)
            news = (news and not any(map(_is_news, word.destinations))) or any(
                map(_is_news, word.sources)
            )
            needed |= {name for name in word.sources if not _is_news(name)}
    runs_in_order = numbers[::-1]
    if news_keeps:  # leave out the words that would write to NEWS what NEWS already holds
        numbers, runs_in_order, holds = runs_in_order, [], contents.get("NEWS")
        for number in numbers:
            values = {v for name, v in written[number].items() if _is_news(name)}
            if len(program[number].destinations) == 1 and values == {holds}:
                continue
            runs_in_order.append(number)
            holds = next(iter(values), holds)
    return Reuse(tuple(runs_in_order), held, tuple(written))


def _is_news(name: str) -> bool:
    """Return whether an operand is NEWS (the register that neighbours can read), of the pixel
    itself or of a neighbour."""
    return name == "NEWS" or name in NEIGHBOURS


class RegisterEmitter(CountEmitter):
    """Emits words of images, and assigns the registers of their values.

    `free` are the free analog registers. `contents` is what analog registers hold, for reuse.
    `held` has the register of each value, and `uses` the number of its reads that are left, by
    name. `kept_ranges` are the (least, largest value) of kept images before a frame, in electrons.
    `loops` are the words of loops. `loop_registers` are the registers of planes that are repeated
    now. `propagating` is the register whose bits the chip can propagate, None if it or its mask has
    bits of codes."""

    def __init__(
        self,
        pictures: p.Pictures,
        container: Container,
        kept_ranges: Mapping[str, tuple[float, float]],
    ) -> None:
        """Find the registers that are free after the exposure, and count how often each value is
        read.

        Registers of the code are never free, nor the mask and the masked register, which changes
        only in pixels whose mask is 1. `kept_ranges` gives the (least, largest value) of each kept
        image before a frame, in electrons. Raises PictureRefused if there are too few registers for
        what is kept from frame to frame."""
        super().__init__(pictures)
        self.kept_ranges = kept_ranges
        self.loops: list[LoopWords] = []
        self.loop_registers: dict[str, str] = {}
        target = self.target = container.target
        buckets = {
            # A register with a negative gain holds minus the exposure.
            readout.bucket: (readout.register, 1 if readout.gain > 0 else -1)
            for readout in container.readouts
        }
        bucket_registers = {register for register, _ in buckets.values()}
        self.free = [name for name in target.analog_available if name not in bucket_registers]
        exposing = [matching(word, target.words) for k in container.kernels for word in k.words]
        written = {name for word in exposing if word is not None for name in word.destinations}
        self.contents: dict[str, Contents] = {}
        self.held = {
            name: Held(register, sign, low=0.0, high=pictures.limits_e[name], name=name)
            for name, (register, sign) in buckets.items()
        }
        guarded = (*container.code_registers, target.mask_register, target.masked_register)
        digital = [name for name in target.digital_registers if name not in guarded]
        pair = {target.mask_register, target.masked_register}
        self.propagating = None if pair & {*container.code_registers} else target.masked_register
        lasting = {*digital} - written
        # The mask guards nothing while no word writes the masked register. It is taken last, and
        # keeps no plane from frame to frame, because a flood overwrites it.
        if self.saves_words and self.propagating and target.mask_register:
            digital.append(target.mask_register)
        self.bits = BitWords(self, digital, lasting, target.or_sources)
        self.count_e = pictures.count_steps * target.electrons_per_step
        # How often each image and bucket is read; an output counts once more, so its register is
        # never freed.
        self.uses = dict.fromkeys((*self.held, *self.pictures.expressions), 0)
        for expression in self.pictures.expressions.values():
            for node in p.subexpressions(expression):
                if isinstance(node, p.Source):
                    self.uses[node.name] += 1
        for name in self.pictures.outputs:
            self.uses[name] = self.uses.get(name, 0) + 1
        # `give` takes back one use, and so frees the registers of unread buckets.
        for name, value in list(self.held.items()):
            self.uses[name] += 1
            self.give(value)
        self._keep_images([name for name in self.free if name not in written])

    def _keep_images(self, lasting: list[str]) -> None:
        """Give each kept image one of the registers `lasting`, which no word of the exposure
        writes.

        Raises PictureRefused if there are too few."""
        kept = self.pictures.kept_images
        for image in kept:
            if not lasting:
                raise PictureRefused("registers", image.name, len(kept), len(self.held))
            register = lasting.pop(0)
            self.free.remove(register)
            sign = -1 if image.name in self.pictures.negated else 1
            low, high = self.kept_ranges[image.name]
            self.held[image.name] = Held(register, sign, low=low, high=high, name=image.name)
            self.uses[image.name] += 1  # never freed

    def hand_over(self, name: str) -> bool:
        """Return whether the caller is the only remaining reader of the value `name`.

        If so, the value is forgotten, and its register belongs to the caller. Otherwise nothing
        changes."""
        if self.uses[name] != 1:
            return False
        self.uses[name] = 0
        del self.held[name]
        return True

    def take(self) -> str:
        """Return a free analog register, which is then occupied; raise PictureRefused if there is
        none.

        Registers whose contents may be reused are taken last, of these the one with the most
        weights first."""
        if not self.free:
            count = len(self.target.analog_available)
            raise PictureRefused("registers", self.now, count + 1, count)
        # Contents with the most weights are the least likely to be read again. Registers without
        # contents come first.
        sizes = {name: len(taps) for name, (_, taps) in self.contents.items()}
        register = min(self.free, key=lambda name: (name in sizes, -sizes.get(name, 0)))
        self.free.remove(register)
        return register

    def word(self, op: Op, level: Level = None) -> None:
        """Emit a word that needs `level` of IN (None if it does not read IN).

        What the registers that it writes held before is no longer reused. IN is the level sent to
        all pixels."""
        super().word(op, level)
        self.bits.forget(op.destinations)
        for name in op.destinations:
            self.contents.pop("NEWS" if name in NEIGHBOURS else name, None)

    def give(self, *values: Held) -> None:
        """Note that values have been read once, and free each register that no later word reads.

        A value without a name is read only once. A value without further reads is forgotten."""
        for value in values:
            if value.name is not None:
                self.uses[value.name] -= 1
                if self.uses[value.name]:
                    continue
                del self.held[value.name]
            self.free.append(value.register)
            self.free.sort(key=self.target.analog_available.index)

    def checked(self, low: float, high: float) -> None:
        """Raise PictureRefused ("range") if values from `low` to `high` electrons do not fit a
        register."""
        target, slack = self.target, 1 + 1e-9
        if high > target.register_max_e * slack or low < target.register_min_e * slack:
            over = max(high / target.register_max_e, low / target.register_min_e)
            raise PictureRefused("range", self.now, over, available=1.0)

    def negated(self, value: Held) -> Held:
        """Emit the word that inverts the sign in which a register holds a value; return the new
        register.

        `value` has then been read. The result has no name. Raises PictureRefused if no register is
        free."""
        self.everywhere()
        register = self.take()
        self.word(op("bus", [register], [value.register]))
        self.give(value)
        variance = value.variance + 1
        return Held(register, -value.sign, value.low, value.high, variance=variance)

    def positive(self, value: Held) -> Held:
        """Return the value in a register that holds it with its own sign.

        If it is held as its negative, a word inverts it, and `value` has then been read. Raises
        PictureRefused if no register is free for that."""
        return self.negated(value) if value.sign < 0 else value

    def reuse_of(self, program: Program, value: Held) -> Reuse:
        """Return which words of a program must run on `value`.

        A word need not run if a register still holds its result from an earlier program on the same
        value."""
        base = f"{value.name or self._written(value.register)} {value.sign}"
        return reuse(program, base, self.contents, self.free, self.target.news_read_keeps)

    def _written(self, register: str) -> str:
        """Return a name for the content of a register that is different after each word that writes
        it.

        It has the index of the last word that wrote the register, 0 if none did."""
        numbers = range(len(self.words) - 1, -1, -1)
        last = next((n for n in numbers if register in self.words[n][0].destinations), 0)
        return f"{register} of word {last}"

    def run_program(self, program: Program, value: Held) -> str:
        """Emit the words of a program for a convolution kernel on a value; return the register of
        its result.

        The program must not be empty. Words whose result is still in a register are left out. The
        value has then been read. Raises PictureRefused if registers run out; some words are then
        emitted, and the caller restores the state."""
        self.everywhere()
        left = self.reuse_of(program, value)
        # The last word that uses each of the program's registers.
        last: dict[str, int] = {}
        for number in left.words:
            for name in (*program[number].sources, *program[number].destinations):
                last[name] = number
        result = program[-1].destinations[0]
        register_of = {"x": value.register, **left.held}
        # Free registers whose contents the program reads must not be taken before that.
        reserved = {*left.held.values()} & {*self.free}
        self.free = [name for name in self.free if name not in reserved]
        if "x" not in last:
            self.give(value)
        for number in left.words:
            word, names = program[number], []
            for name in word.destinations:
                if name != "NEWS" and name not in NEIGHBOURS and name not in register_of:
                    register_of[name] = self.take()
                names.append(register_of.get(name, name))
            sources = [register_of.get(name, name) for name in word.sources]
            self.word(op("bus2" if word.halves else "bus", names, sources))
            for name, contents in left.contents[number].items():
                self.contents[register_of.get(name, "NEWS")] = contents
            for name, at in last.items():
                if at == number and name in register_of and name != result:
                    if name == "x":
                        self.give(value)
                    # A reused register that was not free still belongs to another value.
                    elif name not in left.held or register_of[name] in reserved:
                        self.give(replace(value, register=register_of[name], name=None))
        # Reserved registers that no word reads are free as before.
        unread = [register_of[name] for name in left.held if name not in last and name != result]
        self.free += [name for name in unread if name in reserved]
        return register_of[result]

    def do_shortest(self, ways: Sequence[Callable[[], Result]], shares: Sequence[int]) -> Result:
        """Emit the words of the one of `ways` with the fewest words per share, and return its
        result; of equals, the first.

        Each way is tried, undone, and the best one called again. `shares` says for each way how
        many images it computes. Raises the first PictureRefused if no way fits the registers."""
        best: tuple[float, int] | None = None
        refused: PictureRefused | None = None
        before = len(self.words)
        for number, (way, share) in enumerate(zip(ways, shares, strict=True)):
            state = self.state()
            try:
                way()
            except PictureRefused as error:
                refused = refused or error
            else:
                words = (len(self.words) - before) / share
                best = min(best or (words, number), (words, number))
            self.restore(state)
        if best is None:
            assert refused is not None
            raise refused
        return ways[best[1]]()

    def state(self) -> tuple[Any, ...]:
        """Return a copy of everything that emitting words changes, for `restore`, which takes it
        once to undo an attempt.

        `loops` and `loop_registers` are not part of it."""
        bits = self.bits
        return (
            len(self.words),
            self.free[:],
            dict(self.held),
            dict(self.uses),
            self.masked,
            dict(self.contents),
            bits.free[:],
            dict(bits.planes),
            dict(bits.uses),
            bits.steered,
            dict(bits.known),
            {name: terms[:] for name, terms in self.ready.items()},
            self.walks,
        )

    def restore(self, saved: tuple[Any, ...]) -> None:
        """Undo everything that was emitted since the call of `state` that returned `saved`.

        It serves once, because its lists and dicts are then in use."""
        bits = self.bits
        words, self.free, self.held, self.uses, self.masked, self.contents, *of_bits = saved
        del self.words[words:]
        bits.free, bits.planes, bits.uses, bits.steered, bits.known, *of_counting = of_bits
        self.ready, self.walks = of_counting
