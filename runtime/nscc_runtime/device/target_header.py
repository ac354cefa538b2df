"""Write the firmware's target table from nscc's own: `target.hpp` of `runtime/firmware`.

Usage: python -m nscc_runtime.device.target_header scamp5 >
runtime/firmware/targets/scamp5/target.hpp"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.operations import (
    ANALOG_SOURCES,
    DIGITAL_SOURCES,
    NEIGHBOURS,
    OPERATIONS,
    Op,
    Phase,
    Word,
    WordEffect,
    op,
    pair,
)
from nscc.words.encoding import encode, masks
from nscc.words.readout import spreading
from nscc_runtime.device.objects import target_digest

_PHASES = {Phase.WHOLE: "WHOLE", Phase.READ: "FIRST_HALF", Phase.WRITE: "SECOND_HALF"}
_PAIRS = ("OR", "NOR", "REFRESH", "PROP")
_NO_LIMIT = 255
"""Largest number in the loader's table, which stands for no limit."""
_NOTHING: Word = (0, 0, 0, 0, 0)
_LONGEST_REFRESH = 5
"""Number of words that refresh the masked register; others need fewer."""


def target_header(target: Target) -> str:
    """Return the text of `target.hpp` for `target`: the words that the loader accepts.

    Raises ValueError for a target with custom words, which the loader does not know, and for a
    target whose pixels have no logic."""
    if not target.has_logic:
        raise ValueError(
            f"the loader's firmware runs words, but the pixels of {target.name} have no logic"
        )
    if target.words:
        names = ", ".join(row.name for row in target.words)
        raise ValueError(
            f"the loader's firmware does not support custom words of {target.name}: {names}"
        )
    return "\n".join(
        [
            *_numbers(target),
            "",
            *_operations(target),
            "",
            *_registers(target),
            "",
            *_sequences(target),
            "",
            "}  // namespace nscc::target",
            "",
            "#endif",
            "",
        ]
    )


def _numbers(target: Target) -> Iterator[str]:
    """Yield the start of the header and the C++ constants of `target`: sizes, times (us) and
    limits."""
    names = target.digital_registers

    def number(register: str | None) -> int:
        """Return the number of a digital register by its name, -1 for None."""
        return -1 if register is None else names.index(register)

    digest = [f"0x{byte:02x}" for byte in target_digest(target)]
    yield f"""\
// Written by nscc_runtime.device.target_header from nscc's target table.
#ifndef NSCC_TARGET_HPP
#define NSCC_TARGET_HPP

#include "words.hpp"

namespace nscc::target {{

constexpr char name[] = {json.dumps(target.name)};
constexpr uint8_t digest[32] = {{
    {", ".join(digest[:16])},
    {", ".join(digest[16:])},
}};
constexpr uint16_t rows = {target.rows}, cols = {target.cols};
constexpr uint32_t store_words = {target.store_words};
constexpr uint32_t analog_count = {len(target.analog_registers)};
constexpr uint32_t digital_count = {len(names)};
constexpr int masked_register = {number(target.masked_register)};
constexpr int mask_register = {number(target.mask_register)};
constexpr double analog_word_us = {target.analog_word_us!r};
constexpr double digital_word_us = {target.digital_word_us!r};
constexpr double launch_us = {target.launch_us!r};
constexpr double wait_us = {target.wait_us!r};
constexpr double readout_us = {target.readout_us!r};
constexpr double retention_us = {target.digital_retention_us!r};
constexpr double in_settle_us = {target.in_settle_us!r};
constexpr int in_low = {target.in_low}, in_high = {target.in_high};
constexpr bool where_reads_flag = {str(target.where_reads_flag).lower()};
constexpr unsigned or_sources = {_limit(target.or_sources)};
constexpr unsigned where_sources = {_limit(target.where_sources)};
constexpr unsigned directed_sources = {target.directed_sources};
constexpr bool directed_halving = {str(target.directed_halving).lower()};"""


def _limit(count: int | None) -> int:
    """Return a limit on operands as the loader stores it, at most 255; None, no limit, is 255."""
    return _NO_LIMIT if count is None else min(count, _NO_LIMIT)


def _word(word: Word) -> str:
    """Return a word, five numbers, as an initializer of C++."""
    return "{{" + ", ".join(f"0x{field:05x}" for field in word) + "}}"


def _operations(target: Target) -> Iterator[str]:
    """Yield the lines of the C++ table of operations that `target` has, with their fixed bits and
    operand counts."""
    word_masks = masks()
    yield f"constexpr Word kind_analog = {_word(word_masks.kind_analog)};"
    yield f"constexpr Word kind_digital = {_word(word_masks.kind_digital)};\n"
    yield "constexpr Operation operations[] = {"
    for row in OPERATIONS:
        if row.effect is WordEffect.DIGITAL_NEIGHBOURS and not target.sees_neighbours:
            continue
        if row.name.startswith("PROP") and not (
            target.sees_neighbours and target.propagation_pixels
        ):
            continue
        kind = row.name.partition(".")[0]
        half = row.phase is not Phase.WHOLE
        counts = [*row.destinations, *row.sources]
        numbers = [
            str(row.clock),
            "NOTHING" if row.effect is WordEffect.NONE else row.effect.name,
            _PHASES[row.phase],
            str(1 + _PAIRS.index(kind) if half else 0),
            *(str(_limit(count)) for count in counts),
        ]
        yield f"    // {row.name}"
        yield f"    {{{_word(word_masks.fixed[row.name])}, {', '.join(numbers)}}},"
    yield "};"


