"""Loading of finished run folders: decoder and shutters."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import torch

from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import rejected
from nscc.files import file_sha256, read_whole, reads
from nscc.mappings import JsonObject
from nscc.npy import check_size
from nscc_training.codes_files import load_codes
from nscc_training.encoders import Encoder
from nscc_training.import_paths import is_import_path
from nscc_training.loop.setup import TrainingSetup, make_setup, started_encoder
from nscc_training.problems import is_out_of_memory, one_line
from nscc_training.programs import CODES_FILE, SENSOR_FILE, TARGET_FILE, Chip
from nscc_training.run_files import CONFIG, run_path
from nscc_training.settings import RunSettings, load_config

_TOLD = ("shutter.nsl", CODES_FILE, "decoder.safetensors")
"""Files of a run whose digests are stored in its result."""


class RunFolder(NamedTuple):
    """A loaded run: its folder `path`, its objects with learned codes and weights (`setup`), the
    text of its `program`, and `result`, the content of `result.json`.

    `seen_digests` are the digests of the scene files that it was trained or validated with."""

    path: Path
    setup: TrainingSetup
    program: str
    seen_digests: frozenset[str]
    result: JsonObject


def load_run(path: Path, *, trust_code: bool = False) -> RunFolder:
    """Load the run in a folder, or the shipped run with that name. Codes, chip and sensor are read
    from its folder.

    Raises Rejected (NS0818) for a missing, unfinished or damaged run. A run may name Python code of
    its author, `module:name`, as decoder or loss. Loading executes this code, which needs
    `trust_code`; otherwise Rejected (NS0823) is raised."""
    from safetensors.torch import load_file

    path = run_path(path)
    needed = (
        "config.resolved.toml",
        "decoder.safetensors",
        "shutter.nsl",
        "split.json",
        "result.json",
    )
    if not path.is_dir():
        reason = "it is a file: name the run's folder first" if path.is_file() else ""
        raise _no_run(path, reason or "the folder does not exist")
    reads(*(path / name for name in (*needed, CODES_FILE)))
    missing = [name for name in needed if not (path / name).is_file()]
    if missing:
        raise _no_run(path, f"missing files: {', '.join(missing)}")
    settings = load_config(path / "config.resolved.toml")
    if not trust_code:
        _refuse_code(path, settings)
    # Codes, chip and sensor are read from the run folder. Such files may also
    # be of another run that was in this folder before.
    shutter, sensor = replace(settings.shutter, init="uniform"), settings.sensor
    # The schedule of learning no longer matters, and older versions allowed other values.
    shutter = replace(shutter, warm_up=0.0, settle=0.0)
    decoder = replace(settings.decoder, init="")
    train = settings.train
    if train.device == "cuda" and not torch.cuda.is_available():
        train = replace(train, device="auto")
    if Chip(shutter.target).file is not None and (path / TARGET_FILE).is_file():
        shutter = replace(shutter, target=str(path / TARGET_FILE))
    if sensor.file and (path / SENSOR_FILE).is_file():
        sensor = replace(sensor, file=str(path / SENSOR_FILE))
    begun = replace(settings, shutter=shutter, decoder=decoder, sensor=sensor, train=train)
    setup = make_setup(begun)
    setup = replace(setup, settings=settings)
    try:
        if (path / CODES_FILE).is_file():
            setup.encoder.load_codes(load_codes(path / CODES_FILE))
        check_size((path / "decoder.safetensors").stat().st_size)
        setup.decoder.load_state_dict(load_file(str(path / "decoder.safetensors")))
        split = json.loads(read_whole(path / "split.json"))
        seen_digests = frozenset(str(s["sha256"]) for entries in split.values() for s in entries)
        result = dict(json.loads(read_whole(path / "result.json")))
        _check_whole(path, result)
        program = read_whole(path / "shutter.nsl").decode()
    except (ValueError, KeyError, TypeError, AttributeError, RuntimeError, OSError) as error:
        if is_out_of_memory(error):
            raise
        raise _no_run(path, f"{type(error).__name__}: {one_line(error, 150)}") from error
    except Exception as error:
        if type(error).__name__ != "SafetensorError":
            raise
        raise _no_run(path, f"decoder.safetensors: {error}") from error
    setup.decoder.eval()
    return RunFolder(path, setup, program, seen_digests, result)


def run_codes(path: Path) -> Encoder:
    """Return the encoder with the codes of the run in a folder, without loading its decoder. Raise
    Rejected for a configuration that cannot be read, NS0805 for a missing or damaged file of codes,
    and NS0815 if they do not fit the configuration."""
    settings = load_config(path / CONFIG)
    chosen = replace(settings.shutter, init=str(path / CODES_FILE))
    file = path / TARGET_FILE
    if chosen.target.endswith(".toml") and file.is_file():
        chosen = replace(chosen, target=str(file))
    chip = Chip(chosen.target, chosen.slot_us, chosen.require or None)
    return started_encoder(chosen, chip, load_target(chosen.target, Path()), seed=0)


def _refuse_code(path: Path, settings: RunSettings) -> None:
    """Raise Rejected (NS0823) if loading the run at `path` with these `settings` would execute
    Python code that its decoder or loss names (`module:name`)."""
    named = {"decoder": [settings.decoder.name], "loss": settings.loss.name.split("+")}
    code = [
        f"its {role} is `{name.strip()[:100]}`"
        for role, names in named.items()
        for name in names
        if is_import_path(name)
    ]
    if code:
        raise rejected(
            "NS0823",
            f"the run '{path}' uses custom Python code, which nscc would execute",
            notes=(
                f"{', '.join(code)}, searched in the current folder and the installed packages",
            ),
            helps=(
                "if you trust that code, because it is yours or you have read it, add "
                "--trust-code; in Python, `trust_code=True`",
            ),
        )


def _check_whole(path: Path, result: JsonObject) -> None:
    """Raise ValueError if a file in the folder `path` is missing, or has another digest than
    `result` (the content of `result.json`) says: it then belongs to another run."""
    named = {name: result["files"].get(name) for name in _TOLD}
    named |= {
        name: result[key]
        for name, key in (("config.resolved.toml", "config_sha256"), ("split.json", "split_sha256"))
        if key in result
    }
    for name, digest in named.items():
        file = path / name
        actual = file_sha256(file) if file.is_file() else None
        if actual != digest:
            difference = "is missing" if actual is None else "belongs to another run"
            raise ValueError(f"{name} {difference}: its digest in result.json differs")


def _no_run(path: Path, reason: str) -> Exception:
    """Return the error (NS0818), for the caller to raise, that `path` is not a finished run, with
    the `reason`."""
    return rejected(
        "NS0818",
        f"'{path}' is not a finished run of nscc train",
        notes=(reason,),
        helps=("`nscc train CONFIG.toml --out RUN` creates a run, and resumes one that stopped",),
    )
