"""A draft put together: names resolved, indices and sizes checked, a container made."""

from __future__ import annotations

from base64 import b64decode
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.chips.load import DEFAULT_NAME, load_target, parse_target
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label, Rejected
from nscc.diagnostics.suggest import meant
from nscc.source import Span
from nscc.words import machine_file, pictures_file
from nscc.words.container import Container, DecodeTable, Kernel, Launch, Readout
from nscc.words.draft import Draft, Faults, Token, shown
from nscc.words.legality import target_fault
from nscc.words.machine import Machine, StatePlanes
from nscc.words.pictures import Pictures
from nscc.words.planes import codes_of_planes, read_planes
from nscc.words.soundness import faults as container_faults
from nscc.words.text import read_integer, read_slots

MOST_TABLE_CELLS = 1 << 28
"""Shutters times buckets times slots that one text may ask for (a byte each)."""

_DEFAULT_BUCKET = "frame"
_START = Span(0, 0)
NO_TABLE = {"table": "none"}
"""The note of a container that says what pixels hold, and not what it means."""


def link(draft: Draft, base: Path, faults: Faults) -> Container:
    """The container of a draft. Raises Rejected with everything found, `faults` included."""
    target = find_target(draft, base, faults)
    if target is None:
        faults.stop()
        raise AssertionError("a target was refused without a fault")
    check_instructions(draft, target, faults)
    _check_complete(draft, faults)
    buckets = _buckets(draft, faults)
    launches = _launches(draft, faults)
    readouts = _readouts(draft, target, buckets, faults)
    load = _load(draft, target, faults)
    faults.stop()  # what follows needs sizes that hold

    notes = dict(draft.notes)
    if draft.shutters or draft.codes:
        table, encoding = _table(draft, target, buckets, faults)
        pixels = _pixels(draft, target, len(table.codes), faults)
        message = ".plane and .shutter both say what pixels hold: a text has one or the other"
        for plane in draft.planes:
            faults.add("NS0719", message, plane.register.span)
    else:
        planes = read_planes(draft.planes, target, base, faults)
        faults.stop()
        load = _loading_order(draft, tuple(planes), load, target, faults)
        encoding, pixels = codes_of_planes(planes, target)
        table = _empty_table(len(encoding), len(buckets), len(draft.slot_us), bool(planes))
        notes |= NO_TABLE
        if draft.pixels is not None:
            span = draft.pixels.directive.span
            faults.add("NS0715", ".pixels names codes, and there is no .code", span)
    machine: Machine | None = None
    state_planes: dict[str, StatePlanes] = {}
    if draft.machine is not None:
        text = "".join(line for line, _ in draft.machine.lines)
        read = machine_file.from_text(text, len(buckets), len(draft.slot_us), len(launches))
        if read is None:
            message = "the lines below are no machine of this program"
            faults.add("NS0714", message, draft.machine.directive.span)
        else:
            machine, state_planes, levels = read
            pairs = zip(launches, levels, strict=True)
            launches = tuple(replace(launch, level=level) for launch, level in pairs)
    pictures: Pictures | None = None
    if draft.pictures is not None:
        pictures = pictures_file.from_text("".join(line for line, _ in draft.pictures.lines))
        if pictures is None:
            message = "the lines below are no images and planes"
            faults.add("NS0714", message, draft.pictures.directive.span)
    faults.stop()
    container = Container(
        target=target,
        slot_us=tuple(draft.slot_us),
        buckets=buckets,
        table=table,
        kernels=tuple(
            Kernel(kernel.name.text, tuple(word for line in kernel.lines for word in line.words))
            for kernel in draft.kernels
        ),
        launches=launches,
        code_registers=load,
        encoding=encoding,
        pixel_codes=pixels,
        readouts=readouts,
        source_lines=tuple(text for text, _ in draft.source.lines) if draft.source else (),
        notes=notes,
        machine=machine,
        state_planes=state_planes,
        pictures=pictures,
    )
    for wrong in container_faults(container):
        faults.add("NS0707", f"what this text describes makes no sense: {wrong}", _START)
    faults.stop()
    return container


def find_target(draft: Draft, base: Path, faults: Faults) -> Target | None:
    """The target that the text names, scamp5 if it names none; None if it is at fault."""
    block = draft.target
    if block is None:
        return load_target(DEFAULT_NAME, base)
    try:
        if block.arguments:
            name = block.arguments[0]
            return load_target(name.text, base, source=faults.source, span=name.span)
        text = "\n".join(line for line, _ in block.lines)
        return parse_target(text.encode("utf-8", "replace"), faults.source.name)
    except Rejected as rejected:
        if not block.arguments:
            place = Label(block.directive.span, "the target below")
            found = [replace(d, source=faults.source, label=place) for d in rejected.diagnostics]
            faults.found.extend(found)
            return None
        if rejected.status != 1 and not faults.found:
            raise
        faults.found.extend(rejected.diagnostics)
        return None


