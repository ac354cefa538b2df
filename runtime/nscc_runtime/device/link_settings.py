"""The settings of a serial link: their kinds, meanings and defaults, without the link."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.toml.kinds import Integer, Number
from nscc.toml.schema import key


@dataclass(frozen=True)
class LinkSettings:
    """How a serial port is used."""

    baud: int = key(Integer(1200, 12_000_000), "Speed of the device's port", 3_000_000)
    patience_s: float = key(
        Number(0.1, 3600),
        "Seconds without an answer after which a device counts as lost",
        10.0,
        name="patience",
    )
