"""A device that runs programs on a chip behind a port, and the frames that it takes.

Their `meta` has the same keys as those of the emulator, without simulation settings."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from itertools import count, islice
from pathlib import Path
from random import SystemRandom
from time import monotonic, sleep

import numpy as np

from nscc.arrays import Array, Bools, Bytes, Floats
from nscc.chips.load import load_target, target_names
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import rejected
from nscc.files import write_whole
from nscc.mappings import JsonObject
from nscc.words.container import Container, state_registers
from nscc.words.file import to_bytes
from nscc.words.reach import Reach, beyond_reaches
from nscc.words.readout import converter_of
from nscc_runtime.device import tasks
from nscc_runtime.device.device_errors import check_fits, no_program, states_lost, wrong_target
from nscc_runtime.device.host import Task
from nscc_runtime.device.link import SerialLink
from nscc_runtime.device.messages import (
    Capability,
    CaptureReply,
    Channel,
    Info,
    LoaderState,
    plane_bytes,
)
from nscc_runtime.device.objects import (
    Upload,
    device_reports,
    packed_plane,
    split_reports,
    target_digest,
    unpacked_plane,
    upload_of,
)
from nscc_runtime.effects import Selection, everything, selected
from nscc_runtime.frame_file import Frame, FrameFile, Provenance, joined, last_codes, meta
from nscc_runtime.host_setting import HostSetting
from nscc_runtime.light import Light
from nscc_runtime.neighbours.plane_summary import PlaneSummary
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.response import with_decode_arrays
from nscc_runtime.run_kinds import KINDS, Sent
from nscc_runtime.sensor import Sensor, default_sensor

_STEP = 1024
"""Number of bytes per step of a progress bar."""


@dataclass(frozen=True, eq=False)
class Shot:
    """A frame from a device; `captured` is the loader's reply about it."""

    frame: Frame
    captured: CaptureReply


