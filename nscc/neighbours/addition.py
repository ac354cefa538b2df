"""Programs that add one neighbour after another, for any kernel.

The input is halved as often as the weights need, so that they are integers, and multiples of it are
computed. Each word then adds a multiple, seen from another pixel, to minus the sum so far. NEWS
holds a multiple while several neighbours read it. A beam search orders the neighbours so that few
words write NEWS, and few multiples are needed: signs alternate from word to word.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import combinations

from nscc.neighbours.programs import OF_STEP, UNIT, BusWord, Offset, Program, Taps
from nscc.operations import STEPS

BEAM = 60
"""Unfinished orders that are kept, of each number of words."""
_MOST_PROGRAMS = 12
_MOST_SOURCES = 4
_OPPOSITE = {name: OF_STEP[-x, -y] for name, (x, y) in STEPS.items()}
_WRITES: dict[Offset, str] = {(0, 0): "NEWS"} | {
    step: _OPPOSITE[name] for name, step in STEPS.items()
}
"""What a word writes so that NEWS holds what the pixel at an offset had."""

Content = tuple[int, Offset, Offset]
"""What NEWS holds minus of: a multiple, moved by an offset, and by one step more."""


@dataclass(frozen=True)
class Added:
    """A word that adds: `content` is what NEWS then holds, None where it adds no neighbour; `step`
    the neighbour whose NEWS it reads; `centre` the multiple of the pixel itself, 0 for none."""

    content: Content | None
    step: Offset
    centre: int


def halvings_of(taps: Taps) -> int:
    """How often a kernel of whole weights is halved to give this one."""
    lowest = min((weight & -weight).bit_length() for weight in taps.values())
    return max(0, UNIT.bit_length() - lowest)


def additions(taps: Taps, news_keeps: bool = True, beam: int = BEAM) -> list[Program]:
    """Programs that add the neighbours of a kernel, the ones of the fewest words first.

    With `news_keeps` NEWS keeps its value when neighbours read it; otherwise each word that reads
    it follows one that writes it.
    """
    halvings = halvings_of(taps)
    weights = {at: weight * (-2) ** halvings // UNIT for at, weight in taps.items()}
    orders = _orders(weights, halvings, news_keeps, beam)
    programs = [_program(order, halvings, news_keeps) for order in orders]
    return sorted(programs, key=len)


# --- orders ---------------------------------------------------------------------------------------

_Node = tuple[int, frozenset[Offset], Content | None, frozenset[tuple[int, Offset]], int]
"""An estimate of words, the places that are left, what NEWS holds, the multiples that are read, and
how many words follow."""


def _orders(
    weights: dict[Offset, int], halvings: int, news_keeps: bool, width: int
) -> list[list[Added]]:
    """Orders in which neighbours are added, found from the last word to the first."""
    ready = frozenset(((-2) ** number, (0, 0)) for number in range(halvings + 1))
    beam: dict[_Node, list[Added]] = {(0, frozenset(weights), None, ready, 0): []}
    finished: dict[frozenset[tuple[int, Offset]], tuple[int, list[Added]]] = {}
    while beam:
        following: dict[tuple[object, ...], tuple[_Node, list[Added]]] = {}
        for node, words in beam.items():
            for reached, word in _predecessors(node, weights, news_keeps):
                cost, left, _, used, _ = reached
                if not left:
                    if cost < finished.get(used, (cost + 1, []))[0]:
                        finished[used] = cost, [word, *words]
                elif cost < following.get(reached[1:], ((cost + 1,), []))[0][0]:
                    following[reached[1:]] = reached, [word, *words]
        ranked = sorted(following.values(), key=lambda each: _rank(each[0]))
        beam = dict(ranked[:width])
    best = sorted(finished.items(), key=lambda each: (each[1][0], sorted(each[0])))
    return [words for _, (_, words) in best[:_MOST_PROGRAMS]]


def _rank(node: _Node) -> tuple[object, ...]:
    cost, left, content, used, _ = node
    return cost + len(left), sorted(left), content or (), sorted(used)


def _predecessors(
    node: _Node, weights: dict[Offset, int], news_keeps: bool
) -> list[tuple[_Node, Added]]:
    """The words that may come before those of a node."""
    cost, left, content, used, follow = node
    sign = -1 if follow % 2 else 1
    found = []
    centre = -sign * weights[0, 0] if (0, 0) in left else 0

    def add(places: frozenset[Offset], words: int, word: Added) -> None:
        multiples = {(word.centre, (0, 0))} if word.centre else set()
        if word.content is not None:
            multiples.add(word.content[:2])
        new = sum(1 if at == (0, 0) else 3 for _, at in multiples - used)
        kept = content if word.content is None else word.content
        reached = (cost + words + new, left - places, kept, used | multiples, follow + 1)
        found.append((reached, word))

    if centre:
        add(frozenset({(0, 0)}), 1, Added(None, (0, 0), centre))
    for place in sorted(left - {(0, 0)}):
        base = _base(place)
        x, y = place[0] - base[0], place[1] - base[1]
        for written in _WRITES:
            step = x - written[0], y - written[1]
            if step != (0, 0) and step not in OF_STEP:
                continue
            reads: Content = (sign * weights[place], base, written)
            words = 1 + (reads != content or not news_keeps)
            add(frozenset({place}), words, Added(reads, step, 0))
            if centre and (step == (0, 0) or len(left) == 2):
                add(frozenset({place, (0, 0)}), words, Added(reads, step, centre))
    return found


@cache
def _base(place: Offset) -> Offset:
    """How far a multiple is moved first, so that two steps remain."""
    steps = _steps(place)
    moved = steps[: 2 * max(0, (len(steps) - 1) // 2)]
    return sum(x for x, _ in moved), sum(y for _, y in moved)


def _steps(place: Offset) -> list[Offset]:
    x, y = place
    return [(1 if x > 0 else -1, 0)] * abs(x) + [(0, 1 if y > 0 else -1)] * abs(y)


# --- words ----------------------------------------------------------------------------------------


def _program(order: Sequence[Added], halvings: int, news_keeps: bool) -> Program:
    """The words of an order."""
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
    """Integer multiples of the halved input, computed when they are first asked for; `used_news`
    tells whether that wrote NEWS."""

    def __init__(self, halvings: int, words: list[BusWord]) -> None:
        self.words, self.used_news = words, False
        self.held = {
            (-2) ** (halvings - number): f"h{number}" if number else "x"
            for number in range(halvings, -1, -1)
        }
        self.places: dict[tuple[int, Offset], str] = {}

    def of(self, factor: int) -> str:
        """The register that holds so many times the halved input."""
        if factor not in self.held:
            self._emit(factor)
        return self.held[factor]

    def _emit(self, factor: int) -> None:
        name, held = f"m{factor}", self.held
        for count in range(1, _MOST_SOURCES):
            for terms in combinations(held, count):
                if sum(terms) == -factor:
                    self.words.append(BusWord((name,), tuple(held[term] for term in terms)))
                    held[factor] = name
                    return
        half = (1 if factor > 0 else -1) << (abs(factor).bit_length() - 1)
        half = half // 2 if half == factor else half
        first, remainder = self.of(-half), factor - half
        if remainder == half:
            self.words.append(BusWord(("NEWS",), (self.of(half),)))
            self.used_news = True
            sources = (first, "NEWS")
        else:
            sources = (first, self.of(-remainder))
        self.words.append(BusWord((name,), sources))
        held[factor] = name

    def moved(self, factor: int, base: Offset) -> str:
        """The register that holds a multiple of the pixel at an offset."""
        register = self.of(factor)
        steps = [OF_STEP[step] for step in _steps(base)]
        for number in range(0, len(steps), 2):
            first, second = steps[number : number + 2]
            name = f"{register}{first}{second}"
            if name not in self.places.values():
                self.words.append(BusWord((_OPPOSITE[first],), (register,)))
                self.words.append(BusWord((name,), (second,)))
                self.used_news = True
                self.places[factor, base] = name
            register = name
        return register
