"""What `nscc device` prints and writes: a loader's description, and frames with time stamps."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict
from datetime import UTC, datetime
from itertools import count
from pathlib import Path
from time import monotonic, sleep
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc_cli.programs import BuildChoice, load_program
from nscc_cli.support import done, progress, say, write_whole

if TYPE_CHECKING:
    from nscc.target.target import Target
    from nscc.words.container import Container
    from nscc_runtime.device.chip import Chip, Shot
    from nscc_runtime.device.messages import Info, Status
    from nscc_runtime.sensor import Sensor


def info_text(info: Info, status: Status) -> str:
    """A loader's description, a line a fact."""
    from nscc_runtime.device.messages import State

    state = State(info.state).name.lower() if info.state in set(State) else str(info.state)
    holds = f"program {info.label.hex()}" if any(info.program) else "no program"
    return "\n".join(
        [
            f"loader     {info.firmware}, protocol {info.version}",
            f"target     {info.target_name}, {info.rows} x {info.cols} pixels, "
            f"table {info.target.hex()[:16]}",
            f"holds      {holds} ({state})",
            f"room       {info.most_words} words, {info.most_kernels} kernels, "
            f"{info.most_rows} rows of schedule, {info.most_frame} bytes of frame",
            f"line       {info.window} bytes ahead, {info.most_data} a packet; "
            f"{status.packets} packets received, {status.damaged} damaged",
            f"up         {status.uptime_ms / 1000:.1f} s",
            "",
        ]
    )


def info_json(info: Info, status: Status) -> str:
    """The same as JSON."""
    values = {**asdict(info), "status": asdict(status)}
    for name in ("target", "program", "label"):
        values[name] = values[name].hex()
    return json.dumps(values, indent=2) + "\n"


def capture_frames(port: str, program: Path | None, options: dict[str, Any]) -> None:
    """Expose and write one frame, or frame after frame into a folder."""
    from nscc_cli.run import with_pixels
    from nscc_runtime.device.chip import Chip
    from nscc_runtime.device.link import Link
    from nscc_runtime.frame_file import check_adc
    from nscc_runtime.sensor import load_sensor

    container = None
    if program is not None:
        choice = BuildChoice(target=options["target"])
        container, messages = load_program(program, choice)
        container = with_pixels(container, program, options["pixels"])
        say(list(messages))
    elif options["pixels"]:
        raise Rejected(
            Diagnostic(
                "NS0770",
                "--pixels belongs to a program, and none is named",
                helps=("name the program: `nscc device capture PORT FILE --pixels CODES.npz`",),
            ),
            status=2,
        )
    with Link(port, baud=options["baud"], patience_s=options["patience"]) as link:
        chip = Chip(link, progress=progress)
        target = container.target if container else _target(chip, options["target"])
        sensor = load_sensor(target, options["sensor"], options["sensor_set"])
        check_adc(target)
        chip.sensor = sensor
        if container is not None:
            chip.upload(container)
        for path in _paths(options):
            stamp = datetime.now(UTC).isoformat(timespec="microseconds")
            shot = chip.capture(container) if container else chip.capture_held(target)
            _write(path, chip, shot, container, sensor, stamp)
            done(f"wrote {path}")


def _target(chip: Chip, named: str | None) -> Target:
    """The chip behind the port: the table of its own name, or the one that the user names."""
    from nscc.target.load import load_target, target_names
    from nscc_runtime.device.objects import target_digest
    from nscc_runtime.device.trouble import wrong_target

    info = chip.info()
    name = named or (info.target_name if info.target_name in target_names() else "scamp5")
    target = load_target(name, Path())
    if target_digest(target) != info.target:
        raise wrong_target(chip.link.path, target, info)
    return target


def _paths(options: dict[str, Any]) -> Iterator[Path]:
    """Where the frames go, each when its time has come."""
    if options["out"] is not None:
        yield options["out"]
        return
    folder: Path = options["folder"]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Rejected(
            Diagnostic(
                "NS0784",
                f"cannot write into '{folder}': {error.strerror}",
                helps=("name a folder that you may write",),
            ),
            status=2,
        ) from None
    taken = {path.name for path in folder.glob("frame-*.npz")}
    begin = monotonic()
    most = options["count"]
    written = 0
    for number in count(1):
        if written == most:
            return
        name = f"frame-{number:06d}.npz"
        if name in taken:
            continue
        sleep(max(0.0, begin + written * options["every"] - monotonic()))
        yield folder / name
        written += 1


def _write(
    path: Path, chip: Chip, shot: Shot, container: Container | None, sensor: Sensor, stamp: str
) -> None:
    from nscc_runtime.device.frames import device_meta
    from nscc_runtime.frame_file import FrameFile

    info = chip.link.host.info
    assert info is not None  # a frame came
    meta = device_meta(shot.frame, info, sensor, chip.label.hex(), container)
    meta["time_utc"] = stamp
    meta["device_time_us"] = shot.captured.started_us
    write_whole(path, FrameFile(shot.frame, meta, {}, {}).write)
