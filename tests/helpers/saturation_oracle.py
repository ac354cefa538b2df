"""A chip whose PIX and registers hold no more than so much, beside one without limits.

Both run the words slot by slot on `emulator_oracle.Chip`; what the one gives less than the other is
what was lost.
"""

from __future__ import annotations

import numpy as np
from emulator_oracle import Chip

from nscc.words.container import Container
from nscc.words.legality import decoded


class LimitedChip(Chip):
    """PIX ends at `well_e`; a register bends by tanh beyond `knee` of `most_e`. Nothing else."""

    well_e = np.inf
    most_e = np.inf
    knee = 1.0

    def expose(self, words: list[list[tuple]], light: np.ndarray) -> None:
        """Run words[n] at boundary n, PIX full at `well_e`."""
        for n, here in enumerate(words):
            for word in here:
                self.run(*word)
            if n < len(light):
                self.analog["PIX"] = np.minimum(self.analog["PIX"] + light[n], self.well_e)

    def run(self, name: str, destinations: tuple, sources: tuple) -> None:
        """One word; what it writes to analog registers bends."""
        super().run(name, destinations, sources)
        for register in destinations:
            if register in self.analog and np.isfinite(self.most_e):
                self.analog[register] = self.bent(self.analog[register])

    def bent(self, value: np.ndarray) -> np.ndarray:
        """What a register makes of a value."""
        linear, room = self.knee * self.most_e, (1 - self.knee) * self.most_e
        beyond = np.maximum(np.abs(value) - linear, 0)
        return np.sign(value) * (np.abs(value) - beyond + room * np.tanh(beyond / room))


def exposures(container: Container, light: np.ndarray, **limits: float) -> np.ndarray:
    """Exposures (buckets, rows, cols) of light (N, rows, cols) under limits."""
    target, shape = container.target, light.shape[1:]
    nothing = np.zeros(shape, bool)
    digital = dict.fromkeys((*target.digital_registers, "SELECT"), nothing)
    chip = LimitedChip(
        analog={name: np.zeros(shape) for name in (*target.analog_registers, "PIX", "IN")},
        digital={**digital, **container.planes()},
        flag=~nothing,
        reset=np.zeros(shape),
    )
    for name, value in limits.items():
        setattr(chip, name, value)
    kernels = decoded(container)
    words = [
        [
            (op.name, op.destinations, op.sources)
            for launch in container.launches
            if launch.instant == n
            for op in kernels[launch.kernel]
        ]
        for n in range(container.slots + 1)
    ]
    chip.expose(words, light.astype(float))
    found = {r.bucket: chip.analog[r.register] * r.gain for r in container.readouts}
    return np.stack([found[bucket] for bucket in container.buckets])


def lost_e(container: Container, light: np.ndarray, **limits: float) -> np.ndarray:
    """Electrons that limits take from exposures (buckets, rows, cols)."""
    return np.abs(exposures(container, light) - exposures(container, light, **limits))
