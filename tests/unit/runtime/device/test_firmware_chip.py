"""The loader fits its chip: linked for both cores of the LPC4357 by the real cross compiler."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from chip_image import Image, linked

FLASH, SHARED = 512 << 10, 64 << 10
RAM = {"m0": 40 << 10, "m4": 32 << 10}
LIBRARY_STORE = 20480
"""Bytes of the devkit library's own store of instruction words."""
LIBRARY_STACK = 512
"""Bytes of stack that are left to the devkit's functions."""


@pytest.fixture(scope="module", params=["m0", "m4"])
def core(request: pytest.FixtureRequest) -> str:
    """A core of the chip."""
    return str(request.param)


@pytest.fixture(scope="module")
def image(core: str, root: Path, tmp_path_factory: pytest.TempPathFactory) -> Image:
    """The loader for it."""
    return linked(core, root, tmp_path_factory.mktemp(core))


def test_the_firmware_leaves_a_tenth_of_every_memory_free(image: Image, core: str) -> None:
    """The linked image fills at most 90 % of the flash and of each core's memory, with the
    library's store and the stack counted."""
    size = image.sections
    assert size[".text"] + size[".data"] <= 0.9 * FLASH
    assert size[".bss"] >= LIBRARY_STORE, "the library's store is not counted"
    assert size[".data"] + size[".bss"] + size[".stack"] <= 0.9 * RAM[core]
    assert 0.5 * SHARED < size[".shared"] <= 0.9 * SHARED


def test_the_stack_is_deep_enough(image: Image) -> None:
    need = image.stack_bytes("main")
    assert 500 < need + LIBRARY_STACK <= 0.9 * image.sections[".stack"]


def test_the_firmware_calls_no_slow_arithmetic_or_allocation_of_the_library(image: Image) -> None:
    """The image holds no symbol of float, 64-bit division, malloc or throw. It does hold the loop
    of a frame."""
    slow = re.compile(r"__aeabi_[df]|__aeabi_u?ldivmod|__(u?div|u?mod)di3|_Z?malloc|__cxa_throw")
    found = [name for name in image.symbols if slow.match(name)]
    assert not found
    assert "_ZN4nscc8Schedule5go_onEv" in image.symbols, "the frame's loop is not there at all"
