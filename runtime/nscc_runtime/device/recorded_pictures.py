"""Find the words of images and planes in a recorded frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nscc.operations import Op, WordEffect
from nscc.words.container import Container, Readout
from nscc.words.encoding import decode
from nscc.words.pictures import Constant, KeptPlane, Picture, Pictures, Source, TailLaunch
from nscc.words.reach import live_registers

IMAGE = 256
"""Added to the register number of a readout that is an image, not a bucket."""


def with_recorded_pictures(
    container: Container, readouts: Sequence[tuple[int, float]], states: Sequence[int]
) -> Container | None:
    """Return `container` with its last launches that do not read PIX as images and planes.

    Return None if there are no such launches, if earlier words compare analog values, or if the
    launches read a digital register that is not a code bit or that earlier words wrote.

    The exposures of the result are the contents of analog registers before these words. `readouts`
    are pairs of a register number, plus IMAGE for an image, and a gain. `states` are the numbers of
    digital registers that are read. Outputs are named after their registers. Code registers that
    these words write are kept states."""
    target, launches = container.target, container.launches
    kernels = [[decode(word) for word in kernel.words] for kernel in container.kernels]
    first = len(launches)
    while first and launches[first - 1].instant == container.slots:
        if "PIX" in live_registers(kernels[launches[first - 1].kernel], target)[0]:
            break
        first -= 1
    tail, before = launches[first:], launches[:first]
    live, written = live_registers(_ops(kernels, [each.kernel for each in tail]), target)
    exposing = _ops(kernels, [each.kernel for each in before])
    written_before = live_registers(exposing, target)[1]
    looks = any(op.operation.effect is WordEffect.FLAG_ANALOG for op in exposing)
    planes = frozenset(container.code_registers)
    known = frozenset((*target.analog_registers, "IN")) | (planes - written_before)
    if not tail or looks or not live <= known:
        return None
    images = [target.analog_registers[n - IMAGE] for n, _ in readouts if n >= IMAGE]
    buckets = [target.analog_registers[n] for n, _ in readouts if n < IMAGE]
    exposed = [name for name in target.analog_registers if name in {*live, *buckets}] or ["A"]
    bits = [target.digital_registers[number] for number in states]
    kept = [name for name in container.code_registers if name in written]
    level = None
    tail_launches = []
    for index, launch in enumerate(launches):
        level = launch.level if launch.level is not None else level
        if index >= first:
            tail_launches.append(TailLaunch(launch.kernel, level))
    names = {f"image {register}": register for register in images}
    names |= {f"plane {register}": register for register in bits}
    items = [
        Picture(name, Constant(False) if name.startswith("plane") else Source(exposed[0]))
        for name in names
    ]
    pictures = Pictures(
        (), tuple(items), None, dict.fromkeys(exposed, float("inf")), (*buckets, *names), (),
        tuple(kernel.words for kernel in container.kernels), tuple(tail_launches),
        {**names, **{register: register for register in (*buckets, *kept)}},
        states=tuple(KeptPlane(register, False, Constant(False)) for register in kept),
    )  # fmt: skip
    shutters = np.zeros((len(container.encoding), len(exposed), container.slots), np.bool_)
    numbers = sorted({launch.kernel for launch in before})
    return replace(
        container,
        buckets=tuple(exposed),
        table=replace(container.table, shutters=shutters),
        kernels=tuple(container.kernels[number] for number in numbers),
        launches=tuple(replace(each, kernel=numbers.index(each.kernel)) for each in before),
        pictures=pictures,
        readouts=tuple(Readout(register, register) for register in exposed),
        state_planes={},
    )


def _ops(kernels: Sequence[Sequence[Op]], numbers: Sequence[int]) -> list[Op]:
    return [op for number in numbers for op in kernels[number]]
