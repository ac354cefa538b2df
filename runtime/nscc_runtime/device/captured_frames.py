"""Frames of a device. Their `meta` has the same keys as those of the emulator, without simulation
settings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from itertools import count, islice
from pathlib import Path
from time import monotonic, sleep

import numpy as np

from nscc.chips.load import load_target, target_names
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import rejected
from nscc.files import write_whole
from nscc.mappings import JsonObject
from nscc.words.container import Container
from nscc.words.readout import converter_of
from nscc_runtime.device.device_chip import DeviceChip
from nscc_runtime.device.device_errors import wrong_target
from nscc_runtime.device.objects import target_digest
from nscc_runtime.frame_file import Frame, FrameFile, Provenance, joined, meta
from nscc_runtime.host_setting import HostSetting
from nscc_runtime.light import Light
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.response import with_decode_arrays
from nscc_runtime.sensor import Sensor, default_sensor


def exposed(
    chip: DeviceChip,
    container: Container,
    light: Light | None = None,
    repeat: int | None = None,
    progress: Progress = unseen,
    setting: HostSetting | None = None,
) -> tuple[Frame, JsonObject]:
    """Expose frames with a program on a device, and return them and their meta.

    `repeat`: the number of frames, stacked as first axis; None for one frame without that axis.
    `light`: the scene, if known. `setting`: what the host sets before each frame, None for the
    starts of the program. `progress` counts the frames. Raises Rejected (status 3) if the device
    fails, and what `DeviceChip.upload` raises."""
    chip.upload(container)
    most = repeat or 1
    setting = setting or HostSetting.at_start(container)
    shots = (chip.capture(container, setting) for _ in range(most))
    frames = [shot.frame for shot in progress(shots, "exposing", most)]
    frame = joined(frames, np.stack) if repeat else frames[0]
    sensor = chip.sensor or default_sensor(converter_of(container))
    params = (setting.plain(container),) * most
    return frame, device_meta(chip, frame, sensor, container, light, params)


def device_meta(
    chip: DeviceChip,
    frame: Frame,
    sensor: Sensor,
    container: Container | None,
    light: Light | None = None,
    params: tuple[Mapping[str, float], ...] = (),
) -> JsonObject:
    """Return the `meta` of the `frame` that `chip` just exposed with `sensor`.

    `container` and `light` are the program and the scene, None if unknown. Seeds, plan and audit
    are None, because a device has none. `params`: for each frame the values of the parameters by
    name, levels in electrons. The entry `device` has the names of target and loader."""
    info = chip.link.host.info
    assert info is not None  # known since the frame was received
    origin = Provenance(
        chip.label.hex(), sensor, seed=None, device_seed=None, fidelity="device", params=params
    )
    device = {"target": info.target_name, "loader": info.firmware}
    return {**meta(container, light, frame, origin), "device": device}


def target_of(chip: DeviceChip, named: str | None = None) -> Target:
    """Return the target of the device `chip`: the one `named` by the user, or else by the device,
    or scamp5 if nscc has no target of that name. Raises Rejected if the device was built for
    another target table."""
    info = chip.info()
    name = named or (info.target_name if info.target_name in target_names() else "scamp5")
    target = load_target(name, Path())
    if target_digest(target) != info.target:
        raise wrong_target(chip.link.path, target, info)
    return target


def numbered_paths(folder: Path, most: int | None = None, every_s: float = 0.0) -> Iterator[Path]:
    """Yield unused paths frame-000001.npz and so on in `folder`, which is created, `every_s`
    seconds apart.

    `most`: their number, None for no end. A path that the caller is late for comes at once. Raises
    Rejected (NS0784) if the folder cannot be created."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise rejected(
            "NS0784",
            f"cannot write into '{folder}': {error.strerror}",
            helps=("choose a folder that you may write to",),
        ) from None
    existing = set(folder.glob("frame-*.npz"))
    named = (folder / f"frame-{number:06d}.npz" for number in count(1))
    begin = monotonic()
    for written, path in enumerate(islice((path for path in named if path not in existing), most)):
        sleep(max(0.0, begin + written * every_s - monotonic()))
        yield path


def capture_to(
    path: Path,
    chip: DeviceChip,
    target: Target,
    sensor: Sensor,
    container: Container | None,
    setting: HostSetting | None = None,
) -> None:
    """Expose a frame with the device `chip` and write its file to `path`.

    `container`: the program; None for the one on the device, decoded for `target`. `sensor`
    describes the converter. `setting`: what the host sets before the frame, None for the starts of
    the program. `meta` additionally contains `time_utc` and `device_time_us`. Raises Rejected:
    status 3 if the device fails, and if the file cannot be written."""
    stamp = datetime.now(UTC).isoformat(timespec="microseconds")
    params: tuple[Mapping[str, float], ...] = ()
    if container is None:
        shot = chip.capture_held(target)
    else:
        setting = setting or HostSetting.at_start(container)
        shot, params = chip.capture(container, setting), (setting.plain(container),)
    meta = device_meta(chip, shot.frame, sensor, container, params=params)
    meta |= {"time_utc": stamp, "device_time_us": shot.captured.started_us}
    file = FrameFile(shot.frame, meta, {}, {})
    write_whole(path, (with_decode_arrays(file, container) if container else file).write)
