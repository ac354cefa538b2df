"""The kind of programs for chips without logic."""

from __future__ import annotations

from nscc_runtime.run_kinds import RunKind


class BitPlanesRun(RunKind):
    """A program whose bit planes assign the light."""

    without_plan = "bit planes assign the light to buckets slot by slot"
