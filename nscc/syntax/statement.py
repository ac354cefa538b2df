"""Parsing of the tokens of one statement by lark's LALR parser."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from lark import Token, Tree, UnexpectedToken
from lark.parsers.lalr_interactive_parser import InteractiveParser

from nscc.syntax.grammar import END, START, parser, spellings
from nscc.syntax.lexer import Tokens


@dataclass(frozen=True)
class Stuck:
    """The token at which the parser stopped because no statement can continue with it.

    `token` is its index, one past the last token if the statement ends too early. `before` are the
    statement's tokens before it."""

    token: int
    before: tuple[Token, ...]

    @cached_property
    def expected(self) -> frozenset[str]:
        """The kinds of token that could follow instead; END if the statement could end.

        They are computed from `before`, because the failed token may already have reduced the
        parser's stack, after which fewer kinds appear possible."""
        machine = _machine()
        for token in self.before:
            machine.feed_token(token)
        words = spellings()
        terminals = machine.accepts()  # type: ignore[no-untyped-call]
        return frozenset(words.get(terminal, terminal) for terminal in terminals)


def read(tokens: Tokens, first: int, last: int) -> tuple[Tree[Token] | None, Stuck | None]:
    """Parse the tokens from `first` up to, but not including, `last` as one statement.

    Returns lark's tree and None. If parsing fails, returns a Stuck, with the tree of the tokens
    before it if they are a complete statement."""
    machine = _machine()
    stuck = None
    for index in range(first, last):
        try:
            machine.feed_token(tokens.lark_tokens[index])
        except UnexpectedToken:
            stuck = Stuck(index, tuple(tokens.lark_tokens[first:index]))
            break
    try:
        return machine.feed_token(Token(END, "")), stuck
    except UnexpectedToken:
        return None, stuck or Stuck(last, tuple(tokens.lark_tokens[first:last]))


def _machine() -> InteractiveParser:
    return parser().parse_interactive(start=START)
