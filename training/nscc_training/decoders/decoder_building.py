"""Build decoders by name and size; count their parameters and operations."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import Any

import torch
from torch import Tensor, nn

from nscc_training.decoders.declared import DECODERS, SIZES, Decoder, DecoderTask, added_decoders
from nscc_training.import_paths import imported, is_import_path, own_code, own_failed

SMALL = 600_000
"""Largest number of parameters of a small decoder of width 1; it grows with the square of a larger
width."""
_PARTS = 24
"""Channels of a small decoder with more parameters are reduced in steps of 1/24."""


def make_decoder(name: str, size: str, task: DecoderTask, width: float = 1.0) -> nn.Module:
    """Build a decoder.

    Parameters
    ----------
    name : str
        A name of `DECODERS` or `added_decoders`, or `module:name` of the user's own code.
    size : str
        One of `SIZES`.
    task : DecoderTask
    width : float
        Factor on the channels of all layers, above 0. A small decoder with more parameters than
        `SMALL` becomes narrower.

    Raises
    ------
    ValueError
        If the decoder does not support the task, or no decoder of this size exists for it.
    Rejected
        NS0822 if the user's code fails, now or when it decodes.

    Notes
    -----
    The user's own code is called as name(size=.., kind=.., slots=.., tile=.., sees_code=..), with
    buckets=2 for two buckets, and classes=COUNT for classes.
    """
    declared = DECODERS.get(name)
    if declared is None or size not in SIZES:
        known = (*DECODERS, *added_decoders())
        if size not in SIZES or not (is_import_path(name) or name in known):
            raise ValueError(
                f"'{name}' of the size '{size}' is unknown; the decoders are {', '.join(known)}, "
                f"the sizes {' and '.join(SIZES)}, and module:name is a custom decoder"
            )
        if width != 1:
            raise ValueError(f"decoder.width applies only to nscc's own decoders, not to '{name}'")
        _check_guess(name, guesses=False, task=task)
        make = imported(name, "decoder") if is_import_path(name) else added_decoders()[name]
        extra = {"buckets": task.buckets} if task.buckets > 1 else {}
        extra |= {"classes": len(task.classes)} if task.classes else {}
        with own_code(name, "decoder"):
            network = make(
                size=size,
                kind=task.kind,
                slots=task.slots,
                tile=task.tile,
                sees_code=task.sees_code,
                **extra,
            )
        if not isinstance(network, nn.Module):
            raise ValueError(f"'{name}' returned a {type(network).__name__}, not a torch module")
        # The module is not wrapped, so the weights keep their names in the user's module.
        network.forward = partial(_called, network, network.forward, name, task)
        return network
    abilities = {"stills": declared.stills, "clips": declared.clips, "classes": declared.classifies}
    wanted = "classes" if task.classes else "stills" if task.kind == "still" else "clips"
    if not abilities[wanted]:
        decoded = " and ".join(kind for kind, able in abilities.items() if able)
        raise ValueError(f"{name} decodes {decoded}, not {wanted}")
    if declared.needs_code and not task.sees_code:
        raise ValueError(f"{name} {declared.needs_code}")
    if task.buckets > 1 and not declared.two_buckets:
        takers = [decoder.name for decoder in DECODERS.values() if decoder.two_buckets]
        raise ValueError(f"{name} accepts one bucket; {', '.join(takers)} accept two")
    _check_guess(name, guesses=declared.guesses, task=task)
    if declared.fixed_channels and not declared.scales and width != 1:
        raise ValueError(f"{name} has one width: leave decoder.width at 1")
    if declared.fixed_channels or size != "small":
        return _built(declared, size, task, width)
    count, most = 0, int(SMALL * max(1.0, width) ** 2)
    for numerator in range(_PARTS, 0, -1):
        narrowed = width * numerator / _PARTS
        with torch.device("meta"):
            count = parameter_count(_built(declared, size, task, narrowed))
        if count <= most:
            return _built(declared, size, task, narrowed)
    rows, cols = task.tile
    raise ValueError(
        f"a small {name} has at most {most:,} parameters, and {count:,} at its narrowest for "
        f"{task.slots} slots and a tile of {rows} x {cols}: take fewer slots, a smaller tile, "
        "another decoder or the size paper"
    )


def _check_guess(name: str, guesses: bool, task: DecoderTask) -> None:
    """Raise ValueError if the task asks for a first guess that decoder `name` cannot make, or asks
    for one without letting the decoder see the code.

    `guesses` says whether the decoder can make one. A task that leaves the choice open (`guess` is
    None) passes."""
    if task.guess is not None and not guesses:
        takers = " and ".join(decoder.name for decoder in DECODERS.values() if decoder.guesses)
        raise ValueError(f"decoder.guess applies to {takers}, not to {name}")
    if task.guess and not task.sees_code:
        raise ValueError(
            "decoder.guess computes a first guess from the code: it needs decoder.sees_code = true"
        )


def _built(declared: Decoder, size: str, task: DecoderTask, width: float) -> nn.Module:
    """Build the network of a declared decoder. Its layers have `width` times the channels that are
    declared for this size, rounded down, at least one."""
    module, _, name = declared.network.partition(":")
    # rounded first, so that the width is exactly a multiple of 1/24
    channels = tuple(max(1, int(round(full * width, 6))) for full in declared.channels[size])
    network: nn.Module = getattr(import_module(module), name)(channels, task, size)
    return network


def _called(
    module: nn.Module,
    forward: Callable[..., Any],
    name: str,
    task: DecoderTask,
    frame: Tensor,
    shutters: Tensor,
) -> Tensor:
    """Return the output of the user's decoder for a frame and its shutters.

    `module` is the decoder, `forward` its own method, and `name` its import path for messages.
    `frame` is (batch, [2,] rows, cols), `shutters` (N, r, c). Raises Rejected (NS0822) if it fails,
    returns another shape than the task needs, or has weights but passes no gradient during
    training."""
    with own_code(name, "decoder"):
        output = forward(frame, shutters)
    expected_shape = (len(frame), *frame.shape[-2:])
    if task.classes:
        expected_shape = (len(frame), len(task.classes))
    elif task.kind != "still":
        expected_shape = (expected_shape[0], task.slots, *expected_shape[1:])
    if not isinstance(output, Tensor):
        raise own_failed(name, "decoder", f"it returns a {type(output).__name__}, not a tensor")
    if tuple(output.shape) != expected_shape or not output.is_floating_point():
        reason = f"it gives {tuple(output.shape)} {output.dtype}, and should "
        reason += f"real numbers {expected_shape}"
        raise own_failed(name, "decoder", reason)
    learns = any(p.requires_grad for p in module.parameters())
    if module.training and torch.is_grad_enabled() and learns and not output.requires_grad:
        raise own_failed(name, "decoder", "its output has no gradient, so it cannot learn")
    return output


def parameter_count(module: nn.Module) -> int:
    """Return the number of parameters of a module."""
    return sum(p.numel() for p in module.parameters())


def flops(module: nn.Module, slots: int, rows: int, cols: int, buckets: int = 1) -> int:
    """Return the number of arithmetic operations of a decoder for one frame of rows x cols pixels
    and `slots` slots. A multiplication and an addition count as two; only operations that torch's
    counter knows (convolutions, matrix products) count. The frame has `buckets` buckets."""
    from torch.utils.flop_counter import FlopCounterMode

    device = next((p.device for p in module.parameters()), torch.device("cpu"))
    with FlopCounterMode(display=False) as counter, torch.no_grad():
        several = (buckets,) if buckets > 1 else ()
        frame = torch.zeros(1, *several, rows, cols, device=device)
        module(frame, torch.ones(slots, rows, cols, device=device))
    return int(counter.get_total_flops())
