"""Other ways to compute the same images, which the lowering tries at higher levels of optimisation.

* Kernels of one exposure or image often share a divisor. The halvings then run once, before them.
* Images that only apply kernels to exposures can be computed in any order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from nscc.neighbours.lower import merged
from nscc.words import pictures as p

_MOST_MOVED = 5
"""Most images of which one is moved to the front."""


def alternatives(pictures: p.Pictures) -> Iterator[p.Pictures]:
    """Yield programs of images with the same results as `pictures` that may need fewer words; none
    if there is nothing to change.

    In some, convolution kernels share their halvings; in others, one image is computed before all
    others. `pictures` itself is not among them."""
    shared = with_shared_halvings(pictures)
    if shared is not None:
        yield shared
    movable = [item for item in pictures.items if _is_kernel_of_exposure(item, pictures)]
    for item in movable[1:_MOST_MOVED] if len(movable) > 2 else ():
        others = (other for other in pictures.items if other is not item)
        moved = replace(pictures, items=(item, *others))
        yield moved
        if shared is not None:
            # Shared divisors do not depend on the order, so this always finds the same ones.
            yield with_shared_halvings(moved) or moved


def with_shared_halvings(pictures: p.Pictures) -> p.Pictures | None:
    """Return the images with further items: values divided by the divisor that several convolution
    kernels share.

    Return None if there are none. Such an item stands before the first item that reads it, and is
    called `NAME / DIVISOR`. The kernels then read it times the divisor. The program must have no
    images that are kept from frame to frame."""
    divisors_by_name: dict[str, list[int]] = {}
    for expression in pictures.expressions.values():
        for name, divisor in _divisors(expression, pictures.weights_by_name):
            divisors_by_name.setdefault(name, []).append(divisor)
    # Values that at least two kernels read, and nothing else (which has the divisor 1).
    # All divisors are powers of two, so the smallest one divides the others.
    least = {name: min(of_name) for name, of_name in divisors_by_name.items() if len(of_name) > 1}
    divisors = {name: divisor for name, divisor in least.items() if divisor > 1}
    if not divisors:
        return None

    def divided_source(node: p.Node) -> p.Node:
        """Return an expression in which each source with a common divisor is replaced by the
        divided value times the divisor."""
        if isinstance(node, p.Source) and node.name in divisors:
            divisor = divisors[node.name]
            return p.Sum(((Fraction(divisor), p.Source(f"{node.name} / {divisor}")),))
        return p.with_operands(node, divided_source)

    items: list[p.Picture] = []
    known = set(pictures.limits_e)
    for item in pictures.items:
        for name in [name for name in divisors if name in known]:
            divided = p.Sum(((Fraction(1, divisors[name]), p.Source(name)),))
            items.append(p.Picture(f"{name} / {divisors[name]}", divided))
            known.remove(name)
        items.append(replace(item, node=divided_source(item.node)))
        known.add(item.name)
    return replace(pictures, items=tuple(items))


def _divisors(node: p.Node, kernels: Mapping[str, p.Weights]) -> Iterator[tuple[str, int]]:
    """Yield each value that an expression reads, as (name, divisor), as often as it is read.

    The divisor is the largest denominator of the weights of the convolution kernel that reads the
    value, and 1 without a kernel. `kernels` has the convolution kernels by name."""
    if isinstance(node, p.Source):
        yield node.name, 1
    elif isinstance(node, p.Filtered | p.Sum):
        taps, inner = merged(node, kernels)
        if isinstance(inner, p.Source):
            yield inner.name, max(weight.denominator for weight in taps.values() or [Fraction(1)])
        else:
            # `merged` returns the node itself if it cannot merge a sum: then look at its terms.
            for operand in p.operands(node) if inner is node else (inner,):
                yield from _divisors(operand, kernels)
    else:
        for operand in p.operands(node):
            yield from _divisors(operand, kernels)


def _is_kernel_of_exposure(item: p.Picture, pictures: p.Pictures) -> bool:
    """Return whether the image `item` only applies a convolution kernel of at least two weights to
    an exposure.

    Return False for a plane, and for a kernel of another image."""
    if isinstance(item.node, p.Condition):
        return False
    taps, inner = merged(item.node, pictures.weights_by_name)
    return len(taps) > 1 and isinstance(inner, p.Source) and inner.name in pictures.limits_e
