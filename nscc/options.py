"""The options of the compiler: their kinds, meanings and defaults, without the compiler."""

from __future__ import annotations

import os
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from nscc.toml.kinds import Flag, Instance, Integer, TextKind
from nscc.toml.schema import key

if TYPE_CHECKING:
    from nscc.chips.target import Target
    from nscc.lower.exposure_plan import LoweringOption
    from nscc.program.program import Codes


@dataclass(frozen=True)
class Options:
    """Options of the compiler; each field that is an option of the command line declares its
    meaning.

    `price_all` computes the costs of all lowerings (ways to compute the exposure), for the report.
    If `unproved_is_error` is false and only a longer search can decide whether the program fits,
    this is a note instead of an error."""

    level: int = key(
        Integer(0, 3),
        "Effort of the search for fewer words",
        2,
        option="-O",
        default_text="2; check: 1",
    )
    codes: Codes = key(
        TextKind(("fixed", "open")), "Compile for the codes in use, or for every legal one", "fixed"
    )
    lowering: LoweringOption = key(
        TextKind(("auto", "accumulate", "latch", "edges")),
        "How the exposure is computed",
        "auto",
        default_text="auto, the cheapest",
    )
    target: Target | str | None = key(
        Instance(
            (str, os.PathLike, "nscc.chips.target:Target"), "a chip's name, its file or a Target"
        ),
        "The chip, instead of the chip in the program",
        None,
        notation="NAME|FILE.toml",
    )
    cache: bool = key(
        Flag(),
        "Store search results of -O2 and -O3 and reuse them (default), or search again",
        True,
        option="--cache/--no-cache",
    )
    max_words_per_slot: int | None = key(
        Integer(1, inf),
        "Reject programs that execute more words than this in any slot",
        None,
        notation="W",
    )
    price_all: bool = False
    unproved_is_error: bool = True
