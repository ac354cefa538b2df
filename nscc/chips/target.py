"""Description of a chip for compiler, trainer and emulator, read from a TOML file.

The fields of `Target` are the keys of a target file, and also determine how targets are written,
listed and stored in containers. There are two kinds of chip with different keys. Pixels of the kind
"scamp" have a processor. Pixels of the kind "stream" have no logic and receive a bit for every
slot."""

from __future__ import annotations

from dataclasses import MISSING, dataclass, replace
from functools import partial
from typing import Any, Literal

from nscc.chips.words import OwnWords
from nscc.operations import Operation
from nscc.toml.kinds import LINE, NAME, Flag, Integer, Number, Several, TextKind
from nscc.toml.schema import FileCodes, Key, Schema, key, keys_of

_SIDE = Integer(1, 8192)
_REGISTER = TextKind(phrase="the name of a register", optional=True)
_REGISTERS = Several(TextKind(), text="a list of register names")
_TAP = TextKind(pattern=r"[A-Z][A-Z0-9_]{0,15}")
_SOURCES = Integer(2, 1000, unlimited=True)
_WORD_US = Number(0, 1e6, low_excluded=True)
_ABOVE_0 = Number(0, 1e15, low_excluded=True)
_ours = partial(key, source="not public")
_stream = partial(key, section="stream")
_neighbours_key = partial(key, source="not public", section="neighbours", later=True)
_in = partial(key, source="not public", section="in", later=True)
_memory = partial(key, section="memory", later=True)


