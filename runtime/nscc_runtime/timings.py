"""Measure the time of each part of a run."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

from nscc_runtime.machine_code import working_s

_EMULATION = ("analyse", "plan", "expose", "audit")


@dataclass
class Timings:
    """Seconds spent in each part of a run, by name such as `expose_s`, without compiling loops; a
    part that did not run is missing."""

    seconds: dict[str, float] = field(default_factory=dict)

    @contextmanager
    def measure(self, name: str) -> Iterator[None]:
        """Add the seconds that a with block takes to the entry `name` (ending in `_s`), also after
        an error. Time in which loops are compiled does not count."""
        begin = working_s()
        try:
            yield
        finally:
            self.seconds[name] = self.seconds.get(name, 0.0) + working_s() - begin

    @property
    def emulation_s(self) -> float:
        """Seconds of planning, exposing and auditing, without compiling loops or writing files."""
        return sum(self.seconds.get(f"{name}_s", 0.0) for name in _EMULATION)

    def json(self) -> bytes:
        """Return the content of the file of --timings: the seconds of each part by name, as
        JSON."""
        return (json.dumps(self.seconds, indent=2) + "\n").encode()
