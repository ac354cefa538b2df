"""What a run must remember to go on as if nothing had happened: one file, safetensors."""

from __future__ import annotations

import json
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from nscc.diagnostics.rejection import rejected
from nscc.npy import check_size
from nscc_training.data import Scenes
from nscc_training.loop.artifacts import config_digest, split_digest
from nscc_training.loop.setup import Parts

CHECKPOINT = "checkpoint.safetensors"


@dataclass
class Progress:
    """How far a run has come: `step` updates are done; the best validation's loss so far.

    `best` holds the encoder's and decoder's tensors at that validation.
    """

    step: int = 0
    best_loss: float = float("inf")
    best_step: int = 0
    best: dict[str, Tensor] | None = None


def _file_digests(parts: Parts) -> dict[str, str]:
    return {name: sha256(data).hexdigest() for name, data in sorted(parts.files.items())}


def tensors_of(parts: Parts) -> dict[str, Tensor]:
    """Copies of the parameters of encoder and decoder, by name."""
    return {
        f"{name}.{key}": value.detach().clone().contiguous()
        for name, module in (("encoder", parts.encoder), ("decoder", parts.decoder))
        for key, value in module.state_dict().items()
    }


def set_tensors(parts: Parts, tensors: dict[str, Tensor]) -> None:
    """The reverse of `tensors_of`; KeyError or RuntimeError where they are another network's."""
    for name, module in (("encoder", parts.encoder), ("decoder", parts.decoder)):
        start = f"{name}."
        module.load_state_dict(
            {k.removeprefix(start): v for k, v in tensors.items() if k.startswith(start)}
        )


def packed(
    parts: Parts, scenes: Scenes, optimiser: torch.optim.Optimizer, progress: Progress
) -> bytes:
    """The checkpoint as bytes."""
    from safetensors.torch import save

    tensors = tensors_of(parts)
    tensors |= {f"best.{k}": v for k, v in (progress.best or {}).items()}
    for index, entry in optimiser.state_dict()["state"].items():
        for key, value in entry.items():
            tensors[f"optimiser.{index}.{key}"] = torch.as_tensor(value).clone().contiguous()
    about = {
        "step": progress.step,
        "best_loss": repr(progress.best_loss),
        "best_step": progress.best_step,
        "config_sha256": config_digest(parts.settings),
        "files": _file_digests(parts),
        "split_sha256": split_digest(scenes),
    }
    # One entry: several would be written in an order of the moment.
    return save(tensors, metadata={"nscc": json.dumps(about)})


def unpack(path: Path, parts: Parts, scenes: Scenes, optimiser: torch.optim.Optimizer) -> Progress:
    """Set everything to a checkpoint.

    Rejected (NS0816) if it is damaged, of another run, or one that has seen other scenes.
    """
    from safetensors import safe_open

    try:
        check_size(path.stat().st_size)
        with safe_open(str(path), framework="pt", device="cpu") as file:
            about = dict(json.loads(file.metadata()["nscc"]))
            tensors = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
        found = Progress(int(about["step"]), float(about["best_loss"]), int(about["best_step"]))
    except Exception as error:  # safetensors raises its own type and several others
        raise _refused(path, f"it cannot be read: {' '.join(str(error).split())[:100]}") from error
    if about.get("config_sha256") != config_digest(parts.settings):
        raise _refused(path, "it was made with another configuration")
    changed = [name for name, digest in _file_digests(parts).items()
               if about.get("files", {}).get(name) != digest]  # fmt: skip
    if changed:
        names = " and the ".join(changed)
        raise _refused(path, "the chip or the sensor has changed since: what the run began with is "
                       f"the {names} in its folder")  # fmt: skip
    if about.get("split_sha256") != split_digest(scenes):
        raise _refused(path, "it was made with other scenes: the files of [data] have changed")
    try:
        best = {k.removeprefix("best."): v for k, v in tensors.items() if k.startswith("best.")}
        if best:
            set_tensors(parts, best)
        set_tensors(parts, tensors)
        _set_optimiser(optimiser, tensors)
    except (KeyError, RuntimeError, ValueError) as error:
        raise _refused(path, f"it lacks something: {' '.join(str(error).split())[:100]}") from error
    found.best = best or None
    return found


def _set_optimiser(optimiser: torch.optim.Optimizer, tensors: dict[str, Tensor]) -> None:
    state: dict[int, dict[str, Any]] = {}
    for name, value in tensors.items():
        kind, _, rest = name.partition(".")
        if kind == "optimiser":
            index, _, key = rest.partition(".")
            state.setdefault(int(index), {})[key] = value
    if any(set(entry) != {"step", "exp_avg", "exp_avg_sq"} for entry in state.values()):
        raise ValueError("the moments of a parameter")
    optimiser.load_state_dict({**optimiser.state_dict(), "state": state})
    # A checkpoint keeps values, not the order in memory that a parameter has; fused updates go
    # through memory, parameter and state alike.
    for parameter, held in optimiser.state.items():
        for key, value in held.items():
            if value.shape == parameter.shape:
                held[key] = torch.empty_like(parameter).copy_(value)


def _refused(path: Path, reason: str) -> Exception:
    return rejected(
        "NS0816",
        f"training cannot go on from '{path}'",
        notes=(reason,),
        helps=("--resume never starts again from the beginning; or name another --out",),
    )
