"""What a compiler, a trainer and an emulator may know of a chip: one frozen value from TOML.

The fields are the keys of a target file: reading one, writing one, listing a target and the table
in a container all follow from them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from nscc.toml.kinds import Flag, Integer, Name, Number, Register, Registers, Text
from nscc.toml.schema import Codes, Schema, keys_of, setting

_SIDE = Integer(1, 8192)
_SOURCES = Integer(2, 1000, unlimited=True)
_NOT_PUBLIC = "not public"


@dataclass(frozen=True, kw_only=True)
class Target:
    """A chip as a compile target. Every number carries its unit; None means no limit, or none.

    Registers are those of one pixel. A key without a default of its own that is not required has
    scamp5's value where a file leaves it out.
    """

    name: str = setting(Name(), "what messages and reports call it", required=True)
    description: str = setting(Text(longest=400), "one line for `nscc targets`", default="")

    rows: int = setting(_SIDE, "pixels from top to bottom", path="array.rows", required=True)
    cols: int = setting(_SIDE, "pixels from left to right", path="array.cols", required=True)

    analog_registers: tuple[str, ...] = setting(
        Registers(), "analog registers of one pixel", path="registers.analog", required=True
    )
    analog_scratch: str = setting(
        Register(), "every analog sequence passes through it",
        path="registers.analog_scratch", required=True,
    )  # fmt: skip
    digital_registers: tuple[str, ...] = setting(
        Registers(), "one-bit registers of one pixel", path="registers.digital", required=True
    )
    mask_register: str | None = setting(
        Register(), "a write to `masked` takes place only where it is 1",
        path="registers.mask", default=None,
    )  # fmt: skip
    masked_register: str | None = setting(
        Register(), 'the register that `mask` guards; both are "none" on a chip without this',
        path="registers.masked", default=None,
    )  # fmt: skip

    reset_honours_flag: Literal["no", "yes", "unknown"] = setting(
        Text(("no", "yes", "unknown")),
        'does rpix reset only where FLAG is 1? "no", "yes" or "unknown"',
        path="behaviour.reset_honours_flag", source=_NOT_PUBLIC,
    )  # fmt: skip
    where_reads_flag: bool = setting(
        Flag(), "may WHERE read FLAG, which it also writes?",
        path="behaviour.where_reads_flag", source=_NOT_PUBLIC,
    )  # fmt: skip
    where_obeys_flag: bool = setting(
        Flag(), "does the analog `where` itself act only where FLAG is 1?",
        path="behaviour.where_obeys_flag", source=_NOT_PUBLIC,
    )  # fmt: skip
    or_sources: int | None = setting(
        _SOURCES, 'most sources of an OR or NOR word: "any" or a number',
        path="behaviour.or_sources", source=_NOT_PUBLIC,
    )  # fmt: skip
    where_sources: int | None = setting(
        _SOURCES, 'most sources of a WHERE word: "any" or a number',
        path="behaviour.where_sources", source=_NOT_PUBLIC,
    )  # fmt: skip

    store_words: int = setting(
        Integer(1, 1 << 18), "ICWs that all stored kernels may have", path="store.words"
    )
    tables_count_against_store: bool = setting(
        Flag(), "do constant kernel tables count against the store?",
        path="store.tables_count", source=_NOT_PUBLIC,
    )  # fmt: skip

    analog_word_us: float = setting(
        Number(0, 1e6, low_excluded=True), "one analog word",
        path="time.analog_word_us", source=_NOT_PUBLIC,
    )  # fmt: skip
    digital_word_us: float = setting(
        Number(0, 1e6, low_excluded=True), "one digital word",
        path="time.digital_word_us", source=_NOT_PUBLIC,
    )  # fmt: skip
    launch_us: float = setting(
        Number(0, 1e9), "overhead of one kernel launch", path="time.launch_us", source=_NOT_PUBLIC
    )
    readout_us: float = setting(
        Number(0, 1e12), "reading one analog register of the whole array out",
        path="time.readout_us", source=_NOT_PUBLIC,
    )  # fmt: skip
    digital_retention_us: float = setting(
        Number(0, 1e15, low_excluded=True),
        "an untouched digital register keeps its bit for so long",
        path="time.digital_retention_us",
    )  # fmt: skip

    full_well_e: float = setting(
        Number(0, 1e15, low_excluded=True), "electrons that PIX can hold",
        path="range.full_well_e", source=_NOT_PUBLIC,
    )  # fmt: skip
    register_min_e: float = setting(
        Number(-1e15, 0, high_excluded=True), "least value of an analog register, below 0",
        path="range.register_min_e", source=_NOT_PUBLIC,
    )  # fmt: skip
    register_max_e: float = setting(
        Number(0, 1e15, low_excluded=True), "largest value of an analog register, above 0",
        path="range.register_max_e", source=_NOT_PUBLIC,
    )  # fmt: skip
    adc_bits: int = setting(Integer(1, 16), "bits of the readout", path="range.adc_bits")
    adc_offset_lsb: float = setting(
        Number(-65536, 65536), "code of a register that holds nothing",
        path="range.adc_offset_lsb", source=_NOT_PUBLIC,
    )  # fmt: skip

    @property
    def electrons_per_lsb(self) -> float:
        """Electrons a code of the readout ADC."""
        return self.full_well_e / ((1 << self.adc_bits) - 1)

    @property
    def analog_available(self) -> tuple[str, ...]:
        """The analog registers that keep a value while other analog words run."""
        return tuple(r for r in self.analog_registers if r != self.analog_scratch)


SCHEMA = Schema(
    "a target",
    "target file",
    keys_of(Target),
    {
        "": "",
        "array": "the pixels",
        "registers": "of one pixel",
        "behaviour": "none of these is stated in public: each key has a default",
        "store": "",
        "time": "",
        "range": "",
    },
    Codes("NS0231", "NS0232", unknown="NS0233", wrong="NS0235", missing="NS0234"),
    "`nscc targets scamp5 --toml` prints a complete file to start from",
)
