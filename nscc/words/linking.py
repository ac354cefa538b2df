"""Linking of a draft to a container: resolves names, checks indices and sizes."""

from __future__ import annotations

from base64 import b64decode
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np

from nscc.arrays import Array, Bools, Ints32
from nscc.chips.load import DEFAULT_NAME, load_target, parse_target
from nscc.chips.target import Target
from nscc.codec import from_json
from nscc.diagnostics.diagnostic import Label, Rejected
from nscc.diagnostics.suggest import meant
from nscc.source import Span
from nscc.words.assembly_text import read_integer, read_slots
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.directives import Draft, Faults, Token, shown
from nscc.words.legality import target_fault
from nscc.words.pictures import Pictures
from nscc.words.plane_files import codes_of_planes, read_planes
from nscc.words.soundness import faults as container_faults
from nscc.words.stored_machine import with_machine_data

MOST_TABLE_CELLS = 1 << 28
"""Most shutters x buckets x slots of one text (a byte each)."""

_DEFAULT_BUCKET = "frame"
_START = Span(0, 0)
NO_TABLE = {"table": "none"}
"""The note of a container with register contents of pixels but without a decode table."""


def link(draft: Draft, base: Path, faults: Faults) -> Container:
    """Return the container (a compiled program) of an assembly text's draft; files are relative to
    `base`.

    Raises Rejected with all errors, including those already in `faults`. If a group of checks finds
    errors, later groups are left out."""
    target = find_target(draft, base, faults)
    if target is None:
        faults.stop()
        raise AssertionError("a target was refused without a fault")
    check_instructions(draft, target, faults)
    _check_complete(draft, faults)
    # Without `.buckets`, the buckets are those that readouts name, or a single one.
    if draft.buckets:
        buckets = tuple(_indexed(draft.buckets, "bucket", faults))
    else:
        named = (readout.bucket.text for readout in draft.readouts if readout.bucket)
        buckets = tuple(dict.fromkeys(named)) or (_DEFAULT_BUCKET,)
    launches = _launches(draft, faults)
    readouts = _readouts(draft, target, buckets, faults)
    registers = {name: i for i, name in enumerate(target.digital_registers)}
    for token in draft.load:
        _find(token, registers, "digital register", faults)
    load = tuple(_indexed(draft.load, "register", faults))
    faults.stop()  # the following steps need valid sizes

    notes = dict(draft.notes)
    # Register contents are defined by shutters and codes, or by bit planes, but not by both.
    if draft.shutters or draft.codes:
        table, encoding = _table(draft, target, buckets, faults)
        pixels = _pixels(draft, target, len(table.codes), faults)
        message = (
            ".plane and .shutter both define the contents of the registers: use only one of them"
        )
        helps = ("remove the `.plane` lines, or all of `.shutter`, `.code` and `.pixels`",)
        for plane in draft.planes:
            faults.add("NS0719", message, plane.register.span, helps=helps)
    else:
        table, encoding, pixels, load = _table_of_planes(draft, target, base, load, buckets, faults)
        notes |= NO_TABLE
    faults.stop()
    container = Container(
        target=target,
        slot_us=tuple(draft.slot_us),
        buckets=buckets,
        table=table,
        kernels=tuple(
            StoredKernel(
                kernel.name.text, tuple(word for line in kernel.lines for word in line.words)
            )
            for kernel in draft.kernels
        ),
        launches=launches,
        code_registers=load,
        encoding=encoding,
        pixel_codes=pixels,
        readouts=readouts,
        source_lines=tuple(text for text, _ in draft.source.lines) if draft.source else (),
        notes=notes,
    )
    container = _with_blocks(container, draft, faults)
    for fault_text in container_faults(container):
        faults.add("NS0707", f"this text is inconsistent: {fault_text}", _START)
    faults.stop()
    return container


def _with_blocks(container: Container, draft: Draft, faults: Faults) -> Container:
    """Return the container (a compiled program) with the state machine and the images that the text
    contains as base64; unchanged without such blocks.

    Raises Rejected (NS0714) if such data are damaged or do not match the program, with all errors
    so far."""
    for block, add in (
        (draft.machine, with_machine_data),
        (draft.pictures, lambda c, data: replace(c, pictures=from_json(Pictures, data))),
    ):
        if block is not None:
            try:
                data = b64decode("".join(line for line, _ in block.lines), validate=True)
                container = add(container, data)
            except ValueError as error:
                name = block.directive
                message = f"the lines below are not the {name.text[1:]} of this program: {error}"
                helps = ("write the text again with `nscc disasm`: only nscc makes this block",)
                faults.add("NS0714", message, name.span, helps=helps)
    faults.stop()
    return container


