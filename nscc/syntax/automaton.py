"""Runs the grammar's LALR automaton over the tokens of one statement."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any, Protocol

from nscc.source import Span
from nscc.syntax.lexer import Tokens
from nscc.syntax.tables import END, GATHER, HAND_ON, Rule, tables

MOST_DEPTH = 200
"""Levels of nodes and brackets in a statement. Later passes recurse over the tree: with Python's
usual limit of a thousand calls each may take four a level."""


class TooDeep(Exception):
    """A statement is nested more than MOST_DEPTH deep; `token` is the last one read."""

    def __init__(self, token: int) -> None:
        super().__init__(f"token {token}")
        self.token = token


class Build(Protocol):
    """Makes the value of a rule from its kept parts; a part that is an int is a token's index."""

    def __call__(self, action: str, span: Span, parts: list[Any]) -> Any: ...


@dataclass(frozen=True)
class Stuck:
    """Where a statement stopped making sense: no statement goes on with this token.

    `token` is its index, one past the statement's last where that ends too soon; `before` are the
    kinds of the statement's tokens before it.
    """

    token: int
    before: tuple[str, ...]

    @cached_property
    def expected(self) -> frozenset[str]:
        """The terminals that could stand there instead (END: the statement could be over).

        They are found from `before` alone: a token taken in vain may already have reduced what
        stands before it, and then less seems possible than is.
        """
        states = [0]
        for kind in self.before:
            _take(states, kind)
        possible = tables().actions[states[-1]]
        return frozenset(kind for kind in possible if _take(states[:], kind))


def run(tokens: Tokens, first: int, last: int, build: Build) -> tuple[Any, Stuck | None]:
    """The value of the statement that is the tokens `first` up to but not including `last`.

    Where the tokens are no statement, says where they stop being one; the value is then that of
    the part before if it is a whole statement, else None. Raises TooDeep, and what `build` raises.
    """
    machine = _Machine(tokens, build)
    for index in range(first, last + 1):
        if not machine.feed(tokens.kinds[index] if index < last else END, index):
            whole = index < last and machine.feed(END, index)
            stuck = Stuck(index, tuple(tokens.kinds[first:index]))
            return machine.values[0] if whole else None, stuck
    return machine.values[0], None


def _take(states: list[int], kind: str) -> bool:
    """Takes a token without building anything, or reports False where none of that kind may
    follow."""
    language = tables()
    while True:
        step = language.actions[states[-1]].get(kind)
        if step is None:
            return False
        if step >= 0:
            states.append(step)
            return True
        rule = language.rules[-1 - step]
        if rule.size:
            del states[-rule.size :]
        states.append(language.gotos[states[-1]][rule.left])
        if kind == END and states == [0, language.end]:
            return True


class _Machine:
    """The stack: the state, value, first character and depth of every symbol on it."""

    def __init__(self, tokens: Tokens, build: Build) -> None:
        self.language = tables()
        self.tokens = tokens
        self.build = build
        self.states = [0]
        self.values: list[Any] = []
        self.begins: list[int] = []
        self.depths: list[int] = []

    def feed(self, kind: str, index: int) -> bool:
        """Takes a token, or reports False where none of that kind may follow.

        END is taken where the statement is whole, and leaves its value alone on the stack.
        """
        _, _, rules, actions, gotos, end = self.language
        states = self.states
        while True:
            state = states[-1]
            step = actions[state].get(kind)
            if step is None:
                return False
            if step >= 0:
                states.append(step)
                self.values.append(index)
                self.begins.append(self.tokens.starts[index])
                self.depths.append(0)
                return True
            rule = rules[-1 - step]
            if rule.size == 1:
                below = states[-2]
                if rule.action != HAND_ON:
                    self._make_leaf(rule, index)
                    state = gotos[below][rule.left]
                states[-1] = _climb(below, state, kind)
                continue
            self._reduce(rule, index)
            states.append(gotos[states[-1]][rule.left])
            if kind == END and states == [0, end]:
                return True

    def _make_leaf(self, rule: Rule, index: int) -> None:
        """Replaces the token on top by the node of it."""
        span = Span(self.begins[-1], self.tokens.ends[index - 1])
        self.values[-1] = self.build(rule.action, span, self.values[-1:] if rule.kept else [])

    def _reduce(self, rule: Rule, index: int) -> None:
        """Replaces the symbols of a rule by what they make; `index` is the token that follows."""
        values = self.values
        base = len(values) - rule.size
        end = self.tokens.ends[index - 1]
        begin = self.begins[base] if rule.size else end
        depth = max(self.depths[base:], default=0)
        parts = [values[base + place] for place in rule.kept]
        value: Any
        if rule.action == GATHER:
            value = parts
            if type(parts[0]) is list:
                value = parts[0]
                value += parts[1:]
        elif rule.action == HAND_ON:
            value = parts[0]
            depth += 1
        else:
            value = self.build(rule.action, Span(begin, end), _flat(parts))
            depth += 1
        if depth > MOST_DEPTH:
            raise TooDeep(index - 1)
        if rule.size:
            del values[base:], self.begins[base:], self.depths[base:], self.states[base + 1 :]
        values.append(value)
        self.begins.append(begin)
        self.depths.append(depth)


def _flat(parts: list[Any]) -> list[Any]:
    if list not in map(type, parts):
        return parts
    flat: list[Any] = []
    for part in parts:
        if type(part) is list:
            flat += part
        else:
            flat.append(part)
    return flat


@cache
def _climb(below: int, state: int, kind: str) -> int:
    """The state after all reductions in a row that only hand on the one symbol above `below`.

    An operand climbs ten levels of precedence; the way up depends on two states and a terminal
    only, so it is walked once.
    """
    language = tables()
    while True:
        step = language.actions[state].get(kind, 0)
        rule = language.rules[-1 - step] if step < 0 else None
        if rule is None or rule.action != HAND_ON or rule.size != 1:
            return state
        state = language.gotos[below][rule.left]
