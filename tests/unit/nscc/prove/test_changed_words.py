"""Changed words: a proof notices every change that could be seen in a frame.

What still proves is executed by an interpreter of the tests' own, on a chip whose bits fade, over
random states and light: shutters and frame must be what they were.
"""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lowering_oracle import container_of, does_as_told, lowered_as, program_from

from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.operations import (
    ANALOG_SOURCES,
    ANALOG_WRITE,
    OPERATIONS,
    WordEffect,
    op,
)
from nscc.prove.proof import prove
from nscc.words.container import StoredKernel
from nscc.words.encoding import encode, matching
from nscc.words.legality import decoded

N = np.arange(9)
BUMPS = [(start <= N) & (stop > N) for start in range(9) for stop in range(start + 1, 10)]
TABLES = {
    "always": np.ones((1, 4)),
    "never": np.zeros((1, 4)),
    "stops": [stop > N for stop in range(1, 10)],
    "many_stops": [np.arange(40) < stop for stop in range(1, 41)],
    "bumps": BUMPS,
    "bits": [[i >> k & 1 for k in range(5)] for i in range(32)],
    "book": np.random.default_rng(3).integers(0, 2, (20, 10)),
    "buckets": [[stop > N, stop <= N] for stop in range(1, 9)],
}
CHIPS = {
    "scamp5": {},
    "scamp5-algorithm1": {},
    "unknown": {"reset_honours_flag": "unknown", "where_obeys_flag": True},
    "narrow": {"or_sources": 4, "where_sources": 3, "where_reads_flag": True},
    "short": {"digital_retention_us": 20000.0},
}


def built(table, chip, lowering):
    """Container and words, or None where the lowering does not serve."""
    target = load_target(chip if chip.startswith("scamp") else "scamp5", Path())
    program = program_from(TABLES[table], target=replace(target, **CHIPS[chip]))
    lowered = lowered_as(program, lowering)
    if not hasattr(lowered, "schedule"):
        return None
    container = container_of(lowered)
    return container, decoded(container)


def changed(container, kernel, index, word):
    """The container with one word replaced."""
    kernels = list(container.kernels)
    words = kernels[kernel].words
    kernels[kernel] = StoredKernel(
        kernels[kernel].name, (*words[:index], word, *words[index + 1 :])
    )
    return replace(container, kernels=tuple(kernels))


def noticed_or_harmless(container, seed):
    """The property; False is a hole in the proof."""
    try:
        kernels = decoded(container)
    except Rejected:
        return True
    return not prove(container, kernels).holds or does_as_told(container, seed, kernels)


def any_operation(choose, target):
    """A word of the table with operands of the target, as likely in each row."""
    while True:
        row = choose.choice(OPERATIONS)
        analog = row.effect in (WordEffect.BUS, WordEffect.FLAG_ANALOG)
        operands = []
        for names, (low, high) in (
            (list(ANALOG_WRITE if analog else target.digital_registers), row.destinations),
            (
                list(ANALOG_SOURCES) if analog else [*target.digital_registers, "FLAG", "SELECT"],
                row.sources,
            ),
        ):
            most = 3 if high is None else min(high, 3)
            operands.append(choose.sample(names, choose.randint(min(low, most), most)))
        try:
            return op(row.name, *operands)
        except ValueError:
            continue


def flipped(choose, word):
    """The word with one or two of its bits the other way round; one that decodes if it can be."""
    other = word
    for _ in range(100):
        integers = list(word)
        for _ in range(choose.choice((1, 1, 2))):
            integers[choose.randrange(5)] ^= 1 << choose.randrange(22)
        other = tuple(integers)
        if other != word and matching(other) is not None:
            break
    return other


