"""The keys of a target table: names, types, ranges and what is public about them.

One row a key: reading a file, writing one, listing a target and the table in a container all
follow from it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["name", "text", "integer", "number", "names", "register", "flag", "choice", "limit"]


@dataclass(frozen=True, slots=True)
class Key:
    """A key `key` of the table `section` ("" for the top), kept in `Target`'s `attribute`.

    `kind`: a name; a line of text; an integer or a number within `low`..`high`; a list of
    registers; one register or "none"; true or false; "no", "yes" or "unknown"; "any" or an
    integer. `low_excluded` and `high_excluded` leave the bounds themselves out. `required` keys
    have no default. `public` says whether the value for scamp5 is published.
    """

    section: str
    key: str
    attribute: str
    kind: Kind
    comment: str
    low: float = 0
    high: float = 1e300
    low_excluded: bool = False
    high_excluded: bool = False
    required: bool = False
    public: bool = False

    @property
    def path(self) -> str:
        """The key with its table, as messages name it."""
        return f"{self.section}.{self.key}" if self.section else self.key


_LARGEST_SIDE = 8192

KEYS: tuple[Key, ...] = (
    Key("", "name", "name", "name", "what messages and reports call it", required=True,
        public=True),
    Key("", "description", "description", "text", "one line for `nscc targets`", public=True),
    Key("array", "rows", "rows", "integer", "pixels from top to bottom", 1, _LARGEST_SIDE,
        required=True, public=True),
    Key("array", "cols", "cols", "integer", "pixels from left to right", 1, _LARGEST_SIDE,
        required=True, public=True),
    Key("registers", "analog", "analog_registers", "names", "analog registers of one pixel",
        required=True, public=True),
    Key("registers", "analog_scratch", "analog_scratch", "register",
        "every analog sequence passes through it", required=True, public=True),
    Key("registers", "digital", "digital_registers", "names", "one-bit registers of one pixel",
        required=True, public=True),
    Key("registers", "mask", "mask_register", "register",
        "a write to `masked` takes place only where it is 1", public=True),
    Key("registers", "masked", "masked_register", "register",
        'the register that `mask` guards; both are "none" on a chip without this', public=True),
    Key("behaviour", "reset_honours_flag", "reset_honours_flag", "choice",
        'does rpix reset only where FLAG is 1? "no", "yes" or "unknown"'),
    Key("behaviour", "where_reads_flag", "where_reads_flag", "flag",
        "may WHERE read FLAG, which it also writes?"),
    Key("behaviour", "where_obeys_flag", "where_obeys_flag", "flag",
        "does the analog `where` itself act only where FLAG is 1?"),
    Key("behaviour", "or_sources", "or_sources", "limit",
        'most sources of an OR or NOR word: "any" or a number', 2, 1000),
    Key("behaviour", "where_sources", "where_sources", "limit",
        'most sources of a WHERE word: "any" or a number', 2, 1000),
    Key("store", "words", "store_words", "integer", "ICWs that all stored kernels may have", 1,
        1 << 18, public=True),
    Key("store", "tables_count", "tables_count_against_store", "flag",
        "do constant kernel tables count against the store?"),
    Key("time", "analog_word_us", "analog_word_us", "number", "one analog word", 0, 1e6, True),
    Key("time", "digital_word_us", "digital_word_us", "number", "one digital word", 0, 1e6, True),
    Key("time", "launch_us", "launch_us", "number", "overhead of one kernel launch", 0, 1e9),
    Key("time", "readout_us", "readout_us", "number",
        "reading one analog register of the whole array out", 0, 1e12),
    Key("time", "digital_retention_us", "digital_retention_us", "number",
        "an untouched digital register keeps its bit for so long", 0, 1e15, True, public=True),
    Key("range", "full_well_e", "full_well_e", "number", "electrons that PIX can hold", 0, 1e15,
        True),
    Key("range", "register_min_e", "register_min_e", "number",
        "least value of an analog register, below 0", -1e15, 0, high_excluded=True),
    Key("range", "register_max_e", "register_max_e", "number",
        "largest value of an analog register, above 0", 0, 1e15, True),
    Key("range", "adc_bits", "adc_bits", "integer", "bits of the readout", 1, 16, public=True),
    Key("range", "adc_offset_lsb", "adc_offset_lsb", "number",
        "code of a register that holds nothing", -65536, 65536),
)  # fmt: skip

SECTIONS = {
    "": "",
    "array": "the pixels",
    "registers": "of one pixel",
    "behaviour": "none of these is stated in public: each key has a default",
    "store": "",
    "time": "",
    "range": "",
}
"""The tables in the order of a file, each with a remark."""

CHOICES = ("no", "yes", "unknown")
