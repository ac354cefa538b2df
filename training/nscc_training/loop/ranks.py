"""Data-parallel training under `torchrun`: every process takes its part of each batch."""

from __future__ import annotations

import importlib
import os
from datetime import timedelta

import torch
from torch import distributed, nn
from torch.nn.parallel import DistributedDataParallel

LONGEST_WAIT = timedelta(hours=6)
"""How long a process waits for the one that writes: it validates and makes artifacts alone."""


class Ranks:
    """The processes of a run: `rank` of `count`; alone outside of `torchrun`."""

    def __init__(self) -> None:
        self.count = int(os.environ.get("WORLD_SIZE", "1"))
        self.rank = int(os.environ.get("RANK", "0"))
        self._ours = self.count > 1 and not distributed.is_initialized()
        if self._ours:
            # Functions there have the group of their import as a default argument: a module first
            # imported later (by an optimiser) would keep ours, and with it gloo's threads, alive.
            importlib.import_module("torch.distributed.nn.functional")
            backend = "nccl" if torch.cuda.is_available() else "gloo"
            if backend == "nccl":
                torch.cuda.set_device(int(os.environ.get("LOCAL_RANK", "0")))
            distributed.init_process_group(backend, timeout=LONGEST_WAIT)

    @property
    def first(self) -> bool:
        """Whether this process is the one that writes."""
        return self.rank == 0

    def batch_range(self, size: int) -> tuple[int, int]:
        """Which patches of a batch are this process's: from, to."""
        return self.rank * size // self.count, (self.rank + 1) * size // self.count

    def parallel(self, module: nn.Module) -> nn.Module:
        """The module, its gradients averaged over all processes where there are several."""
        if self.count == 1:
            return module
        return DistributedDataParallel(module, find_unused_parameters=True)

    def weight(self, size: int) -> float:
        """What a loss counts here, so that all patches count alike in the mean of gradients."""
        first, last = self.batch_range(size)
        return (last - first) * self.count / size

    def meet(self) -> None:
        """Wait until all are here: the one that writes is done, too."""
        if self.count > 1:
            distributed.barrier()

    def close(self) -> None:
        """Leave the group, if it was entered here.

        Gloo's threads end with it. They may still hold gradients of the last step, and an
        interpreter that ends under them aborts.
        """
        if self._ours:
            distributed.destroy_process_group()
