"""The lexer, which converts text to tokens, and lark's LALR parser for the tokens of one statement.

Every character belongs to a token, so the lexer accepts any text."""

from __future__ import annotations

import re
from functools import cached_property

from lark import Token, Tree, UnexpectedToken
from lark.parsers.lalr_interactive_parser import InteractiveParser

from nscc.record import Record
from nscc.source import Source, Span
from nscc.syntax.words import END, START, names_in, parser, spellings, statement_words


class Tokens(Record):
    """The tokens of a text, without blanks and comments, as lark has them, and the kind of each at
    the same index.

    The kind of a token is its terminal in the grammar; the kind of a keyword or sign is its text.
    The kinds MALFORMED, UNCLOSED and STRAY are invalid in every statement."""

    source: Source
    lark_tokens: list[Token]
    kinds: list[str]

    @property
    def version(self) -> int:
        """The language version at the start of the text, 1 if there is none or an unknown one."""
        states_version = self.kinds[:2] == ["nsl", "INTEGER"]
        number = self.text(1).lstrip("0") if states_version else ""
        return int(number) if number in ("2", "3", "4") else 1

    def text(self, index: int) -> str:
        """Return the text of token number `index`, from 0, in the source."""
        span = self.span(index)
        return self.source.text[span.start : span.end]

    def span(self, index: int) -> Span:
        """Return the place of token number `index`, from 0."""
        return span_of(self.lark_tokens[index])

    def read_as(self, index: int, word: str) -> None:
        """Replace token number `index` by the keyword `word`, which was probably meant. The source
        text stays as it is."""
        terminal = next(name for name, spelt in spellings().items() if spelt == word)
        self.lark_tokens[index] = self.lark_tokens[index].update(type=terminal)
        self.kinds[index] = word


def span_of(token: Token) -> Span:
    """Return the place of a token of the lexer."""
    assert token.start_pos is not None
    assert token.end_pos is not None
    return Span(token.start_pos, token.end_pos)


def lex(source: Source) -> Tokens:
    """Return all tokens of a text, in order; every character but blanks and comments belongs to
    one.

    Invalid text gives tokens of the kinds MALFORMED, UNCLOSED and STRAY; nothing is raised. The
    kinds of some tokens depend on the statement and the version of the language: names of targets,
    levels of senses, and words that are names in older versions."""
    words = spellings()
    target_name = re.compile(parser().get_terminal("TARGET_NAME").pattern.value)
    level_pattern = re.compile(parser().get_terminal("LEVEL").pattern.value)
    lexer = parser().parse_interactive(source.text, start=START).lexer_thread
    tokens = Tokens(source, [], [])
    end = 0
    statement = ""
    for token in lexer.lex(None):  # type: ignore[no-untyped-call]
        start = span_of(token).start
        # Part of a token that was made here from several, such as a target's name with dots.
        if start < end:
            continue
        if tokens.kinds[-1:] == ["target"]:
            target_match = target_name.match(source.text, start)
            if target_match is not None and target_match.group() not in words.values():
                end = target_match.end()
                token = Token("TARGET_NAME", target_match.group(), start, end_pos=end)
            elif token.type == "NAME":
                token = token.update(type="TARGET_NAME")
        elif words.get(token.type) in names_in(tokens.version):
            token = token.update(type="NAME")
        elif statement in _PICTURES and (
            picture_token := _of_picture(tokens, token, statement, level_pattern)
        ):
            token, end = picture_token, span_of(picture_token).end
        elif _awaits_level(tokens, statement) and (
            amount := level_pattern.match(source.text, start)
        ):
            end = amount.end()
            token = Token("LEVEL", amount.group(), start, end_pos=end)
        tokens.lark_tokens.append(token)
        tokens.kinds.append(words.get(token.type, token.type))
        if token.type in words and words[token.type] in statement_words(tokens.version):
            statement = words[token.type]
    return tokens


_PICTURES = ("image", "plane", "assume", "next", "param", "report")
"""The statements of versions 3 and 4 whose operands may be levels."""
_ENDS = ("NAME", "INTEGER", "AMOUNT", "true", "false", ")", "]")
"""The tokens that end an operand, after which `repeat` and `with` are no names."""
_OF_TWO = re.compile(r"\[[^\[\]]*,")
"""The bracket after a plane, not that of a field."""
_NOT_DIVIDED = re.compile(r"\s*[<>=!)]")
_ADDED = re.compile(r"[ \t]*([-+,\n#]|$|(when|if|else|and|or|xor)\b)")
"""What follows a level that an image adds."""


