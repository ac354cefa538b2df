"""Flats and darks made with known values, by numpy alone."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from nscc_runtime.calibrate import Stack

TOP = 255


@dataclass(frozen=True)
class Chip:
    """The values that a calibration should find. Codes are lsb, times seconds."""

    electrons_per_lsb: float = 20.0
    offset_lsb: float = 14.3
    dsnu_lsb: float = 0.8
    read_e: float = 30.0
    dark_e_per_s: float = 3000.0
    dark_spread: float = 0.25
    prnu: float = 0.015
    crosstalk: float = 0.004
    full_well_e: float = 4400.0
    shape: tuple[int, int] = (96, 96)

    def made(self, rng: np.random.Generator) -> Camera:
        """One chip with these values: its pixels drawn."""
        s = np.sqrt(np.log1p(self.dark_spread**2))
        z = rng.normal(size=(3, *self.shape))
        return Camera(
            self,
            1 + self.prnu * z[0],
            self.dark_e_per_s * np.exp(s * z[1] - s * s / 2),
            self.offset_lsb + self.dsnu_lsb * z[2],
            rng,
        )


@dataclass(frozen=True, eq=False)
class Camera:
    chip: Chip
    response: np.ndarray
    dark_e_per_s: np.ndarray
    offset_lsb: np.ndarray
    rng: np.random.Generator

    def codes(self, light_e_per_s: np.ndarray | float, time_s: float, frames: int) -> np.ndarray:
        """uint8 (frames, rows, cols)."""
        chip, rng = self.chip, self.rng
        rate = (light_e_per_s * self.response + self.dark_e_per_s) * time_s
        charge = rng.poisson(rate, (frames, *chip.shape)).astype(float)
        padded = np.pad(charge, ((0, 0), (1, 1), (1, 1)), mode="edge")
        around = (
            padded[:, :-2, 1:-1] + padded[:, 2:, 1:-1] + padded[:, 1:-1, :-2] + padded[:, 1:-1, 2:]
        )
        charge += chip.crosstalk * (around - 4 * charge)
        held = np.minimum(charge, chip.full_well_e) + rng.normal(0, chip.read_e, charge.shape)
        return np.clip(np.rint(held / chip.electrons_per_lsb + self.offset_lsb), 0, TOP).astype(
            np.uint8
        )

    def stack(
        self, light_e_per_s: np.ndarray | float, time_s: float, frames: int, **changes: object
    ) -> Stack:
        codes = self.codes(light_e_per_s, time_s, frames).astype(np.uint16)
        made = Stack(f"{time_s:g}s", codes, np.ones(self.chip.shape, bool), time_s)
        return replace(made, **changes)


LIGHT = 100_000.0
FLAT_TIMES = (0.004, 0.008, 0.012, 0.016, 0.02, 0.024, 0.028, 0.06)
DARK_TIMES = (0.001, 0.03, 0.06)


def taken(
    chip: Chip, seed: int, flats: int = 6, darks: int = 12, light: float = LIGHT
) -> tuple[list[Stack], list[Stack]]:
    """Flats and darks of one chip, so many frames a level."""
    camera = chip.made(np.random.default_rng(seed))
    return (
        [camera.stack(light, time, flats) for time in FLAT_TIMES],
        [camera.stack(0.0, time, darks) for time in DARK_TIMES],
    )


def truth(chip: Chip) -> dict[str, float]:
    """What `nscc_runtime.calibrate` should find, by its names."""
    epl = chip.electrons_per_lsb
    return {
        "system_gain": 1 / epl,
        "conversion_gain": epl,
        "crosstalk": chip.crosstalk,
        "dark_noise_lsb": chip.read_e / epl,
        "dark_noise_e": chip.read_e,
        "offset": chip.offset_lsb,
        "dsnu_lsb": chip.dsnu_lsb,
        "dsnu_e": chip.dsnu_lsb * epl,
        "dark_current": chip.dark_e_per_s,
        "dark_spread": chip.dark_spread,
        "prnu": chip.prnu,
        "saturation_lsb": chip.full_well_e / epl,
        "full_well": chip.full_well_e,
    }
