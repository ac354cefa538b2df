"""The order of images and planes in which few of them are alive at once.

The text may define all of them first, and read them once each later. The results do not depend on
the order, so each is computed just before the first item that reads it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from nscc.words import pictures as p


def by_last_use(pictures: p.Pictures) -> p.Pictures:
    """Return the same images and planes, each just before the first item that reads it, so that few
    registers are occupied at once.

    Of the items that an item reads, the one that depends on most others comes first. Long sums and
    conditions become items of two operands each, called `NAME / NUMBER`. The program must have no
    repeated items."""
    nodes = {
        part.name: part.node
        for item in pictures.items
        for part in _taken_apart(item.name, item.node)
    }
    reads = {
        name: [read for read in dict.fromkeys(names_read(node)) if read in nodes]
        for name, node in nodes.items()
    }
    depth: dict[str, int] = {}
    for name in nodes:  # an item reads only items before it
        depth[name] = 1 + sum(depth[read] for read in reads[name])
    order: dict[str, None] = {}
    read_by_others = {read for names in reads.values() for read in names}
    # Depth first, from the items that no other item reads, in the order of the text.
    stack = [name for name in reversed(nodes) if name not in read_by_others]
    while stack:
        missing = [read for read in reads[stack[-1]] if read not in order]
        if missing:
            stack += sorted(missing, key=depth.__getitem__)
        else:
            order.setdefault(stack.pop())
    return replace(pictures, items=tuple(p.Picture(name, nodes[name]) for name in order))


def names_read(node: p.Node) -> Iterator[str]:
    """Yield the names of the images, planes and buckets that an expression reads, as often as it
    reads them."""
    for part in p.subexpressions(node):
        if isinstance(part, p.Bit | p.Source):
            yield part.name


def _taken_apart(name: str, node: p.Node) -> Iterator[p.Picture]:
    """Yield an expression as items of two operands each, in the order in which they are computed;
    the last is called `name`.

    Only nested `and`, `or` and `xor`, and sums of more than two terms are divided. Any other
    expression is yielded whole."""
    if isinstance(node, p.Joined):
        operands: list[p.Condition] = []
        for number, operand in enumerate((node.first, node.second), 1):
            part = f"{name} / {number}"
            if isinstance(operand, p.Joined):
                yield from _taken_apart(part, operand)
            operands.append(p.Bit(part) if isinstance(operand, p.Joined) else operand)
        node = p.Joined(node.op, *operands)
    elif isinstance(node, p.Sum) and len(node.terms) > 2:
        # Each term is scaled first, because a sum of whole terms may be beyond the range.
        total: p.Value
        total, *terms = [p.Sum((term,)) for term in node.terms]
        for number, term in enumerate(terms, 1):
            node = p.Sum(((Fraction(1), total), (Fraction(1), term)))
            if term is not terms[-1]:
                yield p.Picture(f"{name} / {number}", node)
                total = p.Source(f"{name} / {number}")
    yield p.Picture(name, node)