def find_target(draft: Draft, base: Path, faults: Faults) -> Target | None:
    """Return the target that the text names or contains, by default scamp5; None after reporting an
    error.

    `base` is the folder of target files. Raises Rejected if such a file cannot be read and no other
    error was reported."""
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
            diagnostics = [
                replace(d, source=faults.source, label=place) for d in rejected.diagnostics
            ]
            faults.found.extend(diagnostics)
            return None
        # A file that cannot be read keeps its own exit status, unless the text has errors too.
        if rejected.status != 1 and not faults.found:
            raise
        faults.found.extend(rejected.diagnostics)
        return None


def check_instructions(draft: Draft, target: Target, faults: Faults) -> None:
    """Report each instruction that the target does not have (NS0708), and kernels (lists of words)
    that exceed its store (NS0718).

    Words that are given as integers (`.word`) are not checked here."""
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
        message = f"{have}, but {target.name} stores {target.store_words}"
        helps = ("put repeated words into one kernel and launch it several times",)
        faults.add("NS0718", message, draft.kernels[-1].name.span, helps=helps)


def _check_complete(draft: Draft, faults: Faults) -> None:
    """Report (NS0715) if the draft has no slot lengths, and if it has no readout."""
    if not draft.slot_us:
        helps = ("write `.wait 125us x64`: 64 slots of 125 us each",)
        faults.add("NS0715", "the lengths of the slots are missing", _START, helps=helps)
    if not draft.readouts:
        helps = ("write `.readout A frame`: register A holds the exposure",)
        faults.add("NS0715", "`.readout` is missing", _START, helps=helps)


def _find(token: Token, names: dict[str, int], kind: str, faults: Faults) -> int:
    """Return the index that `names` has for the name `token`; report an unknown name (NS0719) and
    return 0.

    `kind` names in the message what is looked for, such as "bucket"."""
    index = names.get(token.text)
    if index is not None:
        return index
    helps = meant(token.text, names, f"defined are: {', '.join(list(names)[:12]) or 'none'}")
    faults.add("NS0719", f"undefined {kind} {shown(token.text)}", token.span, helps=helps)
    return 0


def _indexed(tokens: list[Token], kind: str, faults: Faults) -> dict[str, int]:
    """Return the index of each of the names `tokens`, in order.

    A name that occurs twice is reported in `faults` (NS0719), and gets no second index. `kind`
    names in the message what is defined, such as "bucket"."""
    names: dict[str, int] = {}
    for token in tokens:
        if token.text in names:
            message = f"the {kind} {shown(token.text)} is defined twice"
            helps = ("give each a name of its own, or remove the second",)
            faults.add("NS0719", message, token.span, helps=helps)
        names.setdefault(token.text, len(names))
    return names


def _launches(draft: Draft, faults: Faults) -> tuple[Launch, ...]:
    """Return the starts of kernels (lists of words) that the draft's `.slot` lines state, by
    boundary, and at one boundary in the order of the text.

    Unknown kernels and boundaries beyond the frame are reported in `faults`; after an error the
    result must not be used."""
    kernels = {kernel.name.text: i for i, kernel in enumerate(draft.kernels)}
    at_instant: dict[int, list[int]] = {}
    slots = len(draft.slot_us)
    for line in draft.slots:
        sequence = [_find(name, kernels, "kernel", faults) for name in line.kernels]
        if slots and any(instant_range[-1] > slots for instant_range in line.instants):
            text = shown(line.range_token.text)
            message = f"{text} extends beyond instant {slots}, the end of the frame"
            helps = (f".wait gives {slots} slots, so kernels run at instants 0 to {slots}",)
            faults.add("NS0714", message, line.range_token.span, helps=helps)
            continue
        for instant_range in line.instants:
            for instant in instant_range:
                at_instant.setdefault(instant, []).extend(sequence)
    return tuple(
        Launch(instant, kernel) for instant in sorted(at_instant) for kernel in at_instant[instant]
    )


