"""Text tables with aligned columns."""

from __future__ import annotations

from collections.abc import Collection, Sequence


def columns(
    rows: Sequence[Sequence[str]], left_aligned: Collection[int] | None = None, indent: str = ""
) -> str:
    """Return rows of equal length as lines of aligned columns, two blanks apart, each after
    `indent`.

    Columns whose index is in `left_aligned` (None: all) are aligned to the left, others to the
    right. There are no blanks at the end of lines, and no line break after the last. Without rows,
    the result is ""."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]

    def line(row: Sequence[str]) -> str:
        """Return one row as text: cells padded to the column widths, two spaces apart, without
        trailing spaces."""
        cells = (
            cell.ljust(width)
            if left_aligned is None or number in left_aligned
            else cell.rjust(width)
            for number, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        return indent + "  ".join(cells).rstrip()

    return "\n".join(map(line, rows))
