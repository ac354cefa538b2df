"""Colours of pictures: light and dark."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

MARKERS = "osD^vP"
"""Markers of series. Their number is coprime with that of the series colours, so 42 series differ
in colour or marker."""
_LEGIBLE = 4.5
"""Smallest contrast of small type (Web Content Accessibility Guidelines 2.2, 1.4.3)."""


@dataclass(frozen=True)
class Look:
    """The colours of a picture, all as `#rrggbb`.

    `paper`: background. `ink`, `faint`: type. `grid`: thinnest lines. `closed`: empty areas. `bar`:
    bars behind marks. `series`: seven colours that colour-blind readers can distinguish."""

    paper: str
    ink: str
    faint: str
    grid: str
    closed: str
    bar: str
    series: tuple[str, ...]

    def of(self, number: int) -> dict[str, Any]:
        """Return the colour and the marker of a series."""
        return {
            "color": self.series[number % len(self.series)],
            "marker": MARKERS[number % len(MARKERS)],
        }

    def type_in(self, colour: str) -> str:
        """Return the colour, mixed with ink until small type in it is legible on the background."""
        mixed = (_mix(colour, self.ink, step / 20) for step in range(21))
        return next(shade for shade in mixed if contrast(shade, self.paper) >= _LEGIBLE)

    def on(self, colour: str) -> str:
        """Return the more legible type colour, ink or paper, on an area of a colour."""
        return max(self.ink, self.paper, key=lambda type_: contrast(type_, colour))


LIGHT = Look(
    paper="#ffffff", ink="#1d2129", faint="#5b6270", grid="#e3e7ee", closed="#f1f3f6",
    bar="#bcc8da",
    # The colours of Okabe and Ito, except yellow, which is illegible on white.
    series=("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#1d2129", "#56b4e9", "#e69f00"),
)  # fmt: skip
DARK = Look(
    paper="#131416", ink="#e6e9ee", faint="#a3abb8", grid="#2c3037", closed="#22252b",
    bar="#46536b",
    series=("#1f78c8", "#e0682f", "#12a87c", "#d588b4", "#e6e9ee", "#8ccbf5", "#f0b429"),
)  # fmt: skip
LOOKS = {"light": LIGHT, "dark": DARK}

_current: ContextVar[Look] = ContextVar("look", default=LIGHT)


def look() -> Look:
    """Return the colours of the pictures being drawn."""
    return _current.get()


@contextmanager
def looking(chosen: Look) -> Iterator[None]:
    """Draw and save the pictures of a with block in these colours."""
    before = _current.set(chosen)
    try:
        yield
    finally:
        _current.reset(before)


def contrast(colour: str, other_colour: str) -> float:
    """Return the contrast of two colours, 1 to 21, as the WCAG defines it."""
    dark, light = sorted((_luminance(colour), _luminance(other_colour)))
    return (light + 0.05) / (dark + 0.05)


def _luminance(colour: str) -> float:
    linear = [
        value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4
        for value in (level / 255 for level in _rgb_levels(colour))
    ]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _mix(colour: str, target_colour: str, share: float) -> str:
    pairs = zip(_rgb_levels(colour), _rgb_levels(target_colour), strict=True)
    return "#" + "".join(f"{round(a + (b - a) * share):02x}" for a, b in pairs)


def _rgb_levels(colour: str) -> list[int]:
    return [int(colour[at : at + 2], 16) for at in (1, 3, 5)]
