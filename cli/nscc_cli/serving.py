"""`nscc device serve`: sets up the stand-in and prints its port."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.scene_options import scene_of, sensor_of
from nscc_cli.support import done, session, show


def serve(options: dict[str, Any]) -> None:
    """Serve a stand-in as `nscc device serve` was told to, until it is time to end."""
    from nscc.target.load import load_target
    from nscc_runtime.device import stand_in
    from nscc_runtime.device.faults import Faults, parse_faults
    from nscc_runtime.emulator.loops import expose_block

    faults = parse_faults(options["fault"]) if options["fault"] else Faults()
    target = load_target(options["target"], Path())
    sensor = sensor_of(target, options)
    scene = scene_of(options, "nothing for the stand-in to see: --scene is missing")
    chip = stand_in.emulated_chip(
        scene, target, sensor, options["device_seed"], warn=_warn, failed=_report
    )
    if not expose_block.is_compiled():
        done("compiling the emulator's loops for this processor: once, some seconds")
        expose_block.load()
    with stand_in.loaded(options["loader"], target, chip, done) as loader:
        stand_in.serve(
            loader, faults, opened=click.echo, moved=_moved, once=options["once"],
            seconds=options["seconds"],
        )  # fmt: skip


def _warn(diagnostic: Diagnostic) -> None:
    show([diagnostic], session().message_format)


def _report(error: Exception) -> None:
    """Say here why there is no frame: the host only learns that there is none."""
    if isinstance(error, Rejected):
        show(error.diagnostics, session().message_format)
        return
    _warn(Diagnostic("NS0768", f"the stand-in could not expose a frame: {error}"[:500]))


def _moved(port: str) -> None:
    done(f"the port is {port} now: its old name was taken")