def _readouts(
    draft: Draft, target: Target, buckets: tuple[str, ...], faults: Faults
) -> tuple[Readout, ...]:
    """Return the readouts of the draft, in the order of the text; `buckets` are the names of all
    buckets.

    Unknown registers and buckets, and a bucket that is not read exactly once, are reported in
    `faults`; after an error the result must not be used."""
    registers = {name: i for i, name in enumerate(target.analog_registers)}
    known = {name: i for i, name in enumerate(buckets)}
    readouts, read = [], set()
    listed_buckets = f"the buckets are {', '.join(buckets)}"
    for line in draft.readouts:
        _find(line.register, registers, "analog register", faults)
        place = line.bucket or line.register
        if line.bucket is not None:
            bucket = buckets[_find(line.bucket, known, "bucket", faults)]
        else:
            bucket = buckets[0]
            if len(buckets) > 1:
                helps = (f"write `.readout {place.text} {bucket}`; {listed_buckets}",)
                faults.add("NS0714", "this readout must name its bucket", place.span, helps=helps)
        if bucket in read:
            message = f"the bucket {shown(bucket)} is read out twice"
            helps = (f"read each bucket once; {listed_buckets}",)
            faults.add("NS0719", message, place.span, helps=helps)
        read.add(bucket)
        readouts.append(Readout(line.register.text, bucket, line.gain))
    for token in draft.buckets:
        if token.text not in read and draft.readouts:
            message = f"the bucket {shown(token.text)} is not read out"
            helps = (f"write `.readout REGISTER {token.text}`, or remove it from `.bucket`",)
            faults.add("NS0715", message, token.span, helps=helps)
    return tuple(readouts)


def _table_of_planes(
    draft: Draft,
    target: Target,
    base: Path,
    load: tuple[str, ...],
    buckets: tuple[str, ...],
    faults: Faults,
) -> tuple[DecodeTable, Bools, Ints32 | None, tuple[str, ...]]:
    """Return a decode table for a program of which only the bit planes of registers are known.

    No shutter of it is open. The results are table, encoding, pixel codes and registers in loading
    order, as in `Container`. Each distinct content of the registers is a code; without planes there
    is one, and no pixel codes. `load` are the registers of `.load`, () without it. By default the
    masked register is loaded first, before the plane of its mask forbids it. Raises Rejected if a
    plane's file has errors."""
    planes = read_planes(draft.planes, target, base, faults)
    faults.stop()
    if load and set(load) != set(planes):
        message = "without a decode table, .load names exactly the registers with a .plane"
        helps = (f"write `.load {' '.join(planes)}`, or leave .load out",)
        faults.add("NS0715", message, draft.load[0].span, helps=helps)
    if draft.pixels is not None:
        span = draft.pixels.directive.span
        helps = ("write `.code` and `.shutter` lines, or remove .pixels",)
        faults.add("NS0715", ".pixels needs codes, but .code is missing", span, helps=helps)
    encoding, pixels = codes_of_planes(planes, target)
    codes = len(encoding)
    table = DecodeTable(
        fields=("code",) if planes else (),
        codes=np.arange(codes, dtype=np.int64)[:, None] if planes else np.zeros((1, 0), np.int64),
        shutter_of_code=np.arange(codes, dtype=np.int32),
        shutters=np.zeros((codes, len(buckets), len(draft.slot_us)), dtype=np.bool_),
    )
    order = load or tuple(sorted(planes, key=lambda name: name != target.masked_register))
    return table, encoding, pixels, order