@dataclass(frozen=True, kw_only=True)
class Target:
    """A chip as a compile target.

    Every number has its unit in its name; None means no limit, or that the chip lacks the feature.
    Registers are those of one pixel. An optional key without a default has scamp5's value."""

    name: str = key(NAME, "its name in messages and reports", required=True)
    kind: Literal["scamp", "stream"] = key(
        TextKind(("scamp", "stream")),
        'pixels with a processor ("scamp"), or sent a bit for every slot ("stream")',
        default="scamp",
        later=True,
    )
    description: str = key(LINE, "one line for `nscc targets`", default="")
    words: tuple[Operation, ...] = key(
        OwnWords(), "words that only this chip has, each in a [[words]] of its own", default=()
    )

    rows: int = key(_SIDE, "pixels from top to bottom", section="array", required=True)
    cols: int = key(_SIDE, "pixels from left to right", section="array", required=True)

    analog_registers: tuple[str, ...] = key(
        _REGISTERS,
        "analog registers of one pixel",
        section="registers",
        name="analog",
        required=True,
    )
    analog_scratch: str = key(
        _REGISTER,
        "register that every analog sequence overwrites",
        section="registers",
        required=True,
    )
    digital_registers: tuple[str, ...] = key(
        _REGISTERS,
        "one-bit registers of one pixel",
        section="registers",
        name="digital",
        required=True,
    )
    mask_register: str | None = key(
        _REGISTER,
        "a word changes `masked` only in pixels where this register is 1",
        section="registers",
        name="mask",
        default=None,
    )
    masked_register: str | None = key(
        _REGISTER,
        'the register that `mask` guards; both are "none" on a chip without this',
        section="registers",
        name="masked",
        default=None,
    )

    reset_honours_flag: Literal["no", "yes", "unknown"] = _ours(
        TextKind(("no", "yes", "unknown")),
        'does rpix reset only where FLAG is 1? "no", "yes" or "unknown"',
        section="behaviour",
    )
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
        Integer(1, 1 << 18),
        "largest number of ICWs in all stored kernels",
        section="store",
        name="words",
    )
    tables_count_against_store: bool = _ours(
        Flag(),
        "do constant kernel tables count against the store?",
        section="store",
        name="tables_count",
    )

    analog_word_us: float = _ours(_WORD_US, "one analog word", section="time")
    digital_word_us: float = _ours(_WORD_US, "one digital word", section="time")
    launch_us: float = _ours(Number(0, 1e9), "overhead of one kernel launch", section="time")
    wait_us: float = _ours(
        Number(0, 1e9),
        "the frame loop's own time at a boundary",
        section="time",
        later=True,
        default=1.0,
    )
    readout_us: float = _ours(
        Number(0, 1e12),
        "reading one analog register, or all taps, of the whole array out",
        section="time",
    )
    digital_retention_us: float = key(
        _ABOVE_0, "time for which a digital register keeps an unwritten bit", section="time"
    )

    full_well_e: float = _ours(_ABOVE_0, "electrons that PIX, or a tap, can hold", section="range")
    register_min_e: float = _ours(
        Number(-1e15, 0, high_excluded=True),
        "least value of an analog register, below 0",
        section="range",
    )
    register_max_e: float = _ours(
        _ABOVE_0, "largest value of an analog register, above 0", section="range"
    )
    adc_bits: int = key(Integer(1, 16), "bits of the readout", section="range")
    adc_offset_lsb: float = _ours(
        Number(-65536, 65536),
        "offset added to the converter code of an exposure of 0",
        section="range",
    )
    readout: Literal["spread", "full", "half"] = key(
        TextKind(("spread", "full", "half")),
        "codes of 0 .. full_well_e: spread, all of them (2 x exposure - full well is converted); "
        "full, the upper half, for the converter is symmetric around 0; half, 0 to the middle",
        section="range",
        default="spread",
        later=True,
        source="not public",
    )

    in_low: int = _in(Integer(-32767, 0), "least value of IN, in steps", default=-127)
    in_high: int = _in(Integer(1, 32767), "largest value of IN, in steps", default=126)
    in_step_e: float | None = _in(
        Number(0, 1e15, low_excluded=True, automatic=True),
        'electrons a step of IN; "auto": register_max_e / 127',
        default=None,
    )
    in_settle_us: float = _in(
        Number(0, 1e9), "time from setting IN to the first word that reads it", default=5.0
    )

    sees_neighbours: bool = _neighbours_key(
        Flag(), "do words reach the NEWS, and the digital registers, of neighbours?", default=True
    )
    directed_sources: int = _neighbours_key(
        Integer(1, 4),
        "most analog sources of a word that writes or reads a neighbour's NEWS",
        default=2,
    )
    directed_halving: bool = _neighbours_key(
        Flag(), "may a bus2 word read a neighbour's NEWS?", default=False
    )
    news_read_keeps: bool = _neighbours_key(
        Flag(), "does NEWS keep its value when neighbours read it?", default=True
    )

    propagation_pixels: int = _neighbours_key(
        Integer(0, 1 << 16),
        "how many pixels far does one PROP flood? 0: not at all; 128 is assumed",
        default=128,
    )

    leakage_tau_s: float = _memory(
        Number(0, 1e9, low_excluded=True),
        "time constant with which an analog register loses its value, in seconds",
        default=10.0,
        source="not public",
    )
    analog_move_loss: float = _memory(
        Number(0, 1),
        "1 - gain of a copy between analog registers, as a part of 1 - gain of an addition",
        default=0.065,
        source="fit to frames of SCAMP-5",
    )
    analog_move_noise: float = _memory(
        Number(0, 1),
        "random error of such a copy, as a part of that of an addition",
        default=0.0,
        source="fit to frames of SCAMP-5",
    )

    taps: tuple[str, ...] = _stream(
        Several(_TAP, text="a list of names of capital letters, digits and `_`"),
        "where a pixel can collect charge, in the order of a program's buckets",
        default=(),
        required=True,
    )
    drain: bool = _stream(Flag(), "can a slot's bit also select a drain?", default=False)
    row_load_us: float = _stream(
        _WORD_US, "time to send one row of a bit plane", default=1.0, required=True
    )
    pipelined: bool = _stream(
        Flag(),
        "is a bit plane loaded while the previous one acts?",
        default=True,
    )
    tap_gain: tuple[float, ...] = _stream(
        Several(Number(0, 1e6, low_excluded=True), text="a list of numbers above 0, one per tap"),
        "gain from a tap's charge to the converter; [] is 1 for each",
        default=(),
    )

    @property
    def has_logic(self) -> bool:
        """Whether the pixels execute instruction words; else they receive a bit for every slot."""
        return self.kind == "scamp"

    @property
    def plane_load_us(self) -> float:
        """The time to load a bit plane, in microseconds: `row_load_us` for each row."""
        return self.rows * self.row_load_us

    @property
    def gains(self) -> tuple[float, ...]:
        """The gain from each tap's charge to the converter, in the order of `taps`; 1 if none is
        declared."""
        return self.tap_gain or (1.0,) * len(self.taps)

    @property
    def electrons_per_step(self) -> float:
        """Electrons per step of IN (the level sent to all pixels): `in_step_e` or, if that is None,
        `register_max_e` / 127."""
        # The magnitude of the lowest default value of IN is 127: it then reaches a full register.
        return self.register_max_e / 127 if self.in_step_e is None else self.in_step_e

    @property
    def electrons_per_lsb(self) -> float:
        """Electrons per step of the converter: its range in electrons, divided by the steps between
        its codes."""
        return self.full_well_e * self.wells_read / ((1 << self.adc_bits) - 1)

    def level_e(self, value: float, unit: str) -> float:
        """Convert a level to electrons.

        Parameters
        ----------
        value : float
            The number of the level.
        unit : {"%", "e", "lsb"}
            Percent of a full well, electrons, or converter codes.

        Returns
        -------
        float
            Electrons.
        """
        sizes_e = {"%": self.full_well_e / 100, "e": 1.0, "lsb": self.electrons_per_lsb}
        return value * sizes_e[unit]

    @property
    def wells_read(self) -> int:
        """The range of the converter in full wells: 1 if exposures are spread over it, else 2, of
        which they use half."""
        return 1 if self.conversion == "spread" else 2

    @property
    def conversion(self) -> Literal["spread", "full", "half"]:
        """The conversion that is used: `readout`, but "full" where exposures cannot be spread.

        Spreading subtracts a full well with IN (the level sent to all pixels). So IN and the
        registers must reach a full well below 0; see `spread_level`."""
        reached = not self.has_logic or self.spread_level is not None
        return "full" if self.readout == "spread" and not reached else self.readout

    @property
    def spread_level(self) -> int | None:
        """The value of IN (the level sent to all pixels), in steps, closest to minus a full well.
        Twice an exposure plus this value covers all codes.

        None if exposures are not spread, or if IN or a register does not reach this value."""
        level = round(-self.full_well_e / self.electrons_per_step)
        held_e = min(self.register_max_e, -self.register_min_e)
        reached = self.in_low <= level < 0 and self.full_well_e <= held_e
        return level if self.has_logic and self.readout == "spread" and reached else None

    @property
    def code_bits(self) -> int:
        """The number of bits of the largest converter code: with `conversion` "half", one less than
        `adc_bits`."""
        # With "half", exposures reach only the lower half of the codes.
        return self.adc_bits - (self.conversion == "half")

    @property
    def top_code(self) -> int:
        """The largest converter code, 2^`code_bits` - 1."""
        return (1 << self.code_bits) - 1

    @property
    def zero_lsb(self) -> float:
        """The converter code, possibly fractional, of an exposure of 0, with `adc_offset_lsb`."""
        zero = 0.0
        if self.conversion == "full":
            zero = 1 << (self.adc_bits - 1)  # the middle of the codes
        elif self.spread_level is not None:
            # IN is set in whole steps, so the subtracted full well may be wrong by half a step.
            taken_e = -self.spread_level * self.electrons_per_step
            # Spread exposures are twice the exposure minus a full well, hence the 2.
            zero = (self.full_well_e - taken_e) / (2 * self.electrons_per_lsb)
        return zero + self.adc_offset_lsb

    @property
    def analog_available(self) -> tuple[str, ...]:
        """The analog registers that keep a value while other analog words run: all but
        `analog_scratch`."""
        return tuple(r for r in self.analog_registers if r != self.analog_scratch)


