"""The parsed lines of an assembly text, with their places, before linking."""

from __future__ import annotations

from dataclasses import dataclass, field

from nscc.diagnostics.diagnostic import Diagnostic, Label, Rejected
from nscc.operations import Op
from nscc.source import Source, Span
from nscc.words.container import Word
from nscc.words.soundness import MOST_WORDS

_IMPLIED_KERNEL = "main"


@dataclass(frozen=True, slots=True)
class Token:
    """A token of a line; for a token in quotation marks, `text` is its content."""

    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Instruction:
    """The words of one line; `ops` is empty for a `.word`."""

    words: tuple[Word, ...]
    ops: tuple[Op, ...]
    span: Span


@dataclass
class KernelDraft:
    """A `.kernel` and the lines below it."""

    name: Token
    lines: list[Instruction] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class SlotDraft:
    """A `.slot` line: the kernels that run, in order, at each of the boundaries `instants`."""

    instants: tuple[range, ...]
    place: Token
    kernels: tuple[Token, ...]


@dataclass(frozen=True, slots=True)
class ReadoutDraft:
    """A `.readout` line; the bucket may be omitted if there is only one."""

    register: Token
    bucket: Token | None
    gain: float


@dataclass(frozen=True, slots=True)
class PlaneDraft:
    """A `.plane` line."""

    register: Token
    file: Token
    sha256: Token | None


@dataclass
class TextBlock:
    """A directive with lines of free text below it, each after a bar."""

    directive: Token
    arguments: tuple[Token, ...]
    lines: list[tuple[str, Span]] = field(default_factory=list)


class Faults:
    """The errors of a text; collection stops after too many."""

    _MOST = 50

    def __init__(self, source: Source) -> None:
        self.source = source
        self.found: list[Diagnostic] = []

    def add(
        self, code: str, message: str, span: Span, *, label: str = "", helps: tuple[str, ...] = ()
    ) -> None:
        """Add an error at `span`; raise Rejected if the limit is reached."""
        place = Label(span, label)
        self.found.append(Diagnostic(code, message, source=self.source, label=place, helps=helps))
        if len(self.found) >= self._MOST:
            self.stop()

    def stop(self) -> None:
        """Raise Rejected if there are errors."""
        if self.found:
            raise Rejected(self.found)


def shown(text: str) -> str:
    """Quote a text in a message: on one line and short."""
    return ascii(text if len(text) <= 60 else text[:57] + "...")


@dataclass
class Draft:
    """The content of a text, in order."""

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
        """Add a line to the current kernel; without `.kernel` this is `main`.

        Raises Rejected (NS0718) with all errors if there are too many words."""
        if not self.kernels:
            self.kernels.append(KernelDraft(Token(_IMPLIED_KERNEL, line.span)))
        self.kernels[-1].lines.append(line)
        self.words += len(line.words)
        if self.words > MOST_WORDS:
            message = f"a text has at most {MOST_WORDS} words"
            faults.add("NS0718", message, line.span)
            faults.stop()
