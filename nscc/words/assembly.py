"""Assembly text to words and containers: the inverse of `nscc.words.disassembly`.

A text is a list of lines; `;` or `#` begins a comment.

    OP a, b, c                an instruction or macro (`nscc.macros`), destinations first
    .word 0x.. (five times)   the bits of a word
    .kernel NAME              the instructions below belong to this kernel
    .target NAME              or "FILE.toml", or a TOML table below, each line behind a bar
    .wait 125us x64 1ms       the lengths of slots, in order; may stand several times
    .slot 0..15,31 NAME ..    kernels that run, in order, before these slots' light
    .bucket NAME ..           the frames of the exposure; without it `frame`
    .readout REG BUCKET GAIN  where a bucket's exposure is when the frame ends
    .plane REG FILE [sha256 HEX]   a plane of 0 and 1 to load before the frame (.npy or .npz)
    .load REG ..              the registers that carry code, in loading order
    .fields NAME ..           the fields of the pixel code
    .shutter BITS SLOTS ..    the registers' contents and, a bucket each, the open slots
    .code SHUTTER VALUE ..    what a code means: its shutter and its fields' values
    .pixels tile R C          the code of every pixel: a repeated tile, its rows behind bars,
    .pixels plane R C         or all of them, as base64 of 32-bit integers behind bars
    .machine                  what pixels that look do, and the levels of IN of all launches, as
                              base64 behind bars: `nscc disasm` writes it
    .source                   the program's text, its lines behind bars
    .note KEY "TEXT"
"""

from __future__ import annotations

import re
from pathlib import Path

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.suggest import meant
from nscc.macros import OperandError, expand, mnemonics
from nscc.operations import READ_LINES, Operation
from nscc.source import Source, Span
from nscc.words.container import Container, Word
from nscc.words.directives import DIRECTIVES
from nscc.words.draft import Block, Draft, Faults, Instruction, Token, shown
from nscc.words.encoding import encode
from nscc.words.linking import check_instructions, find_target, link
from nscc.words.text import read_block_line, read_string

