"""The checkpoint of a run, from which training continues exactly, and the lock of its folder."""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor
from torch.optim.swa_utils import AveragedModel

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.mappings import NamedValues
from nscc.npy import check_size
from nscc_training.data import Scenes
from nscc_training.loop.artifacts import config_digest, split_digest
from nscc_training.loop.optimizers import Muon
from nscc_training.loop.setup import TrainingSetup
from nscc_training.problems import listed, one_line
from nscc_training.run_files import CONFIG
from nscc_training.settings import RunSettings, load_config, values_of

CHECKPOINT = "checkpoint.safetensors"
_KEPT = {False: {"step", "exp_avg", "exp_avg_sq"}, True: {"momentum_buffer"}}
"""Names of an optimizer's state tensors; True is for Muon, False for Adam."""


@dataclass
class TrainingProgress:
    """The progress of a run after `step` updates.

    `best_loss` is the lowest validation loss, reached after `best_step` updates, and `best` the
    parameters at that time; None before the first validation that counts."""

    step: int = 0
    best_loss: float = float("inf")
    best_step: int = 0
    best: dict[str, Tensor] | None = None


class TrainingState(NamedTuple):
    """All tensors that training steps read and change: those of encoder and decoder in `setup`, and
    of the `optimizers`. `average` is the running average of the decoder's weights, None if the
    settings do not ask for it."""

    setup: TrainingSetup
    optimizers: list[torch.optim.Optimizer]
    average: AveragedModel | None

    def tensors(self) -> dict[str, Tensor]:
        """Return copies of all tensors of the checkpoint by name: parameters, their running
        average, the states of the optimizers, and the table of the emulated sensor."""
        tensors = tensors_of(self.setup)
        tensors |= {f"emulated.{k}": _copied(v) for k, v in self.setup.tables.tensors().items()}
        if self.average is not None:
            tensors |= {f"average.{k}": _copied(v) for k, v in self.average.state_dict().items()}
        for number, optimizer in enumerate(self.optimizers):
            for index, entry in optimizer.state_dict()["state"].items():
                for key, value in entry.items():
                    name = f"optimizer.{number}.{index}.{key}"
                    tensors[name] = _copied(torch.as_tensor(value))
        return tensors

    def set(self, tensors: dict[str, Tensor]) -> None:
        """Load `tensors`, those of a checkpoint by the names that the method `tensors` gives them.
        Raise KeyError, RuntimeError or ValueError if some are missing or do not fit."""
        set_tensors(self.setup, tensors)
        self.setup.tables.set(_below("emulated.", tensors))
        if self.average is not None:
            self.average.load_state_dict(_below("average.", tensors))
        for number, optimizer in enumerate(self.optimizers):
            _set_optimizer(optimizer, _below(f"optimizer.{number}.", tensors))


def _other_settings_digest(settings: RunSettings) -> str:
    """Return the digest of all settings except `train.steps`, which may grow when a run is
    resumed."""
    return config_digest(replace(settings, train=replace(settings.train, steps=1)))


def tensors_of(setup: TrainingSetup) -> dict[str, Tensor]:
    """Return copies of the parameters and buffers of encoder and decoder of `setup`, by name."""
    return {
        f"{name}.{key}": _copied(value)
        for name, module in (("encoder", setup.encoder), ("decoder", setup.decoder))
        for key, value in module.state_dict().items()
    }


def set_tensors(setup: TrainingSetup, tensors: dict[str, Tensor]) -> None:
    """Load tensors with the names of `tensors_of` ("encoder.NAME", "decoder.NAME"; others are
    ignored) into the encoder and the decoder of `setup`. Raise KeyError or RuntimeError if names or
    shapes differ."""
    setup.encoder.load_state_dict(_below("encoder.", tensors))
    setup.decoder.load_state_dict(_below("decoder.", tensors))


def packed(state: TrainingState, scenes: Scenes, progress: TrainingProgress) -> bytes:
    """Return the checkpoint as bytes in the format safetensors: all tensors of `state`, with the
    best ones of `progress`.

    Its metadata has the progress, and the digests of settings, files and split that `unpack`
    compares."""
    from safetensors.torch import save

    tensors = state.tensors()
    tensors |= {f"best.{k}": v for k, v in (progress.best or {}).items()}
    about = {
        "step": progress.step,
        "best_loss": repr(progress.best_loss),
        "best_step": progress.best_step,
        "config_sha256": config_digest(state.setup.settings),
        "steps": state.setup.settings.train.steps,
        "other_settings_sha256": _other_settings_digest(state.setup.settings),
        "files": _file_digests(state.setup),
        "split_sha256": split_digest(scenes),
    }
    # A single metadata entry: the order of several entries is not deterministic.
    return save(tensors, metadata={"nscc": json.dumps(about)})


