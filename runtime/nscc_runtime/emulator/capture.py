"""One frame on the emulated chip, without sensor effects.

Words take no time: all words of boundary n see PIX as it is after the slots before n. Then the
light of slot n is added to PIX of every pixel. After boundary N the readouts follow.

A frame starts with arbitrary values in PIX, FLAG, the analog registers and the digital registers
without code. The reset level of PIX is a nonzero constant of each pixel. These values are
determined by `device_seed`. Analog values are 1/4 to 3/4 of the pixel's light in the frame (1 to 2
without light). That is large enough to reveal a program that forgets a reset or reads an unwritten
register. It is small enough that a correct program, which subtracts the value, loses no accuracy,
for any amount of light. PIX and the reset level are positive, registers have either sign.

Not emulated, because no program of this project uses it: addresses (SELECT reads 0) and the global
DAC (IN reads 0)."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np

from nscc.diagnostics.rejection import rejected
from nscc.words.legality import decoded
from nscc.words.soundness import faults
from nscc_runtime.caches import OfContainer
from nscc_runtime.emulator.array_words import ArrayWords, packed
from nscc_runtime.interface import Exposure
from nscc_runtime.pool import in_parts, threads_of

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_runtime.emulator.loops import EmulatedProgram
    from nscc_runtime.light import Light

BLOCK = 8192
"""Number of pixels exposed together, a multiple of 64. Their registers stay in the cache."""


def expose(
    container: Container,
    light: Light,
    *,
    device_seed: int = 0,
    threads: int | None = None,
) -> Exposure:
    """Run the words of `container` over `light`, slot by slot, in float64; for a chip without
    words, sort the light into taps.

    Results do not depend on `threads` (None: all processors). Raises Rejected for a program without
    pixel codes (NS0741), for light of another size (NS0734), and for words that the target cannot
    run (`nscc.words.legality`). Raises ValueError for an inconsistent container or light."""
    check(container, light)
    if container.stream is not None:
        return _sorted_light(container, light)
    from nscc_runtime.emulator.loops import PixelRange, expose_pixels

    table, program = _decoded(container)
    readouts = {readout.bucket: readout for readout in container.readouts}
    ordered = [readouts[bucket] for bucket in container.buckets]
    pixels = light.shape[0] * light.shape[1]
    exposure = np.empty((len(ordered), pixels), np.float64)
    block = min(BLOCK, (pixels + 63) // 64 * 64)
    starts, index = light.row_start, light.frame_index
    if starts[0] != 0 or np.any(np.diff(starts) < 0):
        raise ValueError("the rows of the light's matrix are out of order")
    if index.size and not (index.min() >= 0 and index.max() < len(light.frames)):
        raise ValueError("the light's matrix names a frame that does not exist")
    frames, registers = len(light.frames), len(table.analog)
    readout_rows = np.array([table.analog[readout.register] for readout in ordered], np.int64)
    readout_gain = np.array([readout.gain for readout in ordered], np.float64)

    def fill(begin: int, end: int) -> None:
        chosen = PixelRange(
            slots=container.slots,
            pixels=pixels,
            begin=begin,
            end=end,
            block=block,
            frames=frames,
            code_registers=len(program.code_rows),
            buckets=len(ordered),
            seed=np.uint64(device_seed & 2**64 - 1),
            pix=table.analog["PIX"],
        )
        expose_pixels(
            chosen=chosen,
            shape=table.shape(1, block, block, registers),
            program=program,
            light=light.matrix,
            frame_weight=light.frame_weight,
            readout_rows=readout_rows,
            readout_gain=readout_gain,
            planes=np.empty(len(table.digital) * (block // 64), np.uint64),
            values=np.zeros((2 * registers + 5) * block),
            marks=np.empty(0, np.uint8),
            marked=np.zeros(1, np.int64),
            charge=np.empty(block, np.float32),
            exposure=exposure,
        )

    in_parts(fill, pixels, threads_of(threads), block)
    shaped = exposure.reshape(len(ordered), *light.shape)
    return Exposure(shaped, np.isfinite(shaped))


def _sorted_light(container: Container, light: Light) -> Exposure:
    """Return the exposure of a chip without logic: for each bucket the light that its tap collects,
    times the tap's gain, in float64.

    Raises ValueError for a container without planes. Other errors must be checked before."""
    sent = container.stream
    if sent is None:
        raise ValueError("a container without planes")
    exposure = np.zeros((len(container.buckets), *light.shape))
    for slot in range(container.slots):
        fallen = light.slot(slot).astype(np.float64)
        place = sent.place(slot, light.shape[1])
        for bucket in range(len(exposure)):
            exposure[bucket] += np.where(place == bucket, fallen, 0.0)
    exposure *= np.array([readout.gain for readout in container.readouts])[:, None, None]
    return Exposure(exposure, np.isfinite(exposure))


@OfContainer
def _decoded(container: Container) -> tuple[ArrayWords, EmulatedProgram]:
    """Return a program's words and codes for the loop. The schedule must be sound
    (`nscc.words.soundness`)."""
    from nscc_runtime.emulator.loops import EmulatedProgram

    assert container.pixel_codes is not None  # see `check_program`
    table, codes = ArrayWords(container.target), container.planes()
    pixels = container.pixel_codes.size
    kernel_start = [0]
    for kernel in decoded(container):
        # No word reads its own result, so repeating a word changes nothing.
        kernel_start.append(table.append((op, 0.0) for op, _ in groupby(kernel)))
    instants = np.array([launch.instant for launch in container.launches], np.int64)
    kernels = np.array([launch.kernel for launch in container.launches], np.int64)
    launch_start = np.zeros(container.slots + 2, np.int64)
    np.cumsum(np.bincount(instants, minlength=container.slots + 1), out=launch_start[1:])
    return table, EmulatedProgram(
        *table.table,
        np.array(kernel_start, np.int64),
        launch_start,
        kernels[np.argsort(instants, kind="stable")],
        packed(np.array([*codes.values()], np.bool_).reshape(len(codes), pixels)),
        np.array([table.digital[name] for name in codes], np.int64),
    )


_faults = OfContainer(faults)


def check(container: Container, light: Light) -> None:
    """Raise like `check_program` and `check_size` for a program or light that cannot run."""
    check_program(container)
    check_size(container, light)


def check_program(container: Container) -> None:
    """Raise NS0741 for a program without pixel codes, ValueError for an inconsistent container."""
    check_codes(container)
    unsound = _faults(container)
    if unsound:
        raise ValueError(f"unsound container: {unsound[0]}")


def check_codes(container: Container) -> None:
    """Raise Rejected (NS0741) for a program without pixel codes."""
    if container.pixel_codes is None:
        raise rejected(
            "NS0741",
            "the program has no pixel codes",
            helps=("add a `pixels` statement, or give codes in a file: --pixels CODES.npz",),
            status=1,
        )


def check_size(container: Container, light: Light) -> None:
    """Raise Rejected (NS0734) for light with another number of pixels or slots than the program."""
    shape = light.shape if container.pixel_codes is None else container.pixel_codes.shape
    if light.shape != shape or light.slots != container.slots:
        light_size, array_size = (
            " x ".join(map(str, array_shape)) for array_shape in (light.shape, shape)
        )
        raise rejected(
            "NS0734",
            f"the light has {light_size} pixels in {light.slots} slots, but the array has "
            f"{array_size} pixels in {container.slots} slots",
            helps=("prepare the scene for the array and the slots of this program",),
            status=1,
        )