def _table(
    draft: Draft, target: Target, buckets: tuple[str, ...], faults: Faults
) -> tuple[DecodeTable, Bools]:
    """Return the decode table, and the register bits of each shutter, bool (shutters, registers).

    They come from the `.shutter` and `.code` lines of the draft. Errors (NS0714, NS0715, NS0719)
    are reported; the result must then not be used. Raises Rejected for a table that is too large.
    """
    shutters, slots = len(draft.shutters), len(draft.slot_us)
    fields = tuple(_indexed(draft.fields, "field", faults))
    for lines, name in ((draft.shutters, ".shutter"), (draft.codes, ".code")):
        if not lines:
            span = (draft.codes or draft.shutters)[0][0].span
            helps = (f"write a `{name}` line: shutters and codes only count together",)
            faults.add("NS0715", f"the decode table has no {name}", span, helps=helps)
    if shutters * len(buckets) * slots > MOST_TABLE_CELLS:
        message = f"{shutters} shutters of {slots} slots exceed the size of a table"
        helps = (
            f"shutters x buckets x slots are at most {MOST_TABLE_CELLS:,}: use fewer shutters",
        )
        faults.add("NS0714", message, draft.shutters[0][0].span, helps=helps)
        faults.stop()
    opened = np.zeros((shutters, len(buckets), slots), dtype=np.bool_)
    registers = len(target.digital_registers)
    encoding = np.zeros((shutters, registers), dtype=np.bool_)
    for row, (bits, *slot_tokens) in enumerate(draft.shutters):
        # Without registers, `-` stands for no digits.
        digits = bits.text if registers else bits.text.replace("-", "", 1)
        if len(digits) != registers or digits.strip("01"):
            message = f"{shown(bits.text)} is not {registers} digits 0 or 1"
            helps = (f"write a digit for each of {', '.join(target.digital_registers) or 'none'}",)
            faults.add("NS0714", message, bits.span, helps=helps)
        else:
            encoding[row] = [digit == "1" for digit in digits]
        if len(slot_tokens) != len(buckets):
            message = (
                f"a shutter has slots for each of {len(buckets)} buckets, not {len(slot_tokens)}"
            )
            helps = (f"write one set of slots for each bucket: {', '.join(buckets)}",)
            faults.add("NS0714", message, bits.span, helps=helps)
            continue
        for bucket, token in enumerate(slot_tokens):
            open_slots = read_slots(token.text, slots)
            if open_slots is None:
                message = f"{shown(token.text)} is not a valid set of slots in 0..{slots - 1}"
                helps = ("write `0..15,20`, `1..63/2`, `never`, or `x` and hexadecimal",)
                faults.add("NS0714", message, token.span, helps=helps)
            else:
                opened[row, bucket] = open_slots
    codes = np.zeros((len(draft.codes), len(fields)), dtype=np.int64)
    shutter_of_code = np.zeros(len(draft.codes), dtype=np.int32)
    for row, tokens in enumerate(draft.codes):
        # The number of the shutter, then the values of the fields; None is no integer.
        read = [read_integer(token.text) for token in tokens]
        values = [value for value in read if value is not None]
        if not len(values) == len(read) == 1 + len(fields):
            message = f"a code consists of a shutter and {len(fields)} values, all integers"
            helps = (f"write `{' '.join(['.code', 'SHUTTER', *fields])}`",)
            faults.add("NS0714", message, tokens[0].span, helps=helps)
        elif not 0 <= values[0] < shutters:
            message = f"unknown shutter {shown(tokens[0].text)}: there are {shutters} shutters"
            helps = (f"write a number from 0 to {shutters - 1}, in the order of `.shutter`",)
            faults.add("NS0714", message, tokens[0].span, helps=helps)
        else:
            shutter_of_code[row] = values[0]
            codes[row] = values[1:]
    return DecodeTable(fields, codes, shutter_of_code, opened), encoding


def _pixels(draft: Draft, target: Target, codes: int, faults: Faults) -> Ints32 | None:
    """Return the code of every pixel, int32 (rows, cols), from the `.pixels` block of the draft: a
    tile or the whole array.

    A tile is repeated, and cut at the ends of the array. Return None without such a block, and
    after reporting an error (NS0714) in `faults`. `codes` is the number of codes."""
    block = draft.pixels
    if block is None:
        return None
    span = block.directive.span
    form, rows, cols = block.arguments[0].text, *(int(token.text) for token in block.arguments[1:])
    texts = [text for text, _ in block.lines]
    values: Array | None = None
    with suppress(ValueError):
        if form == "tile":
            integers = [read_integer(item) for text in texts for item in text.split()]
            values = np.array(integers, np.int64) if None not in integers else None
        else:
            values = np.frombuffer(b64decode("".join(texts), validate=True), dtype="<i4")
    if values is None or values.size != rows * cols:
        needs = "integers between blanks" if form == "tile" else "base64 of int32"
        message = f"the lines below are not {rows} x {cols} codes"
        advice = f"write {rows * cols} {needs}, each line after a bar `|`"
    elif (
        rows > target.rows
        or cols > target.cols
        or (form == "plane" and (rows, cols) != (target.rows, target.cols))
    ):
        message = f"{rows} x {cols} does not match {target.name}: {target.rows} x {target.cols}"
        advice = "a plane has the size of the array, a tile at most this size"
    elif values.min() < 0 or values.max() >= codes:
        message = f"the code of a pixel is not one of the {codes} codes"
        advice = f"write numbers from 0 to {codes - 1}, in the order of `.code`"
    else:
        repeats = (-(-target.rows // rows), -(-target.cols // cols))  # rounded up, then cut
        tiled = np.tile(values.reshape(rows, cols).astype(np.int32), repeats)
        return np.ascontiguousarray(tiled[: target.rows, : target.cols])
    faults.add("NS0714", message, span, helps=(advice,))
    return None
