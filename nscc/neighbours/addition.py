"""Programs that add one neighbour after another, for any kernel.

First, words halve the input until all weights are integers, and compute multiples of the halved
input. Each following word adds the multiple of one neighbour and inverts the sum, so the signs of
the weights alternate from word to word. NEWS holds a multiple while several neighbours read it. A
beam search orders the neighbours so that few words write NEWS and few multiples are needed."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import combinations

from nscc.neighbours.programs import OF_STEP, UNIT, BusWord, Offset, Program, Taps
from nscc.neighbours.table import WordForms
from nscc.operations import STEPS
from nscc.record import Record

BEAM = 60
"""Number of unfinished orders that the beam search keeps after each word."""
_MOST_PROGRAMS = 12
"""Most programs returned for a convolution kernel."""
_MOST_SOURCES = 4
"""A word that forms a multiple of the input has fewer sources than this."""
_OPPOSITE = {name: OF_STEP[-x, -y] for name, (x, y) in STEPS.items()}
_WRITES: dict[Offset, str] = {(0, 0): "NEWS"} | {
    step: _OPPOSITE[name] for name, step in STEPS.items()
}
"""Destination that moves the value of the pixel at an offset into NEWS, by offset."""

Content = tuple[int, Offset, Offset]
"""Content of NEWS up to the sign: a multiple, shifted by an offset and by one further step."""


class Added(Record):
    """A word that adds the multiple of a neighbour, of the pixel itself, or of both to a sum.

    `content` is what NEWS (the register that neighbours can read) holds when the word runs: a
    multiple of the halved input, the offset of its pixel, and a further step. It is None if the
    word adds no neighbour. `step` is the offset of the pixel whose NEWS it reads, (0, 0) for its
    own. `centre` is the multiple of the pixel itself, or 0."""

    content: Content | None
    step: Offset
    centre: int


def halvings_of(taps: Taps) -> int:
    """Return how often the input must be halved so that all weights of a convolution kernel become
    integers; 0 if they are integers.

    `taps` are the weights by offset, in units of 1 / UNIT, without zeros; there must be at least
    one."""
    lowest = min((weight & -weight).bit_length() for weight in taps.values())
    return max(0, UNIT.bit_length() - lowest)


def additions(taps: Taps, forms: WordForms, beam: int = BEAM) -> list[Program]:
    """Return programs that add the neighbours of a convolution kernel one by one, the shortest
    first.

    There is at least one program, and at most `_MOST_PROGRAMS`. `taps` are the nonzero weights by
    offset, in units of 1 / UNIT, at least one. `forms` are the words that the chip allows. `beam`
    is the number of partial orders that the search keeps. If NEWS (the register that neighbours can
    read) does not keep its value, each word that reads NEWS follows a word that writes NEWS."""
    halvings = halvings_of(taps)
    # A halving word also inverts: the input is (-2)^halvings times the halved input.
    weights = {at: weight * (-2) ** halvings // UNIT for at, weight in taps.items()}
    orders = _orders(weights, halvings, forms, beam)
    programs = [forms.allowed(_program(order, halvings, forms.news_keeps)) for order in orders]
    return sorted(programs, key=len)


# --- orders ---------------------------------------------------------------------------------------

_Node = tuple[int, frozenset[Offset], Content | None, frozenset[tuple[int, Offset]], int]
"""The estimated number of words, the places not yet added, the content of NEWS, the multiples that
are read, and the number of words that follow."""


def _orders(
    weights: dict[Offset, int], halvings: int, forms: WordForms, width: int
) -> list[list[Added]]:
    """Return orders in which words add the neighbours of a convolution kernel, best first, at most
    `_MOST_PROGRAMS`.

    `weights` are nonzero integers by offset, as multiples of the input after `halvings` halvings.
    The search runs from the last word to the first, and keeps at most `width` partial orders after
    each word. Each order uses another set of multiples of the input."""
    ready = frozenset(((-2) ** number, (0, 0)) for number in range(halvings + 1))
    beam: dict[_Node, list[Added]] = {(0, frozenset(weights), None, ready, 0): []}
    finished: dict[frozenset[tuple[int, Offset]], tuple[int, list[Added]]] = {}
    # `beam` holds the best orders with as many words so far; `finished` the best complete order for
    # each set of multiples that it uses.
    while beam:
        following: dict[tuple[object, ...], tuple[_Node, list[Added]]] = {}
        for node, words in beam.items():
            for reached, word in _predecessors(node, weights, forms):
                cost, left, _, used, _ = reached
                if not left:
                    # Without an entry, any cost is lower.
                    if cost < finished.get(used, (cost + 1, []))[0]:
                        finished[used] = cost, [word, *words]
                elif cost < following.get(reached[1:], ((cost + 1,), []))[0][0]:
                    following[reached[1:]] = reached, [word, *words]
        ranked = sorted(following.values(), key=lambda each: _rank(each[0]))
        beam = dict(ranked[:width])
    best = sorted(finished.items(), key=lambda each: (each[1][0], sorted(each[0])))
    return [words for _, (_, words) in best[:_MOST_PROGRAMS]]


def _rank(node: _Node) -> tuple[object, ...]:
    """Return the key that sorts unfinished orders: fewest words first, where each
    neighbour that is left counts as one word.

    Ties are broken by the other members of the node, so that the search is deterministic."""
    cost, left, content, used, _ = node
    return cost + len(left), sorted(left), content or (), sorted(used)


def _predecessors(
    node: _Node, weights: dict[Offset, int], forms: WordForms
) -> list[tuple[_Node, Added]]:
    """Return all ways to put one more word before the words of an unfinished order, each as the new
    order and the word.

    `node` describes the unfinished order: its cost, the neighbours left, the content of NEWS (the
    register that neighbours can read), the multiples used, and the number of words. `weights` are
    the integer weights by offset. `forms` are the words that the chip allows."""
    cost, left, content, used, follow = node
    # Every word inverts the sum so far, so the sign of a weight depends on how many words follow.
    sign = -1 if follow % 2 else 1
    found = []
    # A neighbour's value is inverted once more, by the word that writes NEWS; the centre is not.
    centre = -sign * weights[0, 0] if (0, 0) in left else 0

    def add(offsets: frozenset[Offset], words: int, word: Added) -> None:
        """Record the order that has `word` in front.

        `offsets` are the pixels whose values the word adds. `words` is 1, or 2 if a word that
        writes NEWS comes before it. New multiples of the input cost further words."""
        multiples = {(word.centre, (0, 0))} if word.centre else set()
        if word.content is not None:
            multiples.add(word.content[:2])
        # One word computes a multiple, and two more copy it to another pixel.
        new = sum(1 if at == (0, 0) else 3 for _, at in multiples - used)
        kept = content if word.content is None else word.content
        reached = (cost + words + new, left - offsets, kept, used | multiples, follow + 1)
        found.append((reached, word))

    if centre:
        add(frozenset({(0, 0)}), 1, Added(content=None, step=(0, 0), centre=centre))
    for offset in sorted(left - {(0, 0)}):
        base = _base(offset)
        x, y = offset[0] - base[0], offset[1] - base[1]
        for written in _WRITES:
            step = x - written[0], y - written[1]
            if step != (0, 0) and step not in OF_STEP:
                continue  # further than one pixel from where NEWS has the value
            reads: Content = (sign * weights[offset], base, written)
            # A word that writes NEWS comes first, unless NEWS holds the value already.
            words = 1 + (reads != content or not forms.news_keeps)
            add(frozenset({offset}), words, Added(reads, step, centre=0))
            # Sources: the neighbour, the centre and, unless nothing else is left, the sum so far.
            # Only words that read a neighbour directly may be limited to two.
            if centre and (step == (0, 0) or len(left) == 2 or forms.sources > 2):
                add(frozenset({offset, (0, 0)}), words, Added(reads, step, centre))
    return found


@cache
def _base(offset: Offset) -> Offset:
    """Return the offset to which a multiple is copied first, one or two steps before `offset` on
    the path from (0, 0); (0, 0) if that is near enough.

    Copies move by two pixels, so the path is cut after an even number of steps. The words that
    write and read NEWS make the steps that are left."""
    steps = _steps(offset)
    moved = steps[: 2 * max(0, (len(steps) - 1) // 2)]
    return sum(x for x, _ in moved), sum(y for _, y in moved)


def _steps(offset: Offset) -> list[Offset]:
    """Return the steps, each to a direct neighbour, that lead from (0, 0) to an offset: those along
    the row first; [] for (0, 0)."""
    x, y = offset
    return [(1 if x > 0 else -1, 0)] * abs(x) + [(0, 1 if y > 0 else -1)] * abs(y)


# --- words ----------------------------------------------------------------------------------------


def _program(order: Sequence[Added], halvings: int, news_keeps: bool) -> Program:
    """Return the words that halve the input `halvings` times and then add the neighbours in this
    order.

    The input is the register `x`, its halvings are `h1`, `h2` and so on, and the sums `s0`, `s1`
    and so on. `news_keeps` tells whether NEWS (the register that neighbours can read) keeps its
    content when it is read, so that it need not be written again."""
    words = [
        BusWord((f"h{number + 1}", "NEWS"), (f"h{number}" if number else "x",))
        for number in range(halvings)
    ]
    multiples = _Multiples(halvings, words)
    total: tuple[str, ...] = ()
    content: Content | None = None
    for number, added in enumerate(order):
        sources = total
        if added.centre:
            sources = (multiples.of(added.centre), *sources)
        if added.content is not None:
            factor, base, written = added.content
            register = multiples.moved(factor, base)
            if added.content != content or multiples.used_news or not news_keeps:
                words.append(BusWord((_WRITES[written],), (register,)))
            content, multiples.used_news = added.content, False
            sources = (OF_STEP.get(added.step, "NEWS"), *sources)
        total = (f"s{number}",)
        words.append(BusWord(total, sources))
    return tuple(words)


class _Multiples:
    """The registers of integer multiples of the halved input, which are computed when first
    requested.

    `held` has the registers by multiple, and `copies` those of other pixels' multiples by
    (multiple, offset). `used_news` tells whether a computation overwrote NEWS (the register that
    neighbours can read); the caller resets it."""

    def __init__(self, halvings: int, words: list[BusWord]) -> None:
        """Begin with the input and its halvings, each with the sign of the one before inverted.

        `words` is the program, to which the words of further multiples are appended."""
        self.words, self.used_news = words, False
        self.held = {
            (-2) ** (halvings - number): f"h{number}" if number else "x"
            for number in range(halvings, -1, -1)
        }
        self.copies: dict[tuple[int, Offset], str] = {}

    def of(self, factor: int) -> str:
        """Return the register that holds `factor` (a nonzero integer) times the halved input, of
        the pixel itself.

        Words that compute it are appended if no register holds it yet."""
        if factor not in self.held:
            self._emit(factor)
        return self.held[factor]

    def _emit(self, factor: int) -> None:
        """Append the words that compute `factor` times the halved input, and record the register,
        which is called `m` and the factor.

        One word adds fewer than `_MOST_SOURCES` known multiples, if they suffice. Otherwise the
        factor is divided into a power of two and the rest."""
        name, held = f"m{factor}", self.held
        for count in range(1, _MOST_SOURCES):
            for terms in combinations(held, count):
                if sum(terms) == -factor:
                    self.words.append(BusWord((name,), tuple(held[term] for term in terms)))
                    held[factor] = name
                    return
        # The largest power of two below the factor. A word inverts, so it reads the negatives.
        half = (1 if factor > 0 else -1) << (abs(factor).bit_length() - 1)
        # A power of two is divided into two equal parts.
        half = half // 2 if half == factor else half
        first, remainder = self.of(-half), factor - half
        if remainder == half:  # a word cannot read one register twice: NEWS has the copy
            self.words.append(BusWord(("NEWS",), (self.of(half),)))
            self.used_news = True
            sources = (first, "NEWS")
        else:
            sources = (first, self.of(-remainder))
        self.words.append(BusWord((name,), sources))
        held[factor] = name

    def moved(self, factor: int, base: Offset) -> str:
        """Return the register that holds `factor` times the halved input of the pixel at offset
        `base`.

        `base` is an even number of steps away. The multiple is copied two pixels at a time, by
        words that are appended; each copy overwrites NEWS. With `base` (0, 0), nothing is copied.
        """
        register = self.of(factor)
        steps = [OF_STEP[step] for step in _steps(base)]
        for number in range(0, len(steps), 2):
            # `_base` gives an even number of steps, so each copy has two.
            first, second = steps[number : number + 2]
            name = f"{register}{first}{second}"
            if name not in self.copies.values():
                self.words.append(BusWord((_OPPOSITE[first],), (register,)))
                self.words.append(BusWord((name,), (second,)))
                self.used_news = True
                self.copies[factor, base] = name
            register = name
        return register
