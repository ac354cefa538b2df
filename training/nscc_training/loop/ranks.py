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
    """The processes of a run: `rank` of `count`; without `torchrun`, 0 of 1."""

    def __init__(self) -> None:
        """Join the other processes if `torchrun` has started several; `RANK` and `WORLD_SIZE`
        tell."""
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
        """Return the range of a batch's patches that this process computes."""
        return self.rank * size // self.count, (self.rank + 1) * size // self.count

    def parallel(self, module: nn.Module) -> nn.Module:
        """Return the module, with gradients averaged over the processes."""
        if self.count == 1:
            return module
        return DistributedDataParallel(module, find_unused_parameters=True)

    def weight(self, size: int) -> float:
        """Return the weight of this process's loss, so that all patches have equal weight."""
        first, last = self.batch_range(size)
        return (last - first) * self.count / size

    def meet(self) -> None:
        """Wait until all processes reach this point."""
        if self.count > 1:
            distributed.barrier()

    def close(self) -> None:
        """Leave the process group: its threads may hold gradients, at which the interpreter would
        abort."""
        if self._ours:
            distributed.destroy_process_group()
