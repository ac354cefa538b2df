"""The supported devkits, described by the public names of their libraries."""

from __future__ import annotations

import re
from dataclasses import dataclass

from nscc.chips.target import Target
from nscc.emit.cpp.codes import ADDRESS_BITS
from nscc.operations import ANALOG_WRITE
from nscc.words.container import Container
from nscc.words.legality import loader_fault

_SIDE = 1 << ADDRESS_BITS
"""Most rows and columns whose pixels the devkit can select by address."""
_IN_LOW, _IN_HIGH = -128, 127
_NAMES = re.compile(r"\bscamp5(_\w+(?=\()|\.hpp)")


@dataclass(frozen=True)
class Devkit:
    """The software library of a chip's devkit.

    Names in the library start with `library`. It has `digital` one-bit registers R0, R1, ...
    `tables` means that the layout of its constant tables of words is public."""

    name: str
    library: str
    digital: int
    tables: bool

    @property
    def registers(self) -> frozenset[str]:
        """The names of the registers in the library."""
        return frozenset(ANALOG_WRITE) | {f"R{i}" for i in range(self.digital)}

    def named(self, line: str) -> str:
        """Return a line of C++ with the SCAMP-5d library's names replaced by those of this
        library."""
        return _NAMES.sub(lambda match: f"{self.library}{match[1]}", line).replace(
            "SCAMP5_PE", f"{self.library.upper()}_PE"
        )


DEVKITS = (
    Devkit("SCAMP-5d", "scamp5", 13, tables=True),
    Devkit("SCAMP-7", "scamp7", 23, tables=False),
)


def devkit_of(target: Target) -> Devkit:
    """Return the first devkit whose library has all registers of the target, else the last devkit,
    for which `devkit_fault` then names the missing registers."""
    registers = {*target.analog_registers, *target.digital_registers}
    return next((devkit for devkit in DEVKITS if registers <= devkit.registers), DEVKITS[-1])


def devkit_fault(container: Container, devkit: Devkit) -> str | None:
    """Return why the devkit cannot run the container (a compiled program), as the end of "the
    target ..."; None if it can. Of several reasons the first is named.

    It checks what the host must do, registers, words, the size of the array and the range of IN
    (the level sent to all pixels)."""
    target = container.target
    fault = loader_fault(container)
    if fault is not None:
        return f"cannot do what the program needs: {fault}"
    names = (*target.analog_registers, *target.digital_registers)
    extra = [name for name in names if name not in devkit.registers]
    if extra:
        shown = ", ".join(extra) if len(extra) < 4 else f"{extra[0]} to {extra[-1]}"
        return f"has registers that no devkit has: {shown}"
    # The devkit's words for R12 always obey R0, so a target without this rule cannot use them.
    if "R12" in target.digital_registers and (
        (target.mask_register, target.masked_register) != ("R0", "R12")
    ):
        return (
            f"writes R12 in all pixels, but the {devkit.name} devkit writes it only where R0 is 1"
        )
    if target.words:
        shown = ", ".join(row.name for row in target.words[:4])
        return f"has words that the {devkit.name} devkit does not have: {shown}"
    if target.rows > _SIDE or target.cols > _SIDE:
        return (
            f"has {target.rows} x {target.cols} pixels, but the {devkit.name} devkit has "
            f"{_SIDE} x {_SIDE}"
        )
    levels = [launch.level for launch in container.launches if launch.level is not None]
    if levels and not _IN_LOW <= min(levels) <= max(levels) <= _IN_HIGH:
        return (
            f"sets IN to {min(levels)} to {max(levels)} steps, but the {devkit.name} devkit "
            f"allows {_IN_LOW} to {_IN_HIGH}"
        )
    return None
