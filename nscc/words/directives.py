"""The parsed lines of an assembly text, with their places, before linking, and the directives:
functions that add the tokens of a line to the draft.

The grammar, `assembly.lark`, has checked the number and form of the tokens."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.operations import Op, Word
from nscc.record import Record
from nscc.source import Source, Span
from nscc.words.assembly_text import read_number, read_ranges, read_time_us
from nscc.words.soundness import MOST_SLOTS, MOST_WORDS

_IMPLIED_KERNEL = "main"


class Token(Record):
    """A token of a line and its place; for a token in quotation marks, `text` is its content."""

    text: str
    span: Span


class Instruction(Record):
    """The words of one line and the operations `ops` that they encode.

    `ops` is empty for a `.word`, which need not be a valid word."""

    words: tuple[Word, ...]
    ops: tuple[Op, ...]
    span: Span


@dataclass
class KernelDraft:
    """A kernel (a list of words): its name and the instructions below its `.kernel` line."""

    name: Token
    lines: list[Instruction] = field(default_factory=list)


class SlotDraft(Record):
    """A `.slot` line: the kernels (lists of words) that run, in order, at each of the boundaries
    `instants`.

    `range_token` is the token with these boundaries."""

    instants: tuple[range, ...]
    range_token: Token
    kernels: tuple[Token, ...]


class ReadoutDraft(Record):
    """A `.readout` line: the register that holds the exposure of `bucket` divided by `gain`.

    `bucket` is None if it was omitted, which is allowed if there is only one."""

    register: Token
    bucket: Token | None
    gain: float


class PlaneDraft(Record):
    """A `.plane` line: the file with the bits of a register, and the file's SHA-256 in hexadecimal,
    None if it is not stated."""

    register: Token
    file: Token
    sha256: Token | None


@dataclass
class TextBlock:
    """A directive with its arguments and the lines of free text below it.

    A line is its text after the bar, with its place."""

    directive: Token
    arguments: tuple[Token, ...]
    lines: list[tuple[str, Span]] = field(default_factory=list)


class Faults:
    """Collects the errors of an assembly text; `add` raises Rejected when there are 50."""

    _MOST = 50

    def __init__(self, source: Source) -> None:
        """Begin without errors; `source` is the assembly text that messages show."""
        self.source = source
        self.found: list[Diagnostic] = []

    def add(
        self, code: str, message: str, span: Span, *, label: str = "", helps: tuple[str, ...] = ()
    ) -> None:
        """Add an error at `span`; raise Rejected with all errors if there are `_MOST`.

        `code` is that of a diagnostic, such as "NS0714". `label` is a remark at the place in the
        text, and `helps` say what to do."""
        place = Label(span, label)
        self.found.append(Diagnostic(code, message, source=self.source, label=place, helps=helps))
        if len(self.found) >= self._MOST:
            self.stop()

    def stop(self) -> None:
        """Raise Rejected with all errors if there are any; else do nothing."""
        if self.found:
            raise Rejected(self.found)


def shown(text: str) -> str:
    """Return a text for a message: cut to 60 characters, in quotes, on one line, with escapes for
    all but ASCII."""
    return ascii(text if len(text) <= 60 else text[:57] + "...")


@dataclass
class Draft:
    """The content of an assembly text by directive, in order, before names are resolved.

    `words` is the number of words of all kernels (lists of words). A block that the text does not
    have is None."""

    target: TextBlock | None = None
    source: TextBlock | None = None
    pixels: TextBlock | None = None
    machine: TextBlock | None = None
    pictures: TextBlock | None = None
    notes: dict[str, str] = field(default_factory=dict)
    slot_us: list[float] = field(default_factory=list)
    buckets: list[Token] = field(default_factory=list)
    kernels: list[KernelDraft] = field(default_factory=list)
    slots: list[SlotDraft] = field(default_factory=list)
    readouts: list[ReadoutDraft] = field(default_factory=list)
    load: list[Token] = field(default_factory=list)
    fields: list[Token] = field(default_factory=list)
    shutters: list[tuple[Token, ...]] = field(default_factory=list)
    codes: list[tuple[Token, ...]] = field(default_factory=list)
    planes: list[PlaneDraft] = field(default_factory=list)
    words: int = 0

    def add(self, line: Instruction, faults: Faults) -> None:
        """Add the words of a line to the last kernel (list of words); before any `.kernel` line,
        that is one named `main`.

        Raises Rejected with all errors (NS0718) if there are too many words."""
        if not self.kernels:
            self.kernels.append(KernelDraft(Token(_IMPLIED_KERNEL, line.span)))
        self.kernels[-1].lines.append(line)
        self.words += len(line.words)
        if self.words > MOST_WORDS:
            message = f"a text has at most {MOST_WORDS} words"
            faults.add("NS0718", message, line.span, helps=("split the text into programs",))
            faults.stop()


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
    """Begin a block of lines for the directive `head`, store it in `attribute` of the draft (such
    as "source"), and return it.

    `tokens` are the directive's arguments. A second such block is reported, and replaces the first.
    """
    if getattr(draft, attribute) is not None:
        helps = ("join the two, or remove one",)
        faults.add("NS0719", f"{head.text} appears twice", head.span, helps=helps)
    block = TextBlock(head, tuple(tokens))
    setattr(draft, attribute, block)
    return block


def _target(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> TextBlock | None:
    """Begin the block of a target's table, and return it; return None if the line names a target
    instead.

    A second `.target` is reported."""
    block = _block("target", head, tokens, draft, faults)
    return None if tokens else block


def _note(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add a note to the draft.

    `tokens` are its key and its text. A second note with the same key is reported, and left out."""
    key, text = tokens
    if key.text in draft.notes:
        helps = ("keep one of them, or name the second otherwise",)
        faults.add("NS0719", f"the note {shown(key.text)} appears twice", key.span, helps=helps)
    else:
        draft.notes[key.text] = text.text


