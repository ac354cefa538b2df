"""The encoding, the macros and the table of operations against the published examples."""

from __future__ import annotations

import itertools
import json
from collections.abc import Callable

import pytest
from checkout import ROOT

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.macros import MNEMONICS, OperandError, expand
from nscc.operations import BY_NAME, DIGITAL_WRITE, OPERATIONS, Op, Phase, WordEffect, op, pair
from nscc.words.encoding import decode, encode, matching, word_lines, word_text
from nscc.words.legality import split_pairs, target_fault

EXAMPLES = json.loads((ROOT / "tests" / "data" / "icw_examples.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda e: " ".join([e["op"], *e["args"]]))
def test_published_examples_encode_and_decode(example: dict[str, list[str]]) -> None:
    """Each published example gives its published words, and these give back its operations."""
    ops = expand(str(example["op"]), example["args"])
    assert [word_text(encode(o)).split() for o in ops] == example["icw"]
    words = [[int(text, 16) for text in word] for word in example["icw"]]
    assert [decode((a, b, c, d, e)) for a, b, c, d, e in words] == list(ops)


def test_every_single_bit_counts() -> None:
    """No bit of a word may change without the operation changing or vanishing."""
    for example in EXAMPLES:
        for operation in expand(example["op"], example["args"]):
            word = encode(operation)
            for position in range(160):
                changed = list(word)
                changed[position // 32] ^= 1 << position % 32
                a, b, c, d, e = changed
                assert matching((a, b, c, d, e)) != operation


def test_registers_beyond_r12_lie_in_bits_that_scamp5_leaves_unused() -> None:
    plain = encode(op("OR", ["R1"], ["R2", "R3"]))
    for k in range(13, 39):
        word = encode(op("OR", ["R1"], ["R2", "R3", f"R{k}"]))
        (extra,) = set(word_lines(word)) - set(word_lines(plain))
        line = extra - 80
        difference = [a ^ b for a, b in zip(word, plain, strict=True)]
        expected = [0] * 5
        expected[1 + line // 13] = 1 << 19 + line % 13
        assert difference == expected
        assert decode(word).sources == ("R2", "R3", f"R{k}")


def test_a_word_that_is_no_operation_is_explained() -> None:
    """NS0701 says where the word stands, which part differs and what is nearest. Numbers out of
    range match nothing."""
    with pytest.raises(Rejected, match="NS0701") as caught:
        decode((0x80020, 0x10000, 0x20000, 0x31101, 0x30000), "word 3 of kernel 'step'")
    found = caught.value.diagnostics[0]
    assert found.message.startswith(
        "word 3 of kernel 'step': unknown word, which matches no operation"
    )
    assert "4 (0x30000)" in found.notes[0]
    assert "s_in" in found.notes[1]
    assert matching((-1, 0, 0, 0, 0)) is None
    assert matching((1 << 40, 0x10000, 0x20000, 0x30000, 0x40000)) is None


def run(ops: tuple[Op, ...], state: dict[str, bool]) -> dict[str, bool]:
    """Digital words on one pixel, straight from the table; R12 is written where R0 is 1."""
    state, bus = dict(state), False
    for operation in ops:
        row = BY_NAME[operation.name]
        assert row.effect is WordEffect.DIGITAL
        value = any(state[s] for s in operation.sources) != row.inverted
        if row.phase is Phase.READ:
            bus = value
            continue
        if row.phase is Phase.WRITE:
            # The second half passes what the first left: inverted twice it is NOR, not OR.
            value = bus
        for destination in operation.destinations:
            if destination != "R12" or state["R0"]:
                state[destination] = value
    return state


MEANING: dict[str, tuple[int, Callable[..., bool]]] = {
    "AND": (3, lambda _, x, y: x and y),
    "NAND": (3, lambda _, x, y: not (x and y)),
    "ANDX": (3, lambda _, b, x: b and x),
    "NANDX": (3, lambda _, b, x: not (b and x)),
    "IMP": (3, lambda _, x, y: x or not y),
    "NIMP": (3, lambda _, x, y: not (x or not y)),
    "CLR_IF": (2, lambda a, x: a and not x),
    "XORX": (3, lambda _, x, y: x != y),
    "MUX": (4, lambda _, x, y, z: y if x else z),
    "NOT": (1, lambda a: not a),
    "REFRESH": (1, lambda a: a),
    "OR": (2, lambda a, x: a or x),
    "NOR": (2, lambda a, x: not (a or x)),
}


@pytest.mark.parametrize("name", MEANING)
def test_digital_macro_computes_what_its_name_says(name: str) -> None:
    """For all values of the registers, R1 holds the logic function after which the macro is
    named."""
    count, meaning = MEANING[name]
    registers = ["R1", "R2", "R3", "R4"][:count]
    for values in itertools.product([False, True], repeat=count + 2):
        state = dict(zip([*registers, "R0", "R12"], values, strict=True))
        result = run(expand(name, registers), state)
        assert result["R1"] == meaning(*values[:count])


ANALOG = {
    ("res", "A"): lambda v: {"A": 0},
    ("res", "A", "B"): lambda v: {"A": 0, "B": 0},
    ("mov", "A", "B"): lambda v: {"A": v["B"]},
    ("add", "A", "B", "C"): lambda v: {"A": v["B"] + v["C"]},
    ("add", "A", "A", "B", "C"): lambda v: {"A": v["A"] + v["B"] + v["C"]},
    ("sub", "A", "A", "B"): lambda v: {"A": v["A"] - v["B"]},
    ("neg", "A", "B"): lambda v: {"A": -v["B"]},
    ("abs", "A", "B"): lambda v: {"A": abs(v["B"])},
    ("div", "A", "C", "D", "B"): lambda v: {"A": v["B"] / 2},
    ("diva", "A", "C", "D"): lambda v: {"A": v["A"] / 2},
    ("getpix", "A", "B"): lambda v: {"A": v["PIX"] - v["B"]},
    ("getpix", "A", "C", "B"): lambda v: {"A": 2 * v["PIX"] - v["B"], "C": -v["PIX"]},
    ("get_image", "A"): lambda v: {"A": v["PIX"] - 7.0, "PIX": 7.0},
    ("get_image", "A", "C"): lambda v: {"A": 2 * v["PIX"] - 7.0, "C": -v["PIX"], "PIX": 7.0},
    ("respix", "A"): lambda v: {"A": 7.0, "PIX": 7.0},
}


@pytest.mark.parametrize("line", ANALOG, ids=" ".join)
def test_analog_macro_computes_what_its_name_says(line: tuple[str, ...]) -> None:
    start = {"A": 3.0, "B": -5.0, "C": 11.0, "D": 2.0, "NEWS": 100.0, "PIX": 29.0}
    for sign in (1.0, -1.0):
        state = {**start, "B": sign * start["B"]}
        expected, flag = {**state, **ANALOG[line](state)}, True
        for operation in expand(line[0], line[1:]):
            row = operation.operation
            total = sum(state[s] for s in operation.sources)
            if row.effect is WordEffect.BUS and flag:
                state.update(dict.fromkeys(operation.destinations, -total / row.divisor))
            elif row.effect is WordEffect.RESET_PIX:
                state["PIX"] = 7.0
            elif row.effect is WordEffect.FLAG_ANALOG:
                flag = total > 0
            elif row.effect is WordEffect.FLAG_ALL:
                flag = True
        kept = ("A", "PIX") if "div" in line[0] else ("A", "B", "C", "D", "PIX")
        assert {r: state[r] for r in kept} == {r: expected[r] for r in kept}


@pytest.mark.parametrize(
    ("line", "index", "words"),
    [
        ("AND R1, R2", None, "AND takes 3 operands, not 2"),
        ("AND R1, R0, R2", 1, "overwrites R0 and R12"),
        ("mov A, NEWS", 1, "overwrites NEWS"),
        ("sub A, B, A", None, "cannot write A and read it"),
        ("XORX R1, R2, R1", 2, "three registers"),
        ("bus A, B, B", 2, "twice"),
        ("bus R1, A", 0, "not R1"),
        ("bus A, R1", 1, "not R1"),
        ("MOV R1, A", 1, "not A"),
        ("SET R1, R1", 1, "twice"),
        ("SET FLAG", 0, "not FLAG"),
        ("NOT R1, R1", 1, "cannot write R1 and read it"),
        ("OR R1", None, "OR takes 2 or more operands, not 1"),
        ("OR R1, R2, R2", 2, "twice"),
        ("nop A", None, "nop takes no operands"),
        ("bus3 A, B, C, D, E", None, "bus3 takes 4 operands"),
        ("REFRESH A", 0, "not A"),
    ],
)
def test_wrong_operands_are_explained(line: str, index: int | None, words: str) -> None:
    name, _, rest = line.partition(" ")
    with pytest.raises(OperandError, match=words) as caught:
        expand(name, [part.strip() for part in rest.split(",")])
    assert caught.value.index == index


def test_every_mnemonic_shows_its_usage() -> None:
    """Each usage begins with the mnemonic, and each whole operation has one."""
    for name, mnemonic in MNEMONICS.items():
        assert mnemonic.usage.startswith(name)
    whole = {row.name for row in OPERATIONS if row.phase is Phase.WHOLE}
    assert whole <= MNEMONICS.keys()


def test_target_limits_hold_for_words() -> None:
    """SCAMP-5 takes eleven sources of NOR. It has no R13, and WHERE cannot read the FLAG that it
    writes."""
    scamp5 = builtin_target("scamp5")
    wide = op("NOR", ["R1"], [f"R{i}" for i in range(2, 13)])
    assert target_fault(wide, scamp5) is None
    assert "no register R13" in (target_fault(op("SET", ["R13"]), scamp5) or "")
    assert "cannot also read it" in (target_fault(op("WHERE", (), ["FLAG"]), scamp5) or "")
    assert set(DIGITAL_WRITE) > set(scamp5.digital_registers)


def test_words_of_a_pair_must_stand_together() -> None:
    """A pair with a word between, in the wrong order or of two kinds gives an error for each
    half."""
    read, write = pair("OR", "R1", ["R1", "R2"])
    nop = op("nop")
    assert split_pairs("k", [nop, read, write, nop]) == []
    assert [d.data["word"] for d in split_pairs("k", [read, nop, write])] == [0, 2]
    assert [d.data["word"] for d in split_pairs("k", [write, read])] == [0, 1]
    other = pair("NOR", "R1", ["R1", "R2"])[1]
    assert [d.code for d in split_pairs("k", [read, other])] == ["NS0703", "NS0703"]
