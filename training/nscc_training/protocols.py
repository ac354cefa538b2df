"""Protocols: what a number means. Frozen files; their digests stand beside every number."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected
from nscc.diagnostics.suggest import closest

NAMES = ("hdr-v1", "video-v1", "sci8", "deblur-v1", "two-bucket-v1", "staggered-v1")


@dataclass(frozen=True)
class Protocol:
    """A protocol: its name, the digest of its file, and what it fixes."""

    name: str
    sha256: str
    values: Mapping[str, Any]

    def __getitem__(self, key: str) -> Any:
        return self.values[key]


def load_protocol(name: str) -> Protocol:
    """The protocol of that name; Rejected (NS0806) for another one."""
    if name not in NAMES:
        near = closest(name, NAMES)
        raise rejected(
            "NS0806",
            f"there is no protocol '{name[:60]}'",
            notes=(f"the protocols are {', '.join(NAMES)}",),
            helps=(f"did you mean {near}?",) if near else ("name one of them",),
        )
    installed = Path(__file__).with_name("protocol_files")
    folder = installed if installed.is_dir() else Path(__file__).resolve().parents[1] / "protocols"
    data = (folder / f"{name}.toml").read_bytes()
    return Protocol(name, sha256(data).hexdigest(), tomllib.loads(data.decode()))
