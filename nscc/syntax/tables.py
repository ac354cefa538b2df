"""The parser's tables, as `nscc.syntax.generate` made them from the grammar."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import NamedTuple

END = "$END"
"""What the automaton sees after a statement's last token."""

HAND_ON = ""
GATHER = "+"


class Rule(NamedTuple):
    """A reduction: `size` symbols become one `left`.

    `action` names what to build from the symbols at the `kept` positions; HAND_ON hands on the one
    that is kept, GATHER adds them to a list.
    """

    left: str
    action: str
    size: int
    kept: tuple[int, ...]


class Tables(NamedTuple):
    """The words and the automaton of the language.

    `actions[s][terminal]` is the state after it, or -1 - r for a reduction by `rules[r]`;
    `gotos[s][left]` is the state after a reduction to `left`. State 0 is the start; in state `end`
    a whole statement has been read.
    """

    literals: frozenset[str]
    patterns: dict[str, str]
    rules: tuple[Rule, ...]
    actions: tuple[dict[str, int], ...]
    gotos: tuple[dict[str, int], ...]
    end: int


@cache
def tables() -> Tables:
    """The tables of the language."""
    with open(Path(__file__).with_name("tables.json"), encoding="utf-8") as file:
        data = json.load(file)
    return Tables(
        frozenset(data["literals"]),
        dict(data["patterns"]),
        tuple(Rule(left, action, size, tuple(kept)) for left, action, size, kept in data["rules"]),
        tuple(data["actions"]),
        tuple(data["gotos"]),
        data["end"],
    )
