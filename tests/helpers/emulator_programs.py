"""Containers made by hand, for tests and benchmarks of the emulator alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from nscc.chips.load import builtin_target
from nscc.chips.target import Target
from nscc.operations import Op, op, pair
from nscc.words.container import Container, DecodeTable, Launch, Readout, StoredKernel
from nscc.words.encoding import encode


def target_of(shape: tuple[int, int], name: str = "scamp5", **changes: object) -> Target:
    """A built-in target with an array of another size, and further keys changed."""
    target = replace(builtin_target(name), rows=shape[0], cols=shape[1])
    return replace(target, **changes)  # type: ignore[arg-type]


def container_of(
    target: Target,
    planes: dict[str, np.ndarray],
    kernels: Sequence[Sequence[Op]],
    launches: Iterable[tuple[int, int]],
    slots: int,
    readouts: Sequence[Readout] = (Readout("A", "frame"),),
) -> Container:
    """A container whose pixels start with `planes` (rows, cols) in their registers.

    Its decode table holds one shutter for each distinct set of bits; they are left closed, because
    the emulator does not look at them.
    """
    names = tuple(planes)
    shape = (target.rows, target.cols)
    number = np.zeros(shape, np.int64)
    for k, name in enumerate(names):
        number |= planes[name].astype(np.int64) << k
    used, codes = np.unique(number, return_inverse=True)
    encoding = np.zeros((len(used), len(target.digital_registers)), bool)
    for k, name in enumerate(names):
        encoding[:, target.digital_registers.index(name)] = used >> k & 1
    buckets = tuple(dict.fromkeys(readout.bucket for readout in readouts))
    return Container(
        target=target,
        slot_us=(1.0,) * slots,
        buckets=buckets,
        table=DecodeTable(
            fields=("code",),
            codes=used[:, None],
            shutter_of_code=np.arange(len(used), dtype=np.int32),
            shutters=np.zeros((len(used), len(buckets), slots), bool),
        ),
        kernels=tuple(
            StoredKernel(f"k{i}", tuple(encode(word) for word in words))
            for i, words in enumerate(kernels)
        ),
        launches=tuple(Launch(*launch) for launch in launches),
        code_registers=names,
        encoding=encoding,
        pixel_codes=codes.reshape(shape).astype(np.int32),
        readouts=tuple(readouts),
    )


RESET = [op("rpix"), op("rpix"), op("nop")]
CLEAR = [op("bus", ["NEWS"]), op("bus", ["A"], ["NEWS"])]
LEVEL = [op("bus", ["NEWS"], ["PIX"]), op("bus", ["B"], ["NEWS"])]
ADD = [op("bus", ["NEWS"], ["A", "PIX"]), op("bus", ["A"], ["NEWS", "B"])]
SUBTRACT = [op("bus", ["NEWS"], ["A", "B"]), op("bus", ["A"], ["NEWS", "PIX"])]
TAKE = [op("bus", ["NEWS"], ["PIX"]), op("bus", ["A"], ["NEWS", "B"])]


def bumps(
    target: Target, start: np.ndarray | None, stop: np.ndarray, slots: int, lowering: str
) -> Container:
    """Open while start <= n < stop; `start` and `stop` int (rows, cols), None: from slot 0 on.

    The fields lie in registers as Gray codes, of which every boundary flips one bit in place, so
    that a field's registers are all 0 where it equals the boundary's number. A pixel keeps whether
    it is open in a register. `lowering` is accumulate, latch (only from slot 0 on) or edges.
    """
    shape = (target.rows, target.cols)
    masked = {target.mask_register, target.masked_register}
    free = [name for name in target.digital_registers if name not in masked]
    opened, closed = free.pop(), free.pop()
    fields, planes = [], {}
    for values in (stop,) if start is None else (stop, start):
        gray = values ^ values >> 1
        names = [free.pop(0) for _ in range(int(slots).bit_length())]
        planes.update({name: (gray >> k & 1).astype(bool) for k, name in enumerate(names)})
        fields.append(names)
    assert all(plane.shape == shape for plane in planes.values())

    def words(n: int) -> list[Op]:
        found: list[Op] = []
        if n == 0:
            found += [op("all"), *RESET, *CLEAR, *LEVEL]
            found += [op("SET" if start is None else "CLR", [opened])]
        elif lowering != "edges":
            found += [op("WHERE", (), [opened]), *(ADD if lowering == "accumulate" else TAKE)]
        if n and lowering == "accumulate":
            found += [op("all"), *RESET]
        flips = (n ^ n >> 1) ^ (n - 1 ^ n - 1 >> 1) if n else 0
        for which, names in enumerate(fields):
            for k, name in enumerate(names):
                if flips >> k & 1:
                    found += pair("NOR", name, [name])
            found += [op("NOR", ["R0"], names)]
            if lowering == "edges":
                found += [op("WHERE", (), ["R0"]), *(ADD if which == 0 else SUBTRACT)]
            elif which == 0:
                found += [op("NOT", [closed], [opened]), *pair("OR", closed, [closed, "R0"])]
                found += [op("NOT", [opened], [closed])]
            else:
                found += pair("OR", opened, [opened, "R0"])
        return found

    kernels: dict[tuple[Op, ...], int] = {}
    launches = []
    for n in range(slots + 1):
        number = kernels.setdefault(tuple(words(n)), len(kernels))
        launches.append((n, number))
    return container_of(target, planes, list(kernels), launches, slots)
