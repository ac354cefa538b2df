"""The directives of assembly text, one function each: tokens of a line into the draft."""

from __future__ import annotations

import re
from collections.abc import Callable

from nscc.words.draft import (
    Block,
    Draft,
    Faults,
    Instruction,
    KernelDraft,
    PlaneDraft,
    ReadoutDraft,
    SlotDraft,
    Token,
    shown,
)
from nscc.words.soundness import MOST_SLOTS
from nscc.words.text import read_number, read_ranges, read_time_us

Directive = Callable[[list[Token], Draft, Faults], Block | None]

_REPEAT = re.compile(r"x([0-9]{1,9})")
_WORD = re.compile(r"0[xX][0-9a-fA-F]{1,8}|[0-9]{1,10}")
_LARGEST = 0xFFFF_FFFF


def _wrong(faults: Faults, token: Token, message: str, help_text: str) -> None:
    faults.add("NS0714", message, token.span, helps=(help_text,))


def _once(old: Block | None, tokens: list[Token], faults: Faults) -> Block:
    if old is not None:
        faults.add("NS0719", f"{tokens[0].text} stands twice", tokens[0].span)
    return Block(tokens[0], tuple(tokens[1:]))


def _target(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    if len(tokens) > 2:
        _wrong(faults, tokens[2], ".target takes one name", "write `.target scamp5`")
    draft.target = _once(draft.target, tokens, faults)
    return draft.target if len(tokens) == 1 else None


def _source(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    if len(tokens) > 1:
        _wrong(faults, tokens[1], ".source takes its text below", "write it behind bars: `| text`")
    draft.source = _once(draft.source, tokens, faults)
    return draft.source


def _pixels(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    draft.pixels = _once(draft.pixels, tokens, faults)
    sizes = [token.text for token in tokens[2:]]
    form = tokens[1].text if len(tokens) > 1 else ""
    good = form in ("tile", "plane") and len(sizes) == 2
    if not good or not all(re.fullmatch("[1-9][0-9]{0,4}", size) for size in sizes):
        usage = "write `.pixels tile ROWS COLS` or `.pixels plane ROWS COLS`"
        _wrong(faults, tokens[0], ".pixels needs a form and a size", usage)
    return draft.pixels


def _machine(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    if len(tokens) > 1:
        _wrong(faults, tokens[1], ".machine takes its data below", "write it behind bars: `| text`")
    draft.machine = _once(draft.machine, tokens, faults)
    return draft.machine


def _note(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    if len(tokens) != 3:
        _wrong(faults, tokens[0], ".note takes a key and a text", 'write `.note KEY "TEXT"`')
    elif tokens[1].text in draft.notes:
        faults.add("NS0719", f"the note {shown(tokens[1].text)} stands twice", tokens[1].span)
    else:
        draft.notes[tokens[1].text] = tokens[2].text
    return None


def _wait(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    usage = "write `.wait 125us x64` (ns, us, ms or s; x64: for 64 slots)"
    if len(tokens) == 1:
        _wrong(faults, tokens[0], ".wait needs the length of a slot", usage)
    length: float | None = None
    for token in tokens[1:]:
        repeat = _REPEAT.fullmatch(token.text)
        if repeat and length is not None:
            count = int(repeat[1])
            if count < 1 or len(draft.slot_us) + count > MOST_SLOTS:
                _wrong(faults, token, f"a frame has 1 to {MOST_SLOTS} slots", usage)
                return None
            # The first of them was noted with the time itself.
            draft.slot_us.extend([length] * (count - 1))
            length = None
            continue
        length = read_time_us(token.text)
        if length is None:
            _wrong(faults, token, f"{shown(token.text)} is not the length of a slot", usage)
            return None
        draft.slot_us.append(length)
    return None


def _names(of: Callable[[Draft], list[Token]], what: str, usage: str) -> Directive:
    """The directive that adds its tokens, one at least, to a list of the draft."""

    def add(tokens: list[Token], draft: Draft, faults: Faults) -> None:
        if len(tokens) == 1:
            _wrong(faults, tokens[0], f"{tokens[0].text} needs {what}", f"write `{usage}`")
        of(draft).extend(tokens[1:])

    return add


def _row(
    of: Callable[[Draft], list[tuple[Token, ...]]], least: int, what: str, usage: str
) -> Directive:
    """The directive that adds its tokens, at least so many, as a row to a list of the draft."""

    def add(tokens: list[Token], draft: Draft, faults: Faults) -> None:
        if len(tokens) <= least:
            _wrong(faults, tokens[0], f"{tokens[0].text} needs {what}", f"write {usage}")
        else:
            of(draft).append(tuple(tokens[1:]))

    return add


def _kernel(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    if len(tokens) != 2:
        _wrong(faults, tokens[0], ".kernel takes one name", "write `.kernel step`")
        tokens = [tokens[0], Token("", tokens[0].span)]
    elif any(kernel.name.text == tokens[1].text for kernel in draft.kernels):
        faults.add("NS0719", f"there are two kernels {shown(tokens[1].text)}", tokens[1].span)
    draft.kernels.append(KernelDraft(tokens[1]))
    return None


def _word(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    usage = "write five 32-bit integers: `.word 0x80020 0x10000 0x20000 0x31100 0x40000`"
    if len(tokens) != 6:
        _wrong(faults, tokens[0], f".word takes five integers, not {len(tokens) - 1}", usage)
        return None
    integers = []
    for token in tokens[1:]:
        base = 16 if token.text[:2] in ("0x", "0X") else 10
        value = int(token.text, base) if _WORD.fullmatch(token.text) else -1
        if not 0 <= value <= _LARGEST:
            _wrong(faults, token, f"{shown(token.text)} is no 32-bit integer", usage)
            return None
        integers.append(value)
    a, b, c, d, e = integers
    span = tokens[0].span.to(tokens[-1].span)
    draft.add(Instruction(((a, b, c, d, e),), (), span), faults)
    return None


def _slot(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    usage = "write `.slot 0..63 step`: at which slots, then which kernels"
    if len(tokens) < 3:
        _wrong(faults, tokens[0], ".slot needs slots and a kernel", usage)
        return None
    instants = read_ranges(tokens[1].text, MOST_SLOTS)
    if instants is None:
        _wrong(faults, tokens[1], f"{shown(tokens[1].text)} are no slots", usage)
        return None
    draft.slots.append(SlotDraft(tuple(instants), tokens[1], tuple(tokens[2:])))
    return None


def _readout(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    usage = "write `.readout A frame -1`: register, bucket, gain"
    if not 2 <= len(tokens) <= 4:
        _wrong(faults, tokens[0], ".readout takes a register, a bucket and a gain", usage)
        return None
    gain = read_number(tokens[3].text) if len(tokens) == 4 else 1.0
    if gain is None:
        _wrong(faults, tokens[3], f"{shown(tokens[3].text)} is no gain", usage)
        return None
    bucket = tokens[2] if len(tokens) > 2 else None
    draft.readouts.append(ReadoutDraft(tokens[1], bucket, gain))
    return None


def _plane(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    usage = 'write `.plane R3 "codes.npy"`, and `sha256 HEX` behind it to be sure of the file'
    keyword = len(tokens) == 5 and tokens[3].text == "sha256"
    if len(tokens) != 3 and not keyword:
        _wrong(faults, tokens[0], ".plane takes a register and a file", usage)
        return None
    draft.planes.append(PlaneDraft(tokens[1], tokens[2], tokens[4] if keyword else None))
    return None


_SHUTTER = "`.shutter 0110 0..15`: contents of the registers, open slots of each bucket"

DIRECTIVES: dict[str, Directive] = {
    ".target": _target,
    ".note": _note,
    ".source": _source,
    ".wait": _wait,
    ".kernel": _kernel,
    ".word": _word,
    ".slot": _slot,
    ".bucket": _names(lambda draft: draft.buckets, "a name", ".bucket early late"),
    ".readout": _readout,
    ".plane": _plane,
    ".load": _names(lambda draft: draft.load, "registers", ".load R1 R2"),
    ".fields": _names(lambda draft: draft.fields, "names", ".fields start stop"),
    ".shutter": _row(lambda draft: draft.shutters, 2, "contents and slots", _SHUTTER),
    ".code": _row(lambda draft: draft.codes, 1, "a shutter", "`.code 3 16`"),
    ".machine": _machine,
    ".pixels": _pixels,
}
"""By name. A directive that takes lines behind bars hands back the block they go to."""
