"""Check torch devices for captures. torch is optional and imported only if a device is
requested."""

from __future__ import annotations

from functools import cache

import numpy as np

from nscc.diagnostics.arguments import shown, wrong_argument


def check_device(call: str, device: object) -> None:
    """Raise WrongArgument if torch cannot draw counts on this device."""
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
    """Draw a count on a device, as captures do, and read it."""
    import torch

    from nscc_runtime.noise import RATE_CAP, on_torch

    keys = on_torch.key_tensor([np.uint64(0)], device)
    places = torch.zeros(1, dtype=torch.int64, device=device)
    rate = torch.ones(1, dtype=torch.float64, device=device)
    return float(on_torch.poisson(keys, places, rate, RATE_CAP).cpu())
