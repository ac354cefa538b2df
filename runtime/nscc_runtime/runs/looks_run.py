"""The kind of programs whose pixels look: a frame contains open times, and the light they mean."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

from nscc.words.container import Container
from nscc_runtime.effects import Sensor, everything, selected
from nscc_runtime.looked_light import told_by
from nscc_runtime.run_kinds import Exposing, RunKind, Sent


class LooksRun(RunKind):
    """What the runtime does for a program whose shutters depend on the light: frames contain open
    times and the light that follows from them."""

    open_times_known = False

    def exposing(
        self, container: Container, light: Any, sensor: Sensor, effects: Any, request: Any
    ) -> Exposing:
        """Return how to expose `request.repeat` frames (None: one) of pixels that look, and the
        loop that is compiled first.

        If the user asks for no effects, the compiled loop executes the words in blocks of pixels;
        otherwise the reference does, with `effects`."""
        from nscc_runtime.execution.block_loop import run_blocks
        from nscc_runtime.looked_frames import frames
        from nscc_runtime.noise.noise_loops import fill_normals

        without_effects = request.effects.without_effects
        run = partial(
            frames,
            container,
            light,
            sensor,
            effects,
            seed=request.seed,
            device_seed=request.device_seed,
            count=request.repeat or 1,
            threads=request.threads,
            by_words=not without_effects,
        )
        if without_effects:
            return Exposing(run, run_blocks)
        return Exposing(run, fill_normals, "noise")

    def sheet(self, container: Container, title: str) -> Any:
        """Return the drawing of what pixels do for each sequence of answers, with `title` above."""
        from nscc_runtime.pictures.looking_chart import course_sheet

        return course_sheet(container, title)

    def sent_frame(self, container: Container, frame: Any, sent: Sent) -> Any:
        """Return `frame` with the open times that follow from the sent states (`sent.planes`), and
        the light that they mean, in `told`. If `sent.exact`, the exposures have no effects."""
        simulated = selected("none") if sent.exact else everything()
        told = told_by(container, sent.planes, frame, sent.sensor, simulated)
        return replace(frame, told=told)
