"""Conversion of a container to assembly text; `nscc.words.assembly` gives the same container again.

First come the parts for readers (source, kernels, schedule), then the data: decode table, encoding,
pixel codes."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence

from nscc.chips.load import builtin_names, builtin_target, target_toml
from nscc.chips.target import Target
from nscc.codec import to_json
from nscc.operations import Op, Phase, Word
from nscc.words.assembly_text import (
    base64_lines,
    block_text,
    name_text,
    number_text,
    ranges_text,
    slots_text,
)
from nscc.words.container import Container, StoredKernel, tile_of
from nscc.words.cost import frame_cost, kernel_cost
from nscc.words.encoding import matching, word_text
from nscc.words.legality import pair_kind, refuse_planes, target_fault
from nscc.words.machine import LIGHT
from nscc.words.stored_machine import machine_data

_COMMENT_COLUMN = 40
"""Column of the comments."""
_LARGEST_TILE = 64 * 64
"""Most pixels of a repeated tile that is written as numbers instead of base64."""
_TIMES_A_LINE = 8
"""Most slot times in a line."""


def disassemble(container: Container) -> str:
    """Return the complete container (a compiled program) as assembly text.

    Raises Rejected (NS0510) if it has no words, because its chip has no logic."""
    refuse_planes(
        container.target,
        "this container has no words to disassemble",
        "`nscc build --emit planes,schedule` writes its bit planes and their times",
    )
    parts = sections(container).values()
    return "\n\n".join("\n".join(lines) for lines in parts if lines) + "\n"


def sections(container: Container) -> dict[str, list[str]]:
    """Return the lines of each part of the assembly text by the part's title, in the order of the
    text.

    A part that the container (a compiled program) does not need has no lines."""
    kernels, lines = enumerate(container.kernels), container.source_lines
    parts: dict[str, Iterable[str]] = {
        "target": _head(container),
        "source": [".source", *block_text(lines)] if lines else [],
        "slots": _times(container.slot_us),
        **{f"kernel {kernel.name}": _kernel(container, number) for number, kernel in kernels},
        "schedule": _schedule(container),
        "readouts": _readouts(container),
        "codes": _table(container),
        "machine": _machine(container),
        "pictures": _pictures(container),
        "pixels": _pixels(container),
    }
    return {title: list(lines) for title, lines in parts.items()}


def instruction_lines(words: Sequence[Word], target: Target) -> list[tuple[int, str, str]]:
    """Return the lines of a kernel (a list of words) as (index of the first word, instruction,
    comment or "").

    Two words that form one instruction are one line. A word without an instruction on this target
    becomes `.word` and its five integers, with the reason as comment."""
    lines: list[tuple[int, str, str]] = []
    ops = [matching(word, target.words) for word in words]
    faults: dict[Op, str | None] = {op: target_fault(op, target) for op in ops if op is not None}
    index = 0
    while index < len(words):
        operation = ops[index]
        following = ops[index + 1] if index + 1 < len(words) else None
        text, comment, count = f".word {word_text(words[index])}", "", 1
        if operation is None:
            comment = "matches no operation"
        elif faults[operation] is not None:
            comment = f"{operation}: {faults[operation]}"
        elif operation.operation.phase is Phase.WHOLE:
            text = str(operation)
        elif in_place := _pair(operation, following):
            text, count = in_place, 2
        else:
            comment = f"half of a pair: {operation}"
        lines.append((index, text, comment))
        index += count
    return lines


def _pair(first: Op, second: Op | None) -> str | None:
    """Return the instruction, such as `NOR d, x`, that two words form; None if they form none, or
    if there is no second word.

    The first word reads registers, the second writes the result to one of them."""
    kind = pair_kind(first, second) if second is not None else None
    if kind is None or second is None:
        return None
    (destination,) = second.destinations
    if destination not in first.sources:
        return None
    other_sources = [register for register in first.sources if register != destination]
    # The NOR of a register alone is its NOT.
    if kind == "REFRESH" or (kind == "NOR" and not other_sources):
        return f"{'NOT' if kind == 'NOR' else kind} {destination}"
    if len(other_sources) != 1:
        # `OR d, d, x, y`: with two or more other sources, the destination is also written as a
        # source.
        other_sources.insert(0, destination)
    return f"{kind} {', '.join((destination, *other_sources))}"


def _commented(text: str, comment: str) -> str:
    """Return a line with a comment to its right, from column `_COMMENT_COLUMN` on; without one, the
    line."""
    return f"{text:<{_COMMENT_COLUMN}} ; {comment}" if comment else text


def _head(container: Container) -> Iterator[str]:
    """Yield the first lines: costs as two comments, the target, and notes by key.

    A built-in target is named; any other is written out as a table."""
    cost, target = frame_cost(container), container.target
    slots = _counted(container.slots, "slot")
    yield f"; {slots}, {number_text(round(cost.frame_us, 3))} us of light a frame"
    yield (
        f"; {_counted(cost.stored_words, 'word')} stored in "
        f"{_counted(len(container.kernels), 'kernel')}; {cost.words} executed a frame in "
        f"{_counted(cost.launches, 'launch', 'launches')}, {cost.busy_us:.4g} us"
    )
    if target.name in builtin_names() and target == builtin_target(target.name):
        yield f".target {name_text(target.name)}"
    else:
        yield ".target"
        yield from block_text(target_toml(target).rstrip("\n").split("\n"))
    for key in sorted(container.notes):
        yield f".note {name_text(key)} {json.dumps(container.notes[key])}"


def _counted(count: int, word: str, plural: str = "") -> str:
    """Return a number with its word, such as `1 word`, `2 words`; `plural` is for words that do not
    only add an s."""
    return f"{count} {word if count == 1 else plural or word + 's'}"


def _times(slot_us: Sequence[float]) -> Iterator[str]:
    """Yield the `.wait` lines of the slots' lengths; equal slots in a row are written as `125us
    x64`."""
    first, pending = 0, ""
    for index in range(1, len(slot_us) + 1):
        if index < len(slot_us) and slot_us[index] == slot_us[first]:
            continue
        item = f"{number_text(slot_us[first])}us" + (
            f" x{index - first}" if index - first > 1 else ""
        )
        pending = f"{pending} {item}" if pending else f".wait {item}"
        if pending.count(" ") >= _TIMES_A_LINE or index == len(slot_us):
            yield pending
            pending = ""
        first = index


def _kernel(container: Container, number: int) -> Iterator[str]:
    """Yield the lines of the kernel (list of words) with the index `number`.

    Comments give its cost and the boundaries at which it starts."""
    kernel: StoredKernel = container.kernels[number]
    instants = [launch.instant for launch in container.launches if launch.kernel == number]
    instants_text = ranges_text(sorted(set(instants))) if instants else "nowhere"
    # It is a comment, and may be cut; `.slot` lines have the boundaries.
    if len(instants_text) > 60:
        instants_text = instants_text[:56] + " ..."
    cost = kernel_cost(kernel, container.target)
    comment = f"{_counted(cost.words, 'word')}, {cost.us:.4g} us; launched at {instants_text}"
    yield _commented(f".kernel {name_text(kernel.name)}", comment)
    for _, text, remark in instruction_lines(kernel.words, container.target):
        yield _commented(f"    {text}", remark)


def _schedule(container: Container) -> Iterator[str]:
    """Yield a `.slot` line for each different list of kernels (lists of words), with all boundaries
    at which it runs; nothing without launches (starts of kernels)."""
    at_instant: dict[int, list[int]] = {}
    for launch in container.launches:
        at_instant.setdefault(launch.instant, []).append(launch.kernel)
    instants_of: dict[tuple[int, ...], list[int]] = {}
    for instant, kernels in at_instant.items():
        instants_of.setdefault(tuple(kernels), []).append(instant)
    for sequence, instants in instants_of.items():
        names = " ".join(name_text(container.kernels[kernel].name) for kernel in sequence)
        yield f".slot {ranges_text(instants)} {names}"


def _readouts(container: Container) -> Iterator[str]:
    """Yield the line with the names of buckets, and a line for each readout: its register, its
    bucket and its gain."""
    yield f".bucket {' '.join(map(name_text, container.buckets))}"
    for readout in container.readouts:
        bucket = name_text(readout.bucket)
        yield f".readout {readout.register} {bucket} {number_text(readout.gain)}"


def _table(container: Container) -> Iterator[str]:
    """Yield the lines of the decode table: the registers in loading order, the fields, register
    bits and open slots of each shutter, then each code."""
    table, registers = container.table, container.target.digital_registers
    if container.code_registers:
        yield f".load {' '.join(container.code_registers)}"
    if table.fields:
        yield f".fields {' '.join(map(name_text, table.fields))}"
    span = f"{registers[0]}..{registers[-1]}" if registers else "no register"
    yield f"; a line a shutter: {span} at the start of a frame, then the open slots of each bucket"
    for row, (bits, buckets) in enumerate(zip(container.encoding, table.shutters, strict=True)):
        digits = "".join("1" if bit else "0" for bit in bits) or "-"
        slots = " ".join(slots_text(bucket) for bucket in buckets)
        yield _commented(f".shutter {digits} {slots}", str(row))
    yield "; a line a code: its shutter, then its fields"
    for shutter, values in zip(table.shutter_of_code.tolist(), table.codes.tolist(), strict=True):
        yield " ".join([f".code {shutter}", *map(str, values)])


def _machine(container: Container) -> Iterator[str]:
    """Yield the comparisons of pixels that look as comments, then their state machine and the
    levels of IN (the level sent to all pixels) as base64.

    Yield nothing for other programs."""
    machine, step_e = container.machine, container.target.electrons_per_step
    if not machine.stages:
        return
    for comparison in machine.comparisons:
        signal = (
            "light"
            if comparison.signal == LIGHT
            else f"exposure {container.buckets[comparison.signal]}"
        )
        level = f"{comparison.level} steps of IN, {comparison.level * step_e:.6g} e"
        yield f"; at boundary {comparison.boundary}: {signal} above {level}"
    yield ".machine"
    yield from base64_lines(machine_data(container))


def _pictures(container: Container) -> Iterator[str]:
    """Yield the words of images and planes as comments, then all about them as base64.

    Yield nothing for programs without images and planes."""
    pictures, target = container.pictures, container.target
    if not pictures.outputs:
        return
    yield "; images and planes: these words follow the last slot's"
    of_params = {level.launch: f"{level.factor:+d} * {level.param}" for level in pictures.levels_of}
    loops = {loop.first: loop for loop in pictures.loops}
    for number, launch in enumerate(pictures.launches):
        steps = of_params.get(number, launch.level)
        level = "" if steps is None else f", IN at {steps}"
        if number in loops:
            times = loops[number].times
            of_param = f" {times.factor:+d} * {times.param}" if times.param else ""
            count = f"{times.offset}{of_param} times"
            yield f"; {count}: the next {loops[number].launches} kernels"
        yield f"; kernel {launch.kernel}{level}"
        for word in pictures.kernels[launch.kernel]:
            yield f";     {matching(word, target.words) or word_text(word)}"
    for name, register in pictures.registers.items():
        yield f"; {register} holds {name}"
    yield ".pictures"
    yield from base64_lines(to_json(pictures).encode("ascii"))


def _pixels(container: Container) -> Iterator[str]:
    """Yield the code of every pixel: the smallest tile that gives the array if it has at most
    `_LARGEST_TILE` pixels, else all codes as base64.

    Yield nothing without pixel codes."""
    codes = container.pixel_codes
    if codes is None:
        return
    yield "; the code of every pixel"
    rows, cols = tile_of(codes)
    if rows * cols <= _LARGEST_TILE:
        yield f".pixels tile {rows} {cols}"
        for row in codes[:rows, :cols].tolist():
            yield "| " + " ".join(map(str, row))
        return
    yield f".pixels plane {codes.shape[0]} {codes.shape[1]}"
    yield from base64_lines(codes.astype("<i4").tobytes())
