"""Where the loop over pixels finds what: the columns and places of the arrays it is given."""

from __future__ import annotations

from enum import IntEnum


class Size(IntEnum):
    """What each of the whole numbers `sizes` is; from SHOT on a switch: 0 is off."""

    PIXELS = 0
    SLOTS = 1
    ROWS = 2
    COLS = 3
    BUCKETS = 4
    GROUPS = 5
    REGISTERS = 6
    WHOLE = 7
    """The least power of two that is not below the number of slots."""
    FRAME = 8
    SHOT = 9
    DARK = 10
    """1: counted; 2: its mean."""
    FULL_WELL = 11
    READ = 12
    RESET = 13
    DEAD_TIME = 14
    ANALOG = 15
    """1: gain, pattern and noise; 2: gain and pattern."""
    REGISTER = 16
    LEAKAGE = 17
    CROSSTALK = 18
    PRNU = 19
    KEPT_COLS = 20
    """Columns of the three rows of sites whose charge is kept; no switch."""


class Number(IntEnum):
    """What each of the numbers `numbers` is."""

    FULL_WELL = 0
    REGISTER_MIN = 1
    REGISTER_MAX = 2
    KNEE = 3
    CROSSTALK = 4
    LAG = 5
    PRNU = 6
    DARK = 7
    DARK_VARIANCE = 8
    """Of the logarithm."""
    READ = 9
    RESET = 10
    GAIN = 11
    ANALOG_NOISE = 12
    PATTERN = 13
    BIAS = 14
    LEAK = 15
    LEAK_VARIANCE = 16
    """Of the logarithm."""
    RATE_CAP = 17


class Key(IntEnum):
    """What each of the words `keys` is: a key of the device, or one that a frame's follow from."""

    START = 0
    PRNU = 1
    DARK = 2
    PATTERN = 3
    LEAK = 4
    COUNT = 5
    """Of light, then of dark charge."""
    THIN = 7
    SUM = 9
    """Of reads, resets and analog words."""
    PART = 12


class Entry(IntEnum):
    """The columns of a word in the list of a lane; sources and destinations follow."""

    BOUNDARY = 0
    RESETS = 1
    ACTS = 2
    NUMBER = 3
    READS_PIX = 4
    SOURCES = 5
    DESTINATIONS = 6
    FIRST_SOURCE = 7
    FIRST_DESTINATION = 11


MOST_DESTINATIONS = 3
ENTRY_COLUMNS = int(Entry.FIRST_DESTINATION) + MOST_DESTINATIONS
FUSED_BLOCK = 1024
"""Pixels that go through all steps of a simple plan together."""
