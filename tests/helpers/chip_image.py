"""The loader linked for a chip by the real cross compiler: how large it is, and what is in it."""

from __future__ import annotations

import re
import shutil
import subprocess
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import pytest

from nscc_runtime.device import qemu
from nscc_runtime.device.firmware import SOURCES

PREFIX = "arm-none-eabi-"
CHIP_FLAGS = (*qemu.CHIP_FLAGS, "-Werror", "-fcallgraph-info=su")
_INDIRECT = "__indirect_call"


def needs_cross_compiler() -> None:
    """Skip a test where no compiler for the chip is installed."""
    if shutil.which(f"{PREFIX}g++") is None:
        pytest.skip(f"{PREFIX}g++ is not installed: nothing can be linked for the chip")


@dataclass(frozen=True)
class Image:
    """A linked image; its call graphs stand beside it."""

    path: Path

    def _said(self, tool: str, *options: str) -> str:
        command = [PREFIX + tool, *options, str(self.path)]
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout

    @cached_property
    def sections(self) -> dict[str, int]:
        """Bytes of each section."""
        found = re.findall(r"^(\.\w+)\s+(\d+)\s", self._said("size", "-A"), re.M)
        return {name: int(size) for name, size in found}

    @cached_property
    def symbols(self) -> dict[str, int]:
        """Names and addresses."""
        lines = (line.split() for line in self._said("nm").splitlines())
        return {line[2]: int(line[0], 16) for line in lines if len(line) == 3}

    def stack_bytes(self, entry: str) -> int:
        """Most stack that a call of `entry` takes, as the compiler adds it up.

        A call through a pointer may be one of any function whose address is taken: here, of any
        virtual function. What the compiler did not compile (its own library) takes nothing.
        """
        own: dict[str, int] = {}
        calls: dict[str, set[str]] = {}
        virtual: set[str] = set()
        for graph in self.path.parent.glob("*.ci"):
            text = graph.read_text()
            for name, label in re.findall(r'node: \{ title: "(.+?)" label: "(.+?)"', text):
                size = re.search(r"(\d+) bytes \(static\)", label)
                if size:
                    own[name] = int(size.group(1))
            for caller, callee in re.findall(r'sourcename: "(.+?)" targetname: "(.+?)"', text):
                calls.setdefault(caller, set()).add(callee)
        tables = [name for name in self.symbols if name.startswith("_ZTV")]
        assert tables, "nothing is virtual"
        virtual = {name for name in own if re.search(r"4Chip|Program7refresh", name)}

        def deepest(name: str, above: tuple[str, ...]) -> int:
            assert name not in above, f"{name} calls itself: {above}"
            callees = calls.get(name, set())
            if _INDIRECT in callees:
                callees = (callees - {_INDIRECT}) | (virtual - set(above) - {name})
            below = [deepest(each, (*above, name)) for each in callees]
            return own.get(name, 0) + max(below, default=0)

        return deepest(entry, ())


def linked(core: str, root: Path, folder: Path) -> Image:
    """The loader for the LPC4357's core `m0` or `m4`, with a stand-in for the devkit's library."""
    needs_cross_compiler()
    layer = SOURCES / "scamp5d"
    sources = [
        *sorted((SOURCES / "core").glob("*.cpp")),
        *sorted(layer.glob("*.cpp")),
        root / "tests/firmware_chip/vendor.cpp",
    ]
    includes = [
        SOURCES / "core",
        SOURCES / "port",
        layer,
        SOURCES / "targets/scamp5",
        root / "tests/firmware_chip",
    ]
    path = folder / f"loader-{core}.elf"
    subprocess.run(
        [
            f"{PREFIX}g++",
            *CHIP_FLAGS,
            f"-mcpu=cortex-{core}",
            *(f"-I{each}" for each in includes),
            *map(str, sources),
            f"-L{SOURCES / 'port'}",
            f"-T{layer / f'lpc4357_{core}.ld'}",
            "-o",
            str(path),
        ],
        check=True,
        cwd=folder,
    )
    return Image(path)