@pytest.mark.parametrize("chip", CHIPS)
@pytest.mark.parametrize("table", TABLES)
def test_a_changed_word_is_found_by_the_proof(table, chip):
    for lowering in ("accumulate", "latch", "edges"):
        program = built(table, chip, lowering)
        if program is None:
            continue
        container, kernels = program
        choose = random.Random(f"{table} {chip} {lowering}")
        own = [word for kernel in kernels for word in kernel]
        for trial in range(40):
            kernel = choose.randrange(len(kernels))
            index = choose.randrange(len(kernels[kernel]))
            before = container.kernels[kernel].words[index]
            word = (
                encode(op("nop")),
                encode(choose.choice(own)),
                encode(any_operation(choose, container.target)),
                flipped(choose, before),
            )[trial % 4]
            if word != before:
                mutant = changed(container, kernel, index, word)
                what = f"{lowering}: {kernels[kernel][index]} -> {matching(word)}"
                assert noticed_or_harmless(mutant, trial), what


@pytest.mark.parametrize("source", ["A", "B", "PIX", "IN", "NEWS"])
def test_the_proof_notices_a_flag_that_depends_on_light(source):
    """In most frames `where` sees positive values, but the proof covers all frames."""
    container, kernels = built("always", "scamp5", "edges")
    assert kernels[0][0] == op("all")
    assert not proved(container, 0, 0, op("where", (), [source])).holds
    container, kernels = built("stops", "scamp5", "accumulate")
    for number, kernel in enumerate(kernels):
        for index, word in enumerate(kernel):
            if word.name in ("WHERE", "all"):
                assert not proved(container, number, index, op("where", (), [source])).holds


@pytest.mark.parametrize("table", ["always", "stops", "bumps"])
def test_words_that_read_unwritten_registers_are_not_proved(table):
    for lowering in ("accumulate", "edges"):
        container, kernels = built(table, "scamp5", lowering)
        unused = set(container.target.digital_registers) - set(container.code_registers)
        words = [w for kernel in kernels for w in kernel]
        unused -= {r for w in words for r in w.destinations + w.sources}
        for source in (*sorted(unused), "SELECT"):
            for number, kernel in enumerate(kernels):
                for index, word in enumerate(kernel):
                    if word.name in ("WHERE", "all"):
                        mutant = op("WHERE", (), [*word.sources, source])
                        assert not proved(container, number, index, mutant).holds


def test_bits_that_no_frame_writes_are_not_relied_on():
    container, _ = built("stops", "scamp5", "accumulate")
    last = container.launches[-1].kernel
    kept = [w for w in container.kernels[last].words if "REFRESH" not in str(matching(w))]
    assert len(kept) == len(container.kernels[last].words) - 2 * len(container.code_registers)
    kernels = list(container.kernels)
    kernels[last] = StoredKernel("end", tuple(kept))
    forgetful = replace(container, kernels=tuple(kernels))
    proof = prove(forgetful, decoded(forgetful))
    assert proof.failure is not None
    assert proof.failure.frame == 2
    assert "no frame writes it again" in proof.failure.doubts[0]


def test_bits_that_decay_inside_a_frame_are_not_relied_on():
    """In slots of 0.2 s the code bits fade within the second frame, and the proof says so."""
    container, kernels = built("stops", "scamp5", "accumulate")
    slow = replace(container, slot_us=(200_000.0,) * 9)
    proof = prove(slow, kernels)
    assert proof.failure is not None
    assert proof.failure.frame == 1
    assert "has decayed, at" in proof.failure.doubts[0]


def test_the_proof_notices_a_code_that_is_not_restored():
    """Only the next frame reads the wrong bit, so the proof must check the code registers at the
    end of the frame."""
    container, kernels = built("stops", "scamp5", "accumulate")
    register = container.code_registers[0]
    last = container.launches[-1].kernel
    index = next(i for i, w in enumerate(kernels[last]) if w.sources == (register,))
    other = op("REFRESH.read", (), [container.code_registers[1]])
    proof = proved(container, last, index, other)
    assert proof.failure is not None
    assert "do not hold their code" in proof.failure.reason
    assert proof.failure.frame == 1


def proved(container, kernel, index, word):
    """The proof of the container with one word replaced."""
    mutant = changed(container, kernel, index, encode(word))
    return prove(mutant, [[matching(w) for w in k.words] for k in mutant.kernels])
