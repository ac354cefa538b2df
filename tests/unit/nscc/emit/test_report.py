"""Every number of the report, counted again from the container's words and the target's times."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from emulator_oracle import Chip
from lowering_oracle import words_at

from nscc.chips.load import load_target
from nscc.compiler import compile_source
from nscc.emit.report import report
from nscc.pipeline import Options
from nscc.source import Source
from nscc.words.legality import decoded

TEXTS = {
    "a": "frame 8 slots of 1ms\nopen when true",
    "b": "frame 20 slots of 1ms\ncode stop : 1..20\nopen when n < stop",
    "b_many": "frame 300 slots of 100us\ncode stop : 1..300\nopen when n < stop",
    "b_unequal": "frame slots [100us, 200us, 400us, 5ms]\ncode stop : 1..4\nopen when n < stop",
    "c": "frame 33 slots of 1ms\ncode s : 0..25\nopen when s <= n < s + 8",
    "d": "frame 12 slots of 1ms\ncode a : 0..11\ncode b : 1..12\nrequire a < b\n"
    "open when a <= n < b",
    "e": "frame 9 slots of 1ms\ncode bits : bit[9]\nopen when bits[n]",
    "buckets": "frame 21 slots of 1ms\ncode split : 1..20\n"
    "bucket early open when n < split\nbucket late open when n >= split",
    "book": "frame 10 slots of 1ms\nshutters book [1100111000, 0011101111, 0101010101]\n"
    "code id : row of book\nopen when book[id]",
    "late": "frame 9 slots of 1ms\ncode s : 4..6\nopen when s <= n < 8",
    "long": "frame 12 slots of 0.5s\ncode stop : 1..12\nopen when n < stop",
}
CHIPS = ("scamp5", "scamp5-algorithm1", "scamp7")


@cache
def built(text, lowering="auto", chip="scamp5", **changes):
    """The compiled program and its report; None where the lowering does not serve."""
    target = replace(load_target(chip, Path()), **changes)
    # Every level is counted alike: this one does not search for long.
    options = Options(1, codes="open", lowering=lowering, price_all=True, target=target)
    source = Source("test.nsl", f"nsl 1\n{text}\n")
    compiled = compile_source(source, Path(), options)
    return compiled, report(compiled.layout, compiled.proof)


def word_us(name, target):
    """Time of one word, by its name: lower case is analog but for the digital halves."""
    analog = name in ("nop", "rpix", "all", "bus", "bus2", "bus3", "where")
    return target.analog_word_us if analog else target.digital_word_us


EVERY = [
    pytest.param(name, chip, marks=[pytest.mark.slow] * (name == "b_many"))
    for name in TEXTS
    for chip in CHIPS
]
"""Programs and chips; the large one takes its time on each."""


@pytest.mark.parametrize(("name", "chip"), EVERY)
def test_report_counts_words_and_times_of_the_container(name, chip):
    compiled, values = built(TEXTS[name], chip=chip)
    container, target = compiled.container, compiled.program.target
    slots = container.slots
    kernels = decoded(container)
    launches = Counter(launch.kernel for launch in container.launches)
    assert values["kernels"] == [
        {"words": len(kernel), "launches": launches[i]} for i, kernel in enumerate(kernels)
    ]
    words = words_at(container)
    assert values["words_total"] == sum(map(len, words))
    assert values["words_stored"] == sum(len(kernel.words) for kernel in container.kernels)
    assert values["words_per_slot"] == {
        "mean": pytest.approx(sum(map(len, words)) / slots),
        "max": max(map(len, words)),
    }
    assert values["target"] == chip
    assert values["slots"] == slots
    assert values["slot_time_us"] == list(container.slot_us)
    assert values["source_sha256"] == hashlib.sha256(f"nsl 1\n{TEXTS[name]}\n".encode()).hexdigest()
    assert values["codes"] == {
        "mode": "open",
        "count": len(container.table.codes),
        "shutters": len(container.table.shutters),
    }
    assert json.loads(json.dumps(values)) == values
    starts = Counter(launch.instant for launch in container.launches)
    busy = [
        sum(word_us(name, target) for name, _, _ in here)
        + starts[n] * target.launch_us
        + (target.wait_us if n and starts[n] else 0.0)
        for n, here in enumerate(words)
    ]
    exposed = max(i for i, word in enumerate(words[0]) if word[0] == "rpix")
    setup_us = target.launch_us + sum(word_us(w[0], target) for w in words[0][: exposed + 1])
    shortest_us = max([busy[0] - setup_us, *busy[1:slots]])
    assert values["shortest_slot_us"] == pytest.approx(shortest_us, abs=2e-6)
    assert values["frame_us"] == pytest.approx(
        setup_us + sum(container.slot_us) + busy[slots], abs=2e-6
    )


@pytest.mark.parametrize(("name", "chip"), EVERY)
def test_report_counts_gates_and_registers_of_the_container(name, chip):
    compiled, values = built(TEXTS[name], chip=chip)
    logic = values["logic"]
    gates = (
        "WHERE",
        "SET",
        "CLR",
        "MOV",
        "NOT",
        "OR",
        "NOR",
        "OR.read",
        "OR.write",
        "NOR.read",
        "NOR.write",
    )
    per_boundary = []
    for here in words_at(compiled.container):
        names = " ".join(f"{name}.FLAG" if "FLAG" in sources else name for name, _, sources in here)
        # The masked register's refresh sets its mask, whose own code waits in FLAG: no gates.
        pair = "REFRESH.read REFRESH.write"
        names = names.replace(f"WHERE SET {pair} MOV.FLAG", pair).replace(f"SET {pair}", pair)
        names = names.replace(".FLAG", "")
        per_boundary.append([name for name in names.split() if name in gates])
    every = [name for here in per_boundary for name in here]
    assert logic["words"] == len(every)
    assert logic["in_place"] == sum(name.endswith(".read") for name in every)
    assert logic["ops"] == logic["words"] - logic["in_place"]
    assert logic["max_slot_words"] == max(map(len, per_boundary))
    used = set(compiled.container.code_registers)
    for here in words_at(compiled.container):
        for name, destinations, sources in here:
            if name in gates or name.startswith("REFRESH"):
                used |= {r for r in destinations + sources if r.startswith("R")}
    assert logic["registers"] == len(used)
    assert set(values["digital_registers"]) == used


class Counting(Chip):
    """Counts the `bus` words that take place in each pixel, and watches the values' extremes."""

    counts: np.ndarray
    read: np.ndarray
    held: np.ndarray
    registers: tuple[str, ...]

    def run(self, name, destinations, sources):
        """One word."""
        if name in ("bus", "bus2", "bus3"):
            self.counts = self.counts + self.flag
            if "PIX" in sources:
                value = np.where(self.flag, self.analog["PIX"], 0)
                self.read = np.maximum(self.read, value)
        super().run(name, destinations, sources)
        for register in self.registers:
            value = np.abs(self.analog[register])
            self.held = np.maximum(self.held, value if self.cleared else 0)

    cleared = False


