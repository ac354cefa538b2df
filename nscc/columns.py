"""Tables as text."""

from __future__ import annotations

from collections.abc import Collection, Sequence


def columns(
    rows: Sequence[Sequence[str]], left: Collection[int] | None = None, indent: str = ""
) -> str:
    """Rows of as many cells, a line each; the columns `left` (None: all) begin alike, others end
    alike."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]

    def line(row: Sequence[str]) -> str:
        cells = (
            cell.ljust(width) if left is None or number in left else cell.rjust(width)
            for number, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        return indent + "  ".join(cells).rstrip()

    return "\n".join(map(line, rows))
