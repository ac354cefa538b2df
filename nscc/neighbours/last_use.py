"""The order of images and planes in which few of them are alive at once.

The text may define all of them first, and read them once each later. The results do not depend on
the order, so each is computed just before the first item that reads it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial, reduce
from typing import cast

from nscc.words import pictures as p


def by_last_use(pictures: p.Pictures, eager: bool = False) -> p.Pictures:
    """Return the same images and planes, each just before the first item that reads it, so that few
    registers are occupied at once.

    Of the items that an item reads, the one that depends on most others comes first. Long sums and
    conditions become items of two operands each, called `NAME / NUMBER`. With `eager`, an item
    comes earlier if it is the last one that reads others: sums that read the same images then grow
    together. The program must have no repeated items."""
    places = {item.name: place for place, item in enumerate(pictures.items)}
    nodes = {
        part.name: part.node
        for item in pictures.items
        for part in _taken_apart(item.name, _in_order(item.node, places))
    }
    reads = {
        name: [read for read in dict.fromkeys(names_read(node)) if read in nodes]
        for name, node in nodes.items()
    }
    order = _depth_first(reads)
    if eager:
        kept = {*pictures.outputs}
        next_values: list[p.Node] = [state.next for state in pictures.states]
        next_values += [image.next for image in pictures.kept_images]
        kept |= {name for value in next_values for name in names_read(value)}
        order = _eager(reads, order, kept)
    return replace(pictures, items=tuple(p.Picture(name, nodes[name]) for name in order))


def _depth_first(reads: Mapping[str, Sequence[str]]) -> list[str]:
    """Return the names of all items, each just before the first item that reads it.

    `reads` are the items that each item reads, by name; an item reads only items before it."""
    depth: dict[str, int] = {}
    for name in reads:
        depth[name] = 1 + sum(depth[read] for read in reads[name])
    order: dict[str, None] = {}
    read_by_others = {read for names in reads.values() for read in names}
    # Depth first, from the items that no other item reads, in the order of the text.
    stack = [name for name in reversed([*reads]) if name not in read_by_others]
    while stack:
        missing = [read for read in reads[stack[-1]] if read not in order]
        if missing:
            stack += sorted(missing, key=depth.__getitem__)
        else:
            order.setdefault(stack.pop())
    return list(order)


def _eager(reads: Mapping[str, Sequence[str]], names: Sequence[str], kept: set[str]) -> list[str]:
    """Return `names`, an order of all items, changed so that the next item is always the one that
    occupies fewest further registers; of equal ones, the first of `names`.

    `reads` are the items that each item reads. An item in `kept` occupies its register to the
    end."""
    readers = Counter(read for name in names for read in reads[name])
    remaining, order = dict.fromkeys(names), list[str]()
    while remaining:
        ready = [name for name in remaining if remaining.keys().isdisjoint(reads[name])]
        next_name = max(
            ready, key=lambda name: sum(readers[r] == 1 and r not in kept for r in reads[name])
        )
        del remaining[next_name]
        readers.subtract(reads[next_name])
        order.append(next_name)
    return order


def _in_order(node: p.Node, places: Mapping[str, int]) -> p.Node:
    """Return an expression whose sums, and whose conditions of `and`, `or` and `xor`, have their
    operands in the order in which the items that they read are computed. `places` are the numbers
    of items by name."""

    def last_place(operand: p.Node) -> int:
        """Return the number of the last item that an operand reads, -1 without one."""
        return max((places.get(name, -1) for name in names_read(operand)), default=-1)

    if isinstance(node, p.Sum):
        return p.Sum(tuple(sorted(node.terms, key=lambda term: last_place(term[1]))))
    if not isinstance(node, p.Joined):
        return node
    operands: list[p.Condition] = []
    remaining: list[p.Condition] = [node]
    while remaining:
        operand = remaining.pop()
        if isinstance(operand, p.Joined) and operand.op == node.op:
            remaining += [operand.second, operand.first]
        else:
            operands.append(cast("p.Condition", _in_order(operand, places)))
    return reduce(partial(p.Joined, node.op), sorted(operands, key=last_place))


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
