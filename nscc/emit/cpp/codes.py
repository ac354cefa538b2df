"""C++ that loads the pixel codes: from address patterns for bit planes that repeat, else from
images.

The chip sets all pixels of an address pattern at once. The devkit counts rows from the top and
columns from the right: pixel (row y, column x) has the address (y, cols - 1 - x). A pattern fixes
some address bits and ignores the others.

Digital registers lose their content after some time, and drawing an image takes 0.1 to 0.3 s.
Therefore all code registers are refreshed after each plane is loaded, while waiting for an image,
and every few rows of a drawing. The masked register is loaded first, while its mask is 1, and the
mask's own plane last."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import ceil

import numpy as np

from nscc.arrays import Bools
from nscc.chips.target import Target
from nscc.emit.cpp.cpp_text import Call, comment, literal, section, template_lines
from nscc.emit.cpp.kernels import calls_words
from nscc.logic.cubes import Budget, Cube, cover
from nscc.lower.exposure_plan import RETENTION_SHARE
from nscc.truth import number_planes, packed_bits

ADDRESS_BITS = 8
"""Number of address bits of a row, and of a column."""

MOST_BITS = 12
"""Most address bits of a plane that is loaded by patterns: a tile of 64 x 64 pixels.

Such a plane needs up to about 700 patterns. With more bits, drawing an image pixel by pixel is as
fast."""

_MOST_STEPS = 1 << 62
"""Steps of a search for patterns, more than any plane of `MOST_BITS` needs."""
_SIDE = 1 << ADDRESS_BITS
"""Rows and columns that the address bits can select."""
_OPEN = _SIDE - 1
"""The mask that ignores all address bits."""


@dataclass(frozen=True, slots=True, order=True)
class Match:
    """An address pattern: all pixels whose address equals (row, col) in the bits that the masks do
    not ignore. A 1 in `row_mask` or `col_mask` ignores that bit. Addresses have ADDRESS_BITS bits;
    columns count from the right."""

    row: int
    col: int
    row_mask: int
    col_mask: int


@dataclass(frozen=True, slots=True)
class Patterns:
    """A bit plane as the union of address patterns, or the complement of this union if `inverted`.
    `matches` are sorted; without matches the plane is 0, or 1 if `inverted`."""

    matches: tuple[Match, ...]
    inverted: bool


def patterns_of(plane: Bools) -> Patterns | None:
    """Return a bit plane, bool (rows, cols), as address patterns; None if it depends on more than
    `MOST_BITS` address bits.

    The chip sets all pixels of a pattern at once. Addresses outside the array may get any value.
    The array must have at most 2^ADDRESS_BITS rows and columns. A plane of zeros has no
    patterns."""
    rows, cols = plane.shape
    # Pixels that must be 1, and that must be 0, by address. Columns are reversed: the devkit counts
    # them from the right.
    on, off = (np.zeros((_SIDE, _SIDE), dtype=np.bool_) for _ in range(2))
    on[:rows, :cols] = plane[:, ::-1]
    off[:rows, :cols] = ~plane[:, ::-1]
    ones, zeros, bits = _support(on, off)
    if len(bits) > MOST_BITS:
        return None
    variables = number_planes(np.arange(1 << len(bits)), len(bits))
    plain, complement = (
        cover(wanted, variables, ones | zeros, Budget(_MOST_STEPS)) for wanted in (ones, zeros)
    )
    inverted = len(complement) + 1 < len(plain)  # inverting is a kernel of its own
    cubes = complement if inverted else plain
    return Patterns(tuple(sorted(_match(cube, bits) for cube in cubes)), inverted)


_Bit = tuple[bool, int]
"""An address bit: whether it is a column bit, and its value."""


def _support(on: Bools, off: Bools) -> tuple[int, int, list[_Bit]]:
    """Return two truth tables over the address bits on which a plane depends, and these bits,
    lowest first.

    `on` and `off`, bool (256, 256) by address, mark the pixels that must be 1 and 0; no pixel is
    both. A bit on which neither depends is left out. A table is an integer: bit i is the value at
    address i."""
    cube = (2,) * (2 * ADDRESS_BITS)
    on, off = on.reshape(cube), off.reshape(cube)
    bits: list[_Bit] = []
    for index in range(2 * ADDRESS_BITS):
        on_0, on_1 = np.take(on, [0], index), np.take(on, [1], index)
        off_0, off_1 = np.take(off, [0], index), np.take(off, [1], index)
        if (on_0 & off_1).any() or (on_1 & off_0).any():
            bits.append((index >= ADDRESS_BITS, 1 << (ADDRESS_BITS - 1 - index % ADDRESS_BITS)))
        else:
            # Nothing depends on this address bit: both halves become one.
            on, off = on_0 | on_1, off_0 | off_1
    return packed_bits(on), packed_bits(off), bits[::-1]


def _match(cube: Cube, bits: list[_Bit]) -> Match:
    """Return the address pattern of a cube, which is one pattern for rows and columns together.

    The literal (i, value) of a cube says the value of `bits[i]`. Bits that the cube does not name
    are ignored."""
    value, mask = [0, 0], [_OPEN, _OPEN]
    for number, is_one in cube:
        column, bit = bits[number]
        mask[column] &= ~bit
        value[column] |= bit if is_one else 0
    return Match(value[0], value[1], mask[0], mask[1])


_HEADER = 14 + 40
"""Bytes before the pixels of a BMP file: the file header and the image header."""


def bitmap(plane: Bools) -> bytes:
    """Return a 24-bit Windows bitmap that is white where a bit plane, bool (rows, cols), is 1 and
    black elsewhere.

    The width is rounded up to a multiple of 8 with black pixels, because the devkit packs eight
    pixels of a row into a byte."""
    rows, cols = plane.shape
    width = image_width(cols)
    pixels = np.zeros((rows, width, 3), dtype=np.uint8)
    pixels[:, :cols][plane] = 255
    data = pixels[::-1].tobytes()  # bottom row first; a multiple of 8 needs no padding
    # The length of this header, one colour plane with 24 bits a pixel, and 72 dots per inch (2835 a
    # metre).
    sizes = (40, width, rows, 1 | 24 << 16, 0, len(data), 2835, 2835, 0, 0)
    info = b"".join(size.to_bytes(4, "little") for size in sizes)
    # The length of the file, a reserved 0, and where the pixels begin.
    start = (_HEADER + len(data), 0, _HEADER)
    return b"BM" + b"".join(size.to_bytes(4, "little") for size in start) + info + data


def image_width(cols: int) -> int:
    """Return the width in pixels of the bitmap of a bit plane with `cols` columns."""
    return -(-cols // 8) * 8


_REFRESHES_IN_A_LIFE = 4
"""How often a digital register is refreshed within the time for which it is trusted to keep its
bit."""


@dataclass(frozen=True)
class PlaneLoad:
    """How the plane of one code register is loaded.

    Without `patterns`, it is loaded from the image `file`. `masked` tells whether it is the chip's
    masked register. `scratch` is a register that holds each pattern before it is added; without it,
    several patterns are drawn pixel by pixel. `input_plane` is the name of the input plane that the
    host may load again, "" for other planes."""

    register: str
    masked: bool
    patterns: Patterns | None
    scratch: str | None
    file: str
    input_plane: str = ""

    @property
    def gathered(self) -> bool:
        """Whether the plane is the union of several patterns, which are added one by one."""
        return self.patterns is not None and len(self.patterns.matches) > 1

    @property
    def drawn(self) -> bool:
        """Whether the patterns are drawn pixel by pixel."""
        return self.gathered and self.scratch is None

    @property
    def cleared(self) -> tuple[str, ...]:
        """The registers that are cleared before the load."""
        return (self.register, self.scratch) if self.gathered and self.scratch else (self.register,)


@dataclass(frozen=True)
class CodeLoading:
    """How the bit planes of all code registers of a target are loaded, in this order. There are no
    loads if pixels have no code."""

    target: Target
    loads: tuple[PlaneLoad, ...]

    @property
    def images(self) -> tuple[PlaneLoad, ...]:
        """The loads that need images."""
        return tuple(load for load in self.loads if load.patterns is None)

    @property
    def inputs(self) -> tuple[PlaneLoad, ...]:
        """The loads of input planes that the host may load again."""
        return tuple(load for load in self.loads if load.input_plane)

    @property
    def words(self) -> int:
        """The number of stored words of the kernels (lists of words) that load and refresh code
        registers; 0 if there is no code."""
        kernels = [self.refresh_calls()] if self.loads else []
        for load in self.loads:
            kernels += self.kernels_of(load)
        return sum(map(calls_words, kernels))

    def refresh_calls(self) -> list[Call]:
        """Return the library calls that write every code register again, before it loses its bits;
        none if there is no code.

        The masked register changes only in pixels whose mask, another register, is 1. So the mask
        is set to 1 in all pixels before the masked register is refreshed. If the mask holds bits of
        the code, FLAG (the bit that lets a pixel act) keeps them meanwhile."""
        registers = [load.register for load in self.loads]
        masked, mask = self.target.masked_register, self.target.mask_register
        out: list[Call] = []
        if masked in registers and mask is not None:
            if mask in registers:
                # The mask's code is saved in FLAG, and writing it back refreshes it.
                out += [("WHERE", (mask,)), ("SET", (mask,)), ("REFRESH", (masked,))]
                out.append(("MOV", (mask, "FLAG")))
                registers.remove(mask)
            else:
                out += [("SET", (mask,)), ("REFRESH", (masked,))]
            registers.remove(masked)
        return out + [("REFRESH", (register,)) for register in registers]

    def clear_calls(self, load: PlaneLoad) -> list[Call]:
        """Return the library calls that clear the registers of a load, its own and scratch, before
        it; the mask of a masked register is set first, because it is written only where the mask is
        1."""
        mask = self.target.mask_register
        mask_call = [("SET", (mask,))] if load.masked and mask is not None else []
        return [*mask_call, ("CLR", load.cleared)]

    def add_calls(self, load: PlaneLoad) -> list[Call]:
        """Return the library calls that add the pattern in a load's scratch register to its own
        register, and clear the scratch register for the next. The load must have a scratch register
        (for intermediate results)."""
        assert load.scratch is not None
        return [("OR", (load.register, load.scratch)), ("CLR", (load.scratch,))]

    def kernels_of(self, load: PlaneLoad) -> list[list[Call]]:
        """Return the library calls of each kernel (list of words) that loads one register.

        They clear it, add the address patterns, and invert it if the patterns describe the zeros.
        """
        kernels = [self.clear_calls(load)]
        if load.gathered and load.scratch:
            kernels.append(self.add_calls(load))
        if load.patterns is not None and load.patterns.inverted and not load.drawn:
            kernels.append([("NOT", (load.register,))])
        return kernels


def loading_of(
    planes: Mapping[str, Bools], target: Target, stem: str, inputs: Mapping[str, str]
) -> CodeLoading:
    """Choose how to load bit planes, bool (rows, cols), which are given by register in loading
    order.

    The file names of images start with `stem`. `inputs` has the names of the input planes that the
    host may load, by register; these are always loaded from images. The scratch register (for
    intermediate results) of a plane is an unused register, or one that is loaded later; None if
    there is neither."""
    order = list(planes)
    mask, masked = target.mask_register, target.masked_register
    free = [r for r in target.digital_registers if r not in planes and r != masked]
    loads = []
    for index, (register, plane) in enumerate(planes.items()):
        later = [r for r in order[index + 1 :] if r != masked]
        # A register that is loaded later is free until then, but the mask must be 1 for the masked
        # register.
        usable = [r for r in (*free, *later) if not (r == mask and register == masked)]
        name = inputs.get(register, "")
        loads.append(
            PlaneLoad(
                register,
                register == masked,
                None if name else patterns_of(plane),
                usable[0] if usable else None,
                f"{stem}.input_{name}.bmp" if name else f"{stem}.{register}.bmp",
                name,
            )
        )
    return CodeLoading(target, tuple(loads))


def loading_lines(loading: CodeLoading) -> Iterator[str]:
    """Yield the C++ tables and functions that load the codes; the last function is `load_codes`.

    `loading` must have at least one load."""
    rows, cols = loading.target.rows, loading.target.cols
    yield from template_lines("fading")
    # A WHERE comes first only if both the masked register and its mask hold code.
    if loading.refresh_calls()[0][0] == "WHERE":
        yield from comment(
            f"{loading.target.masked_register} takes a write only where "
            f"{loading.target.mask_register} is 1, whose own code waits in FLAG meanwhile."
        )
    yield "void refresh_codes() {"
    yield from section(loading.refresh_calls())
    yield "}"
    if loading.images or any(load.drawn for load in loading.loads):
        yield ""
        yield f"const int rows = {rows}, cols = {cols};"
    if any(load.gathered for load in loading.loads):
        yield from ["", *template_lines("match")]
    if any(load.drawn for load in loading.loads):
        yield from ["", *template_lines("among")]
    if loading.images:
        yield from ["", *template_lines("images", width=image_width(cols))]
    for load in loading.loads:
        yield ""
        yield from _load_lines(loading, load)
    yield ""
    yield "void load_codes() {"
    for load in loading.loads:
        yield f"    load_{load.register.lower()}();"
        yield "    refresh_codes();"
    yield "}"


def _load_lines(loading: CodeLoading, load: PlaneLoad) -> Iterator[str]:
    """Yield the C++ function that loads one register, with its table of patterns if it needs one.

    The register is loaded from an image, from patterns drawn at once, from patterns gathered in a
    scratch register, or by one call if there is a single pattern. A plane of zeros is only cleared.
    A scratch register holds an intermediate result."""
    register, patterns = load.register, load.patterns
    name = register.lower()
    if load.gathered:
        assert patterns is not None
        yield f"const Match code_{name}[] = {{"
        for start in range(0, len(patterns.matches), 4):
            row_matches = patterns.matches[start : start + 4]
            yield "    " + " ".join(f"{{{_operands(match)}}}," for match in row_matches)
        yield "};"
        yield ""
    yield f"void load_{name}() {{"
    yield from section(loading.clear_calls(load))
    if patterns is None:
        yield f"    load_image({literal(load.file)}, {register});"
    elif load.drawn:
        # Drawn at once, because no register is free to gather the patterns.
        yield from template_lines(
            "drawn", register=register, codes=f"code_{name}", inverted="!" * patterns.inverted
        )
    elif load.gathered:
        add = "\n".join(section(loading.add_calls(load), " " * 8))
        yield from template_lines("gathered", scratch=load.scratch, codes=f"code_{name}", add=add)
    else:
        for match in patterns.matches:
            yield f"    scamp5_load_pattern({register}, {_operands(match)});"
    if patterns is not None and patterns.inverted and not load.drawn:
        yield from section([("NOT", (register,))])
    yield "}"


def _operands(match: Match) -> str:
    """Return the four numbers that tell the devkit which pixels to select: row, column, and the
    masks of both."""
    return f"{match.row}, {match.col}, {match.row_mask}, {match.col_mask}"


def loading_rate(target: Target) -> int:
    """Return the rate in Hz of the loop that waits for images, at least 1.

    It refreshes registers _REFRESHES_IN_A_LIFE times within the retention time."""
    life_us = RETENTION_SHARE * target.digital_retention_us
    return max(1, ceil(_REFRESHES_IN_A_LIFE * 1e6 / life_us))
