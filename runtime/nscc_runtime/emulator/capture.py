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

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nscc.diagnostics.rejection import rejected
from nscc.words.soundness import faults
from nscc_runtime.container_cache import OfContainer
from nscc_runtime.emulator.steps import Layout, Steps, steps_of
from nscc_runtime.emulator.taps import sorted_light
from nscc_runtime.interface import Exposure
from nscc_runtime.pool import in_parts, threads_of

if TYPE_CHECKING:
    from nscc.words.container import Container
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
    if container.target.streamed:
        return sorted_light(container, light)
    from nscc_runtime.emulator.loops import PixelBlock, expose_block

    words = _decoded(container)
    readouts = {readout.bucket: readout for readout in container.readouts}
    ordered = [readouts[bucket] for bucket in container.buckets]
    pixels = light.shape[0] * light.shape[1]
    exposure = np.empty((len(ordered), pixels), np.float64)
    block = min(BLOCK, (pixels + 63) // 64 * 64)
    frames = np.require(light.frames, np.float32, ["C", "A"]).reshape(len(light.frames), pixels)
    _check_matrix(light)
    program, layout = words.steps, words.layout
    run = expose_block.bound(
        steps=program.steps,
        operands=program.operands,
        kernel_start=program.kernel_start,
        launch_start=program.launch_start,
        launch_kernel=program.launch_kernel,
        used_rows=program.used_rows,
        frames=frames,
        row_start=np.require(light.row_start, np.int64, ["C", "A"]),
        frame_index=np.require(light.frame_index, np.int32, ["C", "A"]),
        weight=np.require(light.weight, np.float64, ["C", "A"]),
        frame_weight=np.bincount(light.frame_index, light.weight, minlength=len(frames)),
        code_planes=words.code_planes,
        code_rows=words.code_rows,
        readout_rows=np.array([layout.rows[readout.register] for readout in ordered], np.int64),
        readout_gain=np.array([readout.gain for readout in ordered], np.float64),
        exposure=exposure,
    )

    def fill(begin: int, end: int) -> None:
        working = {
            "planes": np.empty(len(layout.planes) * (block // 64), np.uint64),
            "rows": np.empty(len(layout.rows) * block, np.float64),
            "charge": np.empty(block, np.float32),
        }
        for first in range(begin, end, block):
            sizes = PixelBlock(
                slots=container.slots,
                pixels=pixels,
                first=first,
                length=min(block, end - first),
                frames=len(frames),
                code_registers=len(words.code_rows),
                buckets=len(ordered),
                seed=np.uint64(device_seed & 2**64 - 1),
                flag_plane=layout.planes["FLAG"],
                pix_row=layout.rows["PIX"],
            )
            run(block=sizes, **working)

    in_parts(fill, pixels, threads_of(threads), block)
    shaped = exposure.reshape(len(ordered), *light.shape)
    return Exposure(shaped, np.isfinite(shaped))


@dataclass(frozen=True, eq=False)
class _Decoded:
    """A program's words and codes as the arrays that the compiled loop reads. `code_planes`: packed
    planes of the codes. `code_rows`: the numbers of their registers."""

    layout: Layout
    steps: Steps
    code_planes: NDArray[np.uint64]
    code_rows: NDArray[np.int64]

    @classmethod
    def of(cls, container: Container) -> _Decoded:
        assert container.pixel_codes is not None  # see `check_program`
        layout, codes = Layout.of(container.target), container.planes()
        return cls(
            layout,
            steps_of(container, layout),
            _packed(codes.values(), container.pixel_codes.size),
            np.array([layout.planes[name] for name in codes], np.int64),
        )


_decoded = OfContainer(_Decoded.of)
_faults = OfContainer(faults)


def _check_matrix(light: Light) -> None:
    """Raise ValueError for an inconsistent matrix of a light: the loop does not check it."""
    starts, index = light.row_start, light.frame_index
    if starts[0] != 0 or np.any(np.diff(starts) < 0):
        raise ValueError("the rows of the light's matrix are out of order")
    if index.size and not (index.min() >= 0 and index.max() < len(light.frames)):
        raise ValueError("the light's matrix names a frame that does not exist")


def check(container: Container, light: Light) -> None:
    """Raise like `check_program` and `check_size` for a program or light that cannot run."""
    check_program(container)
    check_size(container, light)


def check_program(container: Container) -> None:
    """Raise NS0741 for a program without pixel codes, ValueError for an inconsistent container."""
    if container.pixel_codes is None:
        raise rejected(
            "NS0741",
            "the program has no pixel codes",
            helps=("add a `pixels` statement, or give codes in a file: --pixels CODES.npz",),
            status=1,
        )
    unsound = _faults(container)
    if unsound:
        raise ValueError(f"unsound container: {unsound[0]}")


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


def _packed(planes: Iterable[NDArray[np.bool_]], pixels: int) -> NDArray[np.uint64]:
    """Return planes as 64-bit words: pixel i is bit i % 64 of word i // 64; padding is 0."""
    packed = [np.packbits(plane.reshape(-1), bitorder="little") for plane in planes]
    words = np.zeros((len(packed), (pixels + 63) // 64 * 8), np.uint8)
    for row, data in zip(words, packed, strict=True):
        row[: data.size] = data
    return words.view("<u8").astype(np.uint64)
