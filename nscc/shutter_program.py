"""The Python interface to programs: compile text or files, or load compiled words.

    import nscc

    p = nscc.compile("examples/hdr_2x2.nsl", level=2)   # or the text itself
    p.codes["stop"]                                     # int64 (codes,)
    p.shutters()                                        # bool (buckets, codes, slots)
    p.save("hdr_2x2.icw")
    p = nscc.load("hdr_2x2.icw")

Options and their defaults are those of `nscc build`."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nscc.arrays import Bools, Ints, Ints32
from nscc.chips.target import Target
from nscc.compiler import compile_source
from nscc.container_proof import replayed
from nscc.containers import program_text, with_pixels
from nscc.diagnostics.arguments import (
    path_of,
    warn,
    wrong_argument,
)
from nscc.diagnostics.diagnostic import Diagnostic, rejected
from nscc.files import write_together
from nscc.lower.exposure_plan import LoweringOption
from nscc.mappings import JsonObject
from nscc.options import Options
from nscc.pipeline import KINDS, Compiled, with_all_lowerings
from nscc.program.problems import counted
from nscc.program.program import Codes
from nscc.source import Source
from nscc.toml.arguments import argument, checked
from nscc.toml.kinds import Flag
from nscc.words.container import Container
from nscc.words.file import read_container, to_bytes


@dataclass(frozen=True, eq=False, repr=False)
class ShutterProgram:
    """A compiled program: words that were proved, or that were loaded from a file.

    Parameters
    ----------
    name : str
        The name in messages.
    container : Container
        The words with their launches, planes and decode table, as the runtime executes them.
    compiled : Compiled, optional
        All results of the compiler; None for a loaded program.
    options : Options, optional
        The options of the compilation; None for a loaded program.
    """

    name: str
    container: Container
    compiled: Compiled | None = None
    options: Options | None = None

    @property
    def target(self) -> Target:
        """The chip of the program; `dataclasses.replace(target, rows=64, cols=64)` gives another
        chip."""
        return self.container.target

    @property
    def slots(self) -> int:
        """N, the number of time slots in a frame."""
        return self.container.slots

    @property
    def slot_us(self) -> tuple[float, ...]:
        """The length of each slot in microseconds."""
        return self.container.slot_us

    @property
    def buckets(self) -> tuple[str, ...]:
        """The names of the buckets; most programs have one."""
        return self.container.buckets

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, cols) of the array."""
        return self.target.rows, self.target.cols

    @property
    def messages(self) -> tuple[Diagnostic, ...]:
        """The compiler's warnings and notes."""
        return () if self.compiled is None else self.compiled.diagnostics

    @cached_property
    def codes(self) -> dict[str, Ints]:
        """The value of each field of the code, int64 (codes,), by the field's name.

        Code k opens the shutter `shutters()[:, k]`. A program without fields has one code."""
        table = self.container.table
        return {name: table.codes[:, i].copy() for i, name in enumerate(table.fields)}

    @property
    def code_at_pixels(self) -> Ints32:
        """The index of each pixel's code, int32 (rows, cols): `codes[field][code_at_pixels]` is a
        map.

        Raises
        ------
        Rejected
            NS0741 if the program has no pixel data; `with_pixels` adds it.
        """
        codes = self._with_data.container.pixel_codes
        assert codes is not None  # programs without a schedule are rejected
        return codes

    def shutters(self, *, pixels: bool = False) -> Bools:
        """Replay the words and return when each shutter is open.

        Parameters
        ----------
        pixels : bool
            Return the shutter of every pixel instead of every code.

        Returns
        -------
        array of bool
            Shape (buckets, codes, slots); with `pixels` (buckets, slots, rows, cols), the mask of
            snapshot compressive imaging.

        Raises
        ------
        Rejected
            NS0741 for `pixels` without pixel data, NS0442 if the words open no shutters, NS0444 if
            the pixels look at their light.
        """
        table = self.container.table
        at_code = self._replayed[table.shutter_of_code].transpose(1, 0, 2)  # bucket, code, slot
        if not argument("shutters", "pixels", Flag(), pixels):
            return at_code.copy()
        at_pixel = table.shutter_of_code[self.code_at_pixels]
        by_slot = self._replayed.transpose(1, 2, 0)  # bucket, slot, shutter
        return np.ascontiguousarray(by_slot[:, :, at_pixel])

    @property
    def words(self) -> NDArray[np.uint32]:
        """The stored instruction words, kernel after kernel: uint32 (words, 5), five integers for
        each word; (0, 5) for a chip without logic."""
        stored = [word for kernel in self.container.kernels for word in kernel.words]
        return np.array(stored, np.uint32).reshape(len(stored), 5)

    @property
    def words_per_frame(self) -> int:
        """The number of words that a frame executes."""
        return self.container.words_per_frame

    @cached_property
    def report(self) -> JsonObject:
        """The report of `nscc build --emit report`: the program, its cost and its proof.

        Raises
        ------
        Rejected
            NS0743 for a loaded program, which has no report.
        """
        compiled, options = self._as_compiled("report")
        return KINDS.of(compiled.program).report(with_all_lowerings(compiled, options))

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the program to a file, completely or not at all.

        Parameters
        ----------
        path : str or PathLike
            The ending selects the format: `.icw` for words, which `nscc.load` reads; `.asm`,
            `.cpp`, `.dot`, `.graphml`, `.report.json` and the other formats of `nscc build --emit`
            for compiled programs.

        Returns
        -------
        Path
            The file that was written.

        Raises
        ------
        Rejected
            NS0505 for other endings, NS0743 if a loaded program cannot give this format, NS0784 if
            the file cannot be written.
        """
        from nscc.emit.products import SUFFIXES

        out = path_of("save", path)
        kind = next((kind for kind, end in SUFFIXES.items() if out.name.endswith(end)), None)
        if kind is None:
            raise rejected(
                "NS0505",
                f"a program cannot be saved as '{out.name}'",
                notes=(f"names may end in {', '.join(SUFFIXES.values())}",),
                helps=(f"p.save('{out.stem or 'program'}.icw') writes its words",),
            )
        write_together(self._product(kind, out, SUFFIXES[kind]))
        return out

    def with_pixels(
        self, codes: str | os.PathLike[str] | None = None, /, **fields: NDArray[np.integer[Any]]
    ) -> ShutterProgram:
        """Return the same words with other pixel codes.

        Parameters
        ----------
        codes : str or PathLike, optional
            An `.npz` file with an integer array (rows, cols) for each field.
        **fields : array of int
            The same arrays by field name: `p.with_pixels(stop=array)`.

        Returns
        -------
        ShutterProgram

        Raises
        ------
        Rejected
            NS0314 for arrays that do not fit, NS0319 for codes that the program was not compiled
            for. Compile with `codes="open"` to allow all legal codes.
        """
        if codes is not None and fields:
            raise wrong_argument("with_pixels takes either a file or fields")
        pixel_source = fields if codes is None else path_of("with_pixels", codes)
        return replace(self, container=with_pixels(self.container, self.name, pixel_source))

    def __repr__(self) -> str:
        """Return name, class, number of codes and slots, size and target as one line."""
        name = self.container.notes.get("class", "")
        kind = f"class {name}, " if len(name) == 1 else f"{name}, " if name else ""
        size = KINDS.of(self.container).size_text(self.container)
        return (
            f"<nscc program {self.name!r}: {kind}{counted(len(self.container.table.codes), 'code')}"
            f", {counted(self.slots, 'slot')}, {size} a frame, for {self.target.name}>"
        )

    def _repr_html_(self) -> str:
        """Return the card that a notebook shows."""
        from nscc.emit.notebook import program_card

        return program_card(self.name, self.container, self.compiled)

    @cached_property
    def _replayed(self) -> Bools:
        """The shutters that the words open, bool (shutters, buckets, slots), in the order of the
        decode table."""
        return replayed(self.container, f"'{self.name}'")

    @cached_property
    def _with_data(self) -> ShutterProgram:
        """The same program with pixel codes; raises Rejected (NS0741) if it has none."""
        return replace(self, container=with_pixels(self.container, self.name))

    def _as_compiled(self, product: str) -> tuple[Compiled, Options]:
        """Return the compiler's result and options, which are needed for `product` (a word for the
        message).

        Raises Rejected (NS0743) for a program that was loaded from compiled words."""
        if self.compiled is None or self.options is None:
            raise rejected(
                "NS0743",
                f"'{self.name}' contains words but no {product}, because it is compiled already",
                helps=("use nscc.compile: its result contains the compiler's data",),
            )
        return self.compiled, self.options

    def _product(self, kind: str, out: Path, ending: str) -> dict[Path, bytes]:
        """Return the content of the file `out`, and of further files that belong to it, by path.
        Raises Rejected (NS0743) if a loaded program lacks what is needed.

        `kind` is a key of `nscc.emit.products.SUFFIXES`, and `ending` the ending of `out`."""
        if kind == "icw":
            return {out: to_bytes(self.container)}
        if kind == "asm":
            from nscc.words.disassembly import disassemble

            return {out: disassemble(self.container).encode()}
        if kind == "report":
            from nscc.emit.report import report_bytes

            return {out: report_bytes(self.report)}
        from nscc.emit.products import emitted

        compiled, _ = self._as_compiled(f"what goes into '{out.name}'")
        files = emitted(kind, replace(compiled, container=self.container), out.name[: -len(ending)])
        return {out.with_name(name): data for name, data in files.items()}


def compile(
    source: str | os.PathLike[str],
    *,
    target: Target | str | os.PathLike[str] | None = Options.target,
    level: int = Options.level,
    codes: Codes = Options.codes,
    lowering: LoweringOption = Options.lowering,
    max_words_per_slot: int | None = Options.max_words_per_slot,
    cache: bool = Options.cache,
    folder: str | os.PathLike[str] | None = None,
) -> ShutterProgram:
    """Compile a program and prove its words.

    Parameters
    ----------
    source : str or PathLike
        A path, or the text of a program. A string is a path if it is one line that ends in `.nsl`.
    target : Target, str or PathLike, optional
        A chip by name, by its TOML file, or as a `Target`; by default the one that the program
        names.
    level : {0, 1, 2, 3}
        Optimization level: how long to search for few words.
    codes : {"fixed", "open"}
        Compile for the codes that the pixels use, or for all legal codes.
    lowering : {"auto", "accumulate", "latch", "edges"}
        How the exposure is computed from photodiode values.
    max_words_per_slot : int, optional
        Limit on the words between two slots.
    cache : bool
        Keep and reuse search results.
    folder : str or PathLike, optional
        The folder that paths in a program text are relative to; by default the current folder.

    Returns
    -------
    ShutterProgram

    Raises
    ------
    Rejected
        With all errors and their places. Warnings are Python warnings.
    """
    options = Options(**checked("nscc.compile", Options, locals()))
    return compiled(*program_text(source, folder), options)


def compiled(text: Source, folder: Path, options: Options) -> ShutterProgram:
    """Return the compiled program of a text; `folder` is that of the files that it names.

    Raises Rejected with all errors. Warnings become Python warnings, which name the line that
    called the caller of this function."""
    compiled = compile_source(text, folder, options)
    warn(compiled.diagnostics, stacklevel=4)  # the line that called `compile`
    return ShutterProgram(text.name, compiled.built, compiled, options)


def load(path: str | os.PathLike[str]) -> ShutterProgram:
    """Read a compiled program.

    Parameters
    ----------
    path : str or PathLike
        An `.icw` file.

    Returns
    -------
    ShutterProgram

    Raises
    ------
    Rejected
        If the file is not a valid container.
    """
    file = path_of("nscc.load", path)
    if file.suffix.lower() == ".nsl":
        raise wrong_argument(
            f"nscc.load reads compiled programs (.icw), but '{file}' is the text of a program",
            helps=(f"nscc.compile('{file}') compiles it",),
        )
    return ShutterProgram(file.as_posix(), read_container(file))