def _registers(target: Target) -> Iterator[str]:
    """Yield the lines of the C++ table of registers: the bits of each register as source and
    destination, its kind, and whether `target` has it."""
    word_masks = masks()
    known = {*target.analog_registers, *target.digital_registers, "PIX", "IN", "FLAG", "SELECT"}
    known |= NEIGHBOURS.keys() if target.sees_neighbours else set()
    yield "constexpr Register registers[] = {"
    for analog, names in ((True, (*ANALOG_SOURCES, *NEIGHBOURS)), (False, DIGITAL_SOURCES)):
        for name in names:
            flags = (analog, name in known, name == "FLAG", name in NEIGHBOURS, name == "NEWS")
            words = map(_word, (word_masks.read[name], word_masks.written.get(name, _NOTHING)))
            digital = not analog and name in target.digital_registers
            bit = 1 << target.digital_registers.index(name) if digital else 0
            yield f"    // {name}"
            texts = [*words, f"{', '.join(map(str, flags)).lower()}, {bit:#x}"]
            yield "    {" + ",\n     ".join(texts) + "},"
    yield "};"


def _sequences(target: Target) -> Iterator[str]:
    """Yield the lines of the C++ tables of words for `target` that refresh a register, clear it,
    set FLAG, or enable writing to the masked register. FLAG is the bit that lets a pixel act."""
    yield f"struct Refresh {{ uint32_t count; uint32_t word[{_LONGEST_REFRESH}][5]; }};\n"
    yield "// Writes a register back to itself; the masked one where the mask's code waits in FLAG."
    yield "constexpr Refresh refresh[] = {"
    for name in target.digital_registers:
        ops = refresh_words(target, name)
        yield f"    // {name}"
        yield f"    {{{len(ops)}, {{{_table(ops)}}}}},"
    yield "};\n"
    yield "// Sets a register to 0 in all pixels (the masked one where the mask is 1)."
    yield "constexpr uint32_t clear[][1][5] = {"
    for name in target.digital_registers:
        yield f"    {{{_table([op('CLR', [name])])}}},  // {name}"
    yield "};\n"
    yield f"constexpr uint32_t flag_all[1][5] = {{{_table([op('all')])}}};"
    yield from _spreading(target)
    ops = [op("SET", [target.mask_register])] if target.mask_register else [op("nop")]
    yield "// Before the masked register is loaded."
    yield f"constexpr uint32_t set_mask[1][5] = {{{_table(ops)}}};"


def _spreading(target: Target) -> Iterator[str]:
    """Yield the lines of the C++ tables of words that map a register to 2 x exposure - full well
    before conversion. The lines also state how the converter's symmetric codes map to the codes of
    a frame."""
    names, level = target.analog_registers, target.spread_level
    yield "\n// What readout makes of exposures, so that they take all codes of the converter."
    yield f"constexpr bool spreads = {str(level is not None).lower()};"
    yield f"constexpr int spread_level = {level or 0};"
    yield f"constexpr int code_of_nothing = {128 if target.readout == 'half' else 0};"
    yield f"constexpr uint32_t analog_scratch = {names.index(target.analog_scratch)};"
    yield "// Of a register and the one that its copy goes through, in the order of both."
    yield "constexpr uint32_t spread[][3][5] = {"
    for register in names:
        for copy in names:
            apart = len({register, copy, target.analog_scratch}) == 3
            # The table has a place for all pairs; those that need a register twice cannot be used.
            words = spreading(target, register, copy) if apart else [op("nop")] * 3
            yield f"    {{{_table(words)}}},"
    yield "};"


def refresh_words(target: Target, register: str) -> list[Op]:
    """Return the words of `target` that write the digital register named `register` back to itself,
    without other changes. The masked register is written through its mask, whose content waits in
    FLAG meanwhile. FLAG is the bit that lets a pixel act."""
    again = list(pair("REFRESH", register, [register]))
    mask = target.mask_register
    if register != target.masked_register or mask is None:
        return again
    return [op("WHERE", (), [mask]), op("SET", [mask]), *again, op("MOV", [mask], ["FLAG"])]


def _table(ops: Sequence[Op]) -> str:
    """Return the operations `ops` as the rows of a table of C++, each an initializer of five
    numbers."""
    words = (", ".join(f"0x{field:05x}" for field in encode(op)) for op in ops)
    return ",\n        ".join("{" + word + "}" for word in words)


if __name__ == "__main__":
    sys.stdout.write(target_header(load_target(sys.argv[1], Path())))
