"""Devices of torch, for captures in batches: an extra, imported where one is asked for."""

from __future__ import annotations

from functools import cache

import numpy as np

from nscc.diagnostics.arguments import shown, wrong_argument


def check_device(call: str, device: object) -> None:
    """Raises WrongArgument for what is no device that this torch can draw counts on."""
    if not isinstance(device, str):
        raise wrong_argument(
            f"{call}: torch_device must be a name such as 'cuda', not {shown(device)}"
        )
    try:
        _drawn(device)
    except (AssertionError, RuntimeError, TypeError) as error:
        reason = str(error).strip().partition("\n")[0][:150]
        raise wrong_argument(
            f"{call}: torch cannot use the device {shown(device)}",
            notes=(reason,),
            helps=("leave torch_device out to use the processor",),
        ) from error


@cache
def _drawn(device: str) -> float:
    """A count, drawn as captures draw them: a device may hold numbers and have none to read."""
    import torch

    from nscc_runtime.noise import RATE_CAP, on_torch

    keys = on_torch.key_tensor([np.uint64(0)], device)
    places = torch.zeros(1, dtype=torch.int64, device=device)
    rate = torch.ones(1, dtype=torch.float64, device=device)
    return float(on_torch.poisson(keys, places, rate, RATE_CAP).cpu())