def check_instructions(draft: Draft, target: Target, faults: Faults) -> None:
    """Note instructions that the target does not take, and kernels that overfill its store."""
    stored = 0
    for kernel in draft.kernels:
        for line in kernel.lines:
            stored += len(line.words)
            for operation in line.ops:
                fault = target_fault(operation, target)
                if fault is not None:
                    helps = (f"`nscc targets {target.name}` lists what the chip has",)
                    message = f"{target.name} cannot run this: {fault}"
                    faults.add("NS0708", message, line.span, helps=helps)
                    break
    if target.tables_count_against_store and stored > target.store_words:
        have = f"these kernels have {stored} words"
        message = f"{have}, and {target.name} stores {target.store_words}"
        helps = ("words that repeat belong in one kernel that is launched several times",)
        faults.add("NS0718", message, draft.kernels[-1].name.span, helps=helps)


def _check_complete(draft: Draft, faults: Faults) -> None:
    if not draft.slot_us:
        helps = ("write `.wait 125us x64`: 64 slots of 125 us each",)
        faults.add("NS0715", "the lengths of the slots are missing", _START, helps=helps)
    if not draft.readouts:
        helps = ("write `.readout A frame`: register A holds the exposure",)
        faults.add("NS0715", "nothing is read out", _START, helps=helps)


def _find(token: Token, names: dict[str, int], what: str, faults: Faults) -> int:
    """The index of a name; notes a fault and gives 0 where it is not known."""
    index = names.get(token.text)
    if index is not None:
        return index
    helps = meant(token.text, names, f"there are: {', '.join(list(names)[:12]) or 'none'}")
    faults.add("NS0719", f"there is no {what} {shown(token.text)}", token.span, helps=helps)
    return 0


def _indexed(tokens: list[Token], what: str, faults: Faults) -> dict[str, int]:
    names: dict[str, int] = {}
    for token in tokens:
        if token.text in names:
            faults.add("NS0719", f"the {what} {shown(token.text)} stands twice", token.span)
        names.setdefault(token.text, len(names))
    return names


def _buckets(draft: Draft, faults: Faults) -> tuple[str, ...]:
    """The buckets that `.bucket` lists; without it those of the readouts, or `frame`."""
    if draft.buckets:
        return tuple(_indexed(draft.buckets, "bucket", faults))
    named = [readout.bucket.text for readout in draft.readouts if readout.bucket]
    return tuple(dict.fromkeys(named)) or (_DEFAULT_BUCKET,)


def _launches(draft: Draft, faults: Faults) -> tuple[Launch, ...]:
    """All launches, by instant and then in the order of the text."""
    kernels = {kernel.name.text: i for i, kernel in enumerate(draft.kernels)}
    at_instant: dict[int, list[int]] = {}
    slots = len(draft.slot_us)
    for line in draft.slots:
        sequence = [_find(name, kernels, "kernel", faults) for name in line.kernels]
        if slots and any(part[-1] > slots for part in line.instants):
            message = f"{shown(line.place.text)} reaches beyond instant {slots}, the frame's end"
            helps = (f".wait gives {slots} slots, so kernels run at instants 0 to {slots}",)
            faults.add("NS0714", message, line.place.span, helps=helps)
            continue
        for part in line.instants:
            for instant in part:
                at_instant.setdefault(instant, []).extend(sequence)
    return tuple(
        Launch(instant, kernel) for instant in sorted(at_instant) for kernel in at_instant[instant]
    )


def _readouts(
    draft: Draft, target: Target, buckets: tuple[str, ...], faults: Faults
) -> tuple[Readout, ...]:
    registers = {name: i for i, name in enumerate(target.analog_registers)}
    known = {name: i for i, name in enumerate(buckets)}
    readouts, read = [], set()
    for line in draft.readouts:
        _find(line.register, registers, "analog register", faults)
        place = line.bucket or line.register
        if line.bucket is not None:
            bucket = buckets[_find(line.bucket, known, "bucket", faults)]
        else:
            bucket = buckets[0]
            if len(buckets) > 1:
                faults.add("NS0714", "this readout must say of which bucket it is", place.span)
        if bucket in read:
            faults.add("NS0719", f"the bucket {shown(bucket)} is read out twice", place.span)
        read.add(bucket)
        readouts.append(Readout(line.register.text, bucket, line.gain))
    for token in draft.buckets:
        if token.text not in read and draft.readouts:
            faults.add("NS0715", f"the bucket {shown(token.text)} is not read out", token.span)
    return tuple(readouts)


def _load(draft: Draft, target: Target, faults: Faults) -> tuple[str, ...]:
    registers = {name: i for i, name in enumerate(target.digital_registers)}
    for token in draft.load:
        _find(token, registers, "digital register", faults)
    return tuple(_indexed(draft.load, "register", faults))


def _loading_order(
    draft: Draft,
    planes: tuple[str, ...],
    wanted: tuple[str, ...],
    target: Target,
    faults: Faults,
) -> tuple[str, ...]:
    """The order of `.load`; without it the masked register first, for its mask must still be 1."""
    if wanted and set(wanted) != set(planes):
        message = "without a decode table .load names just the registers that have a .plane"
        faults.add("NS0715", message, draft.load[0].span)
    return wanted or tuple(sorted(planes, key=lambda name: name != target.masked_register))


