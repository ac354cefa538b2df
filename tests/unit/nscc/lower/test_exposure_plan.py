"""Programs of every class, lowered in every way: words against equation (3)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lowering_oracle import (
    container_of,
    does_as_told,
    longest_memory_us,
    lowered_as,
    program_from,
)
from program_oracle import program_of

from nscc.chips.load import load_target
from nscc.lower.exposure_plan import LOWERINGS, Misfit
from nscc.prove.proof import prove
from nscc.words.legality import decoded

B = "code stop : 0..N\nopen when n < stop"
D = "code a : 0..N - 1\ncode b : 1..N\nrequire a < b\nopen when a <= n < b"
TEXTS = {
    "a": "frame 9 slots of 1ms\nopen when true",
    "never": "frame 9 slots of 1ms\nopen when false",
    "single_code": "frame 9 slots of 1ms\ncode s : 4..4\nopen when 2 <= n < s",
    **{f"b{n}": f"frame {n} slots of 1ms\n{B}" for n in (1, 2, 3, 7, 13, 17, 33, 65, 100, 200)},
    "b_unequal": f"frame slots [10us, 20us, 50us, 1ms, 7ms]\n{B}",
    **{
        f"c{n}_{length}": f"frame {n} slots of 1ms\ncode s : 0..N - {length}\n"
        f"open when s <= n < s + {length}"
        for n, length in ((2, 1), (13, 3), (33, 8), (65, 5), (100, 13))
    },
    "c_cut": "frame 20 slots of 1ms\ncode s : 0..19\nopen when s <= n < s + 6",
    **{f"d{n}": f"frame {n} slots of 1ms\n{D}" for n in (1, 2, 3, 7, 13, 17, 33)},
    "d_never": "frame 16 slots of 1ms\ncode a : 0..15\ncode b : 0..16\nopen when a <= n < b",
    **{
        f"e{n}": f"frame {n} slots of 1ms\ncode bits : bit[{n}]\nopen when bits[n]"
        for n in (1, 2, 7, 12, 13)
    },
    "codebook": "frame 20 slots of 2ms\nshutters book [ 1111_0000_1111_0000_1111,"
    " 0000_1111_0000_1111_0000, 1010_1010_1010_1010_1010, 0000_0000_1111_1111_1111 ]\n"
    "code id : row of book\nopen when book[id]",
    "general": "frame slots [50us, 100us, 200us, 400us, 800us, 1.6ms, 3.2ms, 6.4ms]\n"
    "code longest : 0..7\ncode skip : 0..7\nopen when n <= longest and n != skip",
    "bump_or_never": "frame 64 slots of 1ms\ncode a : 0..63\ncode b : 0..64\nopen when a <= n < b",
    "hole": "frame 32 slots of 1ms\ncode a : 0..31\ncode b : 0..31\nopen when n <= a and n != b",
    "phase": "frame 20 slots of 1ms\ncode p : 1..9\ncode q : 0..8\nrequire q < p\n"
    "open when n % p == q",
    "flutter": "frame 24 slots of 1ms\ncode p : 1..6\nopen when n % p == 0",
    "two_buckets": "frame 21 slots of 1ms\ncode split : 1..20\n"
    "bucket early open when n < split\nbucket late open when n >= split",
    "overlapping": "frame 9 slots of 1ms\ncode s : 1..8\nbucket all open when true\n"
    "bucket some open when n < s\nbucket none open when n > n + s",
    **{
        f"{k}_buckets": "frame 12 slots of 1ms\ncode s : 0..5\n"
        + "\n".join(f"bucket b{i} open when s + {i} <= n < s + {i + 2}" for i in range(k))
        for k in (4, 5, 6)
    },
    "long_frame": f"frame 7 slots of 0.9s\n{B}",
    "long_bumps": f"frame 20 slots of 0.1s\n{D}",
    "long_bits": "frame 12 slots of 0.5s\ncode bits : bit[12]\nopen when bits[n]",
}


def behaves(program, lowering, level):
    """Whether the lowering serves the program; asserts that its words are right."""
    lowered = lowered_as(program, lowering, level)
    if isinstance(lowered, Misfit):
        return False
    container = container_of(lowered, level)
    assert lowered.retained
    assert does_as_told(container)
    assert longest_memory_us(container) <= program.target.digital_retention_us
    assert prove(container, decoded(container)).holds
    return True


@pytest.mark.parametrize("name", TEXTS)
def test_every_class_has_the_same_shutters_in_all_lowerings(name):
    """A lowering that serves a program at level 0 serves it at level 1. At least one serves
    each."""
    program = program_of(f"nsl 1\n{TEXTS[name]}\n", "open")
    served = {(w, level): behaves(program, w, level) for w in LOWERINGS for level in (0, 1)}
    assert any(served.values())
    assert all(served[w, 0] == served[w, 1] for w in LOWERINGS), served


BEHAVIOURS = {
    "as it is": {},
    "reset unknown": {"reset_honours_flag": "unknown"},
    "reset by pixel": {"reset_honours_flag": "yes"},
    "library calls": {"or_sources": 4, "where_sources": 3},
    "two inputs": {"or_sources": 2, "where_sources": 2},
    "FLAG readable": {"where_reads_flag": True, "where_obeys_flag": True},
    "no masked register": {
        "mask_register": None,
        "masked_register": None,
        "digital_registers": tuple(f"R{i}" for i in range(12)),
    },
    "small store": {"store_words": 60},
    "no readout time": {"readout_us": 0.0},
}


@pytest.mark.parametrize("name", ["b17", "c33_8", "d13", "e7", "codebook", "two_buckets"])
@pytest.mark.parametrize("chip", ["scamp5", "scamp7"])
@pytest.mark.parametrize("behaviour", BEHAVIOURS)
def test_every_variant_of_a_chip_serves_accumulate_and_edges(name, chip, behaviour):
    """Each variant of SCAMP-5 and SCAMP-7 exposes all six programs by `accumulate` and `edges`."""
    target = replace(load_target(chip, Path()), **BEHAVIOURS[behaviour])
    program = program_of(f"nsl 1\n{TEXTS[name]}\n", "open", target=target)
    served = [lowering for lowering in LOWERINGS if behaves(program, lowering, 1)]
    assert {"accumulate", "edges"} <= set(served)


def test_seven_buckets_need_seven_registers():
    """Of six registers each bucket takes one, and each lowering but `edges` one more. Only six
    buckets by `edges` fit."""
    table = np.arange(4)[:, None, None] <= np.arange(9)
    for lowering in LOWERINGS:
        for buckets in (6, 7):
            lowered = lowered_as(program_from(np.repeat(table, buckets, axis=1)), lowering)
            if buckets == 6 and lowering == "edges":
                assert not isinstance(lowered, Misfit)
                continue
            assert isinstance(lowered, Misfit)
            assert (lowered.available, lowered.required) == (6, buckets + (lowering != "edges"))


def test_latch_needs_shutters_that_open_with_the_frame():
    """A shutter of 011 opens late and is refused. Shutters of 000 and 110 are accepted."""
    lowered = lowered_as(program_from([[0, 1, 1], [1, 1, 0]]), "latch")
    assert isinstance(lowered, Misfit)
    assert "latch requires" in lowered.reason
    assert not isinstance(lowered_as(program_from([[0, 0, 0], [1, 1, 0]]), "latch"), Misfit)
