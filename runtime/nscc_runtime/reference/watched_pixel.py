"""The registers of one pixel after every word of a frame, from the reference."""

from __future__ import annotations

import numpy as np

from nscc.mappings import JsonObject
from nscc.words.container import Container
from nscc.words.legality import refuse_planes
from nscc_runtime.effects.selection import Selection
from nscc_runtime.effects.sensor import Sensor
from nscc_runtime.light import Light
from nscc_runtime.reference.capture import ProgramPixels, Reference, reference_scene
from nscc_runtime.reference.charge import charge_of_rows
from nscc_runtime.reference.trace import RunningWord

_MOST_STEPS = 4096
"""Largest number of words that a trace holds; a page that shows more of them is slow."""


def traced(
    container: Container,
    light: Light,
    sensor: Sensor,
    effects: Selection,
    pixel: tuple[int, int],
    seed: int,
) -> JsonObject:
    """Return the words of an exposure as steps with the contents of a pixel's registers after them,
    as JSON values. `pixel`: row and column, inside the array. `seed`: of the noise.

    Keys: `registers`, the names of the registers that the program uses; `steps`, at most 4096 of
    the `words` words; `exposure_e`, the electrons of each bucket by name. A step has the
    `boundary`, the end of the word in `us` after the start of the frame, the `word`, and the
    `values` in the order of `registers`: electrons of PIX (the photodiode) and of the analog
    registers, then bits. Raises Rejected like `Reference.of`, and with NS0510 for chips without
    logic."""
    refuse_planes(container.target, "there are no words to follow", "see the shutters instead")
    row, col = pixel
    reference = Reference.of(container, sensor, effects)
    scene, rows = reference_scene(container, light), range(row, row + 1)
    charge, _ = charge_of_rows(
        scene, sensor, effects, seeds=(seed, 0), frame=0, rows=rows, starts=reference.starts
    )
    watched = _WatchedPixel(
        sensor=sensor,
        seed=seed,
        device_seed=0,
        frame=0,
        places=np.array([row * container.target.cols + col]),
        container=container,
        effects=effects,
        program=reference,
        code={name: plane[row, col : col + 1] for name, plane in container.planes().items()},
    )
    # The charge of the whole row is needed for crosstalk; only this column runs.
    exposures, _ = watched.run(charge[:, 0, col : col + 1])
    return {
        "registers": watched.names,
        "steps": watched.steps,
        "words": len(reference.words),
        "exposure_e": dict(zip(container.buckets, exposures[:, 0].tolist(), strict=True)),
    }


class _WatchedPixel(ProgramPixels):
    """One pixel that records in `steps` the values of the registers `names` after each of the first
    `_MOST_STEPS` words."""

    def __post_init__(self) -> None:
        """Set the registers at the start of the frame, and list those that are recorded: PIX (the
        photodiode), the analog and digital registers that some word reads or writes, and FLAG (the
        bit that lets a pixel act)."""
        super().__post_init__()
        ops = [word.op for word in self.program.words]
        used = {name for op in ops for name in (*op.sources, *op.destinations)}
        registers = *self.target.analog_registers, *self.target.digital_registers
        self.names = ["PIX", *(name for name in registers if name in used), "FLAG"]
        self.steps: list[JsonObject] = []

    def run_word(self, word: RunningWord) -> None:
        """Run a word, and append a step with its boundary, the time in us of its end from the start
        of the frame, its text, and the values of registers after it: electrons rounded to 0.1, then
        bits. After `_MOST_STEPS` steps words still run, but are not recorded."""
        super().run_word(word)
        if len(self.steps) < _MOST_STEPS:
            us = sum(self.container.slot_us[: word.boundary]) + word.after_us
            electrons = {"PIX": self.charge, **self.register}
            values = [
                round(float(electrons[name][0]), 1) + 0.0  # no -0
                if name in electrons
                else int(self.digital.read(name)[0])
                for name in self.names
            ]
            step = {"boundary": word.boundary, "us": round(us, 3), "word": str(word.op)}
            self.steps.append(step | {"values": values})
