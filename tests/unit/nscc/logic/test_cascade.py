"""Cascades: arbitrary shutters by stored predicates and several levels of gates."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from gates_oracle import asked_of, bits, book, words_if_right
from lowering_oracle import container_of, does_as_told, lowered_as, program_from
from marks import slow

from nscc.chips.load import load_target
from nscc.logic import cascade as cascades
from nscc.logic import generate
from nscc.logic.problem import Demand, GaveUp, Machine, Problem
from nscc.prove.proof import prove
from nscc.words.legality import decoded

SCAMP5 = Machine(13, True, None, None, False)
MACHINES = {
    "scamp5": SCAMP5,
    "reads FLAG": replace(SCAMP5, where_reads_flag=True),
    "library calls": replace(SCAMP5, or_sources=4, where_sources=3),
    "two sources": replace(SCAMP5, or_sources=2, where_sources=2),
    "two sources, reads FLAG": Machine(9, False, 2, 2, True),
    "few registers": Machine(8, False, None, None, False),
}


def cascade(asked, machine, steps):
    """The solution of the generator."""
    return next(cascades.cascade(asked, machine, steps))


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("density", [0.1, 0.5, 0.8])
def test_cascades_answer_random_codebooks(machine, lowering, density):
    """For 24 random rows of sparse to dense bits, the cascade gives every demanded value."""
    asked = asked_of(book(24, 18, 4, density), lowering)
    solution = cascade(asked, MACHINES[machine], 30_000)
    assert words_if_right(asked, MACHINES[machine], solution) >= len(asked.demands)


@pytest.mark.parametrize(("shutters", "registers"), [slow(65, 9), slow(200, 11), (480, 12)])
def test_planes_are_changed_until_they_tell_all_shutters_apart(shutters, registers):
    """The predicates alone cannot distinguish so many shutters, so the search changes some
    planes."""
    asked = asked_of(book(shutters, 12, 8))
    machine = replace(SCAMP5, registers=registers)
    solution = cascade(asked, machine, 300_000)
    words_if_right(asked, machine, solution)
    codes = np.array([bits(plane, asked.shutters) for plane in solution.planes])
    assert len(np.unique(codes.T, axis=0)) == asked.shutters
    assert any("changed" in holder for holder in solution.holders)


def test_the_known_codebook_takes_a_tenth_less_than_the_best_known():
    for seed in (1, 2):
        table = np.random.default_rng(seed).integers(0, 2, (64, 16))
        asked = asked_of(table)
        solution = cascade(asked, SCAMP5, 60_000)
        # A recorded number of words: it must not grow.
        assert words_if_right(asked, SCAMP5, solution) <= 187


def test_the_sparsest_predicates_are_stored(monkeypatch):
    """In half of the slots few shutters are open, or few closed. Without exchanges, planes hold
    those slots, inverted if most shutters are open."""
    table = book(32, 22, 2)
    table[:, 10:] = book(32, 12, 3, 0.12)
    table[:, 11::2] ^= True
    asked = asked_of(table)
    monkeypatch.setattr(cascades, "_CHOOSING", 0)
    solution = cascade(asked, SCAMP5, 30_000)
    words_if_right(asked, SCAMP5, solution)
    opens = table.sum(axis=0)
    rarest = sorted((min(count, 32 - count), slot) for slot, count in enumerate(opens))
    demanded = [slot for ones, slot in rarest if ones > 0]
    stored = {holder.removesuffix(", changed in places") for holder in solution.holders}
    assert stored == {
        f"open in slot {slot}{', inverted' * bool(opens[slot] > 16)}"
        for slot in demanded[: len(solution.planes)]
    }


def test_more_steps_take_no_more_words():
    """From 10 000 to 160 000 steps the number of words never rises, and it ends lower."""
    asked = asked_of(book(40, 17, 3))
    words = [
        words_if_right(asked, SCAMP5, cascade(asked, SCAMP5, steps))
        for steps in (10_000, 40_000, 160_000)
    ]
    assert words == sorted(words, reverse=True)
    assert words[-1] < words[0]


def test_cascades_are_deterministic():
    asked = asked_of(book(40, 16, 5))
    assert cascade(asked, SCAMP5, 20_000) == cascade(asked, SCAMP5, 20_000)


def test_shutters_that_no_demand_tells_apart_share_a_code():
    """The first and third shutter are equal, so one plane of one bit tells all apart."""
    wanted = [0b1100, 0b0011, 0b1100]
    demands = tuple(Demand(i + 1, "open", 0, p, i == 2) for i, p in enumerate(wanted))
    asked = Problem(demands, 4, (tuple(wanted),), True, {})
    solution = cascade(asked, replace(SCAMP5, registers=2), 10_000)
    assert len(solution.planes) == 1
    assert words_if_right(asked, SCAMP5, solution) <= 4


def test_demands_take_fewer_words_if_flag_keeps_its_value_between_them():
    """The predicates form pairs that differ in one shutter. There are more pairs than planes."""
    table = np.repeat(book(40, 12, 6), 2, axis=1)
    table[np.arange(12), np.arange(1, 24, 2)] ^= True
    machine = Machine(11, False, None, None, False)
    words = []
    for kept in (True, False):
        asked = asked_of(table)
        demands = tuple(replace(d, flag_kept=kept and i > 0) for i, d in enumerate(asked.demands))
        asked = replace(asked, demands=demands)
        words.append(words_if_right(asked, machine, cascade(asked, machine, 40_000)))
    assert words[0] < words[1]


def test_cascade_gives_up_with_more_than_4096_kinds_of_shutters():
    """Too few steps or registers and 5000 kinds of shutters each raise GaveUp with that reason."""
    asked = asked_of(book(64, 16, 1))
    with pytest.raises(GaveUp, match="steps"):
        cascade(asked, SCAMP5, 100)
    with pytest.raises(GaveUp, match="64 kinds of shutters"):
        cascade(asked, replace(SCAMP5, registers=6), 10_000)
    many = np.arange(5000)[:, None] >> np.arange(13) & 1
    with pytest.raises(GaveUp, match="5000 kinds of shutters, more than 4096"):
        cascade(asked_of(many), SCAMP5, 10_000)


@pytest.mark.parametrize(
    ("lowering", "fan_in"),
    [("accumulate", None), ("edges", 4), slow("accumulate", 4), slow("edges", None)],
)
def test_words_meet_their_demands(monkeypatch, lowering, fan_in):
    """Through the whole compiler: proved, and executed by an emulator of its own."""
    monkeypatch.setitem(generate.SEARCH_STEPS, 2, 100_000)
    target = load_target("scamp5", Path())
    if fan_in:
        target = replace(target, or_sources=fan_in, where_sources=3)
    program = program_from(book(48, 16, 9), target=target)
    lowered = lowered_as(program, lowering, level=2)
    assert "cascades" in lowered.solution.encoding
    container = container_of(lowered, level=2)
    assert prove(container, decoded(container)).holds
    assert does_as_told(container)
