"""`nscc device`: commands for a chip at a serial port, and a simulated device."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, rejected
from nscc_cli import options as shared
from nscc_cli import support
from nscc_cli.completion import TARGET
from nscc_cli.frames import scene_of, sensor_of
from nscc_cli.options import OUT, PATH, flag, json_option, out_option, target_option
from nscc_cli.programs import loaded
from nscc_cli.runtime_options import (
    chip_at,
    host_value_options,
    link_options,
    placing_options,
    scene_option,
)
from nscc_cli.support import (
    NumberRange,
    Subcommands,
    refuse_ignored,
    say_done,
)
from nscc_runtime.request import Request

_LONGEST_S = 1e6


@click.group("device", cls=Subcommands)
def command() -> None:
    """Communicate with a chip at a serial port, or simulate one.

    PORT is a serial device such as /dev/ttyACM0, or the port that `nscc device serve` prints."""


@command.command("serve")
@scene_option
@target_option("The chip to simulate.")
@click.option(
    "--fault",
    metavar="F=V,..",
    help="Simulate a bad cable: corrupt=1e-4,drop=1e-5,delay=50ms, "
    "disconnect=after:20000,reboot=after:40000 (rates per byte).",
)
@click.option(
    "--on",
    "machine",
    type=click.Choice(["host", "qemu", "qemu-m0"]),
    default="host",
    show_default=True,
    help="The machine that runs the firmware: this one, or a Cortex-M4 (or "
    "Cortex-M0) emulated by QEMU.",
)
@placing_options
@shared.sensor_options
@shared.declared(Request, "device_seed", show=True)
@flag("--once", "End when the first host has closed the port.")
@click.option("--for", "seconds", type=NumberRange(0, _LONGEST_S), help="End after S seconds.")
def serve(**options: Any) -> None:
    """Simulate a chip at a serial port, and print the port on the first line.

    Runs the firmware, compiled by the installed C++ compiler. The emulator executes uploaded words
    on SCENE. Press Ctrl-C to stop."""
    from nscc.chips.load import load_target
    from nscc_runtime.device import stand_in
    from nscc_runtime.device.serving import LineFaults, StandInServer, parse_faults
    from nscc_runtime.emulator.loops import expose_without_effects

    faults = parse_faults(options["fault"]) if options["fault"] else LineFaults()
    target = load_target(options["target"], Path())
    sensor = sensor_of(target, options)
    scene = scene_of(options, "--scene is missing: the stand-in needs a scene")
    chip = stand_in.emulated_chip(
        scene,
        target,
        sensor,
        options["device_seed"],
        warn=lambda diagnostic: support.show([diagnostic]),
        failed=_report,
    )
    # Compiling the loops takes seconds, so it happens before the port is announced.
    support.say_compiling(expose_without_effects, "the emulator's loops")
    expose_without_effects.load()
    with stand_in.loaded(options["machine"], target, chip, say_done) as running:
        server = StandInServer(
            running, faults, lambda port: say_done(f"the port is {port} now: its name was taken")
        )
        click.echo(server.terminal.name)
        server.serve(once=options["once"], seconds=options["seconds"])


def _report(error: Exception) -> None:
    """Print `error`, the reason why the stand-in (the simulated chip) could not expose a frame; the
    protocol tells the host only that it failed."""
    if isinstance(error, Rejected):
        support.show(error.diagnostics)
    else:
        message = f"the stand-in could not expose a frame: {error}"[:500]
        support.show([Diagnostic("NS0768", message)])


@command.command("info")
@click.argument("port")
@json_option("Print it as JSON.")
@link_options
def info(port: str, as_json: bool, **options: Any) -> None:
    """Print the description of the loader at PORT, its memory, and the program it holds."""
    from nscc_runtime.device.messages import info_json, info_text

    with chip_at(port, options) as chip:
        device_info = chip.info()
        status = chip.link.run(chip.link.host.status)
    click.echo(
        info_json(device_info, status) if as_json else info_text(device_info, status), nl=False
    )


@command.command("upload")
@click.argument("port")
@shared.program_argument
@shared.pixels_option
@link_options
@shared.build_options
def upload(port: str, program: Path, **options: Any) -> None:
    """Send a program to the device at PORT; parts that the device already holds are not sent
    again."""
    container = loaded(program, options)
    with chip_at(port, options) as chip:
        sent = chip.upload(container)
    say_done(f"{port} holds '{program.name}': {sent.words} words, {len(sent.stream)} bytes")


@command.command("capture")
@click.argument("port")
@click.argument("program", metavar="[FILE.nsl|FILE.icw]", required=False, type=PATH)
@out_option("A frame file: one frame.")
@click.option("--to", "folder", type=OUT, help="A folder: write frame after frame, until Ctrl-C.")
@click.option("--count", type=click.IntRange(1, 1_000_000), help="With --to: the number of frames.")
@click.option(
    "--every",
    type=NumberRange(0, _LONGEST_S),
    default=0.0,
    help="With --to: seconds between frames (default: 0).",
)
@click.option(
    "--target", type=TARGET, metavar="NAME|FILE.toml", help="The chip of the stored program."
)
@host_value_options
@shared.pixels_option
@shared.sensor_options
@link_options
def capture(port: str, program: Path | None, **options: Any) -> None:
    """Expose frames with FILE, or with the program that the device at PORT already holds.

    `meta` in each frame file contains the time of exposure and the program's SHA-256."""
    from nscc_runtime.device.device_chip import capture_to, numbered_paths, target_of
    from nscc_runtime.frame_file import check_adc
    from nscc_runtime.host_setting import host_settings

    if (options["out"] is None) == (options["folder"] is None):
        raise click.UsageError("name either -o FILE (one frame) or --to FOLDER (many)")
    if options["out"] is not None and (options["count"] or options["every"]):
        raise click.UsageError(
            "--count and --every apply to many frames: replace -o by --to FOLDER"
        )
    # Without a program, the device exposes with the one that it holds, and the settings are
    # empty.
    if program is not None and options["target"] and program.suffix.lower() == ".icw":
        raise rejected(
            "NS0743",
            f"--target cannot change '{program}': it is compiled already",
            helps=("give the .nsl file instead, or leave --target out",),
        )
    container, settings = None, tuple[Any, ...]()
    if program is not None:
        container = loaded(program, options)
        settings = host_settings(container, options["params"], options["inputs"])
    else:
        refuse_ignored("no program is named", "params", "inputs")
        if options["pixels"]:
            raise rejected(
                "NS0770",
                "--pixels needs a program, but none is named",
                helps=("name the program: `nscc device capture PORT FILE --pixels CODES.npz`",),
            )
    with chip_at(port, options) as chip:
        target = container.target if container else target_of(chip, options["target"])
        sensor = sensor_of(target, options)
        check_adc(target)
        chip.sensor = sensor
        if container is not None:
            chip.upload(container)
        out, folder = options["out"], options["folder"]
        paths = [out] if out else numbered_paths(folder, options["count"], options["every"])
        for path in paths:
            capture_to(path, chip, target, sensor, container, *settings)
            say_done(f"wrote {path}")


@command.command("calibrate")
@click.argument("port")
@out_option("The target file.", required=True)
@click.option(
    "--target",
    type=TARGET,
    metavar="NAME|FILE.toml",
    help="The chip, if it is not a built-in target.",
)
@link_options
def calibrate(port: str, out: Path, **options: Any) -> None:
    """Measure the duration of launches, words, waits and readouts on the device at PORT.

    Writes the chip's target file with these durations; use it to build programs for this device.
    The measurement overwrites the program on the device."""
    from nscc.chips.load import target_toml
    from nscc.files import write_whole
    from nscc_runtime.device.device_chip import target_of
    from nscc_runtime.device.measured_times import measured

    with chip_at(port, options) as chip:
        target = target_of(chip, options["target"])
        times = measured(chip.link, target)
    write_whole(out, target_toml(times.of(target)).encode())
    say_done(
        f"wrote {out}: a launch {times.launch_us:g} us, an analog word "
        f"{times.analog_word_us:g} us, a digital word {times.digital_word_us:g} us, the loop at a "
        f"boundary {times.wait_us:g} us, a readout {times.readout_us:g} us"
    )
