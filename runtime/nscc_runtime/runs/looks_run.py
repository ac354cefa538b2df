"""The kind of programs whose pixels look: a frame contains open times, and the light they mean."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from nscc.words.container import Container
from nscc_runtime.effects import everything, selected
from nscc_runtime.looked_light import told_by
from nscc_runtime.run_kinds import RunKind, Sent


class LooksRun(RunKind):
    """A program whose shutters depend on the light."""

    open_times_known = False

    def sheet(self, container: Container, title: str) -> Any:
        from nscc_runtime.pictures.looking_chart import course_sheet

        return course_sheet(container, title)

    def sent_frame(self, container: Container, frame: Any, sent: Sent) -> Any:
        simulated = selected("none") if sent.exact else everything()
        told = told_by(container, sent.planes, frame, sent.sensor, simulated)
        return replace(frame, told=told)
