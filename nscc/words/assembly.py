"""Assembly text to words and containers: the inverse of `nscc.words.disassembly`.

A text is a list of lines; `;` or `#` begins a comment.

    OP a, b, c                an instruction or macro (`nscc.macros`), destinations first
    .word 0x.. (five times)   the bits of a word
    .kernel NAME              the instructions below belong to this kernel
    .target NAME              or "FILE.toml", or a TOML table below, each line behind a bar
    .wait 125us x64 1ms       the lengths of slots, in order; may stand several times
    .slot 0..15,31 NAME ..    kernels that run, in order, before these slots' light
    .bucket NAME ..           the buckets of the exposure; without it `frame`
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
    .pictures                 images and planes with their words, as base64 behind bars
    .source                   the program's text, its lines behind bars
    .note KEY "TEXT"
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache, lru_cache
from pathlib import Path

from lark import Lark, UnexpectedInput, UnexpectedToken
from lark import Token as LarkToken

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.suggest import meant
from nscc.macros import Mnemonic, OperandError, expand, mnemonics
from nscc.operations import READ_LINES, Operation, Word
from nscc.source import Source, Span
from nscc.words.assembly_text import read_block_line, read_string
from nscc.words.container import Container
from nscc.words.directives import DIRECTIVES, Draft, Faults, Instruction, TextBlock, Token, shown
from nscc.words.encoding import encode
from nscc.words.linking import check_instructions, find_target, link

_PIECE = re.compile(r'"(?:[^"\\]|\\.)*"?|[^\s;#"]+')
_CODE = re.compile("[;#]")
_MOST_PIECES = 1 << 14
"""Most words and quoted texts in a line."""


def assemble(source: Source, base: Path) -> Container:
    """Return the compiled program that an assembly text describes; its files are relative to the
    folder `base`.

    The module describes the format of the text. Raises Rejected (NS0710 to NS0719, NS0707, NS0708
    and NS0230 to NS0236) with all errors, at most 50."""
    faults = Faults(source)
    draft = _read(source, faults, _own_words(source, base))
    return link(draft, base, faults)


def assemble_words(source: Source, base: Path) -> tuple[Word, ...]:
    """Return the words of all kernels of an assembly text, in order; the text may consist of
    instructions only.

    A kernel is a list of words. Files are relative to `base`. A text without instructions gives ().
    Raises Rejected with all errors, at most 50."""
    faults = Faults(source)
    draft = _read(source, faults, _own_words(source, base))
    target = find_target(draft, base, faults)
    if target is not None:
        check_instructions(draft, target, faults)
    faults.stop()
    return tuple(word for kernel in draft.kernels for line in kernel.lines for word in line.words)


def _own_words(source: Source, base: Path) -> tuple[Operation, ...]:
    """Return the operations that the target of a text adds to those of all chips.

    Target files are relative to `base`. Return () if the target has errors, which are reported
    later."""
    # The lines of the target are read before all others, because it may define instructions.
    target_lines, within = [], False
    for line in map(str.strip, source.text.split("\n")):
        if line.startswith("."):
            within = line.split()[0] == ".target"
        if within and line[:1] in (".", "|"):
            target_lines.append(line)
    faults = Faults(Source(source.name, "\n".join(target_lines)))
    try:
        target = find_target(_read(faults.source, faults), base, faults)
    except Rejected:
        return ()
    return target.words if target is not None else ()


def _read(source: Source, faults: Faults, own_words: tuple[Operation, ...] = ()) -> Draft:
    """Return the lines of an assembly text as a draft, before names are resolved.

    `own_words` are operations that the target adds. Malformed lines are reported in `faults` and
    left out; Rejected is raised when there are 50 errors."""
    draft = Draft()
    block: TextBlock | None = None
    known = mnemonics(own_words)
    offset = 0
    for line in source.text.split("\n"):
        # The span of a line is needed in characters of the whole text.
        text = line.rstrip("\r").lstrip()
        begin = offset + line.index(text)
        offset += len(line) + 1
        # A line that begins with a bar continues the block of the directive above it.
        if text.startswith("|"):
            span = Span(begin, begin + len(text))
            content = read_block_line(text)
            if block is None:
                helps = (".target, .source and .pixels take lines that begin with `| `",)
                faults.add(
                    "NS0713",
                    "this continuation line does not belong to a directive",
                    span,
                    helps=helps,
                )
            elif content is None:
                helps = ('write `| text`, or `|= "text"` with a JSON string',)
                faults.add(
                    "NS0714", f"malformed continuation line: {shown(text)}", span, helps=helps
                )
            else:
                block.lines.append((content, span))
            continue
        first = _PIECE.match(text)
        if first is None:  # a comment, or nothing
            continue
        head, block = Token(first[0], Span(begin, begin + first.end())), None
        if _is_known(head, known, faults):
            pieces = _pieces(text, head, faults)
            if head.text in DIRECTIVES and pieces is not None:
                block = DIRECTIVES[head.text].read(head, pieces, draft, faults)
            elif pieces is not None:
                _instruction(head, pieces, draft, faults, own_words)
    return draft


def _is_known(head: Token, known: Mapping[str, Mnemonic], faults: Faults) -> bool:
    """Return whether a line begins with a known directive or instruction; report an error if not.

    `head` is the first word of the line, and `known` are the instructions by name."""
    name = shown(head.text)
    if head.text.startswith(".") and head.text not in DIRECTIVES:
        helps = meant(head.text, DIRECTIVES, f"there are {', '.join(DIRECTIVES)}")
        faults.add("NS0713", f"unknown directive {name}", head.span, helps=helps)
    elif head.text not in DIRECTIVES and head.text not in known:
        helps = meant(head.text, known, f"instructions and macros: {' '.join(known)}")
        faults.add("NS0710", f"unknown instruction {name}", head.span, helps=helps)
    else:
        return True
    return False


@cache
def _grammar() -> Lark:
    """Return the parser of a line of assembly text, which is made once."""
    text = Path(__file__).with_suffix(".lark").read_text(encoding="utf-8")
    return Lark(text, parser="lalr", start="line", maybe_placeholders=False)


@lru_cache(1 << 12)
def _parsed(line: str) -> tuple[tuple[str, int, int], ...]:
    """Return the pieces of a line, each as (text, offset where it begins, offset where it ends).

    A directive's name, blanks, commas and comments are left out. Raises UnexpectedInput if the
    grammar does not allow the line. Results are memoized, because kernels (lists of words) repeat
    lines."""
    tokens = _grammar().parse(line).scan_values(lambda piece: isinstance(piece, LarkToken))
    return tuple((str(piece), piece.start_pos or 0, piece.end_pos or 0) for piece in tokens)


def _pieces(text: str, head: Token, faults: Faults) -> list[Token] | None:
    """Return the operands of a line that begins with `head`; None after reporting a syntax error.

    `text` is the line from `head` on. A directive's operands in quotation marks are returned
    without these."""
    begin = head.span.start
    is_instruction = head.text not in DIRECTIVES
    # Long lines are refused before the grammar reads them. An instruction ends at ; or #.
    before_comment = _CODE.split(text, 1)[0] if is_instruction else text
    count = before_comment.count(",") if is_instruction else 0
    if count + len(before_comment.split(maxsplit=_MOST_PIECES)) > _MOST_PIECES:
        helps = ("divide it into several lines, or write a range such as `0..63`",)
        faults.add("NS0714", f"a line has at most {_MOST_PIECES} parts", head.span, helps=helps)
        return None
    try:
        pieces = _parsed(text)
    except UnexpectedInput as error:
        fault_at = error.pos_in_stream or 0
        ends = isinstance(error, UnexpectedToken) and error.token.type == "$END"
        match = None if ends else _PIECE.match(text, fault_at)
        misplaced = "" if ends else match[0] if match else text[fault_at]
        span = head.span if ends else Span(begin + fault_at, begin + fault_at + len(misplaced))
        _misplaced(misplaced, span, head, before_comment, faults)
        return None
    tokens = []
    for piece, start, end in pieces:
        span = Span(begin + start, begin + end)
        quoted = piece.startswith('"') and not is_instruction
        value = read_string(piece) if quoted else piece
        if value is None:
            _misplaced(piece, span, head, before_comment, faults)
            return None
        tokens.append(Token(value, span))
    # The grammar returns the name of an instruction as a piece, but not that of a directive.
    return tokens[is_instruction:]


def _misplaced(piece: str, span: Span, head: Token, code: str, faults: Faults) -> None:
    """Report a piece of a line that the grammar does not allow there; an empty `piece` is the end
    of the line.

    `span` is the place of the piece, `head` the first word of the line, and `code` the line without
    its comment."""
    name = head.text
    if name not in DIRECTIVES:
        if piece in ("", ","):
            helps = ("write a register between the commas, or remove a comma",)
            faults.add("NS0712", f"an operand of {name} is empty", span, helps=helps)
            return
        message = f"operands of {name} are separated by commas, not by blanks"
        operands = code.replace(",", " ").split()[1:]
        faults.add("NS0711", message, span, helps=(f"write `{name} {', '.join(operands)}`",))
        return
    needs, usage = DIRECTIVES[name].needs, DIRECTIVES[name].usage
    if piece.startswith('"'):
        message = f"malformed text in quotation marks: {shown(piece)}"
    elif piece:
        message = f"{shown(piece)} does not belong here: {name} takes {needs}"
    else:
        message = f"{name} needs {needs}"
    faults.add("NS0714", message, span, helps=(f"write {usage}",))


def _instruction(
    head: Token,
    operands: list[Token],
    draft: Draft,
    faults: Faults,
    own_words: tuple[Operation, ...],
) -> None:
    """Add the words of one instruction or macro to the draft.

    `head` is its name. Unknown registers (the first 20) and wrong operands are reported instead.
    `own_words` are operations that the target adds."""
    name = head.text
    unknown = [operand for operand in operands if operand.text not in READ_LINES]
    # A long line of unknown names does not need an error for each.
    for operand in unknown[:20]:
        registers_text = "registers are A to F, NEWS, PIX, IN, R0, R1, .., FLAG and SELECT"
        helps = meant(operand.text, READ_LINES, registers_text)
        message = f"unknown register {shown(operand.text)}"
        faults.add("NS0712", message, operand.span, helps=helps)
    if unknown:
        return
    span = head.span.to(operands[-1].span) if operands else head.span
    try:
        ops = expand(name, [operand.text for operand in operands], own_words)
    except OperandError as error:
        place = operands[error.index].span if error.index is not None else span
        usage = mnemonics(own_words)[name].usage
        faults.add("NS0711", str(error), place, helps=(f"write `{usage}`",))
        return
    words = tuple(encode(operation) for operation in ops)
    draft.add(Instruction(words, ops, span), faults)
