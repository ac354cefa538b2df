"""Formatting of programs in the standard style, for `nscc fmt`.

Tokens, comments and their order do not change; blanks, line breaks and commas at the ends of lists
follow the style. Each statement starts a line. Groups of lines are kept: several empty lines become
one. Comments after statements are aligned within a group. A statement with a comment inside keeps
its line breaks."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, groupby, pairwise

from nscc.diagnostics.diagnostic import Rejected
from nscc.record import Record
from nscc.source import Source
from nscc.syntax import tree
from nscc.syntax.lexer import Tokens, lex
from nscc.syntax.parse import parse

WIDTH = 100
"""Longest line, unless a single token or comment is longer."""
_INDENT = "    "
_COMMENTS_AT = 36
"""The column (from 0) of comments after statements; in groups with long lines, steps of 4
further."""
_COMMENT = re.compile(r"#[^\r\n]*")
_OPERANDS = frozenset(("NAME", "INTEGER", "AMOUNT", "true", "false", ")", "]"))
"""Tokens that end an operand; a minus after any other token is a sign."""
_OPENING = ("(", "[", "PLACE")
_LOOSEST_FIRST = (
    ("if", "else"),
    ("or",),
    ("xor",),
    ("and",),
    ("COMPARISON", "in"),
    ("<<",),
    ("+", "-"),
    ("*", "/", "%"),
)
"""Operators before which a long line is broken, in order of preference."""


class _Token(Record):
    """A token of a statement: its text, and its kind as in `Tokens.kinds`.

    `line` is its line, from 0 at the statement's first; `comments` are the comments before it, by
    line. `close` means that no blank comes before it. `sign` marks a minus with one operand."""

    kind: str
    text: str
    line: int
    comments: tuple[tuple[int, str], ...]
    close: bool
    sign: bool


@dataclass
class _Line:
    """A line of output: its text, and a comment after it. With both empty it separates groups; with
    only a comment it is a line of its own."""

    text: str = ""
    comment: str = ""


def format_source(source: Source) -> str:
    """Return a program's text in the standard style, ending in a line break.

    Raises Rejected with all syntax errors of an invalid program. The result is parsed again, and
    AssertionError, a fault of nscc, is raised if its meaning or a comment would change."""
    file, errors = parse(source)
    if errors:
        raise Rejected(errors)
    formatted = Source(source.name, _Writer(source, file).text())
    again, new_errors = parse(formatted)
    if new_errors or _bare(again.statements) != _bare(file.statements):
        raise AssertionError(f"formatting {source.name!r} would change its meaning")
    if _comments(formatted) != _comments(source):
        raise AssertionError(f"formatting {source.name!r} would change its comments")
    return formatted.text


def _bare(value: object) -> object:
    """Return `value`, a syntax tree or a part of one, as nested tuples without places, to compare
    two texts."""
    if isinstance(value, tree.Node):
        # Field 0 is the span.
        return (type(value), *(_bare(getattr(value, name)) for name in value.field_names[1:]))
    return tuple(map(_bare, value)) if isinstance(value, tuple) else value


def _comments(source: Source) -> list[str]:
    """Return the comments of the text `source`, in order, each from its # on, without blanks at its
    end."""
    tokens = lex(source)
    spans = [tokens.span(k) for k in range(len(tokens.kinds))]
    # Comments are in the gaps between tokens, before the first and after the last.
    gaps = zip(
        [0, *(span.end for span in spans)], [*(span.start for span in spans), None], strict=True
    )
    comments_by_gap = (_COMMENT.findall(source.text[begin:end]) for begin, end in gaps)
    return [comment.rstrip() for comments in comments_by_gap for comment in comments]


@dataclass
class _Writer:
    """Writes the statements of a program in the standard style, with the comments of its source, to
    `lines`."""

    source: Source
    file: tree.File
    lines: list[_Line] = field(default_factory=list)

    def text(self) -> str:
        """Return the whole program in the standard style, with its comments; fills `lines`."""
        tokens = lex(self.source)
        starts = {statement.span.start for statement in self.file.statements}
        first = [k for k in range(len(tokens.kinds)) if tokens.span(k).start in starts]
        end = 0
        for begin, last in pairwise([*first, len(tokens.kinds)]):
            self._between(end, tokens.span(begin).start)
            self.lines += _statement_lines(list(_tokens(tokens, begin, last)))
            end = tokens.span(last - 1).end
        self._between(end, len(self.source.text))
        while self.lines and self.lines[-1] == _Line():
            self.lines.pop()
        return "".join(f"{line}\n" for line in _with_comments(self.lines))

    def _between(self, begin: int, end: int) -> None:
        """Append the comments and empty lines between two statements: of the text from character
        `begin` to character `end` - 1."""
        gap = self.source.text[begin:end]
        position = 0
        for comment in _COMMENT.finditer(gap):
            line_ends = _line_ends(gap[position : comment.start()])
            text = comment.group().rstrip()
            # The end of a tile includes the comment of its last row.
            if line_ends == 0 and self.lines and not self.lines[-1].comment:
                self.lines[-1].comment = text
            else:
                self._separate(line_ends)
                self.lines.append(_Line("", text))
            position = comment.end()
        self._separate(_line_ends(gap[position:]))

    def _separate(self, line_ends: int) -> None:
        """Append one empty line if the text had any (`line_ends` above 1), but never two in a row,
        and none at the start."""
        if line_ends > 1 and self.lines and self.lines[-1] != _Line():
            self.lines.append(_Line())


def _line_ends(blank: str) -> int:
    """Return the number of line ends (LF, CR or both) in a text without tokens."""
    return len(re.findall(r"\r\n|\r|\n", blank))


def _tokens(tokens: Tokens, begin: int, last: int) -> Iterator[_Token]:
    """Yield the tokens number `begin` to `last` - 1 of a text, which are a statement, with their
    comments and how they are spaced."""
    text, kinds = tokens.source.text, tokens.kinds
    line, end, sign = 0, tokens.span(begin).start, False
    for k in range(begin, last):
        span = tokens.span(k)
        gap = text[end : span.start]
        comments = tuple(
            (line + _line_ends(gap[: match.start()]), match.group().rstrip())
            for match in _COMMENT.finditer(gap)
        )
        line += _line_ends(gap)
        close = k > begin and (sign or _close(kinds[begin], kinds[k - 1], kinds[k], k - begin))
        # A minus after an operand subtracts; any other is a sign, without a blank after it.
        sign = kinds[k] == "-" and kinds[k - 1] not in _OPERANDS
        yield _Token(
            kind=kinds[k], text=tokens.text(k), line=line, comments=comments, close=close, sign=sign
        )
        end = span.end


def _close(statement: str, before: str, kind: str, place: int) -> bool:
    """Return whether there is no blank between the token `before` and the token `kind`.

    `statement` is the statement's first word, `place` the token's number in it, from 0. Tokens are
    given by kind: a keyword or sign stands for itself."""
    if kind in (",", ")", "]", "..") or before in ("(", "[", "PLACE", ".."):
        return True
    if kind == "(":
        return before in ("min", "max", "FUNCTION")
    if kind == "PLACE":
        return True
    # `[` after a name is an index, as in `code[2]`. In `shutters NAME [`, it begins the rows.
    is_index = before == "NAME" and not (statement == "shutters" and place == 2)
    return kind == "[" and (before == "bit" or is_index)


def _with_comments(lines: Sequence[_Line]) -> Iterator[str]:
    """Yield the lines as text without line ends. Comments after statements are aligned in each
    group of lines between empty lines."""
    for empty, group in groupby(lines, key=_Line().__eq__):
        run = list(group)
        if empty:
            yield from ("" for _ in run)
            continue
        longest = max((len(line.text) for line in run if line.text and line.comment), default=0)
        # At least two blanks after the longest line, rounded up to a multiple of four columns.
        column = max(_COMMENTS_AT, -(-(longest + 2) // 4) * 4)
        for line in run:
            yield (
                f"{line.text:{column}}{line.comment}"
                if line.text and line.comment
                else (line.text or line.comment)
            )


def _statement_lines(tokens: list[_Token]) -> list[_Line]:
    """Return the lines of one statement: a table of rows for codebooks and tiles, or wrapped text.

    Commas at the ends of lists are dropped. A statement with comments inside keeps its line breaks.
    """
    followers = [token.kind for token in tokens[1:]] + [""]
    tokens = [
        token
        for token, after in zip(tokens, followers, strict=True)
        if token.kind != "," or token.comments or after not in ("]", ")", "")
    ]
    rows = _Rows.of(tokens)
    table_lines = None if rows is None else rows.book() if rows.is_book else rows.tile()
    if table_lines is not None:
        return table_lines
    if any(token.comments for token in tokens):
        # Comments inside: only blanks are corrected.
        runs: dict[int, list[_Token]] = {}
        comments: dict[int, str] = {}
        for token in tokens:
            comments |= dict(token.comments)
            runs.setdefault(token.line, []).append(token)
        lines = []
        for number in sorted(runs.keys() | comments.keys()):
            run, comment = runs.get(number, []), comments.get(number, "")
            if not run:
                lines.append(_Line(_INDENT + comment))
                continue
            indent = "" if not lines or [token.kind for token in run] == ["]"] else _INDENT
            lines.append(_Line(indent + _joined(run), comment))
        return lines
    return [_Line(text) for text in _wrapped(tokens, "")]


@dataclass
class _Rows:
    """The rows of a codebook (`is_book`) or a tile, with their comments.

    `head` is the text before the rows, with `[`. `after[k]` is the comment after row k - 1, or
    after `head` for k = 0. `above[k]` are the comment lines above row k; the last are those above
    the closing `]`."""

    head: str
    rows: list[list[_Token]]
    above: list[list[str]]
    after: list[str]
    is_book: bool

    @classmethod
    def of(cls, tokens: list[_Token]) -> _Rows | None:
        """Return the rows of the codebook or tile that `tokens`, a whole statement, declare, with
        their comments.

        Return None for other statements, and for comments inside a row."""
        kinds = [token.kind for token in tokens]
        is_book = kinds[0] == "shutters" and "[" in kinds
        if not is_book and not (kinds[0] == "pixels" and "tile" in kinds):
            return None
        opening = kinds.index("[")
        rows = _split_at_commas(tokens[opening + 1 : -1])
        if not all(rows):  # the final comma was kept because of the comment before it
            return None
        above: list[list[str]] = []
        after: list[str] = []
        # A token has the comments before it. Those on the line of the previous row belong to it.
        row_ends = [tokens[opening], *(row[-1] for row in rows)]
        for end, following in zip(row_ends, [*(row[0] for row in rows), tokens[-1]], strict=True):
            behind = [text for line, text in following.comments if line == end.line]
            after.append("".join(behind))
            above.append([text for line, text in following.comments if line != end.line])
        row_comments = sum(map(len, above)) + sum(map(bool, after))
        if row_comments != sum(len(token.comments) for token in tokens):
            return None
        return cls(_joined(tokens[: opening + 1]), rows, above, after, is_book)

    def book(self) -> list[_Line] | None:
        """Return the lines of a codebook with one row each; None if it has a single row, which is
        written in one line."""
        if len(self.rows) == 1:
            return None
        lines = [_Line(self.head, self.after[0])]
        for row, above, after in zip(self.rows, self.above[:-1], self.after[1:], strict=True):
            lines += [_Line(_INDENT + text) for text in above]
            lines.append(_Line(f"{_INDENT}{_joined(row)},", after))
        return [*lines, *(_Line(_INDENT + text) for text in self.above[-1]), _Line("]")]

    def tile(self) -> list[_Line] | None:
        """Return the lines of a tile, one for each row, with aligned values; None if a line would
        exceed WIDTH, or if comments stand above the first row or below the last."""
        if self.above[0] or self.above[-1] or self.after[0]:
            return None
        values = [[_joined(value) for value in _split_at_commas(row[1:-1])] for row in self.rows]
        columns = max(map(len, values))
        widths = [max(len(row[k]) for row in values if k < len(row)) for k in range(columns)]
        # Two characters between values, and two brackets at the end.
        if len(self.head) + sum(widths) + 2 * columns + 2 > WIDTH:
            return None
        lines: list[_Line] = []
        for k, (row, after) in enumerate(zip(values, self.after[1:], strict=True)):
            lines += [_Line(" " * len(self.head) + text) for text in self.above[k]]
            cells = ", ".join(f"{value:>{widths[i]}}" for i, value in enumerate(row))
            margin = " " * len(self.head) if lines else self.head
            closing = "]]" if k + 1 == len(values) else "],"
            lines.append(_Line(f"{margin}[{cells}{closing}", after))
        return lines


def _split_at_commas(tokens: Sequence[_Token]) -> list[list[_Token]]:
    """Return the groups of tokens between the commas that are outside of all brackets.

    A group is empty where nothing stands before, after or between commas."""
    groups: list[list[_Token]] = [[]]
    for token, depth in zip(tokens, _depths(tokens), strict=True):
        if token.kind == "," and depth == 0:
            groups.append([])
        else:
            groups[-1].append(token)
    return groups


def _depths(tokens: Sequence[_Token]) -> list[int]:
    """Return for each token the number of brackets opened by these tokens that are open after
    it."""
    return [*accumulate((t.kind in _OPENING) - (t.kind in (")", "]")) for t in tokens)]


def _wrapped(tokens: Sequence[_Token], indent: str) -> list[str]:
    """Return the `tokens` of a statement, or a part of one, in lines of at most WIDTH columns if
    possible.

    A part that cannot be broken stays longer. The first line begins with `indent`, the others with
    more. Lines are broken at the outermost brackets and loosest operators first."""
    single_line = indent + _joined(tokens)
    if len(single_line) <= WIDTH:
        return [single_line]
    # Deeper nesting would leave little room for text.
    deeper = indent + _INDENT if len(indent) < 4 * len(_INDENT) else indent
    clauses = ("at", "when") if tokens[0].kind in ("sense", "next") else ("WITH",)
    for depth in range(max(0, *_depths(tokens)) + 1):
        for kinds in (clauses, *_LOOSEST_FIRST, (",",)):
            pieces = _broken(tokens, kinds, depth)
            if len(pieces) > 1:
                # Clauses and branches stay on lines of their own.
                if kinds not in (clauses, ("if", "else")):
                    pieces = _together(pieces, len(deeper))
                if len(pieces) > 1:
                    first, *later_pieces = pieces
                    inner = (line for piece in later_pieces for line in _wrapped(piece, deeper))
                    return [*_wrapped(first, indent), *inner]
    return [single_line]


def _together(pieces: Sequence[list[_Token]], indent_length: int) -> list[list[_Token]]:
    """Join consecutive pieces as long as they fit into one line, of WIDTH columns, which is
    indented by `indent_length` blanks."""
    merged: list[list[_Token]] = []
    for piece in pieces:
        if merged and indent_length + len(_joined([*merged[-1], *piece])) <= WIDTH:
            merged[-1] = [*merged[-1], *piece]
        else:
            merged.append(list(piece))
    return merged


def _broken(tokens: Sequence[_Token], kinds: Sequence[str], depth: int) -> list[list[_Token]]:
    """Split tokens before operators, or after commas, of these kinds at bracket depth `depth`.

    A minus that is a sign is no operator. Without such a token, the result is a single piece."""
    pieces: list[list[_Token]] = [[]]
    for token, token_depth in zip(tokens, _depths(tokens), strict=True):
        is_break = token.kind in kinds and token_depth == depth and not token.sign
        if is_break and token.kind != "," and pieces[-1]:
            pieces.append([])
        pieces[-1].append(token)
        if is_break and token.kind == ",":
            pieces.append([])
    return [piece for piece in pieces if piece]


def _joined(tokens: Sequence[_Token]) -> str:
    """Return tokens, at least one, as one line of text, with blanks where the style has them."""
    first, *later_tokens = tokens
    return first.text + "".join(
        f"{'' if token.close else ' '}{token.text}" for token in later_tokens
    )
