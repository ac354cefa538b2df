"""What a compiler, a trainer and an emulator may know of a chip: one frozen value from TOML."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Target:
    """A chip as a compile target. Every number carries its unit; None means no limit.

    Registers are those of one pixel. `frame_register` names are analog registers that hold a
    frame; `analog_scratch` is overwritten by analog sequences. The register `masked_register` takes
    a write only where `mask_register` is 1 (both None where the chip has no such rule).
    """

    name: str
    description: str
    rows: int
    cols: int
    analog_registers: tuple[str, ...]
    analog_scratch: str
    digital_registers: tuple[str, ...]
    mask_register: str | None
    masked_register: str | None

    reset_honours_flag: Literal["no", "yes", "unknown"]
    """Does rpix reset only the pixels whose FLAG is 1?"""
    where_reads_flag: bool
    """May WHERE, which writes FLAG, also read it?"""
    where_obeys_flag: bool
    """Does the analog `where` itself obey FLAG?"""
    or_sources: int | None
    """Most sources of one OR or NOR word."""
    where_sources: int | None
    """Most sources of one WHERE word."""

    store_words: int
    """ICWs that all stored kernels together may have."""
    tables_count_against_store: bool
    """Do constant kernel tables count against the store?"""

    analog_word_us: float
    digital_word_us: float
    launch_us: float
    """Overhead of launching one kernel."""
    readout_us: float
    """Time to read one analog register of the whole array out."""
    digital_retention_us: float
    """Time after which an untouched digital register has lost its bit."""

    full_well_e: float
    register_min_e: float
    register_max_e: float
    adc_bits: int
    adc_offset_lsb: float

    @property
    def electrons_per_lsb(self) -> float:
        """Electrons a code of the readout ADC."""
        return self.full_well_e / ((1 << self.adc_bits) - 1)

    @property
    def analog_available(self) -> tuple[str, ...]:
        """The analog registers that keep a value while other analog words run."""
        return tuple(r for r in self.analog_registers if r != self.analog_scratch)
