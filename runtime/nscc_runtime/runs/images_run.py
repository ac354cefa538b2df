"""The kind of programs that compute images and planes after the exposure."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

from nscc.arrays import Array
from nscc.words.container import Container
from nscc_runtime.frame_file import joined
from nscc_runtime.neighbours.pictured_program import (
    PicturedProgram,
    image_sensor,
    sums_of_images,
    told_of_planes,
)
from nscc_runtime.run_kinds import Exposing, RunKind, Sent
from nscc_runtime.sensor import Sensor


class ImagesRun(RunKind):
    """What the runtime does for a program with images or planes: it simulates all requested
    effects, without a plan, and takes films."""

    without_plan = "images and planes depend on the neighbours of every pixel"
    note_without_plan = "images and planes: all effects are simulated, without a plan"
    is_fast = True
    takes_films = True

    def exposing(
        self, container: Container, light: Any, sensor: Sensor, effects: Any, request: Any
    ) -> Exposing:
        """Return how to expose frames with images: `request.repeat` frames (None: one) of `light`,
        or, if `request.next_lights` is not empty, a film of `light` and these, one frame each.

        Raises Rejected if a light does not fit the program."""
        from nscc_runtime.emulator.capture import check

        lights, seeds = (light, *request.next_lights), (request.seed, request.device_seed)
        for frame_light in lights:
            check(container, frame_light)
        program = PicturedProgram(container, sensor, effects, request.threads, not request.by_plan)
        film = lights if request.next_lights else lights * (request.repeat or 1)
        run = partial(program.film, film, *seeds, request.settings)
        if effects.without_effects or not request.by_plan:
            return Exposing(run)
        from nscc_runtime.execution.frames import word_reasons

        # Sums expose all pixels. Words then replace the results of pixels that may saturate or
        # leak unlike most.
        reasons = partial(word_reasons, container, sensor, lights, effects, request.device_seed)
        return Exposing(run, word_reasons=reasons)

    def flow(self, container: Container, width: float) -> Any:
        """Return the diagram of how images and planes are computed, `width` wide."""
        from nscc_runtime.pictures.data_flow import DataFlow

        return DataFlow(container, width)

    def frame_sheet(self, container: Container, frame: Any, response: Any, title: str) -> Any:
        """Return the drawing of the images and planes of `frame`, with `title` above; `response` is
        not used."""
        from nscc_runtime.pictures.images import image_plane_sheet

        return image_plane_sheet(frame, container.buckets_read, title)

    def sent_frame(self, container: Container, frame: Any, sent: Sent) -> Any:
        """Return the frame that a chip sent, with its images and planes moved from the readouts to
        `told`, so that only buckets remain.

        `frame` has the buckets that are read, then the images in the order in which they are sent.
        If `sent.exact`, its electrons are exact; otherwise those of images follow from their
        converter codes. The host adds up the images whose sum is reported."""
        told: dict[str, Array] = {}
        buckets = len(container.buckets_read)
        converter = image_sensor(sent.sensor, container.target)
        pictures, values = container.pictures, dict[str, Array]()
        for number, name in enumerate(container.buckets_read):
            values[pictures.registers[name]] = frame.exposure_e[number]
        for number, name in enumerate(pictures.images_sent, buckets):
            codes, image_e = frame.frame[number], frame.exposure_e[number]
            if not sent.exact:
                image_e = (codes - float(converter.adc_offset_lsb)) * converter.electrons_per_lsb
            values[pictures.registers[name]] = image_e
            if name in pictures.reads:
                told[f"image_{name}"], told[f"image_codes_{name}"] = image_e, codes
                told[f"image_saturated_by_{name}"] = frame.saturated_by[number]
        told |= sums_of_images(container, values, sent.reaches)
        told |= told_of_planes(container, sent.planes, sent.reaches, sent.summaries)
        return replace(joined([frame], lambda arrays: arrays[0][:buckets]), told=told)
