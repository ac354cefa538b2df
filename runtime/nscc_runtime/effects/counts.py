"""Random keys of counted charge: one count per pixel, source, frame and group of slots."""

from __future__ import annotations

LIGHT, WITHOUT_LIGHT = 0, 1
"""Numbers of the sources of charge."""
THINNED = 2
"""Added to a source number for the key that distributes counts over the slots of a group."""