def _wait(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add slot lengths, in microseconds, to the draft.

    Each of `tokens` is a time such as `125us`, or a number such as `x64`, which repeats the slot
    before it so that there are 64 of them. An invalid length or too many slots are reported; the
    rest of the line is then ignored."""
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
    """Begin a kernel (a list of words stored on the controller) with the name that `tokens` has;
    report a second one of the same name."""
    (name,) = tokens
    if any(kernel.name.text == name.text for kernel in draft.kernels):
        message = f"two kernels have the name {shown(name.text)}"
        helps = ("name one of them otherwise, also in its `.slot` lines",)
        faults.add("NS0719", message, name.span, helps=helps)
    draft.kernels.append(KernelDraft(name))


def _word(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add a word to the last kernel (a list of words) of the draft.

    `tokens` are its five integers, decimal or hexadecimal after `0x`. Integers of more than 32 bits
    are reported, and the word is left out."""
    a, b, c, d, e = (int(t.text, 16 if t.text[:2] in ("0x", "0X") else 10) for t in tokens)
    span = head.span.to(tokens[-1].span)
    if max(a, b, c, d, e) >= 1 << 32:
        faults.add("NS0714", ".word takes 32-bit integers", span, helps=(f"write {_WORD}",))
        return
    draft.add(Instruction(((a, b, c, d, e),), (), span), faults)


def _slot(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add to the draft a line that starts kernels (lists of words) at ranges of boundaries.

    `tokens` are the ranges, such as `0..15,31`, then the names of kernels in order. An invalid
    range is reported, and the line left out."""
    range_token, *kernels = tokens
    instants = read_ranges(range_token.text, MOST_SLOTS)
    if instants is None:
        message = f"{shown(range_token.text)} is not a valid range of slots"
        faults.add("NS0714", message, range_token.span, helps=(f"write {_SLOT}",))
    else:
        draft.slots.append(SlotDraft(tuple(instants), range_token, tuple(kernels)))


def _readout(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add the readout of a register to the draft.

    `tokens` are the register and perhaps its bucket and its gain (by default 1). An invalid gain is
    reported, and the line left out."""
    register, *operands = tokens
    gain = read_number(operands[1].text) if len(operands) > 1 else 1.0
    if gain is None:
        message = f"{shown(operands[1].text)} is not a valid gain"
        helps = ("write a number, such as `.readout A frame -1`",)
        faults.add("NS0714", message, operands[1].span, helps=helps)
    else:
        draft.readouts.append(ReadoutDraft(register, operands[0] if operands else None, gain))


def _plane(head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Add a file with the bits of a register.

    `tokens` are the register, the file and perhaps the file's stated SHA-256 in hexadecimal."""
    register, file, *sha256 = tokens
    draft.planes.append(PlaneDraft(register, file, sha256[0] if sha256 else None))


def _names(attribute: str, head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Append the operands to the list `attribute` of the draft, such as "buckets"; several lines
    may do so."""
    getattr(draft, attribute).extend(tokens)


def _row(attribute: str, head: Token, tokens: list[Token], draft: Draft, faults: Faults) -> None:
    """Append the operands, as one row, to the list `attribute` of the draft, such as "codes"."""
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
