"""One frame on the emulated chip, without sensor effects."""

from __future__ import annotations

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc.words.container import Container
from nscc.words.legality import decoded
from nscc.words.soundness import faults
from nscc.words.stream import Stream
from nscc_runtime.caches import OfContainer
from nscc_runtime.emulator.chip_program import ChipProgram
from nscc_runtime.exposed_frame import Exposure
from nscc_runtime.light import Light


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
    run (`nscc.words.legality`). Raises ValueError for an inconsistent container (a compiled
    program) or light."""
    check(container, light)
    if container.stream is not None:
        return _sorted_light(container, container.stream, light)
    of_bucket = {readout.bucket: readout for readout in container.readouts}
    readouts = [of_bucket[bucket] for bucket in container.buckets]
    registers = [readout.register for readout in readouts]
    exposure, _ = _chip_program(container).run(
        light, registers, device_seed=device_seed, threads=threads
    )
    exposure *= np.array([readout.gain for readout in readouts])[:, None, None]
    exposure += 0.0  # -0 + 0 is +0
    return Exposure(exposure, np.isfinite(exposure))


def _sorted_light(container: Container, sent: Stream, light: Light) -> Exposure:
    """Return the exposure of a chip without logic: for each bucket the light that its tap collects,
    times the tap's gain, in float64. `sent`: the bit planes of `container`. Errors must be checked
    before."""
    exposure = np.zeros((len(container.buckets), *light.shape))
    for slot in range(container.slots):
        fallen = light.slot(slot).astype(np.float64)
        destinations = sent.destinations(slot, light.shape[1])
        for bucket in range(len(exposure)):
            exposure[bucket] += np.where(destinations == bucket, fallen, 0.0)
    exposure *= np.array([readout.gain for readout in container.readouts])[:, None, None]
    return Exposure(exposure, np.isfinite(exposure))


@OfContainer
def _chip_program(container: Container) -> ChipProgram:
    """Return the program of `container` for the emulator; cached with it. The caller has checked
    that the schedule is sound (`nscc.words.soundness`). Raises Rejected for words that are no
    operations of the chip."""
    launches = sorted(container.launches, key=lambda launch: launch.instant)
    kernels, planes = decoded(container), container.planes()
    return ChipProgram(container.target, container.slots, kernels, launches, planes)


_faults = OfContainer(faults)


def check(container: Container, light: Light) -> None:
    """Check that the program of `container` can run over `light`. Raises Rejected if it has no
    pixel codes (NS0741) or the light has another size (NS0734), and ValueError for an inconsistent
    container (a compiled program)."""
    check_program(container)
    check_size(container, light)


def check_program(container: Container) -> None:
    """Raise Rejected (NS0741) for a program without pixel codes, and ValueError, with the first
    fault, for an inconsistent container (a compiled program)."""
    check_codes(container)
    unsound = _faults(container)
    if unsound:
        raise ValueError(f"unsound container: {unsound[0]}")


def check_codes(container: Container) -> None:
    """Raise Rejected (NS0741) if the program of `container` has no pixel codes."""
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
