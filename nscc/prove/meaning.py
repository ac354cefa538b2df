"""Evaluate the images and planes of a program text as forms on a small array."""

from __future__ import annotations

from fractions import Fraction
from typing import assert_never

from nscc.prove.diagrams import IN, Form, Forms, in_at
from nscc.words import pictures as p
from nscc.words.reach import Reach

Place = tuple[int, int]
Fields = dict[Place, Form]
Bits = dict[Place, int]


def reaches(pictures: p.Pictures, *, of_a_step: bool = False) -> dict[str, Reach]:
    """Return the reach in one frame of every image, plane and state of the program text, by name:
    how far away, in pixels and four directions, it reads the light of other pixels.

    With `of_a_step`, the values of repeated statements count as given. The result then has the
    reach of their start values and of one step together."""
    reach_of: dict[str, Reach] = {}
    weights = pictures.weights_by_name
    states = {*pictures.stepping}

    def reach(node: p.Node) -> Reach:
        """Return the reach of an expression, from those of the names before it. Buckets, and states
        from before the frame, have no reach."""
        if isinstance(node, p.Source | p.Bit):
            return Reach() if node.name in states else reach_of.get(node.name, Reach())
        joined = Reach().joined(*map(reach, p.operands(node)))
        match node:
            case p.Filtered() | p.Near() | p.Largest() | p.Agreement():
                moved = [joined.moved(*offset) for offset in weights[node.kernel].taps]
                joined = Reach().joined(*moved)
            case p.At() | p.Shifted():
                joined = joined.moved(node.right, node.down)
            case p.Propagated() if not of_a_step:  # a proof takes it as one unknown function
                joined = Reach(*(far + node.pixels for far in joined))
        return joined

    loops: dict[str, list[str]] = {}
    needed: dict[str, Reach] = {}
    for name, expression in pictures.expressions.items():
        if not isinstance(expression, p.Repeated):
            needed[name] = reach_of[name] = reach(expression)
            continue
        needed[name] = reach_of[name] = reach(expression.start)
        group = loops.setdefault(expression.leader, [])
        group.append(name)
        # The statements of a loop are stepped together, so the last of them does it for all.
        if len(group) < len(pictures.loop_of(name)):
            continue
        steps = {each: pictures.repeated[each].step for each in group}
        if of_a_step:
            reach_of |= dict.fromkeys(group, Reach())
            needed |= {each: needed[each].joined(reach(step)) for each, step in steps.items()}
            continue
        for _ in range(expression.times.most):
            before = {each: reach_of[each] for each in group}
            after = {each: before[each].joined(reach(step)) for each, step in steps.items()}
            reach_of |= after
            if after == before:
                break
        needed |= {each: reach_of[each] for each in group}
    return needed


