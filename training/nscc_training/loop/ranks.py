"""Data-parallel training under `torchrun`: every process takes a share of each batch."""

from __future__ import annotations

import importlib
import os
from datetime import timedelta

import torch
from torch import distributed, nn
from torch.nn.parallel import DistributedDataParallel

LONGEST_WAIT = timedelta(hours=6)
"""Longest time that other processes wait while the first process validates and writes files."""


class Ranks:
    """The processes that train a run together: this one is number `rank` of `count`. Without
    `torchrun` it is number 0 of 1."""

    def __init__(self) -> None:
        """Join the other processes if `torchrun` has started several: it sets the environment
        variables `RANK` and `WORLD_SIZE`."""
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
        """Whether this process writes the files."""
        return self.rank == 0

    def batch_range(self, size: int) -> tuple[int, int]:
        """Return the range (first, end) of the patches of a batch of `size` that this process
        computes. The shares differ by one patch at most; with fewer patches than processes, some
        are empty."""
        return self.rank * size // self.count, (self.rank + 1) * size // self.count

    def parallel(self, module: nn.Module) -> nn.Module:
        """Return the module, wrapped so that gradients are averaged over the processes; a single
        process gets the module itself."""
        if self.count == 1:
            return module
        return DistributedDataParallel(module, find_unused_parameters=True)

    def weight(self, size: int) -> float:
        """Return the factor on this process's mean loss for a batch of `size` patches. With it, the
        average over processes counts all patches alike, also if their shares differ."""
        first, last = self.batch_range(size)
        return (last - first) * self.count / size

    def meet(self) -> None:
        """Wait until all processes reach this point."""
        if self.count > 1:
            distributed.barrier()

    def close(self) -> None:
        """Leave the process group if this object joined it. Its threads may hold gradients, at
        which the interpreter would abort when it ends."""
        if self._ours:
            distributed.destroy_process_group()
