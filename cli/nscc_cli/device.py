"""`nscc device`: a stand-in for a chip, and what a chip at a port is, gets and gives."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.diagnostics.suggest import closest
from nscc_cli.link_options import link_options
from nscc_cli.programs import BuildChoice, build_options, load_program
from nscc_cli.scene_options import scene_options, sensor_options
from nscc_cli.support import CommonCommand, NumberRange, done, progress, say

_LONGEST_S = 1e6
_MOST_FRAMES = 1_000_000


class _Device(CommonCommand, click.Group):
    """What one can do with a device; anything else is rejected by name (NS0781)."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """The command named first in `args`, and what follows it."""
        name = args[0]
        if name in self.commands or name.startswith("-"):
            return super().resolve_command(ctx, args)
        near = closest(name, self.commands)
        raise Rejected(
            Diagnostic(
                "NS0781",
                f"nscc has no command 'device {name[:60]}'",
                helps=(
                    *((f"did you mean `nscc device {near}`?",) if near else ()),
                    f"there is: {', '.join(self.commands)}",
                ),
            ),
            status=2,
        )


@click.group("device", cls=_Device)
def command() -> None:
    """Talk to a chip at a serial port, or stand in for one.

    The port is a serial device such as /dev/ttyACM0, or what `nscc device serve` prints.
    """


@command.command("serve", cls=CommonCommand)
@click.option("--scene", help="What the stand-in sees: a file, a folder or builtin:NAME.")
@click.option("--target", default="scamp5", show_default=True, metavar="NAME|FILE.toml")
@click.option("--fault", metavar="F=V,..", help="A bad cable: corrupt=1e-4,drop=1e-5,delay=50ms, "
              "disconnect=after:20000,reboot=after:40000 (rates a byte).")  # fmt: skip
@click.option(
    "--loader",
    type=click.Choice(["auto", "firmware", "python"]),
    default="auto",
    show_default=True,
    help="The firmware, compiled for this machine, or its Python twin. auto: the firmware where "
    "there is a C++ compiler.",
)
@scene_options
@sensor_options
@click.option("--device-seed", type=click.IntRange(0, 2**63 - 1), default=0, help="Which chip.")
@click.option("--once", is_flag=True, help="End when the first host has closed the port.")
@click.option("--for", "seconds", type=NumberRange(0, _LONGEST_S), help="End after S seconds.")
def serve(**options: Any) -> None:
    """Stand in for a chip: prints the port to open on the first line, then serves it.

    Uploaded words run on the emulator, over SCENE. Ends with Ctrl-C.
    """
    from nscc_cli.serving import serve as begin

    begin(options)


@command.command("info", cls=CommonCommand)
@click.argument("port")
@click.option("--json", "as_json", is_flag=True, help="Print it as JSON.")
@link_options
def info(port: str, as_json: bool, baud: int, patience: float) -> None:
    """Say what the loader at PORT is, what it has room for and what it holds."""
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.device.description import info_json, info_text
    from nscc_runtime.device.link import Link

    with Link(port, baud=baud, patience_s=patience) as link:
        found = Chip(link).info()
        status = link.run(link.host.status)
    click.echo(info_json(found, status) if as_json else info_text(found, status), nl=False)


@command.command("upload", cls=CommonCommand)
@click.argument("port")
@click.argument("program", metavar="FILE.nsl|FILE.icw", type=click.Path(path_type=Path))
@click.option("--pixels", type=click.Path(path_type=Path), help="The pixels' codes (.npz).")
@link_options
@build_options
def upload(port: str, program: Path, **options: Any) -> None:
    """Bring a program to the device at PORT; what it has of it already is not sent again."""
    from nscc.containers import with_pixels
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.device.link import Link

    container, messages = load_program(program, BuildChoice.of(options))
    container = with_pixels(container, program, options["pixels"])
    say(list(messages))
    with Link(port, baud=options["baud"], patience_s=options["patience"]) as link:
        sent = Chip(link, progress=progress).upload(container)
    done(f"{port} holds '{program.name}': {sent.words} words, {len(sent.stream)} bytes")


@command.command("capture", cls=CommonCommand)
@click.argument("port")
@click.argument(
    "program",
    metavar="[FILE.nsl|FILE.icw]",
    required=False,
    type=click.Path(path_type=Path),
)
@click.option("-o", "out", type=click.Path(path_type=Path), help="A frame file: one frame.")
@click.option("--to", "folder", type=click.Path(path_type=Path), help="A folder: frame after "
              "frame, until Ctrl-C.")  # fmt: skip
@click.option("--count", type=click.IntRange(1, _MOST_FRAMES), help="With --to: so many frames.")
@click.option("--every", type=NumberRange(0, _LONGEST_S), default=0.0,
              help="With --to: seconds from frame to frame (default: 0).")  # fmt: skip
@click.option("--target", metavar="NAME|FILE.toml", help="The chip, of a program that is there.")
@click.option("--pixels", type=click.Path(path_type=Path), help="The pixels' codes (.npz).")
@sensor_options
@link_options
def capture(port: str, program: Path | None, **options: Any) -> None:
    """Expose frames with the program that the device at PORT holds, or with FILE.

    Each file holds in `meta` when the frame was exposed and the program's SHA-256.
    """
    from nscc_cli.device_frames import capture_frames

    if (options["out"] is None) == (options["folder"] is None):
        raise click.UsageError("name either -o FILE (one frame) or --to FOLDER (many)")
    if options["out"] is not None and (options["count"] or options["every"]):
        raise click.UsageError("--count and --every go with --to FOLDER")
    if program is not None and options["target"] and program.suffix.lower() == ".icw":
        raise Rejected(
            Diagnostic(
                "NS0743",
                f"--target cannot change '{program}': it is compiled already",
                helps=("give the .nsl file instead, or leave --target out",),
            ),
            status=2,
        )
    capture_frames(port, program, options)
