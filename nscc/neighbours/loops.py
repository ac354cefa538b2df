"""Emit the words of repeated images and planes, and of values that a register keeps.

The words of one step are stored once. Before and after each step, a repeated value is in the same
register with the same sign, and FLAG is 1 in all pixels."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from nscc.neighbours.held import Held, LoopWords, PictureRefused
from nscc.neighbours.programs import OF_STEP
from nscc.neighbours.registers import RegisterEmitter
from nscc.operations import NEIGHBOURS, STEERING, STEPS, Op, Phase, WordEffect, op
from nscc.words import pictures as p
from nscc.words.picture_launches import LoopValue, Times

_LOCK = 1 << 30
"""Reads that are added to all values while the words of a step are emitted: no register is freed,
because the next step reads it again."""


def emit_loop(lowering: RegisterEmitter, items: Sequence[p.Picture]) -> None:
    """Emit the words of images and planes that `repeat` changes together.

    `items` are at least one; all are repeated, and step the same number of times. The words compute
    the initial values, then one step, which is stored once and executed several times. A flood is
    an item of its own. Raises PictureRefused if the words do not fit the chip."""
    steps: dict[str, p.Node] = {}
    for item in items:
        if isinstance(item.node, p.RepeatedPlane) and isinstance(item.node.step, p.Propagated):
            _emit_flood(lowering, item.name, item.node, item.node.step)
            return
        assert isinstance(item.node, p.Repeated)
        steps[item.name] = item.node.step
        lowering.now = item.name
        lowering.bits.begin(item.name)
        _start(lowering, item.name, item.node.start)
        times = item.node.times
    lowering.everywhere()
    # The second step does not find what registers hold before the first one.
    lowering.contents, lowering.bits.known = {}, {}
    steered, lowering.bits.steered = lowering.bits.steered, None
    state = lowering.state()
    _emit_steps(lowering, steps, times)
    directions = lowering.bits.steered
    if directions is not None:  # try to choose the neighbours once, before all steps
        lowering.restore(state)
        state = lowering.state()  # a state can be restored once
        lowering.bits.steered = steered
        lowering.bits.steer(*directions)
        head = len(lowering.words)
        _emit_steps(lowering, steps, times)
        step = (name for op, _ in lowering.words[head:] for name in op.destinations)
        if {*STEERING} & {*step} - directions[1]:
            lowering.restore(state)
            _emit_steps(lowering, steps, times)
            lowering.bits.steered = None
    lowering.contents, lowering.bits.known = {}, {}


def _emit_flood(
    lowering: RegisterEmitter, name: str, node: p.RepeatedPlane, step: p.Propagated
) -> None:
    """Emit a flood as the plane `name`, by words that propagate bits through many pixels at once.

    `node` has the seed of the flood (its `start`) and the number of steps, and `step` the mask. The
    words change the chip's masked register, in pixels where the mask is 1. Raises PictureRefused if
    the chip has no such register or the program's codes need it."""
    bits, mask, register = lowering.bits, lowering.target.mask_register, lowering.propagating
    if mask is None or register is None:
        raise PictureRefused("planes", name, needed=2, available=0)
    lowering.now = name
    bits.begin(name)
    bits.vacate(mask)
    lowering.everywhere()
    # With the mask at 1 everywhere, the masked register takes the seed in all pixels.
    lowering.word(op("SET", [mask]))
    bits.write(register, bits.bit(node.start))
    bits.write(mask, bits.bit(step.mask))
    bits.steer(frozenset(STEERING))
    begin = len(lowering.words)
    lowering.word(op("PROP.read"))
    lowering.word(op("PROP.write", [register], [register]))
    values = (LoopValue(name, register),)
    lowering.loops.append(LoopWords(begin, len(lowering.words), node.times, values))
    bits.give((mask, None))
    bits.uses[name] -= 1  # the read by its own step
    bits.planes[name] = bits.take()
    lowering.word(op("MOV", [bits.planes[name]], [register]))