class PictureMeaning:
    """The images and planes of a program text, computed from the text alone, on the small array of
    `forms`.

    The value of an image is a form: an exact weighted sum of unknowns, such as the exposures of
    pixels. Images are also defined outside the array, because one convolution kernel may read
    across the border and the next may read back. Bits outside the array are those of the statement
    `outside`."""

    def __init__(self, pictures: p.Pictures, forms: Forms) -> None:
        """Prepare to evaluate the images and planes `pictures` on the small array of `forms`.

        Kept and repeated values are unknowns. Results are cached by expression and pixel."""
        self.pictures, self.forms, self.weights = pictures, forms, pictures.weights_by_name
        self.nodes = pictures.expressions
        # Names whose values are unknowns: before a frame, or before a step.
        unknown, images = pictures.repeated, {image.name for image in pictures.kept_images}
        self.planes = {*pictures.kept} - images
        self.planes |= {name for name, node in unknown.items() if isinstance(node, p.Condition)}
        self.kept = images | {*unknown} - self.planes
        self.count_steps = Fraction(pictures.count_steps)
        diagrams = forms.diagrams
        self.outside = diagrams.one if pictures.outside else diagrams.zero
        # By `id`, because comparing expressions is slow; `pictures` keeps them alive.
        self._images: dict[tuple[int, Place], Form] = {}
        self._bits: dict[tuple[int, Place], int] = {}

    def value(self, name: str, at: Place) -> Form | int:
        """Return an image or a bucket (weighted sums), a plane or the next value of a state (bits)
        at the pixel `at` (x, y).

        A name without an expression is a state from before the frame, or else taken as a bucket."""
        node = self.nodes.get(name)
        if node is None:
            if name in self.planes:
                return self.forms.kept_bit(name, at)
            return self.forms.exposure(name, *at)
        return self.of(node, at)

    def of(self, node: p.Node, at: Place) -> Form | int:
        """Return the value of an expression at the pixel `at` (x, y): the bit of a condition, or
        the weighted sum of an image."""
        return self.bit(node, at) if isinstance(node, p.Condition) else self.image(node, at)

    def image(self, value: p.Value, at: Place) -> Form:
        """Return an image expression at `at` (x, y), which may be outside the array, as an exact
        weighted sum of exposures and other unknowns."""
        form = self._images.get((id(value), at))
        if form is None:
            form = self._images[id(value), at] = self._image(value, at)
        return form

    def _image(self, value: p.Value, at: Place) -> Form:
        """Return the value of an image expression at `at` (x, y), which may be outside the array,
        as a weighted sum; computed anew, because `image` keeps the results."""
        forms, (x, y) = self.forms, at
        match value:
            case p.Source():
                node = None if value.name in self.kept else self.nodes.get(value.name)
                if node is not None:
                    assert not isinstance(node, p.Condition)
                    return self.image(node, at)
                return forms.exposure(value.name, x, y) if forms.inside(x, y) else forms.beyond()
            case p.Sum():
                return forms.sum(*((factor, self.image(term, at)) for factor, term in value.terms))
            case p.Filtered():
                taps = self.weights[value.kernel].taps.items()
                return forms.sum(
                    *((w, self.image(value.value, (x + dx, y + dy))) for (dx, dy), w in taps)
                )
            case p.Absolute():
                form = self.image(value.value, at)
                return forms.chosen(forms.positive(form, at), form, forms.sum((Fraction(-1), form)))
            case p.Chosen():
                if not forms.inside(x, y):
                    return forms.beyond()
                bit = self.bit(value.condition, at)
                return forms.chosen(
                    bit, self.image(value.then, at), self.image(value.otherwise, at)
                )
            case p.Largest():
                first, *others = self.weights[value.kernel].taps
                largest = self.image(value.value, (x + first[0], y + first[1]))
                for dx, dy in others:
                    form = self.image(value.value, (x + dx, y + dy))
                    difference = forms.sum((Fraction(1), form), (Fraction(-1), largest))
                    largest = forms.chosen(forms.positive(difference, at), form, largest)
                return largest
            case p.Larger():
                if not forms.inside(x, y):
                    return forms.beyond()
                both = self.image(value.first, at), self.image(value.second, at)
                difference = forms.sum((Fraction(1), both[0]), (Fraction(-1), both[1]))
                return forms.chosen(forms.positive(difference, at), *both)
            case p.Uniform():
                return {in_at(value.param) if value.param else IN: forms.diagrams.one}
            case p.Shifted():
                return self.image(value.value, (x + value.right, y + value.down))
            case p.RepeatedImage():
                name = next(name for name, node in self.nodes.items() if node is value)
                return forms.exposure(name, x, y) if forms.inside(x, y) else forms.beyond()
            case p.Agreement():
                if not forms.inside(x, y):
                    return forms.beyond()
                # Only the sign of a weight counts.
                bits: list[Form] = []
                all_steps = Fraction(0)
                for (dx, dy), weight in self.weights[value.kernel].taps.items():
                    steps = self.count_steps if weight > 0 else -self.count_steps
                    bit = self.bit(value.condition, (x + dx, y + dy))
                    # A bit counts as +1 or -1, which is 2 * bit - 1; the -1 of all bits are added
                    # up below.
                    bits.append(forms.counted(bit, 2 * steps))
                    all_steps += steps
                ones = forms.counted(forms.diagrams.one, -all_steps)
                return forms.sum(*((Fraction(1), form) for form in (*bits, ones)))
        assert_never(value)

    def bit(self, condition: p.Condition, at: Place) -> int:
        """Return the decision diagram of a condition at the pixel `at` (x, y): its bit for all
        answers of comparisons.

        Pixels outside the array have the bit that the statement `outside` declares."""
        if not self.forms.inside(*at):
            return self.outside
        diagram = self._bits.get((id(condition), at))
        if diagram is None:
            diagram = self._bits[id(condition), at] = self._bit(condition, at)
        return diagram

    def _bit(self, condition: p.Condition, at: Place) -> int:
        """Return the decision diagram of a condition at the pixel `at` (x, y) of the array;
        computed anew, because `bit` keeps the results."""
        forms, diagrams, (x, y) = self.forms, self.forms.diagrams, at
        match condition:
            case p.Bit():
                # The name of a state stands for its bit of the frame before.
                if condition.name in self.planes:
                    return forms.kept_bit(condition.name, at)
                node = self.nodes[condition.name]
                assert isinstance(node, p.Condition)
                return self.bit(node, at)
            case p.Constant():
                return diagrams.one if condition.bit else diagrams.zero
            case p.RepeatedPlane():
                # A repeated plane is known only by its node, so its name is looked up.
                name = next(name for name, node in self.nodes.items() if node is condition)
                return forms.kept_bit(name, at)
            case p.Above() | p.AboveParam() | p.Exceeds():
                unit = IN
                match condition:
                    case p.Above():
                        steps = Fraction(condition.steps)
                    case p.AboveParam():
                        unit, steps = in_at(condition.param), Fraction(condition.factor)
                    case p.Exceeds():
                        steps = condition.level * self.count_steps
                # The comparison `value > level` is the sign of value - level.
                level = {unit: diagrams.leaf(-steps)} if steps else {}
                form = self.image(condition.value, at)
                return forms.positive(forms.sum((Fraction(1), form), (Fraction(1), level)), at)
            case p.Propagated():
                both = self.bit(condition.condition, at), self.bit(condition.mask, at)
                return forms.propagated(*both, at)
            case p.Inverse():
                return diagrams.inverse(self.bit(condition.condition, at))
            case p.Neither():
                bits = (self.bit(condition.first, at), self.bit(condition.second, at))
                return diagrams.inverse(diagrams.either(*bits))
            case p.ChosenPlane():
                parts = (condition.condition, condition.then, condition.otherwise)
                return diagrams.chosen(*(self.bit(part, at) for part in parts))
            case p.Joined():
                join = {"and": diagrams.times, "or": diagrams.either, "xor": diagrams.differs}
                first, second = self.bit(condition.first, at), self.bit(condition.second, at)
                return join[condition.op](first, second)
            case p.At():
                return self.bit(condition.condition, (x + condition.right, y + condition.down))
            case p.Near():
                is_all = condition.kind == "all"
                diagram = diagrams.one if is_all else diagrams.zero
                for dx, dy in self.weights[condition.kernel].taps:
                    neighbour_bit = self.bit(condition.condition, (x + dx, y + dy))
                    diagram = (
                        diagrams.times(diagram, neighbour_bit)
                        if is_all
                        else diagrams.either(diagram, neighbour_bit)
                    )
                return diagram
        assert_never(condition)
