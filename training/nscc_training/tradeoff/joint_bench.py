"""One program on one scene, captured with other words and slots, and results of its stages."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from typing import Any

import numpy as np

from nscc.arrays import Bools, Floats
from nscc.containers import is_compiled, load_container, with_pixels
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, rejected
from nscc.pipeline import Compiled, run_passes
from nscc.source import Source
from nscc.syntax.parse import read_source
from nscc.words.container import Container
from nscc.words.file import to_bytes
from nscc_runtime.effects import selected
from nscc_runtime.light import Light
from nscc_runtime.looked_light import DEVIATION, LIGHT, merged_image
from nscc_runtime.planning.planned_scene import PlannedScene
from nscc_runtime.planning.tolerance import LEAST_E, Tolerance, mean_signal_e, tolerance_of
from nscc_runtime.request import Request
from nscc_runtime.response import response_of
from nscc_runtime.run_kinds import KINDS
from nscc_runtime.scenes import scene_light
from nscc_runtime.sensor import load_sensor
from nscc_runtime.simulate import Simulated, simulate
from nscc_training.command_settings import JointRequest

_CAPTURED_TO = 0.5
"""Tolerance of simulated frames, as a fraction of the target error."""
_NAMED = 3
"""Number of the largest effects that are named."""


@dataclass(frozen=True, eq=False)
class Bench:
    """What all stages (compile, lowering, slots, effects, decoder) of a request share: program,
    sensor, light, and a frame with all effects. Each is computed when it is first needed.

    `warn` receives messages. `notes` collects remarks on the numbers of stages. `known_errors`
    holds errors of programs by their digest. A lowering is a way to compute the exposure."""

    request: JointRequest
    warn: Callable[[Diagnostic], None] = lambda _: None
    notes: list[str] = field(default_factory=list)
    known_errors: dict[str, float] = field(default_factory=dict)

    @cached_property
    def source(self) -> Source:
        """The text of the program. Raises Rejected (NS0743) if the program is compiled already."""
        if is_compiled(self.request.program):
            raise rejected(
                "NS0743",
                f"'{self.request.program.as_posix()}' is compiled already, but this stage compiles "
                "the text of a program: give the .nsl file",
            )
        return read_source(self.request.program)

    def compiled(self, source: Source, **changes: Any) -> Compiled:
        """Compile a text in place of the program, without the cache, so that its time can be
        measured. `changes` are options that differ from those of the request."""
        options = replace(self.request.options, cache=False, **changes)
        options = replace(options, target=options.target or self.container.target)
        return run_passes(source, self.request.program.parent, options)

    def with_codes(self, compiled: Compiled, codes: Any = None) -> Container:
        """Return the container of a compiled program with codes for its pixels: `codes` (arrays by
        field), or None for those of the request. Raises Rejected for codes that the program does
        not have."""
        pixels = self.request.pixels if codes is None else codes
        return with_pixels(compiled.built, self.request.program, pixels)

    @cached_property
    def container(self) -> Container:
        """The compiled program of the request, with codes for its pixels. Messages of the compiler
        are passed to `warn`."""
        container, messages = load_container(self.request.program, self.request.options)
        for message in messages:
            self.warn(message)
        return with_pixels(container, self.request.program, self.request.pixels)

    @cached_property
    def sensor(self) -> Any:
        """The sensor of all frames."""
        return load_sensor(self.container.target, self.request.sensor, self.request.changes)

    @cached_property
    def light(self) -> Light:
        """The scene's light in the program's slots."""
        return scene_light(
            self.request.scene, self.container.slot_us, self.container.target, self.warn
        )

    @cached_property
    def ideal_e(self) -> Floats:
        """The exposures (buckets, rows, cols) in electrons without effects; for pixels that look,
        the light of the whole frame."""
        return self._ideal_e(self.container, self.light)

    def signal_e(self) -> float:
        """Return the mean of `ideal_e` up to a full well, to which errors are relative.

        Raises Rejected (NS0826) for a scene that gives no signal, or for a program that reads out
        no exposure."""
        signal_e = mean_signal_e(self.ideal_e, self.sensor)
        if signal_e > 0:
            return signal_e
        if not self.container.buckets_read:
            raise rejected(
                "NS0826",
                f"'{self.request.program.name}' reads out no exposure",
                notes=("errors are relative to the mean signal of the exposures",),
                helps=("name an exposure and read it: `bucket NAME open when ...`, `read NAME`",),
            )
        raise rejected(
            "NS0826",
            f"'{self.request.scene.name}' gives no signal: the mean signal of the frame is 0",
            notes=("errors are relative to the mean signal, which is 0 electrons",),
            helps=(
                "use a scene with light, such as --scene builtin:hdr, that the open pixels receive",
            ),
        )

    def noise_e(self) -> float:
        """Return the standard deviation of the frame's noise in electrons, as a plan (the effects
        that are simulated) of the program and scene predicts it."""
        seed = self.request.device_seed
        return PlannedScene(self.container, self.sensor, self.light, seed).noise_e()

    @cached_property
    def target(self) -> Tolerance:
        """The largest allowed error, such as `1%` of the mean signal, `5e` or `0.1lsb`, as a
        tolerance.

        Raises Rejected (NS0827) for other texts, and for an error larger than the signal."""
        text, reason = self.request.target_error, None
        try:
            tolerance = tolerance_of(text, self.sensor, self.signal_e, self.noise_e)
        except Rejected as refused:
            if refused.diagnostics[0].code != "NS0746":
                raise
            reason = f"a target error must be a number above 0 with its unit, not '{text[:40]}'"
        else:
            if tolerance.electrons < self.signal_e():
                return tolerance
            reason = (
                f"the target error {text[:40]} is too large: the mean signal is "
                f"{self.signal_e():.3g} electrons, so a black frame has a smaller error"
            )
        raise rejected(
            "NS0827",
            reason,
            notes=(
                "%: of the scene's mean signal; e: electrons; lsb: converter codes; noise: a "
                "fraction of the frame's own noise",
                f"it must be between {LEAST_E:g} electrons and the mean signal",
            ),
            helps=("write --target-error 1%, --target-error 50e or --target-error 0.5lsb",),
        )

    @cached_property
    def shot_percent(self) -> float:
        """The shot noise of the ideal frame, in percent of the signal."""
        return 100 * math.sqrt(float(np.abs(self.ideal_e).mean())) / self.signal_e()

    @cached_property
    def largest(self) -> tuple[tuple[str, float], ...]:
        """The names of the `_NAMED` effects with the largest errors in the program's frame, and the
        errors in percent of the signal.

        The errors are predictions of the plan; empty if the frame has no plan."""
        plan = self.capture.plan
        known = [(d.name, d.predicted_rms_e or 0.0) for d in plan.decisions] if plan else []
        known.sort(key=lambda named_error: -named_error[1])
        return tuple(
            (name, 100 * rms_e / self.signal_e()) for name, rms_e in known[:_NAMED] if rms_e
        )

    def error_percent(self, container: Container, original: Container | None = None) -> float:
        """Return the error of a frame with all effects, in percent of the mean signal: the root
        mean square difference from the true light in the worst bucket.

        `container` has codes for its pixels. `original` is the program that it replaces, whose
        slots have the same total length; None compares it with its own ideal frame. Known gains and
        offsets of words are corrected; pixels marked as saturated are left out."""
        digest = sha256(to_bytes(container)).hexdigest()
        if digest not in self.known_errors:
            self.known_errors[digest] = self._error(container, original)
        return self.known_errors[digest]

    def _error(self, container: Container, original: Container | None) -> float:
        """Return the error of a frame of `container` in percent of the mean signal, from the ideal
        frame of `original` (None: its own). `error_percent` describes it and keeps the results."""
        light = self._light_in(container)
        ideal_e = self._ideal_e(container, light)
        if original is not None:
            ideal_e = self._ideal_e(original, self._light_in(original))
        frame = self._captured(container, light).frame
        if LIGHT in frame.told:
            light_e_per_s, sure = (frame.told[key] for key in (LIGHT, DEVIATION))
            counted = (np.isfinite(sure) & np.isfinite(light_e_per_s)).max(axis=0)[None]
            seen_e = merged_image(light_e_per_s, sure)[None] * (sum(container.slot_us) * 1e-6)
        else:
            counted = frame.valid & ~frame.saturated
            seen_e = response_of(container, self.sensor).electrons(frame.frame)
        return rms_percent(seen_e, ideal_e, counted, mean_signal_e(ideal_e, self.sensor))

    def _light_in(self, container: Container) -> Light:
        """Return the light of the scene in the slots of `container`. The scene is equally bright in
        all frames, so that a shorter frame receives less light."""
        if container.slot_us == self.container.slot_us:
            return self.light
        its_light = scene_light(self.request.scene, container.slot_us, container.target)
        time_share = sum(container.slot_us) / sum(self.container.slot_us)
        whole_e, its_e = (float(light.sum_e.sum()) for light in (self.light, its_light))
        return its_light.scaled(time_share * whole_e / its_e) if its_e > 0 else its_light

    @cached_property
    def capture(self) -> Simulated:
        """The program's frame with all effects."""
        return self._captured(self.container, self.light)

    def _captured(self, container: Container, light: Light) -> Simulated:
        """Simulate a frame with all effects; if plans are possible, with a tolerance below the
        target error, so that the simulation's own error does not matter."""
        tolerance = None
        if not KINDS.of(container).without_plan:
            tolerance = max(_CAPTURED_TO * self.target.electrons, LEAST_E)
        request = Request.of(
            effects="all",
            tolerance=tolerance,
            seed=self.request.seed,
            device_seed=self.request.device_seed,
        )
        return simulate(container, light, self.sensor, request)

    def _ideal_e(self, container: Container, light: Light) -> Floats:
        """Return the exposures of a program without effects (buckets, rows, cols) in electrons; for
        pixels that look, the light of the whole frame."""
        if not KINDS.of(container).open_times_known:
            return np.asarray(light.total_e(), np.float64)[None]
        none = selected("none")
        exact = simulate(container, light, self.sensor, Request.of(effects="none")).frame
        response = response_of(container, self.sensor, none)
        return np.asarray((exact.exposure_e - response.zero_e) / response.gain)


