"""`nscc run FILE --on PORT`: the frame of a chip, in the emulator's frame file."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc_cli.programs import BuildChoice, load_program
from nscc_cli.support import Product, done, progress, say, write_together

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.frame_file import Frame
    from nscc_runtime.light import Light
    from nscc_runtime.sensor import Sensor

_SIMULATION = ("effects", "seed", "device_seed", "fidelity", "tolerance", "audit", "plan")
_SCENE = ("exposure", "transfer", "fps", "crop", "frames_are")


def run_on_device(program: Path, options: dict[str, Any], keep: tuple[str, ...]) -> None:
    """Expose on the device at `options["place"]`, as `nscc run` does on the emulator."""
    from nscc_cli.run import Timings, refuse_same, scene_light, summary, with_pixels
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.device.link import Link
    from nscc_runtime.effects import selected
    from nscc_runtime.frame_file import check_adc
    from nscc_runtime.sensor import load_sensor

    place, scene, repeat = options["place"], options["scene"], options["repeat"]
    _refuse_simulation(place, scene, keep)
    timings = Timings()
    with timings.part("compile_s"):
        container, messages = load_program(program, BuildChoice.of(options))
        container = with_pixels(container, program, options["pixels"])
    check_adc(container.target)
    sensor = load_sensor(container.target, options["sensor"], options["sensor_set"])
    light = None
    if scene:
        with timings.part("scene_s"):
            light = scene_light(container, options, (*messages, _scene_note(scene)))
    else:
        say(list(messages))
    out = options["out"] or Path(program.stem + ".frame.npz")
    refuse_same(out, options["png"], options["timings"])
    with (
        timings.part("expose_s"),
        Link(place, baud=options["baud"], patience_s=options["patience"]) as link,
    ):
        frame, meta = _exposed(Chip(link, sensor, progress), sensor, container, light, repeat)
    with timings.part("write_s"):
        products = _products(container, light, frame, keep, out, meta)
        if options["png"]:
            from nscc_runtime.pictures.frames import frame_sheet, readouts
            from nscc_runtime.pictures.sheet import png_of

            first = frame.frame[0] if repeat else frame.frame
            title = f"{program.name}  ·  on the device"
            products[options["png"]] = png_of(frame_sheet, readouts(container, first), title)
        write_together(products)
    if options["timings"]:
        write_together({options["timings"]: timings.json()})
    done(summary(container, frame, [*products], selected("all")))


def _refuse_simulation(place: str, scene: str | None, keep: tuple[str, ...]) -> None:
    """NS0770 for options that mean nothing to a device, as far as the user gave them."""
    context = click.get_current_context()
    meaningless = [*_SIMULATION, *(() if scene else _SCENE)]
    named = {parameter.name: parameter.opts[-1] for parameter in context.command.params}
    wrong = [
        named[name]
        for name in meaningless
        if context.get_parameter_source(name) is click.core.ParameterSource.COMMANDLINE
    ]
    if not scene:
        wrong += [f"--keep {name}" for name in keep if name in ("light", "truth")]
    if wrong:
        listed = ", ".join(wrong)
        raise Rejected(
            Diagnostic(
                "NS0770",
                f"{listed} cannot be had from a device: --on {place[:60]}",
                notes=("a device exposes what is before it, with the noise that it has",),
                helps=(f"leave {listed} out, or run on the emulator: leave --on out",),
            ),
            status=2,
        )


def _scene_note(scene: str) -> Diagnostic:
    return Diagnostic(
        "NS0770",
        f"the device exposes what is before it: --scene {scene[:60]} only says what that is",
        severity=Severity.NOTE,
        notes=("it goes into meta, and into the file with --keep light,truth",),
    )


def _exposed(
    chip: Chip, sensor: Sensor, container: Container, light: Light | None, repeat: int | None
) -> tuple[Frame, dict[str, Any]]:
    """The frame, or all of `repeat`, and its meta."""
    from nscc.words.file import to_bytes
    from nscc_runtime import frame_file
    from nscc_runtime.device.frames import device_meta

    chip.upload(container)
    count = repeat or 1
    shots = progress(chip.frames(container, count), "exposing", count)
    frames = [shot.frame for shot in shots]
    frame = frame_file.stacked(frames) if repeat else frames[0]
    info = chip.link.host.info
    assert info is not None  # a frame came
    digest = sha256(to_bytes(container)).hexdigest()
    return frame, device_meta(frame, info, sensor, digest, container, light)


def _products(
    container: Container,
    light: Light | None,
    frame: Frame,
    keep: tuple[str, ...],
    out: Path,
    meta: dict[str, Any],
) -> dict[Path, Product]:
    from nscc_cli.run import replayed
    from nscc_runtime import frame_file

    shutters = replayed(container) if "shutter" in keep else None
    kept, slots = frame_file.kept_arrays(container, light, keep, shutters)
    return {out: frame_file.FrameFile(frame, meta, kept, slots, progress).write}