_CODES = FileCodes("NS0231", "NS0232", unknown="NS0233", wrong_value="NS0235", missing="NS0234")
_OF_STREAMS = (
    "name",
    "kind",
    "description",
    "array.rows",
    "array.cols",
    "time.readout_us",
    "range.full_well_e",
    "range.adc_bits",
    "range.adc_offset_lsb",
)
"""Keys that both kinds of chip have."""

SCHEMA = Schema(
    "target",
    tuple(key for key in keys_of(Target) if key.section != "stream"),
    {
        "": "",
        "array": "the pixels",
        "registers": "of one pixel",
        "behaviour": "these values are not public: each key has a default",
        "store": "",
        "time": "",
        "range": "",
        "in": "the global value IN that every pixel can compare with; set between kernels",
        "neighbours": "how words reach the pixels to the north, east, south and west",
        "memory": "how exactly analog registers keep and copy a value; defaults of the emulator",
    },
    _CODES,
    "`nscc targets scamp5 --toml` prints a complete file to start from",
)
"""The target file of a chip whose pixels have a processor."""

STREAM_SCHEMA = Schema(
    "target",
    tuple(
        replace(key, default=MISSING, later=False) if key.name == "kind" else key
        for key in keys_of(Target)
        if key.section == "stream" or key.path in _OF_STREAMS
    ),
    {
        "": "",
        "array": "the pixels",
        "time": "",
        "range": "of every tap",
        "stream": "the bits that pixels receive, and where their light goes",
    },
    _CODES,
    "`nscc targets dual-tap --toml` prints a complete file to start from",
)
"""The target file of a chip whose pixels have no logic and receive bits."""


def schema_of(kind: Any) -> Schema[Key]:
    """Return the keys of target files of a kind.

    `kind` is the value of the key `kind`: "stream" for chips without logic. Any other value, also
    an invalid one, gives the keys of "scamp"."""
    return STREAM_SCHEMA if kind == "stream" else SCHEMA