def unpack(path: Path, state: TrainingState, scenes: Scenes) -> TrainingProgress:
    """Load the checkpoint in the file `path` into `state`, and return its progress.

    The settings may have more steps than those of the checkpoint. Raises Rejected (NS0816) for a
    damaged checkpoint, or another configuration, other files or other scenes."""
    from safetensors import safe_open

    try:
        check_size(path.stat().st_size)
        with safe_open(str(path), framework="pt", device="cpu") as file:
            about = dict(json.loads(file.metadata()["nscc"]))
            tensors = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
        progress = TrainingProgress(
            int(about["step"]), float(about["best_loss"]), int(about["best_step"])
        )
    except Exception as error:  # safetensors raises its own type and several others
        raise _refused(path, f"it cannot be read: {one_line(error, 100)}") from error
    settings = state.setup.settings
    if about.get("config_sha256") != config_digest(settings) and not (
        about.get("other_settings_sha256") == _other_settings_digest(settings)
        and about.get("steps", np.inf) < settings.train.steps
    ):
        raise _refused(path, f"it was made with another configuration{_changed(path, settings)}")
    changed = [
        name
        for name, digest in _file_digests(state.setup).items()
        if about.get("files", {}).get(name) != digest
    ]
    if changed:
        names = " and the ".join(changed)
        raise _refused(
            path,
            f"the chip or the sensor has changed since: the original is {names} in the run folder",
        )
    if about.get("split_sha256") != split_digest(scenes):
        raise _refused(path, "it was made with other scenes: the files of [data] have changed")
    try:
        best = _below("best.", tensors)
        if best:
            # The best state is loaded to check that it fits; then the last state replaces it.
            set_tensors(state.setup, best)
        state.set(tensors)
    except (KeyError, RuntimeError, ValueError) as error:
        raise _refused(path, f"a part is missing: {one_line(error, 100)}") from error
    progress.best = best or None
    return progress


def _changed(checkpoint: Path, settings: RunSettings) -> str:
    """Return the settings that differ from the configuration beside a checkpoint, as the end of a
    sentence ("; changed: a, b"); "" if that configuration cannot be read."""
    try:
        before = load_config(checkpoint.with_name(CONFIG))
    except Rejected:
        return ""
    names = [key for key, value in values_of(settings).items() if values_of(before)[key] != value]
    more = " (train.steps may only grow)" if "train.steps" in names else ""
    return f"; changed: {listed(names)}{more}"


def _copied(value: Tensor) -> Tensor:
    """Return a contiguous copy of a tensor, without gradient."""
    return value.detach().clone().contiguous()


def _below(start: str, tensors: dict[str, Tensor]) -> dict[str, Tensor]:
    """Return the tensors whose names begin with `start`, by their names without it."""
    return {k.removeprefix(start): v for k, v in tensors.items() if k.startswith(start)}


def _file_digests(setup: TrainingSetup) -> dict[str, str]:
    """Return the digests of the user's chip and sensor files, by their names in the run folder."""
    return {name: sha256(data).hexdigest() for name, data in sorted(setup.files.items())}


def _set_optimizer(optimizer: torch.optim.Optimizer, tensors: dict[str, Tensor]) -> None:
    """Load the state of an optimizer from tensors named `index.key`, where the index is that of a
    parameter. Raise ValueError if an entry lacks a key, or has others, and for an index that is no
    number."""
    state: dict[int, NamedValues] = {}
    for name, value in tensors.items():
        index, _, key = name.partition(".")
        state.setdefault(int(index), {})[key] = value
    expected_keys = _KEPT[isinstance(optimizer, Muon)]
    if any(set(entry) != expected_keys for entry in state.values()):
        raise ValueError("the moments of a parameter are not those of the optimizer")
    optimizer.load_state_dict({**optimizer.state_dict(), "state": state})
    # A checkpoint keeps values, not the order in memory that a parameter has; fused updates go
    # through memory, parameter and state alike.
    for parameter, moments in optimizer.state.items():
        for key, value in moments.items():
            if value.shape == parameter.shape:
                moments[key] = torch.empty_like(parameter).copy_(value)


def _refused(path: Path, reason: str) -> Exception:
    """Return the error (NS0816) that training cannot resume from the checkpoint `path`, with the
    `reason`."""
    return rejected(
        "NS0816",
        f"training cannot resume from '{path}'",
        notes=(reason,),
        helps=("use --resume never to start from the beginning, or choose another --out",),
    )


@contextmanager
def locked_folder(folder: Path) -> Iterator[None]:
    """Create `folder` if needed, and lock it until the block or the process ends. Raise Rejected
    (NS0848) if another process has it.

    A folder that was created here and is still empty is removed if the block fails."""
    is_new = not folder.exists()
    folder.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(folder, os.O_RDONLY | os.O_CLOEXEC)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise rejected(
                "NS0848",
                f"another process is training in '{folder}'",
                notes=(
                    "only one process at a time may write a run folder, because two would mix "
                    "their results",
                ),
                helps=("wait until it ends, or give --out another folder",),
            ) from None
        yield
    except BaseException:
        if is_new:  # remove the folder of a run that did not begin
            with suppress(OSError):
                folder.rmdir()
        raise
    finally:
        os.close(descriptor)
