"""Devices of torch, for captures in batches: an extra, imported where one is asked for."""

from __future__ import annotations

from nscc.diagnostics.arguments import shown, wrong_argument


def check_device(call: str, device: object) -> None:
    """Raises WrongArgument for what is no device that this torch can compute with in float64."""
    import torch

    if not isinstance(device, str):
        raise wrong_argument(f"{call}: torch_device is a name as 'cuda', not {shown(device)}")
    try:
        torch.zeros(1, dtype=torch.float64, device=device)
    except (AssertionError, RuntimeError, TypeError) as error:
        reason = str(error).strip().partition("\n")[0][:150]
        raise wrong_argument(
            f"{call}: torch cannot use the device {shown(device)}",
            notes=(reason,),
            helps=("leave torch_device out to use the processor",),
        ) from error
