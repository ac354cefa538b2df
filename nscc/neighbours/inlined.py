"""Images and planes with fewer names: what an item computes is written where it is read.

A name costs a register from its first to its last reader. A second name for an image, and an image
that moves another one, cost less if each reader computes them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Any

from nscc.neighbours.last_use import names_read
from nscc.neighbours.lower import merged
from nscc.words import pictures as p


def without_second_names(pictures: p.Pictures) -> p.Pictures:
    """Return the same images and planes, without items that only rename another and without unread
    items.

    Outputs and repeated items stay, even if nothing else reads them."""
    inlined = _inlined(pictures, lambda node: isinstance(node, p.Source | p.Bit))
    read = {*pictures.outputs}
    for expression in inlined.expressions.values():
        read |= {*names_read(expression)}
    loops = {*inlined.repeated}
    items = (item for item in inlined.items if item.name in read or item.name in loops)
    return replace(inlined, items=tuple(items))


def with_moves_where_read(pictures: p.Pictures) -> p.Pictures:
    """Return the same images and planes, in which each reader of a shifted image shifts it itself.

    Items that only shift an image are left out, except outputs and what a repeated item reads in
    every step."""

    def moves(node: p.Node) -> bool:
        """Return whether an expression is an image or bucket, shifted or not, times 1; False for
        planes."""
        if isinstance(node, p.Condition):
            return False
        taps, inner = merged(node, pictures.weights_by_name)
        return isinstance(inner, p.Source) and [*taps.values()] == [Fraction(1)]

    return _inlined(pictures, moves)


def _inlined(pictures: p.Pictures, is_inlined: Callable[[p.Node], bool]) -> p.Pictures:
    """Return the images and planes, with the expressions that `is_inlined` chooses written where
    they are read, and their items left out.

    Outputs keep their items, and so do items that a repeated item reads in every step."""
    nodes: dict[str, p.Node] = {}

    def changed(node: p.Node) -> Any:
        """Return a node in which names are replaced by what they stand for; names of items that
        stay are unchanged."""
        if isinstance(node, p.Source | p.Bit):
            return nodes.get(node.name, node)
        return p.with_operands(node, changed)

    # Items that keep their place: outputs, and what the steps of a loop read again.
    kept = {*pictures.outputs}
    for loop in pictures.repeated.values():
        kept |= {*names_read(loop.step)}
    items = []
    for item in pictures.items:
        node = changed(item.node)
        if item.name not in kept and is_inlined(node):
            nodes[item.name] = node
        else:
            items.append(replace(item, node=node))
    return replace(
        pictures,
        items=tuple(items),
        states=tuple(replace(state, next=changed(state.next)) for state in pictures.states),
        kept_images=tuple(replace(s, next=changed(s.next)) for s in pictures.kept_images),
    )
