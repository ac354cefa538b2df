"""`nscc device serve`: sets up the stand-in and prints its port."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.support import done, session, show

if TYPE_CHECKING:
    from nscc.target.target import Target
    from nscc_runtime.device.board import EmulatedChip
    from nscc_runtime.device.simulation import Loaded
    from nscc_runtime.light import Light


def serve(options: dict[str, Any]) -> None:
    """Serve a stand-in as `nscc device serve` was told to, until it is time to end."""
    from nscc.target.load import load_target
    from nscc_runtime.device.board import EmulatedChip
    from nscc_runtime.device.faults import Faults, parse_faults
    from nscc_runtime.device.serving import Server
    from nscc_runtime.emulator.loops import expose_block
    from nscc_runtime.sensor import load_sensor

    faults = parse_faults(options["fault"]) if options["fault"] else Faults()
    target = load_target(options["target"], Path())
    sensor = load_sensor(target, options["sensor"], options["sensor_set"])
    scene = _Scene(options, target)
    chip = EmulatedChip(scene.light, target, sensor, options["device_seed"], _report)
    if not expose_block.is_compiled():
        done("compiling the emulator's loops for this processor: once, some seconds")
        expose_block.load()
    seconds = options["seconds"]
    with _loader(options["loader"], target, chip) as loader:
        server = Server(loader, faults, _moved)
        try:
            click.echo(server.port)
            until = None if seconds is None else monotonic() + seconds
            server.serve(once=options["once"], until=until)
        finally:
            server.close()


@dataclass
class _Scene:
    """The scene as the options describe it."""

    options: dict[str, Any]
    target: Target

    def __post_init__(self) -> None:
        """Refuse at once what is no scene for any program; NS0744 where none is named."""
        spec = self.options["scene"]
        if not spec:
            raise Rejected(
                Diagnostic(
                    "NS0744",
                    "nothing for the stand-in to see: --scene is missing",
                    helps=("try --scene builtin:hdr, or name a file or a folder of pictures",),
                ),
                status=2,
            )
        if spec.startswith("builtin:") or not Path(spec).exists():
            self.light((1000.0,))

    def light(self, slot_us: Sequence[float]) -> Light:
        """The light in slots of these lengths."""
        from nscc_runtime.scenes import load_scene, parse_crop, parse_exposure

        options = self.options
        exposure, crop = options["exposure"], options["crop"]
        return load_scene(
            options["scene"],
            slot_us=slot_us,
            rows=self.target.rows,
            cols=self.target.cols,
            exposure=None if exposure is None else parse_exposure(exposure),
            transfer=options["transfer"],
            fps=options["fps"],
            crop=None if crop is None else parse_crop(crop),
            frames_are=options["frames_are"],
            warn=lambda diagnostic: show([diagnostic], session().message_format),
        )


def _report(error: Exception) -> None:
    """Say here why there is no frame: the host only learns that there is none."""
    if isinstance(error, Rejected):
        show(error.diagnostics, session().message_format)
        return
    found = Diagnostic("NS0768", f"the stand-in could not expose a frame: {error}"[:500])
    show([found], session().message_format)


def _moved(port: str) -> None:
    done(f"the port is {port} now: its old name was taken")


@contextmanager
def _loader(choice: str, target: Target, chip: EmulatedChip) -> Iterator[Loaded]:
    """The loader that was chosen: the firmware in a process of its own, or its Python twin."""
    from nscc_runtime.device import firmware
    from nscc_runtime.device.board import BackgroundChip
    from nscc_runtime.device.loader import Loader

    why = "as asked for"
    if choice != "python":
        try:
            built = firmware.built(target)
        except firmware.NotBuilt as reason:
            if choice == "firmware":
                raise Rejected(
                    Diagnostic(
                        "NS0772",
                        f"the firmware cannot be compiled for this machine: {reason}",
                        helps=(
                            "install a C++17 compiler (g++ or clang++; CXX names another)",
                            "or serve its Python twin: --loader python",
                        ),
                    ),
                    status=2,
                ) from None
            why = str(reason)
        else:
            with firmware.Process(built, chip) as process:
                done(f"loader: the firmware, compiled by {built.compiler}")
                yield process
            return
    done(f"loader: the Python twin of the firmware ({why})")
    yield Loader(target, BackgroundChip(chip), firmware.PYTHON_NAME)
