"""Files of run folders: their places, and the capture conditions of the decoder; needs no torch."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from nscc.diagnostics.diagnostic import rejected
from nscc.files import reads
from nscc.words.container import Container
from nscc_runtime.scene_settings import Transfer
from nscc_training.design.text import SLOT_DECIMALS
from nscc_training.programs import SENSOR_FILE, TARGET_FILE
from nscc_training.protocols import load_protocol, packaged
from nscc_training.settings import load_config

PROGRAM, CONFIG = "shutter.nsl", "config.resolved.toml"
WEIGHTS = "decoder.safetensors"
_SHIPPED = {
    "hdr": "stills/class-b/2x2/unet2d/every-effect/seed0",
    "clip": "clips/class-d/learned-from-2x2/unet2d/every-effect/seed0",
}
"""Names of the shipped runs, and their folders in training/results/shipped."""
_SEARCHED = "clips/class-e/searched-from-random/any/noise-alone/seed2"
"""The searched code for clips with the largest gain on validation scenes."""
_DARK = ("builtin:dark", "builtin:flat")
_SLOT_ERROR_US = 10.0**-SLOT_DECIMALS
"""Resolution of slot lengths in a program's text, used as tolerance in comparisons."""
_ELECTRONS = (".npz", ".npy")
"""File endings of scenes in electrons."""


class RunCapture(NamedTuple):
    """The conditions under which a run's decoder expects frames.

    `still` says whether it reconstructs stills instead of clips. `program` is the run's own, with
    `slots` slots of `slot_us` microseconds. `exposure` and `transfer` are values of the options of
    the same names of `nscc run`; a `transfer` of None leaves it to the file. `sensor` and `target`
    are the run's own files, None for the default ones. `classifies` means that the decoder names
    classes."""

    program: Path
    still: bool
    slots: int
    slot_us: float
    exposure: str
    transfer: Transfer | None
    sensor: Path | None
    target: Path | None
    classifies: bool

    def exposure_of(self, scene: str) -> str | None:
        """Return the value of the option --exposure for a scene by its name; None for scenes that
        are in electrons already, and for `builtin:dark` and `builtin:flat`."""
        return None if scene.startswith(_DARK) or scene.endswith(_ELECTRONS) else self.exposure

    def check(self, container: Container, program: Path) -> None:
        """Raise Rejected (NS0821) if `container`, the compiled `program`, has another number of
        slots than the run, or a slot whose length differs by more than `_SLOT_ERROR_US`."""
        away_us = (abs(length_us - self.slot_us) for length_us in container.slot_us)
        if container.slots == self.slots and max(away_us) <= _SLOT_ERROR_US:
            return
        raise rejected(
            "NS0821",
            f"'{program}' has other slots than the run: {container.slots} of "
            f"{min(container.slot_us):g} us and more",
            notes=(f"the run has {self.slots} slots of {self.slot_us:g} us",),
            helps=("leave the program out: the run contains its own",),
        )


def shipped_runs() -> Mapping[str, Path]:
    """Return the folders of the runs that come with nscc, by name; in a checkout, those in
    training/results."""
    runs = packaged("shipped_runs", "results/shipped")
    installed = runs.name == "shipped_runs"
    return {
        name: runs / (name if installed else checkout_path)
        for name, checkout_path in _SHIPPED.items()
    }


def shipped_evaluations() -> Path:
    """Return the folder of the shipped results of `nscc evaluate`."""
    return packaged("shipped_evaluations", "results/evaluations")


def searched_codes() -> Path:
    """Return the file of the best searched codes for clips (16 slots, 8 x 8 tile)."""
    return packaged("searched_codes.npz", f"results/runs/{_SEARCHED}/codes.npz")


def run_path(folder: Path) -> Path:
    """Return `folder` if it is a run folder, else the folder of the shipped run with that name. Any
    other path is returned as it is, so the caller checks it."""
    if (folder / CONFIG).is_file():
        return folder
    return shipped_runs().get(str(folder), folder)


def run_capture(folder: Path) -> RunCapture:
    """Return the capture conditions of a run, a folder or the name of a shipped run. Raise
    Rejected: NS0818 for another folder, and NS0813 to NS0815 for a configuration that cannot be
    read."""
    path = run_path(folder)
    config, program = path / CONFIG, path / PROGRAM
    missing = [file.name for file in (config, program) if not file.is_file()]
    if missing:
        names = ", ".join(shipped_runs())
        raise rejected(
            "NS0818",
            f"'{folder}' is not a run of nscc train",
            notes=(f"missing files: {', '.join(missing)}",),
            helps=(f"name a run folder, or one that comes with nscc: {names}",),
        )
    reads(program)
    settings = load_config(config)
    data, shutter = settings.data, settings.shutter
    protocol = load_protocol(data.protocol)
    still = protocol.name == "hdr-v1"
    # A fraction of a still's pixels saturates: the percentile below it is at the full well.
    share = sum(data.saturated) / len(data.saturated)
    percentile = (
        100 * (1 - share) if still else float(protocol.values.get("full_well_percentile", 99))
    )
    exposed_e = float(protocol.values.get("full_well_e", 30000))
    exposed_e *= protocol.light
    if protocol.mid_grey_e is not None:
        exposed_e, percentile = protocol.mid_grey_e, 50.0
    own_sensor = path / SENSOR_FILE
    own_target = path / TARGET_FILE if shutter.target.endswith(".toml") else None
    exposure = f"{exposed_e:g}@{percentile:g}"
    return RunCapture(
        program,
        still,
        shutter.slots,
        shutter.slot_us,
        exposure,
        data.transfer or None,  # type: ignore[arg-type]  # one of the curves
        own_sensor if settings.sensor.file and own_sensor.is_file() else None,
        own_target,
        protocol.classifies,
    )
