"""The directives of assembly text: functions that add the tokens of a line to the draft.

The grammar, `assembly.lark`, has checked the number and form of the tokens."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from nscc.words.assembly_text import read_number, read_ranges, read_time_us
from nscc.words.draft import (
    Draft,
    Faults,
    Instruction,
    KernelDraft,
    PlaneDraft,
    ReadoutDraft,
    SlotDraft,
    TextBlock,
    Token,
    shown,
)
from nscc.words.soundness import MOST_SLOTS

Read = Callable[[Token, list[Token], Draft, Faults], TextBlock | None]


@dataclass(frozen=True)
class Directive:
    """A directive of assembly text.

    `read` takes its name, the tokens after it, the draft and the errors, and returns the block for
    the following lines with bars, or None. `needs` and `usage` describe the tokens in messages."""

    read: Read
    needs: str
    usage: str


def _block(
    attribute: str, head: Token, tokens: list[Token], draft: Draft, faults: Faults
) -> TextBlock:
    if getattr(draft, attribute) is not None:
        faults.add("NS0719", f"{head.text} appears twice", head.span)
    block = TextBlock(head, tuple(tokens))
    setattr(draft, attribute, block)
    return block


def _target(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> TextBlock | None:
    block = _block("target", head, tokens, draft, faults)
    return None if tokens else block


def _note(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    key, text = tokens
    if key.text in draft.notes:
        faults.add("NS0719", f"the note {shown(key.text)} appears twice", key.span)
    else:
        draft.notes[key.text] = text.text


def _wait(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    for token in tokens:
        if token.text.startswith("x"):  # the number of slots, starting with the previous slot
            repeats = int(token.text[1:]) - 1
            if len(draft.slot_us) + repeats >= MOST_SLOTS:
                message = f"a frame has 1 to {MOST_SLOTS} slots"
                faults.add("NS0714", message, token.span, helps=(f"write {_WAIT}",))
                return
            draft.slot_us.extend(draft.slot_us[-1:] * repeats)
            continue
        length = read_time_us(token.text)
        if length is None:
            message = f"{shown(token.text)} is not the length of a slot"
            faults.add("NS0714", message, token.span, helps=(f"write {_WAIT}",))
            return
        draft.slot_us.append(length)


def _kernel(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    (name,) = tokens
    if any(kernel.name.text == name.text for kernel in draft.kernels):
        faults.add("NS0719", f"two kernels have the name {shown(name.text)}", name.span)
    draft.kernels.append(KernelDraft(name))


def _word(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    a, b, c, d, e = (int(t.text, 16 if t.text[:2] in ("0x", "0X") else 10) for t in tokens)
    span = head.span.to(tokens[-1].span)
    if max(a, b, c, d, e) >= 1 << 32:
        faults.add("NS0714", ".word takes 32-bit integers", span, helps=(f"write {_WORD}",))
        return
    draft.add(Instruction(((a, b, c, d, e),), (), span), faults)


def _slot(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    place, *kernels = tokens
    instants = read_ranges(place.text, MOST_SLOTS)
    if instants is None:
        message = f"{shown(place.text)} is not a valid range of slots"
        faults.add("NS0714", message, place.span, helps=(f"write {_SLOT}",))
    else:
        draft.slots.append(SlotDraft(tuple(instants), place, tuple(kernels)))


def _readout(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    register, *operands = tokens
    gain = read_number(operands[1].text) if len(operands) > 1 else 1.0
    if gain is None:
        faults.add("NS0714", f"{shown(operands[1].text)} is not a valid gain", operands[1].span)
    else:
        draft.readouts.append(ReadoutDraft(register, operands[0] if operands else None, gain))


def _plane(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    register, file, *sha256 = tokens
    draft.planes.append(PlaneDraft(register, file, sha256[0] if sha256 else None))


def _names(attribute: str, head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    getattr(draft, attribute).extend(tokens)


def _row(attribute: str, head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    getattr(draft, attribute).append(tuple(tokens))


_WAIT = "`.wait 125us x64` (ns, us, ms or s; x64: for 64 slots)"
_WORD = "five 32-bit integers: `.word 0x80020 0x10000 0x20000 0x31100 0x40000`"
_SLOT = "`.slot 0..63 step`: at which slots, then which kernels"
_BELOW = "it behind bars: `| text`"

DIRECTIVES: dict[str, Directive] = {
    ".target": Directive(_target, "one name", "`.target scamp5`"),
    ".note": Directive(_note, "a key and a text", '`.note KEY "TEXT"`'),
    ".source": Directive(partial(_block, "source"), "its text below", _BELOW),
    ".wait": Directive(_wait, "the lengths of slots", _WAIT),
    ".kernel": Directive(_kernel, "one name", "`.kernel step`"),
    ".word": Directive(_word, "five integers, each 32-bit", _WORD),
    ".slot": Directive(_slot, "slots and a kernel", _SLOT),
    ".bucket": Directive(partial(_names, "buckets"), "a name", "`.bucket early late`"),
    ".readout": Directive(
        _readout, "a register, a bucket and a gain", "`.readout A frame -1`"
    ),
    ".plane": Directive(
        _plane, "a register and a file",
        '`.plane R3 "codes.npy"`; add `sha256 HEX` to verify the file',
    ),
    ".load": Directive(partial(_names, "load"), "registers", "`.load R1 R2`"),
    ".fields": Directive(partial(_names, "fields"), "names", "`.fields start stop`"),
    ".shutter": Directive(
        partial(_row, "shutters"), "contents and slots",
        "`.shutter 0110 0..15`: contents of the registers, open slots of each bucket",
    ),
    ".code": Directive(partial(_row, "codes"), "a shutter", "`.code 3 16`"),
    ".machine": Directive(partial(_block, "machine"), "its data below", _BELOW),
    ".pictures": Directive(partial(_block, "pictures"), "its data below", _BELOW),
    ".pixels": Directive(
        partial(_block, "pixels"), "a form and a size",
        "`.pixels tile ROWS COLS` or `.pixels plane ROWS COLS`",
    ),
}  # fmt: skip
"""The directives by name."""
