"""Random texts, compiled and proved for a small array."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from pathlib import Path

from nscc.chips.load import builtin_target
from nscc.diagnostics.diagnostic import Rejected
from nscc.pipeline import Options, run_passes
from nscc.source import Source
from nscc.words.container import Container


def proved_or_refused(
    text: str, level: int, size: tuple[int, int], allowed: Set[str]
) -> Container | None:
    """The proved container for an array of `size`; None where the text is refused for an `allowed`
    reason."""
    target = replace(builtin_target("scamp5"), rows=size[0], cols=size[1])
    try:
        made = run_passes(
            Source("random.nsl", text), Path(), Options(level=level, target=target, cache=False)
        )
    except Rejected as rejected:
        if {d.code for d in rejected.diagnostics if d.severity.value == "error"} <= allowed:
            return None
        raise
    assert made.container is not None
    return made.container
