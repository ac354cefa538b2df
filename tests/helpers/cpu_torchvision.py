"""Makes torchvision importable beside a build of torch that its compiled part was not made for.

Package indexes carry torchvision for the CUDA build of torch only. Beside the CPU build its
compiled operators do not load, and two declarations then refuse the whole import. DeepInverse needs
torchvision's Python part alone, so the operators are declared, and stay without a body.
"""

from __future__ import annotations

import torch

_FILTERS = "(Tensor dets, Tensor scores, float iou_threshold) -> Tensor"


def declare_operators() -> None:
    """Declare what torchvision expects; nothing where its own operators load, or it is missing."""
    try:
        import torchvision  # noqa: F401
    except ModuleNotFoundError:
        return
    except RuntimeError:
        library = torch.library.Library("torchvision", "FRAGMENT")
        for name in ("nms", "qnms"):
            library.define(name + _FILTERS)
        _kept.append(library)


_kept: list[torch.library.Library] = []
"""A library's declarations go with it."""
