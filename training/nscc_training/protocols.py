"""Evaluation protocols: fixed files, whose digests are stored in every result."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import unknown_name

TRAINED = (
    "hdr-v1",
    "video-v1",
    "deblur-v1",
    "two-bucket-v1",
    "staggered-v1",
    "codes-v1",
    "class-v1",
)
"""The protocols whose scenes a run can learn from."""
NAMES = (*TRAINED, "sci8")
CLASS = "class"
"""The loss of decoders that name classes."""
PROCEDURAL = "procedural"
"""The name of scenes without files."""
_PHOTONS_OF_LUX = 1 / 683 / (6.626e-34 * 2.998e8 / 555e-9)
"""Photons of 555 nm per second, square metre and lux; one watt is 683 lumens."""


@dataclass(frozen=True)
class Protocol:
    """An evaluation protocol: its `name`, `sha256`, the digest of its file, and the `values` that
    it defines, by key. It fixes how scenes are exposed and scored, so that scores can be compared.
    """

    name: str
    sha256: str
    values: Mapping[str, Any]

    def __getitem__(self, key: str) -> Any:
        """Return the value of a key of the protocol's file. Raise KeyError if the protocol lacks
        it."""
        return self.values[key]

    @property
    def still(self) -> bool:
        """Whether scenes are stills instead of clips."""
        return self.name == "hdr-v1"

    @property
    def classifies(self) -> bool:
        """Whether decoders name the class of a scene instead of reconstructing it."""
        return "correct" in self.metrics

    @property
    def metrics(self) -> tuple[str, ...]:
        """The metrics of a run: the first one is the score, and the mean of a result."""
        return (self.values["metric"],) if "metric" in self.values else ("psnr_db", "ssim")

    def changed(self, **values: Any) -> Protocol:
        """Return a variant with other values; its digest stays that of the file."""
        return replace(self, values={**self.values, **values})

    @property
    def light(self) -> float:
        """The light of clips relative to a full well at their brightest percent, always open."""
        return float(self.values.get("light", 1.0))

    @property
    def mid_grey_e(self) -> float | None:
        """The electrons over the frame at the median of a scene, if the protocol defines the
        illuminance; None if scenes are scaled to a full well.

        A lens with f-number A passes 1 / (4 A^2) of the light of a matt surface to the sensor."""
        if "illuminance_lux" not in self.values:
            return None
        lux = self["illuminance_lux"] * self["reflectance"] / (4 * self["f_number"] ** 2)
        counted_m2 = self["photosite_um2"] * 1e-12 * self["quantum_efficiency"]
        seconds = self["frames"] * self["slot_us"] * 1e-6
        return float(lux * _PHOTONS_OF_LUX * counted_m2 * seconds)


def packaged(name: str, checkout_path: str) -> Path:
    """Return the path of the file or folder `name` of the installed package. In a checkout, which
    has no such file, return the path of `checkout_path` in the folder `training`."""
    installed = Path(__file__).with_name(name)
    return installed if installed.exists() else Path(__file__).resolve().parents[1] / checkout_path


def load_protocol(name: str) -> Protocol:
    """Return the protocol with this name from its file. Raise Rejected (NS0806) for an unknown
    name."""
    if name not in NAMES:
        raise unknown_name("NS0806", "unknown protocol '{}'", name, NAMES, "the protocols are {}")
    data = (packaged("protocol_files", "protocols") / f"{name}.toml").read_bytes()
    return Protocol(name, sha256(data).hexdigest(), tomllib.loads(data.decode()))
