"""`nscc device capture`: one frame, or frame after frame into a folder."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected
from nscc_cli.programs import BuildChoice, load_program
from nscc_cli.scene_options import sensor_of
from nscc_cli.support import done, progress, say


def capture_frames(port: str, program: Path | None, options: dict[str, Any]) -> None:
    """Expose and write as `nscc device capture` was told to."""
    from nscc.containers import with_pixels
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.device.frames import capture_to, numbered_paths, target_of
    from nscc_runtime.device.link import Link
    from nscc_runtime.frame_file import check_adc

    container = None
    if program is not None:
        container, messages = load_program(program, BuildChoice(target=options["target"]))
        container = with_pixels(container, program, options["pixels"])
        say(messages)
    elif options["pixels"]:
        raise rejected(
            "NS0770",
            "--pixels belongs to a program, and none is named",
            helps=("name the program: `nscc device capture PORT FILE --pixels CODES.npz`",),
        )
    with Link(port, baud=options["baud"], patience_s=options["patience"]) as link:
        chip = Chip(link, progress=progress)
        target = container.target if container else target_of(chip, options["target"])
        sensor = sensor_of(target, options)
        check_adc(target)
        chip.sensor = sensor
        if container is not None:
            chip.upload(container)
        out, folder = options["out"], options["folder"]
        paths = [out] if out else numbered_paths(folder, options["count"], options["every"])
        for path in paths:
            capture_to(path, chip, target, sensor, container)
            done(f"wrote {path}")