_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[^\s;#"]+')
_BLANKS = re.compile(r"[ \t\r\f\v]*")
_CODE = re.compile(r"[^;#]*")
_INSTRUCTION = re.compile(r"\s*(\S+)\s*")
_MOST_OPERANDS = 100
_MOST_TOKENS = 1 << 14


def assemble(source: Source, base: Path) -> Container:
    """The container that a text describes; files are looked up in the folder `base`.

    Raises Rejected (NS0710 to NS0719, NS0708 and NS0230 to NS0236) with all errors found.
    """
    faults = Faults(source)
    draft = _read(source, faults, _own(source, base))
    return link(draft, base, faults)


def assemble_words(source: Source, base: Path) -> tuple[Word, ...]:
    """The words of all kernels of a text, in order; it may be instructions and nothing else."""
    faults = Faults(source)
    draft = _read(source, faults, _own(source, base))
    target = find_target(draft, base, faults)
    if target is not None:
        check_instructions(draft, target, faults)
    faults.stop()
    return tuple(word for kernel in draft.kernels for line in kernel.lines for word in line.words)


def _own(source: Source, base: Path) -> tuple[Operation, ...]:
    """The words that the text's target has of its own; what is wrong with it is said later."""
    kept, within = [], False
    for line in map(str.strip, source.text.split("\n")):
        if line.startswith("."):
            within = line.split()[0] == ".target"
        if within and line[:1] in (".", "|"):
            kept.append(line)
    faults = Faults(Source(source.name, "\n".join(kept)))
    try:
        target = find_target(_read(faults.source, faults), base, faults)
    except Rejected:
        return ()
    return target.words if target is not None else ()


def _read(source: Source, faults: Faults, own: tuple[Operation, ...] = ()) -> Draft:
    draft = Draft()
    block: Block | None = None
    offset = 0
    for line in source.text.split("\n"):
        text = line.rstrip("\r")
        begin = offset + len(text) - len(text.lstrip())
        offset += len(line) + 1
        text = text.lstrip()
        if text.startswith("|"):
            _block_line(text, begin, block, faults)
        elif text.startswith("."):
            block = None
            tokens = _tokens(text, begin, faults)
            if tokens:
                block = _directive(tokens, draft, faults)
        elif text and text[0] not in ";#":
            block = None
            _instruction(text, begin, draft, faults, own)
    return draft


def _block_line(text: str, begin: int, block: Block | None, faults: Faults) -> None:
    span = Span(begin, begin + len(text))
    content = read_block_line(text)
    if block is None:
        helps = (".target, .source and .pixels take lines that begin with `| `",)
        faults.add("NS0713", "a line behind a bar belongs to no directive", span, helps=helps)
    elif content is None:
        helps = ('write `| text`, or `|= "text"` with a JSON string',)
        faults.add("NS0714", f"malformed line behind a bar: {shown(text)}", span, helps=helps)
    else:
        block.lines.append((content, span))


def _tokens(text: str, begin: int, faults: Faults) -> list[Token]:
    tokens: list[Token] = []
    at = 0
    while at < len(text) and text[at] not in ";#":
        if len(tokens) == _MOST_TOKENS:
            message = f"a line has at most {_MOST_TOKENS} pieces"
            faults.add("NS0714", message, Span(begin + at, begin + at + 1))
            return []
        match = _TOKEN.match(text, at)
        quoted = text[at] == '"'
        value = match[0] if match else None
        if match and quoted:
            value = read_string(match[0])
        if match is None or value is None:
            span = Span(begin + at, begin + len(text))
            faults.add("NS0714", f"malformed text in quotation marks: {shown(text[at:])}", span)
            return []
        tokens.append(Token(value, Span(begin + at, begin + match.end())))
        blanks = _BLANKS.match(text, match.end())
        at = blanks.end() if blanks else match.end()
        if at == match.end() and not (at < len(text) and text[at] in '";#') and at < len(text):
            # Some other blank, such as U+00A0: not a token's character and not a separator either.
            span = Span(begin + at, begin + at + 1)
            faults.add("NS0714", f"unexpected character {shown(text[at])}", span)
            return []
    return tokens


def _directive(tokens: list[Token], draft: Draft, faults: Faults) -> Block | None:
    head = tokens[0]
    directive = DIRECTIVES.get(head.text)
    if directive is None:
        helps = meant(head.text, DIRECTIVES, f"there are {', '.join(DIRECTIVES)}")
        faults.add("NS0713", f"there is no directive {shown(head.text)}", head.span, helps=helps)
        return None
    return directive(tokens, draft, faults)


def _instruction(
    text: str, begin: int, draft: Draft, faults: Faults, own: tuple[Operation, ...]
) -> None:
    match = _CODE.match(text)
    code = match[0].rstrip() if match else ""
    split = _INSTRUCTION.match(code)
    name, rest = (split[1], code[split.end() :]) if split else (code, "")
    span = Span(begin, begin + len(code))
    if rest.count(",") >= _MOST_OPERANDS:
        message = f"no instruction takes {rest.count(',') + 1} operands"
        faults.add("NS0711", message, Span(begin, begin + len(name)))
        return
    operands = _operands(rest, begin + len(code) - len(rest))
    known = mnemonics(own)
    if name not in known:
        helps = meant(name, known, f"instructions and macros: {' '.join(known)}")
        place = Span(begin, begin + len(name))
        faults.add("NS0710", f"there is no instruction {shown(name)}", place, helps=helps)
        return
    if not _known_registers(name, operands, faults):
        return
    try:
        ops = expand(name, [operand.text for operand in operands], own)
    except OperandError as error:
        place = operands[error.index].span if error.index is not None else span
        faults.add("NS0711", str(error), place, helps=(f"write `{known[name].usage}`",))
        return
    words = tuple(encode(operation) for operation in ops)
    draft.add(Instruction(words, ops, span), faults)


def _operands(text: str, begin: int) -> list[Token]:
    """The pieces between commas; nothing at all is no operand."""
    if not text.strip():
        return []
    tokens = []
    for piece in text.split(","):
        stripped = piece.strip()
        start = begin + len(piece) - len(piece.lstrip())
        tokens.append(Token(stripped, Span(start, start + max(len(stripped), 1))))
        begin += len(piece) + 1
    return tokens


def _known_registers(name: str, operands: list[Token], faults: Faults) -> bool:
    known = True
    for operand in operands[:20]:
        if operand.text in READ_LINES:
            continue
        known = False
        parts = operand.text.split()
        if " " in operand.text and all(part in READ_LINES for part in parts):
            message = f"operands of {name} are separated by commas, not by blanks"
            helps: tuple[str, ...] = (f"write `{name} {', '.join(parts)}`",)
            faults.add("NS0711", message, operand.span, helps=helps)
            continue
        message = f"an operand of {name} is empty"
        if operand.text:
            message = f"there is no register {shown(operand.text)}"
        some = "registers are A to F, NEWS, PIX, IN, R0, R1, .., FLAG and SELECT"
        helps = meant(operand.text, READ_LINES, some)
        faults.add("NS0712", message, operand.span, helps=helps)
    return known
