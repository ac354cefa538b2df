"""Warnings about values that a variable never has."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nscc.program.expressions import Checked
from nscc.program.problems import Problems, printable
from nscc.syntax import tree


def judge_values(
    expressions: Sequence[Checked], ranges: Mapping[str, tuple[int, int]], problems: Problems
) -> None:
    """Warn about variables that are compared by `==` or `!=` with a value that they never have
    (NS0358).

    `ranges` are the least and greatest values of variables by name; other variables are not judged.
    Only a comparison of a name with a number or a constant is judged, not a chain."""
    for checked in expressions:
        for node in checked.nodes:
            if not isinstance(node, tree.Compare) or node.ops not in (("==",), ("!=",)):
                continue
            sides = (node.first, *node.later_operands)
            for variable, other in (sides, sides[::-1]):
                name = variable.text if isinstance(variable, tree.Name) else ""
                value = other.value if isinstance(other, tree.Int) else None
                if isinstance(other, tree.Name):
                    value = checked.constants.get(other.text)
                if name in ranges and value is not None:
                    low, high = ranges[name]
                    if not low <= value <= high:
                        problems.warning(
                            "NS0358",
                            f"`{name}` is never {printable(value)}",
                            other.span,
                            f"`{name}` is in {low}..{high}",
                        )