def _start(lowering: RegisterEmitter, name: str, node: p.Node) -> None:
    """Emit the initial value `node` of the repeated image or plane `name`, into a register of its
    own, which the steps may overwrite.

    An image that is an output is held with its own sign. Raises PictureRefused if registers run
    out."""
    bits = lowering.bits
    if isinstance(node, p.Condition):
        register, owner = bits.bit(node)
        if owner is not None and not bits.hand_over(owner):
            register = bits.copy(register, owner)
        bits.planes[name] = register
        return
    value = lowering.value(node)
    # The steps overwrite the register, so a value with other readers is copied.
    if value.name is not None and not lowering.hand_over(value.name):
        value = lowering.negated(value)
    if name in lowering.pictures.outputs:
        value = lowering.positive(value)
    lowering.held[name] = replace(value, name=name)


def _emit_steps(lowering: RegisterEmitter, steps: Mapping[str, p.Node], times: Times) -> None:
    """Emit one step of all names in `steps`, which is valid for every step; `steps` has their
    expressions by name.

    The range of values that `times` steps can reach is found by repeating the step until it no
    longer grows. Raises PictureRefused if registers or their range do not suffice."""
    images = [name for name in steps if name in lowering.held]
    begin = len(lowering.words)
    heads = {name: lowering.held[name] for name in images}
    # The words of a step depend on the range of the values before it. So an attempt whose results
    # leave the range is undone, and the range widened.
    # After as many attempts as steps, the range holds for every step that is executed.
    for _ in range(max(1, times.most)):
        state = lowering.state()
        results = _emit_step(lowering, steps)
        if all(_contains(heads[name], results[name]) for name in images):
            break
        lowering.restore(state)
        heads = {name: _joined(heads[name], results[name]) for name in images}
        lowering.held.update(heads)
    else:
        results = _emit_step(lowering, steps)
    for name in images:
        # Exact where a step adds its noise to the value's, as shifts and choices do.
        added = max(0.0, results[name].variance - heads[name].variance)
        variance = heads[name].variance + times.most * added
        held = replace(_joined(heads[name], results[name]), variance=variance)
        if name in lowering.held:
            lowering.held[name] = held
    values = []
    for name in steps:
        register = heads[name].register if name in heads else lowering.loop_registers[name]
        sign = heads[name].sign if name in heads else 1
        values.append(LoopValue(name, register, 1 if sign > 0 else -1))
    lowering.loops = [loop for loop in lowering.loops if loop.end <= begin]
    lowering.loops.append(LoopWords(begin, len(lowering.words), times, tuple(values)))


def _emit_step(lowering: RegisterEmitter, steps: Mapping[str, p.Node]) -> dict[str, Held]:
    """Emit one step of all names in `steps`, whose expressions give their new values.

    Return the new values of images by name; planes are left out. No value from before the step
    loses its register, because the next step reads it again."""
    bits, begin = lowering.bits, len(lowering.words)
    lowering.loop_registers = {name: bits.planes[name] for name in steps if name in bits.planes}
    locked, locked_planes = [*lowering.held], [*bits.planes]
    for uses, names in ((lowering.uses, locked), (bits.uses, locked_planes)):
        for name in names:
            uses[name] = uses.get(name, 0) + _LOCK
    results = store_at_once(lowering, steps)
    lowering.everywhere()
    # A step needs at least one word, because a loop launches it.
    if len(lowering.words) == begin:
        lowering.word(op("all"))
    _move_flag(lowering, begin)
    for name in locked:
        # `give` takes back the last one, and frees the register if nothing after the loop reads it.
        lowering.uses[name] -= _LOCK - 1
        lowering.give(lowering.held[name])
    for name in locked_planes:
        bits.uses[name] -= _LOCK - 1
        bits.give((bits.planes[name], name))
    return results


