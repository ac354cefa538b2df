"""Every class in every lowering, for fixed and open codes, at each level, on three chips.

The oracle knows neither the language nor the compiler: a rule written in numpy, times light spread
over the exponents of float32.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from nscc_command import invoke

ROWS, COLS = 33, 70  # neither a multiple of the emulator's 64 pixels
Y, X = np.mgrid[0:ROWS, 0:COLS]

CHIP = f"""name = "small"
description = "an array of odd size"
[array]
rows = {ROWS}
cols = {COLS}
[registers]
analog = ["A", "B", "C", "D", "E", "F", "NEWS"]
analog_scratch = "NEWS"
digital = ["R0", "R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9", "R10", "R11", "R12"]
mask = "R0"
masked = "R12"
[behaviour]
"""
PLAIN = "plain"
CHIPS = {
    PLAIN: "",
    "narrow": 'reset_honours_flag = "unknown"\nor_sources = 4\nwhere_sources = 3\n',
    "generous": 'reset_honours_flag = "yes"\nwhere_reads_flag = true\nwhere_obeys_flag = true\n',
}

Rule = Callable[[np.ndarray], np.ndarray]
PROGRAMS: dict[str, tuple[int, str, tuple[Rule, ...]]] = {}


def add(name: str, slots: int, text: str, *rules: Rule) -> None:
    """A program of `slots` slots, and for each bucket S as a function of n (N, 1, 1)."""
    PROGRAMS[name] = (slots, text, rules)


add("a", 7, "open when true", lambda n: np.ones((len(n), ROWS, COLS), bool))
for count in (5, 17, 64, 100):
    stop = (7 * X + 13 * Y) % (count + 1)
    add(
        f"b{count}",
        count,
        f"code stop : 0..{count} open when n < stop pixels stop = (7*x + 13*y) % {count + 1}",
        lambda n, stop=stop: n < stop,
    )
for count, long in ((64, 8), (65, 5), (30, 7), (128, 13)):
    start = (7 * X + 13 * Y) % (count - long + 1)
    add(
        f"c{count}_{long}",
        count,
        f"code s : 0..{count - long} open when s <= n < s + {long} "
        f"pixels s = (7*x + 13*y) % {count - long + 1}",
        lambda n, s=start, long=long: (s <= n) & (n < s + long),
    )
for count in (3, 16, 33, 63):
    start = (X + 4 * Y) % (count - 1)
    stop = np.minimum(count, 1 + start + (X * Y) % 5)
    add(
        f"d{count}",
        count,
        f"code s : 0..{count - 1} code e : 1..{count} require s < e open when s <= n < e "
        f"pixels s = (x + 4*y) % {count - 1} "
        f"pixels e = min(N, 1 + (x + 4*y) % {count - 1} + (x*y) % 5)",
        lambda n, s=start, e=stop: (s <= n) & (n < e),
    )
for count in (1, 8, 13):
    bits = (2917 * X + 4421 * Y) % 2**count
    add(
        f"e{count}",
        count,
        f"code b : bit[{count}] open when b[n] pixels b = (2917*x + 4421*y) % {2**count}",
        lambda n, b=bits: (b >> n & 1) == 1,
    )
BOOK = np.random.default_rng(3).integers(0, 2, (20, 24))
add(
    "book",
    24,
    "shutters book [" + ", ".join("".join(map(str, row)) for row in BOOK) + "] "
    "code id : row of book open when book[id] pixels id = (3*x + 7*y) % 20",
    lambda n: BOOK.T[:, (3 * X + 7 * Y) % 20] == 1,
)
add(
    "three",
    12,
    "code s : 0..11 bucket p open when n < s bucket q open when n % 3 == s % 3 "
    "bucket r open when s <= n < s + 2 or n == 0 pixels s = (x + y) % 12",
    lambda n: n < (X + Y) % 12,
    lambda n: n % 3 == (X + Y) % 12 % 3,
    lambda n: ((n >= (X + Y) % 12) & (n < (X + Y) % 12 + 2)) | (n == 0),
)

MAY_FAIL = {"NS0414", "NS0501", "NS0502", "NS0601"}
"""A lowering that was asked for may not serve the program, or not fit; `auto` must."""


@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_of_level_1_equal_a_rule_in_numpy(name: str, tmp_path: Path) -> None:
    """On the plain chip at level 1, every lowering opens the shutters that a numpy rule
    computes."""
    sweep(name, tmp_path, chips=(PLAIN,), levels=("1",))


@pytest.mark.slow
@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_of_every_chip_and_level_equal_a_rule_in_numpy(name: str, tmp_path: Path) -> None:
    """On each chip at levels 0, 1 and 2, every lowering opens the shutters that a numpy rule
    computes."""
    sweep(name, tmp_path, chips=tuple(CHIPS), levels=("0", "1", "2"))


# The last level searches for minutes wherever there may be something to gain.
@pytest.mark.slow
@pytest.mark.parametrize("name", ["b5", "d16", "e8", "three"])
def test_programs_of_level_3_equal_a_rule_in_numpy(name: str, tmp_path: Path) -> None:
    """At level 3, which searches longest, four programs on the plain chip open the shutters that a
    numpy rule computes."""
    sweep(name, tmp_path, chips=(PLAIN,), levels=("3",), lowerings=("auto",))


def sweep(
    name: str,
    folder: Path,
    chips: tuple[str, ...],
    levels: tuple[str, ...],
    lowerings: tuple[str, ...] = ("auto", "accumulate", "latch", "edges"),
) -> None:
    """Builds, proves and runs a program in every way, and compares each frame."""
    slots, text, rules = PROGRAMS[name]
    (folder / "p.nsl").write_text(f"nsl 1 frame {slots} slots of 50us {text}\n")
    for chip in chips:
        (folder / f"{chip}.toml").write_text(CHIP + CHIPS[chip])
    light = np.exp(np.random.default_rng(slots).normal(0, 6, (slots, ROWS, COLS)))
    light[:, :3] = 0
    light = light.astype(np.float32)
    np.savez(folder / "light.npz", light=light)
    n = np.arange(slots)[:, None, None]
    shutter = np.stack([np.broadcast_to(rule(n), light.shape) for rule in rules])
    wanted = (shutter * light.astype(np.float64)).sum(1)
    allowed = 1e-6 * wanted + 1e-9 * light.astype(np.float64).sum(0)
    never = ~shutter.any(1)
    for chip, codes, lowering, level in product(chips, ("fixed", "open"), lowerings, levels):
        way = ["--target", f"{chip}.toml", "--codes", codes, "--lowering", lowering, "-O", level]
        built = invoke(["build", "p.nsl", "-o", "p.icw", *way], folder)
        if built.status:
            assert lowering != "auto", (way, built.err)
            assert set(built.codes) & MAY_FAIL, (way, built.err)
            continue
        assert invoke(["prove", "p.icw"], folder).status == 0, way
        ran = invoke(["run", "p.icw", "--scene", "light.npz", "-o", "f.npz"], folder)
        assert ran.status == 0, (way, ran.err)
        with np.load(folder / "f.npz") as frame:
            exposure = frame["exposure_e"]
        assert (np.abs(exposure - wanted) <= allowed).all(), way
        assert (exposure[never] == 0).all(), way
        assert not np.signbit(exposure[never]).any(), way