class DeviceChip:
    """The chip behind an open link.

    `sensor` converts converter codes to electrons if the loader sends only codes; None for the
    values of the target. All methods raise Rejected (status 3) if the device fails."""

    def __init__(
        self, link: SerialLink, sensor: Sensor | None = None, progress: Progress = unseen
    ) -> None:
        """Use an open link. `sensor` describes the chip's converter; by default it is that of the
        program. `progress` counts kilobytes of uploads."""
        self.link, self.sensor, self.progress = link, sensor, progress
        # Frames are numbered from a random number, so that none has the number of another host's
        # frame.
        self._number = SystemRandom().randrange(1 << 63)
        self._made: tuple[Container, Upload] | None = None
        self._reaches: dict[str, Reach] = {}
        self._loaded: dict[int, bytes] = {}
        self.label = bytes(32)
        """SHA-256 of the container whose frames the device exposes."""

    @property
    def effects(self) -> Selection:
        """The effects that frames of the device have: all for a chip, none for a stand-in, which
        sends exact exposures. All before the first contact."""
        info = self.link.host.info
        exact = info is not None and channels_of(info) & Channel.EXPOSURE
        return selected("none") if exact else everything()

    def info(self) -> Info:
        """Ask the loader for its description, in a new session, and return it."""
        host = self.link.host
        host.info = None

        def hello_info() -> Task[Info]:
            """Return the loader's description, which every new session receives first."""
            yield from ()  # `lasting` already received `info`
            assert host.info is not None
            return host.info

        return self.link.run(hello_info)

    def upload(self, container: Container) -> Upload:
        """Upload a program unless the device has it already; return it in the form that is sent.

        A program that keeps states is always sent, which resets the states, and so is one with
        values of the host. Raises Rejected (NS0764, NS0765) for programs that the loader would
        refuse."""
        info = self.info()
        program = self._program(container)
        check_fits(self.link.path, program, container.target, info, channels_of(info, program))
        # Another host may have loaded other planes.
        self._upload(program, anew=container.keeps_states or program.host_values)
        self._reaches, self._loaded = {}, {}
        return program

    def _program(self, container: Container) -> Upload:
        """Return the container (a compiled program) in the form that is sent, for the loader of the
        device. The last one is cached, and `label` becomes its SHA-256."""
        if self._made is None or self._made[0] is not container:
            label = sha256(to_bytes(container)).digest()
            info = self.link.host.info or self.info()
            reports = bool(info.capabilities & Capability.REPORTS)
            self._made = container, upload_of(container, label, reports=reports)
            self.label = label
        return self._made[1]

    def _upload(self, program: Upload, *, anew: bool) -> None:
        """Upload a program and show the progress. With `anew`, the loader first forgets the
        program, so that it starts with fresh registers."""
        sent, host = 0, self.link.host

        def watch(sent_bytes: int) -> None:
            """Note that `sent_bytes` bytes have been acknowledged, for the progress. A repeated
            upload does not move it back."""
            nonlocal sent
            sent = max(sent, sent_bytes // _STEP)

        def work() -> Task[None]:
            """Return the steps of the upload. If a lost link repeats them, the loader does not
            forget again."""
            nonlocal anew
            if anew:
                yield from tasks.forget(host, program)
                anew = False
            yield from tasks.upload(host, program, watch)

        steps = self.link.steps(work, lambda: sent)
        for _ in self.progress(steps, "uploading", len(program.stream) // _STEP):
            pass

    def capture(self, container: Container, setting: HostSetting | None = None) -> Shot:
        """Capture one frame of the uploaded program; the program is sent again if the device lost
        it.

        `setting`: what the host sets before the frame, by default the starts of the program. Raises
        Rejected: NS0774 if a lost program keeps states from frame to frame, because these cannot be
        restored, and status 3 if the device fails."""
        return self._shot(container.target, container, setting or HostSetting.at_start(container))

    def capture_held(self, target: Target) -> Shot:
        """Capture one frame of the program that the device holds, decoded for `target`. Sets
        `label` to the program's. Raises Rejected (NS0771) if the device has no program."""
        info = self.info()
        self.label = info.label
        if info.state not in (LoaderState.READY, LoaderState.EXPOSING):
            raise no_program(self.link.path)
        return self._shot(target)

    def _shot(
        self,
        target: Target,
        container: Container | None = None,
        setting: HostSetting | None = None,
    ) -> Shot:
        """Expose a frame and fetch it, decoded for `target`.

        `container` is the program, None for the program that the device has. `setting`: planes and
        values of parameters that the host sets before the frame, None for none. Raises Rejected
        (NS0774) if the device has lost the program, and with it the kept states."""
        host = self.link.host
        program = None if container is None else self._program(container)
        self._number += 1
        request = tasks.FrameRequest(self._number, 0, program, target.rows * target.cols)
        planes: dict[int, bytes] = {}
        if container is not None and setting is not None:
            pictures, params = container.pictures, setting.params
            for name, bits in setting.inputs.items():
                number = target.digital_registers.index(pictures.registers[name])
                planes[number] = packed_plane(bits)
            request.values = tuple(params[param.name] for param in pictures.params)
            if pictures.stepping or pictures.params:
                self._reaches = beyond_reaches(container, self._reaches, params)
        program_lost = False

        def work() -> Task[tasks.FetchedFrame]:
            """Return the steps of a capture; they run again after a lost link, with the channels of
            the loader that answers then."""
            nonlocal program_lost
            assert host.info is not None
            request.channels = channels_of(host.info, program)
            if program is not None:
                already_held = yield from tasks.upload(host, program)
                program_lost = program_lost or not already_held
                # A program that was sent again has none of the planes that the host loaded.
                self._loaded = self._loaded if already_held else {}
            for register, plane in planes.items():
                if self._loaded.get(register) != plane:
                    yield from tasks.load(host, register, plane)
                    self._loaded[register] = plane
            return (yield from tasks.capture(host, request))

        fetched = self.link.run(work)
        if program_lost and container is not None and container.keeps_states:
            raise states_lost(self.link.path)
        captured = fetched.captured
        shape = (captured.readouts, target.rows, target.cols)
        sensor = self.sensor or default_sensor(converter_of(container) if container else target)
        frame = frame_of(
            fetched.data, request.channels, shape, sensor, target, container, self._reaches or None
        )
        return Shot(frame, captured)


def channels_of(info: Info, program: Upload | None = None) -> int:
    """Return the bits of `Channel` to request from the loader described by `info`: all that it
    supports for `program`. If that is None, states and reports are left out."""
    exact = info.capabilities & Capability.EXACT
    states = Channel.STATES if program and program.states else 0
    reports = Channel.REPORTS if program and program.report_bytes else 0
    return Channel.CODES | (Channel.EXPOSURE if exact else 0) | states | reports


def frame_of(
    data: bytes,
    channels: int,
    shape: tuple[int, ...],
    sensor: Sensor,
    target: Target,
    container: Container | None = None,
    reaches: Mapping[str, Reach] | None = None,
) -> Frame:
    """Convert the bytes of a frame to a frame. `data` has the `channels`, bits of `Channel`, in the
    order of their numbers.

    `shape`: (readouts, rows, cols). `sensor` converts converter codes to electrons if there is no
    channel EXPOSURE. `target` decides which pixels are saturated: those with the largest converter
    code. With a program `container`, pixels with the code of a full well or register are saturated,
    too. With a program whose pixels look, the frame contains the light that follows from the planes
    of STATES. `reaches`: see `told_of_planes`; None if the program's own apply."""
    readouts, rows, cols = shape
    pixels, columns = readouts * rows * cols, (readouts, cols, rows)
    # Loaders send values column by column (`in_columns`).
    codes: Array = np.frombuffer(data, np.uint8, pixels).reshape(columns)
    codes = np.ascontiguousarray(codes.transpose(0, 2, 1))
    exposure: Floats | None = None
    if channels & Channel.EXPOSURE:
        exposure = np.frombuffer(data, "<f8", pixels, offset=pixels).astype(np.float64)
        exposure = np.ascontiguousarray(exposure.reshape(columns).transpose(0, 2, 1))
    planes: dict[str, Bools] = {}
    summaries: Mapping[str, PlaneSummary] = {}
    if container is not None:
        reports = device_reports(container) if channels & Channel.REPORTS else {}
        data, summaries = split_reports(reports, data)
        sent = [name for name in state_registers(container) if name not in reports]
        planes = _planes_at_end(data, sent, target)
    sent_beside = Sent(sensor, exposure is not None, planes, reaches, summaries)
    return frame_of_readouts(codes, exposure, target, container, sent_beside)


def frame_of_readouts(
    codes: Bytes,
    exposure_e: Floats | None,
    target: Target,
    container: Container | None,
    sent: Sent,
) -> Frame:
    """Return the frame of what a chip sent.

    `codes` (readouts, rows, cols): converter codes of buckets, then of images. `exposure_e` (the
    same shape): the electrons before the converter, or None to compute them from the codes.
    `container`: the program, None if unknown; then nothing follows from planes. `sent`: the sensor,
    and the planes that came with the codes."""
    electrons, sensor = exposure_e, sent.sensor
    if electrons is None:
        electrons = np.asarray(
            (codes - float(sensor.adc_offset_lsb)) * sensor.electrons_per_lsb, np.float64
        )
    frame = Frame(codes, electrons, np.isfinite(electrons), last_codes(codes, target))
    return frame if container is None else KINDS.of(container).sent_frame(container, frame, sent)


def _planes_at_end(data: bytes, names: Sequence[str], target: Target) -> dict[str, Bools]:
    """Return the bit planes (rows, cols) of the registers `names`, by name. They are the last bytes
    of a frame's `data`, in this order; `target` gives their size."""
    shape = target.rows, target.cols
    size = plane_bytes(shape[0] * shape[1])
    ends = (len(data) - size * k for k in reversed(range(len(names))))
    return {
        name: unpacked_plane(data[end - size : end], shape)
        for name, end in zip(names, ends, strict=True)
    }


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