def _of_picture(
    tokens: Tokens, token: Token, statement: str, level_pattern: re.Pattern[str]
) -> Token | None:
    """Return `token` as statements of versions 3 and 4 read it; None if its kind does not change.

    `statement` is the first word of its statement, and `level_pattern` matches a level such as
    `6%`. `tokens` are those before it."""
    start, text = span_of(token).start, tokens.source.text
    # Before version 3, `next` reads no images and planes.
    if statement in ("next", "report") and tokens.version < 3:
        return None
    if (amount := level_pattern.match(text, start)) and (
        statement != "next" or not amount.group().endswith("%") or _is_share(tokens, amount)
    ):
        return Token("AMOUNT", amount.group(), start, end_pos=amount.end())
    if statement == "report":
        is_image = token == "exposure" and tokens.version > 3
        return token.update(type="NAME") if is_image else None
    if statement == "assume":
        return None
    is_step_count = tokens.kinds[-1] == "REPEAT"  # a name here is no function
    # After `repeat K` the step begins: there, `repeat` and `with` are names.
    after_expression = tokens.kinds[-1] in _ENDS and tokens.kinds[-2] != "REPEAT"
    if tokens.version > 3 and after_expression and token in ("repeat", "with"):
        return token.update(type=token.upper())
    if token.type == "NAME" and text[span_of(token).end :].lstrip(" \t").startswith("("):
        return None if is_step_count else token.update(type="FUNCTION")
    if token == "exposure":
        return token.update(type="NAME")
    # In `next`, a single number in brackets is an index; two are the offset of a neighbour.
    is_place = statement != "next" or _OF_TWO.match(text, start)
    if token == "[" and tokens.kinds[-1:] == ["NAME"] and is_place:
        return token.update(type="PLACE")
    return None


def _is_share(tokens: Tokens, amount: re.Match[str]) -> bool:
    """Return whether `amount`, such as `5%`, in a `next` is a level: compared, or at the end of
    brackets.

    `tokens` are those before it. From version 4 on, it is also a level if an image adds it.
    Otherwise it is a number and the sign of a remainder."""
    before = [kind for kind in tokens.kinds[-2:] if kind != "-"][-1:]  # a level may have a sign
    if before == ["COMPARISON"] or _NOT_DIVIDED.match(amount.string, amount.end()):
        return True
    return tokens.version > 3 and _ADDED.match(amount.string, amount.end()) is not None


def _awaits_level(tokens: Tokens, statement: str) -> bool:
    """Return whether the next token is a level of a `sense`: after its comparison, or in a list
    there.

    `tokens` are those before it, at least one, and `statement` is the first word of the statement.
    """
    if statement != "sense" or tokens.kinds[-1] not in ("COMPARISON", "[", ","):
        return False
    words = (kind for kind in reversed(tokens.kinds) if kind in ("at", *statement_words(2)))
    return next(words, None) == "sense"


class Stuck(Record):
    """The token at which the parser stopped because no statement can continue with it.

    `token` is its index in the whole text, one past the last token if the statement ends too early.
    `before` are the statement's tokens before it."""

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
    """Parse the tokens number `first` to `last` - 1 as one statement.

    Return lark's tree and None. If parsing fails, return where as a Stuck, with the tree of the
    tokens before it if they are a complete statement, else None."""
    machine = _machine()
    stuck = None
    for index in range(first, last):
        try:
            machine.feed_token(tokens.lark_tokens[index])
        except UnexpectedToken:
            stuck = Stuck(index, tuple(tokens.lark_tokens[first:index]))
            break
    try:
        # Also after an error: the tokens before it may be a complete statement.
        return machine.feed_token(Token(END, "")), stuck
    except UnexpectedToken:
        return None, stuck or Stuck(last, tuple(tokens.lark_tokens[first:last]))


def _machine() -> InteractiveParser:
    """Return a parser that takes tokens one by one."""
    return parser().parse_interactive(start=START)
