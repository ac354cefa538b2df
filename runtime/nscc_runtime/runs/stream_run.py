"""The kind of programs for chips without logic."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nscc.words.container import Container
from nscc_runtime.run_kinds import RunKind


class BitPlanesRun(RunKind):
    """What the runtime does for a program of a chip without logic, whose bit planes assign the
    light of each slot to buckets."""

    without_plan = "bit planes assign the light to buckets slot by slot"

    def absent_effects(self, container: Container, effects: Any) -> Mapping[str, str]:
        """Return the names of those `effects` that a chip without logic does not have, each with
        the reason; empty if it has all."""
        from nscc_runtime.reference.stream import absent_effects

        return absent_effects(container, effects)