def rms_percent(seen_e: Floats, ideal_e: Floats, counted: Bools, signal_e: float) -> float:
    """Return the root mean square difference of `seen_e` from `ideal_e`, both (buckets, rows,
    cols), in percent of the signal, for the worst bucket.

    Only pixels in `counted`, bool of this shape, count; a bucket without any makes the result
    infinite. `signal_e` is the mean signal, above 0."""
    mean_squares = [
        float(np.mean((bucket_e - ideal)[is_counted] ** 2)) if is_counted.any() else math.inf
        for bucket_e, ideal, is_counted in zip(seen_e, ideal_e, counted, strict=True)
    ]
    return 100 * math.sqrt(max(mean_squares)) / signal_e


def scaled_text(target: str, factor: float) -> str:
    """Return the text of a tolerance multiplied by `factor`, in its own unit: `3%` for `1%` and 3.
    The units are e, lsb, % and noise. `target` has been parsed as a tolerance, so that it is valid.
    """
    match = re.fullmatch(r"\s*(.*?\d\.?)\s*(e|lsb|%|noise)\s*", target.lower())
    assert match is not None  # the text was parsed as a tolerance before
    return f"{float(match[1]) * factor:g}{match[2]}"


PERCENT = "percent"
"""The unit of all errors: percent of the mean signal."""