def _move_flag(lowering: RegisterEmitter, begin: int) -> None:
    """Replace the last words of a step that writes where a plane is 1, and then moves the plane by
    one pixel; else change nothing.

    FLAG (the bit that lets a pixel act) has the bits of the plane already, so that one word moves
    them into its register. `begin` is the index of the first word of the step."""
    words = [word for word, _ in lowering.words[max(begin, len(lowering.words) - 5) :]]
    if len(words) < 5:
        return
    where, masked, all_pixels, moves, copies = words
    if (
        where.operation.effect is WordEffect.FLAG_DIGITAL
        and masked.operation.effect is WordEffect.BUS
        and all_pixels == op("all")
        and moves.operation.effect is WordEffect.DIGITAL_NEIGHBOURS
        and copies == op("MOV", where.sources, moves.destinations)
        and moves.sources == where.sources
    ):
        moves = op(moves.name, where.sources, ["FLAG"])
        lowering.words[-3:] = [(moves, None), (all_pixels, None)]


def store_at_once(lowering: RegisterEmitter, nodes: Mapping[str, p.Node]) -> dict[str, Held]:
    """Emit words that give all names their next values at once, in the registers that hold them.

    `nodes` are the expressions of the next values by name, which read the old ones. Return the next
    values of images by name; planes are left out. Raises PictureRefused if registers run out."""
    results: dict[str, Held] = {}
    # New values that must not be stored yet, because a later name reads the old value.
    waiting: list[tuple[str, Held | tuple[str, str | None]]] = []
    for name, is_read_later in _in_order(nodes):
        lowering.now, node = name, nodes[name]
        if isinstance(node, p.Condition):
            if node == p.Bit(name):
                lowering.bits.uses[name] -= 1
            elif is_read_later:
                bit = lowering.bits.shortest(node)
                if bit[1] is not None:  # its register may be overwritten before it is stored
                    bit = lowering.bits.copy(*bit), None
                waiting.append((name, bit))
            else:
                lowering.bits.store(name, lowering.bits.shortest(node))
            continue
        head = lowering.held[name]
        if node == p.Source(name):
            lowering.give(head)
            results[name] = head
        elif is_read_later:
            value = lowering.value(node)
            if value.name is not None:  # its register may be overwritten before it is moved
                value = lowering.negated(value)
            waiting.append((name, value))
        else:
            results[name] = _store(lowering, head, node)
    for name, next_value in waiting:
        if isinstance(next_value, Held):
            results[name] = _move(lowering, next_value, lowering.held[name], flag=None)
        else:
            lowering.bits.store(name, next_value)
    return results


def _in_order(nodes: Mapping[str, p.Node]) -> Iterator[tuple[str, bool]]:
    """Yield the names of `nodes` in the order in which new values replace old ones, each with a
    bool.

    `nodes` has the expression of each new value. The bool tells whether a later name still reads
    the old value, so that the new one needs another register until then. The order avoids this
    where it can."""
    reads = {
        name: {getattr(node, "name", name) for node in p.subexpressions(expression)} - {name}
        for name, expression in nodes.items()
    }
    waiting = list(nodes)
    while waiting:
        # Without a name that no other reads, the first one goes next.
        free = (name for name in waiting if not any(name in reads[n] for n in waiting))
        name = next(free, waiting[0])
        waiting.remove(name)
        yield name, any(name in reads[n] for n in waiting)


def _store(lowering: RegisterEmitter, head: Held, node: p.Node) -> Held:
    """Emit words that write the value of the image `node` to the register of `head`, in its sign;
    return the result.

    `head` is the old value of the same name. A choice that keeps the old value in some pixels
    writes the register in the other pixels only. Raises PictureRefused if registers run out."""
    own = p.Source(head.name or "")
    if not isinstance(node, p.Chosen) or own not in (node.then, node.otherwise):
        assert not isinstance(node, p.Condition)
        return _move(lowering, lowering.value(node), head, flag=None)
    condition, other = node.condition, node.then
    if node.then == own:
        condition, other = p.Inverse(condition), node.otherwise
        if isinstance(node.condition, p.Inverse):
            condition = node.condition.condition
    lowering.give(head)
    bit = lowering.bits.bit(condition)
    result = _move(lowering, lowering.value(other), head, bit[0])
    lowering.bits.give(bit)
    return _joined(head, result)


