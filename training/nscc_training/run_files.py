"""Run folders as files: where they are, and what a capture for their decoder is like.

Nothing here needs torch.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.files import reads
from nscc.words.container import Container
from nscc_runtime.scenes.colour import Transfer
from nscc_training.config import load_config
from nscc_training.design.text import SLOT_DECIMALS
from nscc_training.programs import SENSOR_FILE, TARGET_FILE
from nscc_training.protocols import load_protocol

PROGRAM, CONFIG = "shutter.nsl", "config.resolved.toml"
WEIGHTS = "decoder.safetensors"
_SHIPPED = {
    "hdr": "stills/class-b/learned-from-2x2/unet2d/every-effect/seed0",
    "clip": "clips/class-d/learned-from-2x2/unet2d/every-effect/seed0",
}
"""Runs that come with nscc: what users call them, and their folder in training/results/shipped."""
_SEARCHED = "clips/class-e/searched-from-random/any/noise-alone/seed2"
"""Of the searches for clips the one whose gain validation found largest."""
_DARK = ("builtin:dark", "builtin:flat")
_SLOT_ERROR_US = 10.0**-SLOT_DECIMALS
"""A run's own program is text, and has its slots no closer than this to those of the run."""
_ELECTRONS = (".npz", ".npy")
"""Scenes that say how many electrons they amount to."""


@dataclass(frozen=True)
class RunCapture:
    """How the frames were made that a run's decoder knows.

    `exposure` is text as `--exposure` takes it, `still` whether scenes are stills, `sensor` and
    `target` are files of the run's own; None: the default one, or the program's.
    """

    program: Path
    still: bool
    slots: int
    slot_us: float
    exposure: str
    transfer: Transfer | None
    sensor: Path | None
    target: Path | None

    def exposure_of(self, scene: str) -> str | None:
        """The exposure of a scene of that name; None of those that are electrons by themselves."""
        return None if scene.startswith(_DARK) or scene.endswith(_ELECTRONS) else self.exposure

    def check(self, container: Container, program: Path) -> None:
        """NS0821 for a program whose slots are not those of the run."""
        away_us = (abs(length_us - self.slot_us) for length_us in container.slot_us)
        if container.slots == self.slots and max(away_us) <= _SLOT_ERROR_US:
            return
        raise rejected(
            "NS0821",
            f"'{program}' has other slots than the run: {container.slots} of "
            f"{min(container.slot_us):g} us and more",
            notes=(f"the run has {self.slots} slots of {self.slot_us:g} us",),
            helps=("leave the program out: the run brings its own",),
        )


def shipped_runs() -> Mapping[str, Path]:
    """The folders of the runs that come with nscc, by name."""
    installed = Path(__file__).with_name("shipped_runs")
    if installed.is_dir():
        return {name: installed / name for name in _SHIPPED}
    runs = Path(__file__).resolve().parents[1] / "results" / "shipped"
    return {name: runs / folder for name, folder in _SHIPPED.items()}


def shipped_evaluations() -> Path:
    """The folder of what `nscc evaluate` said of the runs and baselines that results tell of."""
    installed = Path(__file__).with_name("shipped_evaluations")
    in_repository = Path(__file__).resolve().parents[1] / "results" / "evaluations"
    return installed if installed.is_dir() else in_repository


def searched_codes() -> Path:
    """The codes (16 slots, free bits of an 8 x 8 tile) of the best search for clips."""
    installed = Path(__file__).with_name("searched_codes.npz")
    in_repository = (
        Path(__file__).resolve().parents[1] / "results" / "runs" / _SEARCHED / "codes.npz"
    )
    return installed if installed.is_file() else in_repository


def run_path(folder: Path) -> Path:
    """A run folder, or the one that comes with nscc under that name if there is no such run."""
    if (folder / CONFIG).is_file():
        return folder
    return shipped_runs().get(str(folder), folder)


def run_capture(folder: Path) -> RunCapture:
    """What a run's frames are like; Rejected (NS0818) for a folder that is none of a run."""
    path = run_path(folder)
    config, program = path / CONFIG, path / PROGRAM
    missing = [file.name for file in (config, program) if not file.is_file()]
    if missing:
        names = ", ".join(shipped_runs())
        raise rejected(
            "NS0818",
            f"'{folder}' is no run of nscc train",
            notes=(f"it has no {', '.join(missing)}",),
            helps=(f"name a run folder, or one that comes with nscc: {names}",),
        )
    reads(program)
    settings = load_config(config)
    data, shutter = settings.data, settings.shutter
    protocol = load_protocol(data.protocol)
    still = protocol.name == "hdr-v1"
    # Of stills a part saturates when always open: the pixel below that part is at the full well.
    share = sum(data.saturated) / len(data.saturated)
    percentile = 100 * (1 - share) if still else float(protocol.values.get(
        "full_well_percentile", 99))  # fmt: skip
    exposed_e = float(protocol.values.get("full_well_e", 30000))
    if protocol.mid_grey_e is not None:
        exposed_e, percentile = protocol.mid_grey_e, 50.0
    own_sensor = path / SENSOR_FILE
    own_target = path / TARGET_FILE if shutter.target.endswith(".toml") else None
    exposure = f"{exposed_e:g}@{percentile:g}"
    transfers: dict[str, Transfer] = {"linear": "linear", "srgb": "srgb"}
    return RunCapture(
        program, still, shutter.slots, shutter.slot_us, exposure, transfers.get(data.transfer),
        own_sensor if settings.sensor.file and own_sensor.is_file() else None, own_target,
    )  # fmt: skip