def exposed(container, light_e):
    """A chip of one pixel for each shutter after a frame of `light_e` electrons at constant light;
    `counts` are those of the boundaries after the first."""
    target = container.target
    shape = (1, len(container.encoding))
    digital = {name: np.zeros(shape, bool) for name in (*target.digital_registers, "SELECT")}
    for name in container.code_registers:
        column = container.encoding[:, target.digital_registers.index(name)]
        digital[name] = column[None].copy()
    analog = {name: np.zeros(shape) for name in (*target.analog_registers, "PIX", "IN")}
    chip = Counting(
        analog,
        digital,
        np.zeros(shape, bool),
        np.zeros(shape),
        target.reset_honours_flag == "yes",
        target.where_obeys_flag,
    )
    chip.counts, chip.read, chip.held = (np.zeros(shape) for _ in range(3))
    chip.registers = tuple(readout.register for readout in container.readouts)
    words = words_at(container)
    share = np.array(container.slot_us) / sum(container.slot_us)
    for n, here in enumerate(words):
        chip.expose([here], share[n : n + 1, None, None] * light_e)
        if n == 0:
            chip.counts, chip.cleared = np.zeros(shape), True
    return chip


@pytest.mark.parametrize("full_well_e", [10_000.0, 30_000.0])
@pytest.mark.parametrize("chip", CHIPS[:2])
@pytest.mark.parametrize("lowering", ["accumulate", "latch", "edges"])
@pytest.mark.parametrize("name", [name for name in TEXTS if name != "b_many"])
def test_analog_writes_and_headroom_are_those_of_a_frame(name, lowering, chip, full_well_e):
    if lowering == "latch" and name not in ("a", "b", "b_unequal", "long"):
        return
    compiled, values = built(TEXTS[name], lowering, chip, full_well_e=full_well_e)
    container, target = compiled.container, compiled.program.target
    assert values["lowering"] == lowering
    headroom_e = values["headroom_e"]
    below, above = exposed(container, headroom_e * 0.999), exposed(container, headroom_e * 1.001)
    opens = container.table.shutters.any(axis=(1, 2))
    counts = below.counts[0, opens]
    assert values["analog_writes"] == {"min": counts.min(), "max": counts.max()}
    assert below.read.max() <= target.full_well_e
    assert below.held.max() <= target.register_max_e
    assert above.read.max() > target.full_well_e or above.held.max() > target.register_max_e


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[pytest.mark.slow] * (n == "b_many")) for n in TEXTS]
)
def test_alternatives_are_the_other_lowerings(name):
    _, values = built(TEXTS[name])
    others = {other["lowering"]: other for other in values["alternatives"]}
    assert {*others, values["lowering"]} == {"accumulate", "latch", "edges"}
    for lowering, other in others.items():
        if "reason" in other:
            assert other["fits"] is False
            continue
        _, alone = built(TEXTS[name], lowering)
        for key in ("words_total", "words_stored", "shortest_slot_us", "analog_writes"):
            assert other[key] == alone[key]
        assert other["headroom_e"] == alone["headroom_e"]
