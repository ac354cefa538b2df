"""C++ text: comments with safe characters, string literals, and kernel sections."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path
from textwrap import wrap

WIDTH = 100
"""Most columns of a line of C++."""

Call = tuple[str, tuple[str, ...]]
"""A call of the devkit's kernel library: name and operands."""


@cache
def _templates() -> dict[str, str]:
    """Return the sections of `parts.cpp` by name. A section begins after a line `//: NAME` and ends
    before the next."""
    _, *sections = Path(__file__).with_name("parts.cpp").read_text(encoding="ascii").split("//: ")
    split = (section.partition("\n") for section in sections)
    return {name: text.rstrip("\n") for name, _, text in split}


def template_lines(name: str, **values: object) -> list[str]:
    """Return the lines of the section `name` of `parts.cpp`, with each `@KEY@` replaced by the
    value of `KEY` in `values`. Other marks stay. Raises KeyError if there is no such section."""
    text = _templates()[name]
    for key, value in values.items():
        text = text.replace(f"@{key}@", str(value))
    return text.split("\n")


def safe(text: str) -> str:
    """Return `text` for a `//` comment: one line of printable ASCII, other characters as `?`.

    Backslashes and `??/` are replaced, because they would continue the comment on the next line."""
    shown = "".join(ch if " " <= ch <= "~" else "?" for ch in text)
    return shown.replace("\\", "/").replace("??", "? ?").strip()


def comment(text: str, indent: str = "") -> list[str]:
    """Return the lines of a `//` comment, wrapped to WIDTH columns, each beginning with `indent`.
    An empty text gives one empty comment."""
    head = f"{indent}// "
    return [head + line for line in wrap(safe(text), WIDTH - len(head)) or [""]]


def entry(title: str, text: str) -> list[str]:
    """Return the lines of an entry of the header comment: `title` in a column of 11 characters,
    then the wrapped text; further lines begin below the text."""
    # The text is wrapped beside the column: 11 characters and the mark `// ` are cut off as [14:].
    first, *following_lines = comment(text, " " * 11)
    return [
        f"// {title:<11}{first[14:]}",
        *("// " + " " * 11 + line[14:] for line in following_lines),
    ]


def literal(text: str) -> str:
    """Return `text` as a C string literal, in UTF-8. Quotes, backslashes, question marks and all
    but printable ASCII are escaped; lone surrogates become `?`."""
    # Three octal digits: a following digit cannot belong to them.
    shown = (
        f"\\{byte:03o}" if byte in b'"\\?' or not 0x20 <= byte <= 0x7E else chr(byte)
        for byte in text.encode("utf-8", "replace")
    )
    return f'"{"".join(shown)}"'


def call_text(call: Call) -> str:
    """Return a library call as C++."""
    name, operands = call
    return f"{name}({', '.join(operands)});"


def section(calls: Iterable[Call], indent: str = "    ") -> list[str]:
    """Return the lines that record a kernel of these library calls at its first run, and launch it,
    each beginning with `indent`.

    A kernel is a list of words that the chip stores. A launch is the start of a kernel, a list of
    words."""
    return [
        f"{indent}scamp5_kernel_begin();",
        *(f"{indent}    {call_text(call)}" for call in calls),
        f"{indent}scamp5_kernel_end();",
    ]


def remarked(lines: Sequence[tuple[str, str]], column: int = 44) -> Iterator[str]:
    """Yield lines of code, each with its comment in a common column, at least `column`. `lines` are
    pairs of code and comment; a line with the comment "" gets none."""
    # Very long lines do not move the comments of the others.
    at = max([column, *(len(text) + 2 for text, remark in lines if remark and len(text) < 76)])
    for text, remark in lines:
        yield f"{text:<{at}}// {safe(remark)}" if remark else text