def _empty_table(codes: int, buckets: int, slots: int, planes: bool) -> DecodeTable:
    """A table for pixels of which only the registers' contents are known: no slot is open.

    All codes share one shutter where nothing is loaded; else each is its own.
    """
    return DecodeTable(
        ("code",) if planes else (),
        np.arange(codes, dtype=np.int64)[:, None] if planes else np.zeros((1, 0), np.int64),
        np.arange(codes, dtype=np.int32),
        np.zeros((codes, buckets, slots), dtype=np.bool_),
    )


def _table(
    draft: Draft, target: Target, buckets: tuple[str, ...], faults: Faults
) -> tuple[DecodeTable, NDArray[np.bool_]]:
    """The decode table and the encoding that `.fields`, `.shutter` and `.code` lines give."""
    shutters, slots = len(draft.shutters), len(draft.slot_us)
    fields = tuple(_indexed(draft.fields, "field", faults))
    for lines, name in ((draft.shutters, ".shutter"), (draft.codes, ".code")):
        if not lines:
            place = (draft.codes or draft.shutters)[0][0].span
            faults.add("NS0715", f"the decode table has no {name}", place)
    if shutters * len(buckets) * slots > MOST_TABLE_CELLS:
        message = f"{shutters} shutters of {slots} slots are more than a table can hold"
        faults.add("NS0714", message, draft.shutters[0][0].span)
        faults.stop()
    opened = np.zeros((shutters, len(buckets), slots), dtype=np.bool_)
    registers = len(target.digital_registers)
    encoding = np.zeros((shutters, registers), dtype=np.bool_)
    for row, (bits, *parts) in enumerate(draft.shutters):
        digits = bits.text if registers else bits.text.replace("-", "", 1)
        if len(digits) != registers or digits.strip("01"):
            faults.add("NS0714", f"{shown(bits.text)} is not {registers} digits 0 or 1", bits.span)
        else:
            encoding[row] = [digit == "1" for digit in digits]
        if len(parts) != len(buckets):
            message = f"a shutter has slots for each of {len(buckets)} buckets, not {len(parts)}"
            faults.add("NS0714", message, bits.span)
            continue
        for bucket, token in enumerate(parts):
            found = read_slots(token.text, slots)
            if found is None:
                message = f"{shown(token.text)} are no slots of 0..{slots - 1}"
                helps = ("write `0..15,20`, `1..63/2`, `never`, or `x` and hexadecimal",)
                faults.add("NS0714", message, token.span, helps=helps)
            else:
                opened[row, bucket] = found
    codes = np.zeros((len(draft.codes), len(fields)), dtype=np.int64)
    shutter_of_code = np.zeros(len(draft.codes), dtype=np.int32)
    for row, tokens in enumerate(draft.codes):
        read = [read_integer(token.text) for token in tokens]
        values = [value for value in read if value is not None]
        if not len(values) == len(read) == 1 + len(fields):
            message = f"a code has a shutter and {len(fields)} values, all of them integers"
            faults.add("NS0714", message, tokens[0].span)
        elif not 0 <= values[0] < shutters:
            message = f"there is no shutter {shown(tokens[0].text)}, there are {shutters}"
            faults.add("NS0714", message, tokens[0].span)
        else:
            shutter_of_code[row] = values[0]
            codes[row] = values[1:]
    return DecodeTable(fields, codes, shutter_of_code, opened), encoding


def _pixels(draft: Draft, target: Target, codes: int, faults: Faults) -> NDArray[np.int32] | None:
    block = draft.pixels
    if block is None:
        return None
    place = block.directive.span
    form, rows, cols = block.arguments[0].text, *(int(token.text) for token in block.arguments[1:])
    values = _tile(block.lines) if form == "tile" else _plane(block.lines)
    if values is None or values.size != rows * cols:
        faults.add("NS0714", f"the lines below are not {rows} x {cols} codes", place)
        return None
    values = values.reshape(rows, cols)
    if rows > target.rows or cols > target.cols or (
        form == "plane" and values.shape != (target.rows, target.cols)
    ):  # fmt: skip
        message = f"{rows} x {cols} does not fit {target.name}: {target.rows} x {target.cols}"
        faults.add("NS0714", message, place)
        return None
    if values.min() < 0 or values.max() >= codes:
        faults.add("NS0714", f"a pixel holds a code that is not among the {codes}", place)
        return None
    repeats = (-(-target.rows // rows), -(-target.cols // cols))
    tiled = np.tile(values.astype(np.int32), repeats)
    return np.ascontiguousarray(tiled[: target.rows, : target.cols])


def _tile(lines: list[tuple[str, Span]]) -> NDArray[Any] | None:
    values = [read_integer(part) for text, _ in lines for part in text.split()]
    whole = [value for value in values if value is not None]
    return np.array(whole, dtype=np.int64) if len(whole) == len(values) else None


def _plane(lines: list[tuple[str, Span]]) -> NDArray[Any] | None:
    try:
        data = b64decode("".join(text for text, _ in lines), validate=True)
    except ValueError:
        return None
    return np.frombuffer(data, dtype="<i4") if len(data) % 4 == 0 else None
