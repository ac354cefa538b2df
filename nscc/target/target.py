"""What a compiler, a trainer and an emulator may know of a chip: one frozen value from TOML.

The fields are the keys of a target file: reading one, writing one, listing a target and the table
in a container all follow from them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Literal

from nscc.operations import Operation
from nscc.target.words import OwnWords
from nscc.toml.kinds import LINE, NAME, Flag, Integer, Number, Several, Text
from nscc.toml.schema import Codes, Schema, key, keys_of

_SIDE = Integer(1, 8192)
_REGISTER = Text(said="the name of a register", optional=True)
_REGISTERS = Several(Text(), said="a list of register names")
_SOURCES = Integer(2, 1000, unlimited=True)
_WORD_US = Number(0, 1e6, low_excluded=True)
_ABOVE_0 = Number(0, 1e15, low_excluded=True)
_ours = partial(key, source="not public")
_in = partial(key, source="not public", section="in", later=True)


@dataclass(frozen=True, kw_only=True)
class Target:
    """A chip as a compile target. Every number carries its unit; None means no limit, or none.

    Registers are those of one pixel. A key without a default of its own that is not required has
    scamp5's value where a file leaves it out.
    """

    name: str = key(NAME, "what messages and reports call it", required=True)
    description: str = key(LINE, "one line for `nscc targets`", default="")
    words: tuple[Operation, ...] = key(
        OwnWords(), "words that only this chip has, each in a [[words]] of its own", default=()
    )

    rows: int = key(_SIDE, "pixels from top to bottom", section="array", required=True)
    cols: int = key(_SIDE, "pixels from left to right", section="array", required=True)

    analog_registers: tuple[str, ...] = key(
        _REGISTERS, "analog registers of one pixel", section="registers", name="analog",
        required=True,
    )  # fmt: skip
    analog_scratch: str = key(
        _REGISTER, "every analog sequence passes through it", section="registers", required=True
    )
    digital_registers: tuple[str, ...] = key(
        _REGISTERS, "one-bit registers of one pixel", section="registers", name="digital",
        required=True,
    )  # fmt: skip
    mask_register: str | None = key(
        _REGISTER, "a write to `masked` takes place only where it is 1", section="registers",
        name="mask", default=None,
    )  # fmt: skip
    masked_register: str | None = key(
        _REGISTER, 'the register that `mask` guards; both are "none" on a chip without this',
        section="registers", name="masked", default=None,
    )  # fmt: skip

    reset_honours_flag: Literal["no", "yes", "unknown"] = _ours(
        Text(("no", "yes", "unknown")),
        'does rpix reset only where FLAG is 1? "no", "yes" or "unknown"', section="behaviour",
    )  # fmt: skip
    where_reads_flag: bool = _ours(
        Flag(), "may WHERE read FLAG, which it also writes?", section="behaviour"
    )
    where_obeys_flag: bool = _ours(
        Flag(), "does the analog `where` itself act only where FLAG is 1?", section="behaviour"
    )
    or_sources: int | None = _ours(
        _SOURCES, 'most sources of an OR or NOR word: "any" or a number', section="behaviour"
    )
    where_sources: int | None = _ours(
        _SOURCES, 'most sources of a WHERE word: "any" or a number', section="behaviour"
    )

    store_words: int = key(
        Integer(1, 1 << 18), "ICWs that all stored kernels may have", section="store", name="words"
    )
    tables_count_against_store: bool = _ours(
        Flag(), "do constant kernel tables count against the store?", section="store",
        name="tables_count",
    )  # fmt: skip

    analog_word_us: float = _ours(_WORD_US, "one analog word", section="time")
    digital_word_us: float = _ours(_WORD_US, "one digital word", section="time")
    launch_us: float = _ours(Number(0, 1e9), "overhead of one kernel launch", section="time")
    readout_us: float = _ours(
        Number(0, 1e12), "reading one analog register of the whole array out", section="time"
    )
    digital_retention_us: float = key(
        _ABOVE_0, "an untouched digital register keeps its bit for so long", section="time"
    )

    full_well_e: float = _ours(_ABOVE_0, "electrons that PIX can hold", section="range")
    register_min_e: float = _ours(
        Number(-1e15, 0, high_excluded=True), "least value of an analog register, below 0",
        section="range",
    )  # fmt: skip
    register_max_e: float = _ours(
        _ABOVE_0, "largest value of an analog register, above 0", section="range"
    )
    adc_bits: int = key(Integer(1, 16), "bits of the readout", section="range")
    adc_offset_lsb: float = _ours(
        Number(-65536, 65536), "code of a register that holds nothing", section="range"
    )

    in_low: int = _in(Integer(-32767, 0), "least value of IN, in steps", default=-127)
    in_high: int = _in(Integer(1, 32767), "largest value of IN, in steps", default=126)
    in_step_e: float | None = _in(
        Number(0, 1e15, low_excluded=True, automatic=True),
        'electrons a step of IN; "auto": register_max_e / 127', default=None,
    )  # fmt: skip
    in_settle_us: float = _in(
        Number(0, 1e9), "time from setting IN to the first word that reads it", default=5.0
    )

    @property
    def electrons_per_step(self) -> float:
        """Electrons a step of IN."""
        return self.register_max_e / 127 if self.in_step_e is None else self.in_step_e

    @property
    def electrons_per_lsb(self) -> float:
        """Electrons a code of the readout ADC."""
        return self.full_well_e / ((1 << self.adc_bits) - 1)

    @property
    def analog_available(self) -> tuple[str, ...]:
        """The analog registers that keep a value while other analog words run."""
        return tuple(r for r in self.analog_registers if r != self.analog_scratch)


SCHEMA = Schema(
    "target",
    keys_of(Target),
    {
        "": "",
        "array": "the pixels",
        "registers": "of one pixel",
        "behaviour": "none of these is stated in public: each key has a default",
        "store": "",
        "time": "",
        "range": "",
        "in": "the global value IN that every pixel can compare with; set between kernels",
    },
    Codes("NS0231", "NS0232", unknown="NS0233", wrong="NS0235", missing="NS0234"),
    "`nscc targets scamp5 --toml` prints a complete file to start from",
)
