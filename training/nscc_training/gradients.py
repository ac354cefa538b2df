"""Functions with steps or corners, and surrogate gradients for them.

They save tensors in `setup_context`, as `torch.func` requires."""

from __future__ import annotations

from typing import Any

import torch
from torch import Tensor
from torch.autograd import Function


class _Replace(Function):
    """Return `value` in the forward pass, with the gradient of x: a straight-through estimator."""

    @staticmethod
    def forward(x: Tensor, value: Tensor) -> Tensor:
        """Return `value` in place of x."""
        return value.clone()

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Tensor) -> None:
        """Save nothing: the gradient does not depend on the inputs."""

    @staticmethod
    def backward(ctx: Any, grad: Tensor) -> tuple[Tensor, None]:
        """Pass the gradient to x."""
        return grad, None


class _Step(Function):
    """The step function of x: 1 above 0. Its surrogate gradient is a box around 0, or a tent if
    `peaked`."""

    @staticmethod
    def forward(x: Tensor, width: float, peaked: bool) -> Tensor:
        """Return 1 where x is above 0, else 0."""
        return (x > 0).to(x.dtype)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Tensor) -> None:
        """Store x and the shape of the surrogate gradient."""
        x, ctx.width, ctx.peaked = inputs
        ctx.save_for_backward(x)

    @staticmethod
    def backward(ctx: Any, grad: Tensor) -> tuple[Tensor, None, None]:
        """Return the gradient of x, multiplied by a box of height 1 and half-width `width`, or if
        `peaked`, by a tent of the same half-width and of area 1."""
        (x,) = ctx.saved_tensors
        if ctx.peaked:
            slope = torch.clamp(1 - x.abs() / ctx.width, min=0) / ctx.width
        else:
            slope = (x.abs() <= ctx.width).to(x.dtype)
        return grad * slope, None, None


class _Saturate(Function):
    """Clip x to the range from `low` to `high`. The gradient passes within the range; beyond it, it
    is multiplied by `slope`, so that saturated values still learn."""

    @staticmethod
    def forward(x: Tensor, low: float, high: float, slope: float) -> Tensor:
        """Return x clipped to a range."""
        return torch.clamp(x, low, high)

    @staticmethod
    def setup_context(ctx: Any, inputs: tuple[Any, ...], output: Tensor) -> None:
        """Store where x is within the range, and the slope beyond it."""
        x, low, high, ctx.slope = inputs
        ctx.save_for_backward((x >= low) & (x <= high))

    @staticmethod
    def backward(ctx: Any, grad: Tensor) -> tuple[Tensor, None, None, None]:
        """Return the gradient of x: unchanged within the range, and multiplied by `slope` outside
        of it."""
        (inside,) = ctx.saved_tensors
        return torch.where(inside, grad, grad * ctx.slope), None, None, None


def replaced(x: Tensor, value: Tensor) -> Tensor:
    """Return `value` in the forward pass; the gradient goes to `x` unchanged."""
    return _apply(_Replace, x, value)


def rounded(x: Tensor) -> Tensor:
    """Return x rounded to whole numbers (halves to even). The gradient passes as if nothing was
    rounded."""
    return replaced(x, torch.round(x.detach()))


def opened(x: Tensor, width: float = 1.0) -> Tensor:
    """Return 1 where x > 0, else 0, in the shape of x.

    The gradient is a triangle of unit area from -`width` to `width`. For an edge between slots, x
    is its distance from the middle of the slot. With width 1, the gradient is the physical one for
    constant light in the slot."""
    return _apply(_Step, x, width, True)


def signed(x: Tensor, width: float = 1.0) -> Tensor:
    """Return 1 where x > 0, else 0; the gradient is 1 for -width <= x <= width, else 0."""
    return _apply(_Step, x, width, False)


def saturated(x: Tensor, low: float, high: float, slope: float = 0.0) -> Tensor:
    """Return x clipped to low..high; the gradient is 1 within, `slope` outside."""
    return _apply(_Saturate, x, low, high, slope)


def _apply(function: Any, *arguments: Any) -> Tensor:
    """Return the result of a torch `Function` with its own gradient. It gives the untyped result of
    `apply` a type."""
    result: Tensor = function.apply(*arguments)
    return result
