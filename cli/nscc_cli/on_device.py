"""`nscc run FILE --on PORT`: write the frame of a chip in the emulator's file format."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc.diagnostics.rejection import rejected
from nscc_cli.frames import frame_path, scene_of, sensor_of, summary, write_frame
from nscc_cli.programs import load_program
from nscc_cli.support import progress, say, say_done

_SIMULATION = ("effects", "seed", "device_seed", "fidelity", "tolerance", "tolerance_max", "audit",
               "plan", "like", "fit", "color", "first", "single")  # fmt: skip
_SCENE = ("exposure", "transfer", "fps", "crop", "frames_are")


def run_on_device(program: Path, options: dict[str, Any], keep: tuple[str, ...]) -> None:
    """Expose a frame on the device at `options["place"]` and write the emulator's files."""
    from nscc.words.readout import converter_of
    from nscc_runtime.device.captured_frames import exposed
    from nscc_runtime.device.device_chip import DeviceChip
    from nscc_runtime.device.link import SerialLink
    from nscc_runtime.frame_file import check_adc
    from nscc_runtime.response import response_of
    from nscc_runtime.timings import Timings

    place, scene = options["place"], options["scene"]
    _refuse_simulation(place, scene, keep)
    timings = Timings()
    with timings.measure("compile_s"):
        container, messages = load_program(program, options)
    check_adc(container.target)
    sensor = sensor_of(converter_of(container), options)
    light, messages_so_far = None, list(messages)
    if scene:
        messages_so_far.append(_scene_note(scene))
        with timings.measure("scene_s"):
            named = scene_of(options)
            light = named.light(
                container.slot_us, container.target, messages_so_far.append, progress
            )
    say(messages_so_far)
    out = frame_path(program, options)
    with (
        timings.measure("expose_s"),
        SerialLink(place, baud=options["baud"], patience_s=options["patience"]) as link,
    ):
        chip = DeviceChip(link, sensor, progress)
        frame, meta = exposed(chip, container, light, options["repeat"], progress)
        effects = chip.effects
    title = f"{program.name}  ·  on the device"
    files = write_frame(
        out, options, keep, container, light, frame, meta, title, timings,
        lambda: response_of(container, sensor, effects),
    )  # fmt: skip
    say_done(summary(container, frame, files, alike=False))


def _refuse_simulation(place: str, scene: str | None, keep: tuple[str, ...]) -> None:
    """Raise NS0770 if the user gave options that have no meaning for a device."""
    context = click.get_current_context()
    meaningless = [*_SIMULATION, *(() if scene else _SCENE)]
    named = {parameter.name: parameter.opts[-1] for parameter in context.command.params}
    refused_options = [
        named[name]
        for name in meaningless
        if context.get_parameter_source(name) is click.core.ParameterSource.COMMANDLINE
    ]
    if not scene:
        refused_options += [f"--keep {name}" for name in keep if name in ("light", "truth")]
    if refused_options:
        listed = ", ".join(refused_options)
        raise rejected(
            "NS0770",
            f"{listed} does not apply to a device: --on {place[:60]}",
            notes=("a device exposes the real scene with its real noise",),
            helps=(f"leave {listed} out, or run on the emulator: leave --on out",),
        )


def _scene_note(scene: str) -> Diagnostic:
    return Diagnostic(
        "NS0770",
        f"the device exposes the real scene: --scene {scene[:60]} is only recorded",
        severity=Severity.NOTE,
        notes=("it is stored in meta, and in the file with --keep light,truth",),
    )
