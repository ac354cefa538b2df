"""The syntax tree as text, one node per line, for `--emit ast` and `--print-after parse`."""

from __future__ import annotations

from nscc.source import Source
from nscc.syntax.tree import File, Node

_LONGEST = 20


def print_tree(file: File, source: Source) -> str:
    """Return every node with its place, row:column, indented below its parent; long lists are
    shortened."""
    lines: list[str] = []
    for statement in file.statements:
        _print(statement, source, "", lines)
    return "\n".join(lines) + "\n"


def _print(node: Node, source: Source, indent: str, lines: list[str]) -> None:
    row, column = source.row_column(node.span.start)
    plain: list[str] = []
    inner: list[Node] = []
    cut = 0
    for name in node.fields[1:]:
        value = getattr(node, name)
        items = value if isinstance(value, tuple) else (value,)
        nodes = [item for item in items if isinstance(item, Node)]
        if nodes:
            inner += nodes[:_LONGEST]
            cut += max(0, len(nodes) - _LONGEST)
        elif value is not None and value != ():
            plain.append(f"{name}={value}")
    lines.append(f"{indent}{type(node).__name__} {row}:{column} {' '.join(plain)}".rstrip())
    for child in inner:
        _print(child, source, indent + "  ", lines)
    if cut:
        lines.append(f"{indent}  .. and {cut} more")
