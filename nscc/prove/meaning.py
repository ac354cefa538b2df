"""What the text of a program says of its images and planes, as forms on a small array."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple, assert_never

from nscc.prove.forms import IN, Form, Forms
from nscc.words import pictures as p

Place = tuple[int, int]
Fields = dict[Place, Form]
Bits = dict[Place, int]


class Reach(NamedTuple):
    """How many columns and rows around a pixel what is computed for it depends on."""

    left: int = 0
    right: int = 0
    up: int = 0
    down: int = 0

    def joined(self, other: Reach) -> Reach:
        """What one of two values depends on."""
        return Reach(*map(max, self, other))

    def moved(self, right: int, down: int) -> Reach:
        """The reach of a value of the pixel so far away."""
        return Reach(
            max(0, self.left - right), max(0, self.right + right),
            max(0, self.up - down), max(0, self.down + down),
        )  # fmt: skip


def reaches(pictures: p.Pictures) -> dict[str, Reach]:
    """The reach of every image and plane by the text."""
    found: dict[str, Reach] = {}
    weights = pictures.weights_by_name

    def reach(node: p.Node) -> Reach:
        if isinstance(node, p.Source | p.Bit):
            return found.get(node.name, Reach())
        joined = Reach()
        for part in p.operands(node):
            joined = joined.joined(reach(part))
        match node:
            case p.Filtered() | p.Near():
                moved = [joined.moved(*place) for place in weights[node.kernel].taps]
                joined = Reach(*map(max, *moved, (0,) * 4))
            case p.At():
                joined = joined.moved(node.right, node.down)
        return joined

    for item in pictures.items:
        found[item.name] = reach(item.node)
    return found


class Meaning:
    """The images and planes of a text on the array of `forms`, by name."""

    def __init__(self, pictures: p.Pictures, forms: Forms) -> None:
        self.pictures, self.forms, self.weights = pictures, forms, pictures.weights_by_name
        self.images: dict[str, Fields] = {}
        self.planes: dict[str, Bits] = {}
        for bucket in pictures.limits_e:
            self.images[bucket] = {
                place: forms.exposure(bucket, *place) for place in forms.places()
            }
        for item in pictures.items:
            if isinstance(item.node, p.Condition):
                self.planes[item.name] = self.bits(item.node)
            else:
                self.images[item.name] = self.fields(item.node)

    def fields(self, value: p.Value) -> Fields:
        """An image of every pixel."""
        forms = self.forms
        match value:
            case p.Source():
                return self.images[value.name]
            case p.Sum():
                parts = [(factor, self.fields(part)) for factor, part in value.terms]
                return {
                    at: forms.sum(*((factor, part[at]) for factor, part in parts))
                    for at in forms.places()
                }
            case p.Filtered():
                return self._filtered(self.weights[value.kernel].taps, self.fields(value.value))
            case p.Absolute():
                inner = self.fields(value.value)
                return {
                    at: forms.chosen(
                        forms.positive(form, at), form, forms.sum((Fraction(-1), form))
                    )
                    for at, form in inner.items()
                }  # fmt: skip
            case p.Chosen():
                bits = self.bits(value.condition)
                then, otherwise = self.fields(value.then), self.fields(value.otherwise)
                return {at: forms.chosen(bits[at], then[at], otherwise[at]) for at in bits}
        assert_never(value)

    def _filtered(self, taps: Mapping[Place, Fraction], inner: Fields) -> Fields:
        forms = self.forms
        found = {}
        for x, y in forms.places():
            near = ((weight, (x + right, y + down)) for (right, down), weight in taps.items())
            terms = [(weight, inner[at] if at in inner else forms.beyond()) for weight, at in near]
            found[x, y] = forms.sum(*terms)
        return found

    def bits(self, condition: p.Condition) -> Bits:
        """A plane of every pixel."""
        forms, diagrams = self.forms, self.forms.diagrams
        match condition:
            case p.Bit():
                return self.planes[condition.name]
            case p.Constant():
                leaf = diagrams.one if condition.bit else diagrams.zero
                return dict.fromkeys(forms.places(), leaf)
            case p.Above():
                level = {IN: diagrams.leaf(Fraction(-condition.steps))} if condition.steps else {}
                return {
                    at: forms.positive(forms.sum((Fraction(1), form), (Fraction(1), level)), at)
                    for at, form in self.fields(condition.value).items()
                }
            case p.Inverse():
                inner = self.bits(condition.condition)
                return {at: diagrams.inverse(bit) for at, bit in inner.items()}
            case p.Joined():
                join = {"and": diagrams.times, "or": diagrams.either, "xor": diagrams.differs}
                left, right = self.bits(condition.left), self.bits(condition.right)
                return {at: join[condition.op](left[at], right[at]) for at in left}
            case p.At():
                inner = self.bits(condition.condition)
                return self._near(inner, [(condition.right, condition.down)], every=False)
            case p.Near():
                inner = self.bits(condition.condition)
                taps = list(self.weights[condition.kernel].taps)
                return self._near(inner, taps, every=condition.kind == "all")
        assert_never(condition)

    def _near(self, inner: Bits, offsets: list[Place], *, every: bool) -> Bits:
        """Whether every, or any, of a pixel's neighbours at these places has a 1."""
        diagrams = self.forms.diagrams
        outside = diagrams.one if self.pictures.outside else diagrams.zero
        found = {}
        for x, y in self.forms.places():
            bit = diagrams.one if every else diagrams.zero
            for right, down in offsets:
                near = inner.get((x + right, y + down), outside)
                bit = diagrams.times(bit, near) if every else diagrams.either(bit, near)
            found[x, y] = bit
        return found