def _move(lowering: RegisterEmitter, value: Held, head: Held, flag: str | None) -> Held:
    """Emit words that copy a value to the register of `head`, in its sign; return the result, with
    the name of `head`.

    `value` has then been read. `flag` is the digital register that is 1 where they copy; None
    copies in all pixels. If the last word wrote the value, and nothing else reads it, that word
    writes the register instead."""
    register, (last, level) = head.register, lowering.words[-1]
    # A word inverts. To keep the sign, the word that wrote the value writes the register instead,
    # or NEWS takes the value in between.
    source, again = value.register, value.sign == head.sign
    sources = [source]
    if again and value.name is None and not lowering.masked and _writes(last, source, register):
        lowering.words.pop()
        lowering.contents.pop(source, None)
        sources, again = [*last.sources], False
    else:
        level = None
    lowering.everywhere()
    if again:
        lowering.word(op("bus", ["NEWS"], sources))
        sources = ["NEWS"]
    if flag is not None:
        if not NEIGHBOURS.keys().isdisjoint(sources):
            sources = _fetched(lowering, sources, source)
        lowering.word(op("WHERE", [], [flag]))
    lowering.word(op("bus", [register], sources), level)
    lowering.everywhere()
    lowering.give(value)
    return replace(head, low=value.low, high=value.high, variance=value.variance + again)


def _fetched(lowering: RegisterEmitter, sources: list[str], free: str) -> list[str]:
    """Emit words that fetch values from neighbours, and return sources that a masked word may read
    instead.

    A word that acts only where FLAG (the bit that lets a pixel act) is 1 cannot reach neighbours.
    `sources` are those it would read, at least one of which is a neighbour. `free` is a register
    that may be overwritten. NEWS then has the sum of the sources, not its negative."""
    before = lowering.words[-1][0]
    if len(sources) == 1 and before == op("bus", ["NEWS"], before.sources):
        right, down = STEPS[sources[0]]  # the word before moves the values instead
        lowering.words[-1] = op("bus", [OF_STEP[-right, -down]], before.sources), None
        lowering.contents.pop("NEWS", None)
        return ["NEWS"]
    lowering.word(op("bus", [free], sources))
    lowering.word(op("bus", ["NEWS"], [free]))
    return ["NEWS"]


def _writes(word: Op, source: str, register: str) -> bool:
    """Return whether a word writes only the register `source`, and may write `register` instead.

    It may not if it reads `register`, or is one word of a pair."""
    plain = word.operation.effect is WordEffect.BUS and word.operation.phase is Phase.WHOLE
    return plain and word.destinations == (source,) and register not in word.sources


def _contains(outer: Held, inner: Held) -> bool:
    """Return whether the range of values of `outer` contains that of `inner`, up to rounding (1e-9
    of its larger end)."""
    slack = 1e-9 * max(abs(outer.low), abs(outer.high))
    return outer.low - slack <= inner.low and inner.high <= outer.high + slack


def _joined(first: Held, second: Held) -> Held:
    """Return `first` with a range that contains the values of both, and the larger of both
    variances of errors."""
    low, high = min(first.low, second.low), max(first.high, second.high)
    return replace(first, low=low, high=high, variance=max(first.variance, second.variance))


def kept_ranges(
    lowering: RegisterEmitter, results: Mapping[str, Held]
) -> dict[str, tuple[float, float]]:
    """Return new ranges of the kept images whose next values leave the ranges that were assumed.

    A range is (least, largest value in electrons); a new one contains the assumed range and the
    next values. The result is empty if every frame keeps the ranges. `results` are the next values
    by name. Raises PictureRefused for a range that registers cannot hold."""
    wider = {}
    for name, result in results.items():
        low, high = lowering.kept_ranges[name]
        assumed = replace(result, low=low, high=high)
        if not _contains(assumed, result):
            joined = _joined(assumed, result)
            lowering.checked(joined.low, joined.high)
            wider[name] = joined.low, joined.high
    return wider
