"""Consistency checks of a container: every index, shape and name in it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

import numpy as np

from nscc.words import machine_soundness, stream
from nscc.words.container import Container
from nscc.words.pictures import NO_PICTURES, Repeated, subexpressions
from nscc.words.stored_arrays import array_fault, array_faults

MOST_WORDS = 1 << 18
"""Most words of all kernels on a target whose store does not limit them."""
MOST_SLOTS = 1 << 20
"""Most slots of a container."""
_LONGEST_NAME = 200
"""Most characters of a name."""
_SHORTEST_SLOT_US, _LONGEST_SLOT_US = 1e-9, 1e15
"""Shortest and longest slot in microseconds."""


def faults(container: Container) -> list[str]:
    """Return the errors of a container (a compiled program), each as the end of a sentence about
    it; [] if it is consistent.

    Words are only checked to be five 32-bit integers each and to fit the target's store. The module
    `nscc.words.legality` checks their meaning."""
    checks = (
        _time_faults,
        _table_faults,
        _kernel_faults,
        _register_faults,
        _pixel_faults,
        _text_faults,
        machine_soundness.faults,
        _stream_faults,
        _picture_faults,
    )
    return [fault for check in checks for fault in check(container)]


def _names(kind: str, names: Sequence[str]) -> Iterator[str]:
    """Yield the errors of a list of names: empty, unprintable, too long, or twice the same.

    `kind` says in the message of what, such as "bucket"."""
    for name in names:
        if not name or len(name) > _LONGEST_NAME or not name.isprintable():
            yield f"the {kind} name {name[:_LONGEST_NAME]!a} is not one line of visible text"
    if len(set(names)) != len(names):
        yield f"a {kind} name appears twice in {list(names)[:20]}"


def _time_faults(container: Container) -> Iterator[str]:
    """Yield the errors of slots and buckets: their number, lengths (in us) and names; of wrong
    lengths, only the first."""
    if not 1 <= container.slots <= MOST_SLOTS:
        yield f"it has {container.slots} slots, but 1 to {MOST_SLOTS} are allowed"
    for index, length in enumerate(container.slot_us):
        if not (isfinite(length) and _SHORTEST_SLOT_US <= length <= _LONGEST_SLOT_US):
            yield f"slot {index} has the length {length} us"
            break
    if not container.buckets:
        yield "it has no bucket"
    yield from _names("bucket", container.buckets)


def _table_faults(container: Container) -> Iterator[str]:
    """Yield the errors of the decode table: names of fields, shapes, types and indices, and a table
    without codes or shutters."""
    table = container.table
    yield from _names("field", table.fields)
    codes, shutters = len(table.codes), len(table.shutters)
    sizes = {
        "codes": codes,
        "shutters": shutters,
        "fields": len(table.fields),
        "buckets": len(container.buckets),
        "slots": container.slots,
        "registers": len(container.target.digital_registers),
    }
    yield from array_faults(table, sizes)
    encoded = shutters, sizes["registers"]
    yield from array_fault("encoding", container.encoding, np.bool_, encoded)
    if codes == 0 or shutters == 0:
        yield "its decode table is empty"
    elif not _within(table.shutter_of_code, shutters):
        yield f"a code refers to a shutter outside the {shutters} shutters"


def _kernel_faults(container: Container) -> Iterator[str]:
    """Yield the errors of kernels (lists of words) and launches (their starts): words, sizes,
    indices, order.

    Of each kernel, and of launches (starts of kernels), only the first is told."""
    yield from _names("kernel", [kernel.name for kernel in container.kernels])
    stored = 0
    for kernel in container.kernels:
        stored += len(kernel.words)
        for index, word in enumerate(kernel.words):
            if len(word) != 5 or max(word) >> 32 or min(word) < 0:
                yield f"word {index} of kernel '{kernel.name}' is not five 32-bit integers"
                break
    target = container.target
    most = target.store_words if target.tables_count_against_store else MOST_WORDS
    if stored > most:
        yield f"its kernels have {stored} words, but {target.name} stores {most}"
    previous = 0
    for launch in container.launches:
        if not 0 <= launch.instant <= container.slots:
            yield f"a kernel is launched at instant {launch.instant} of 0..{container.slots}"
            break
        if not 0 <= launch.kernel < len(container.kernels):
            yield f"kernel {launch.kernel} is launched, but there are {len(container.kernels)}"
            break
        if launch.instant < previous:
            yield f"the launch at instant {launch.instant} follows a later launch"
            break
        previous = launch.instant


def _register_faults(container: Container) -> Iterator[str]:
    """Yield the errors of code registers and readouts: unknown or repeated registers, buckets that
    are not read out exactly once, and gains that are not finite."""
    target = container.target
    for register in container.code_registers:
        if register not in target.digital_registers:
            yield f"the code register {register[:40]!a} is not one of {target.name}"
    if len(set(container.code_registers)) != len(container.code_registers):
        yield "a code register is listed twice"
    read = [readout.bucket for readout in container.readouts]
    if sorted(read) != sorted(container.buckets):
        yield "its readouts do not name every bucket once"
    readable = target.taps or target.analog_registers
    for readout in container.readouts:
        if readout.register not in readable:
            yield f"it reads out {readout.register[:40]!a}, but {target.name} has no such register"
        if not isfinite(readout.gain):
            yield f"a readout has the gain {readout.gain}"


def _pixel_faults(container: Container) -> Iterator[str]:
    """Yield the errors of the pixel codes: shape, type, or a code that does not exist; nothing
    without pixel codes."""
    pixels, target = container.pixel_codes, container.target
    if pixels is not None:
        shape = target.rows, target.cols
        yield from array_fault("the array of pixel codes", pixels, np.int32, shape)
        if not _within(pixels, len(container.table.codes)):
            yield f"the code of a pixel is not one of the {len(container.table.codes)} codes"


def _stream_faults(container: Container) -> Iterator[str]:
    """Yield the errors of bit planes; nothing for a sound container (a compiled program) with
    words.

    Only chips without logic have bit planes, and these have no words and no senses."""
    target, sent = container.target, container.stream
    if target.has_logic:
        if sent is not None:
            yield f"it has bit planes for slots, but {target.name} uses words"
        return
    if container.kernels or container.launches or container.code_registers:
        yield f"it has words, but the pixels of {target.name} have no logic"
    if container.machine.stages:
        yield f"its pixels look at the light, but those of {target.name} have no logic"
    if (sent is None) != (container.pixel_codes is None):
        yield "it has planes but no codes of the pixels, or codes but no planes"
    elif sent is not None:
        yield from stream.faults(sent, target, container.slots, len(container.buckets))


def _picture_faults(container: Container) -> Iterator[str]:
    """Yield the errors of images and planes, each as the end of a sentence about the container (a
    compiled program); nothing without images and planes.

    An expression may read buckets, states, and items before it. After an error in an expression or
    a launch (the start of a kernel), nothing else is checked."""
    pictures = container.pictures
    if pictures == NO_PICTURES:
        return
    states = {*pictures.kept}
    known: set[str] = {*container.buckets, *states}
    weights = {kernel.name for kernel in pictures.weights}
    for expression_name, expression in pictures.expressions.items():
        if isinstance(expression, Repeated):  # a step reads the names that step together
            known |= {*pictures.loop_of(expression_name)}
        for node in subexpressions(expression):
            name = getattr(node, "name", None)
            if name is not None and name not in known:
                yield f"`{expression_name[:40]!a}` reads a name that is not computed before it"
                return
            if getattr(node, "kernel", None) not in (None, *weights):
                yield f"`{expression_name[:40]!a}` names a kernel that does not exist"
                return
        known.add(expression_name)
    if states - pictures.registers.keys():
        yield "its pictures lack the register of a state"
    if pictures.limits_e.keys() != {*container.buckets}:
        yield "its pictures do not have one largest exposure for each bucket"
    if not known.issuperset(pictures.outputs) or not pictures.outputs:
        yield "its pictures neither read out nor report anything"
    for launch in pictures.launches:
        level, target = launch.level, container.target
        if launch.kernel >= len(pictures.kernels) or not (
            level is None or target.in_low <= level <= target.in_high
        ):
            yield "a launch of its pictures names no kernel, or a level that IN cannot have"
            return
    yield from _loop_faults(container)
    registers = {*container.target.analog_registers, *container.target.digital_registers}
    if not registers.issuperset(pictures.registers.values()):
        yield f"its pictures are in registers that {container.target.name} does not have"


def _loop_faults(container: Container) -> Iterator[str]:
    """Yield the errors of parameters of images, loops and levels, each as the end of a sentence
    about the container (a compiled program).

    A range or a number of steps may be wrong, or a launch (start of a kernel) or parameter may not
    exist."""
    pictures, target, end = container.pictures, container.target, 0
    params = {param.name: param for param in pictures.params}
    for param in pictures.params:
        of_in = target.in_low <= param.low <= param.high <= target.in_high
        if not param.low <= param.start <= param.high or (param.kind == "level" and not of_in):
            yield "the start or the range of a parameter is invalid"
    for loop in pictures.loops:
        if loop.first < end or loop.first + loop.launches > len(pictures.launches):
            yield "a loop of its pictures names launches that do not exist"
        end = loop.first + loop.launches
        used = params.get(loop.times.param)
        ends = {} if used is None else {used.low, used.high}
        if loop.times.param and used is None:
            yield "a loop of its pictures names a parameter that does not exist"
        # Without a parameter, the number of steps is constant.
        if any(loop.times.at({loop.times.param: n}) > loop.times.most for n in ends or (0,)):
            yield "a loop of its pictures has more steps than it says"
    for level in pictures.levels_of:
        if level.param not in params or level.launch >= len(pictures.launches):
            yield "a level of its pictures names a parameter or a launch that does not exist"


def _text_faults(container: Container) -> Iterator[str]:
    """Yield which texts contain a lone surrogate, which cannot be stored as UTF-8."""
    for place, text in (
        ("its program's source", "".join(container.source_lines)),
        ("a note", "".join(note_text for note in container.notes.items() for note_text in note)),
    ):
        if any("\ud800" <= c <= "\udfff" for c in text):
            yield f"{place} holds half a character (a lone surrogate)"


def _within(indices: np.ndarray[tuple[int, ...], np.dtype[np.int32]], count: int) -> bool:
    """Return whether all indices are from 0 to `count` - 1; True if there are none."""
    return bool(indices.size == 0 or (indices.min() >= 0 and indices.max() < count))
