"""The tokens of one statement through lark's LALR parser."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from lark import Token, Tree, UnexpectedToken
from lark.parsers.lalr_interactive_parser import InteractiveParser

from nscc.syntax.grammar import END, START, parser, spellings
from nscc.syntax.lexer import Tokens


@dataclass(frozen=True)
class Stuck:
    """Where a statement stopped making sense: no statement goes on with this token.

    `token` is its index, one past the statement's last where that ends too soon; `before` are the
    statement's tokens before it.
    """

    token: int
    before: tuple[Token, ...]

    @cached_property
    def expected(self) -> frozenset[str]:
        """The kinds that could stand there instead (END: the statement could be over).

        They are found from `before` alone: a token taken in vain may already have reduced what
        stands before it, and then less seems possible than is.
        """
        machine = _machine()
        for token in self.before:
            machine.feed_token(token)
        words = spellings()
        terminals = machine.accepts()  # type: ignore[no-untyped-call]
        return frozenset(words.get(terminal, terminal) for terminal in terminals)


def read(tokens: Tokens, first: int, last: int) -> tuple[Tree[Token] | None, Stuck | None]:
    """Lark's tree of the statement that is the tokens `first` up to but not including `last`.

    Where the tokens are no statement, says where they stop being one; the tree is then that of the
    part before if it is a whole statement, else None.
    """
    machine = _machine()
    stuck = None
    for index in range(first, last):
        try:
            machine.feed_token(tokens.found[index])
        except UnexpectedToken:
            stuck = Stuck(index, tuple(tokens.found[first:index]))
            break
    try:
        return machine.feed_token(Token(END, "")), stuck
    except UnexpectedToken:
        return None, stuck or Stuck(last, tuple(tokens.found[first:last]))


def _machine() -> InteractiveParser:
    return parser().parse_interactive(start=START)
