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
from nscc_training.config import config_toml
from nscc_training.loop.setup import Parts
from nscc_training.settings import Settings

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


def config_digest(settings: Settings) -> str:
    """A digest of everything that a run depends on."""
    return sha256(config_toml(settings).encode()).hexdigest()


def tensors_of(parts: Parts) -> dict[str, Tensor]:
    """Copies of the parameters of encoder and decoder, by name."""
    found = {}
    for name, module in (("encoder", parts.encoder), ("decoder", parts.decoder)):
        for key, value in module.state_dict().items():
            found[f"{name}.{key}"] = value.detach().clone().contiguous()
    return found


def set_tensors(parts: Parts, tensors: dict[str, Tensor]) -> None:
    """The reverse of `tensors_of`; KeyError or RuntimeError where they are another network's."""
    for name, module in (("encoder", parts.encoder), ("decoder", parts.decoder)):
        start = f"{name}."
        module.load_state_dict(
            {k.removeprefix(start): v for k, v in tensors.items() if k.startswith(start)}
        )


def packed(parts: Parts, optimiser: torch.optim.Optimizer, progress: Progress) -> bytes:
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
    }
    # One entry: several would be written in an order of the moment.
    return save(tensors, metadata={"nscc": json.dumps(about)})


def unpack(path: Path, parts: Parts, optimiser: torch.optim.Optimizer) -> Progress:
    """Set everything to a checkpoint. Rejected (NS0816) if it is damaged or of another run."""
    from safetensors import safe_open

    try:
        with safe_open(str(path), framework="pt", device="cpu") as file:
            about = json.loads(file.metadata()["nscc"])
            tensors = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
    except Exception as error:  # safetensors raises its own type and several others
        raise _refused(path, f"it cannot be read: {' '.join(str(error).split())[:100]}") from error
    if about["config_sha256"] != config_digest(parts.settings):
        raise _refused(path, "it was made with another configuration")
    set_tensors(parts, tensors)
    _set_optimiser(optimiser, tensors)
    best = {k.removeprefix("best."): v for k, v in tensors.items() if k.startswith("best.")}
    return Progress(
        int(about["step"]), float(about["best_loss"]), int(about["best_step"]), best or None
    )


def _set_optimiser(optimiser: torch.optim.Optimizer, tensors: dict[str, Tensor]) -> None:
    state: dict[int, dict[str, Any]] = {}
    for name, value in tensors.items():
        kind, _, rest = name.partition(".")
        if kind == "optimiser":
            index, _, key = rest.partition(".")
            state.setdefault(int(index), {})[key] = value
    optimiser.load_state_dict({**optimiser.state_dict(), "state": state})


def _refused(path: Path, reason: str) -> Exception:
    return rejected(
        "NS0816",
        f"training cannot go on from '{path}'",
        notes=(reason,),
        helps=("--resume never starts again from the beginning; or name another --out",),
    )
