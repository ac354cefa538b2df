"""Learned shutters as `.nsl` programs, and their compilation."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nscc.arrays import Bools, Ints
from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.compiler import compile_file, compile_source
from nscc.diagnostics.arguments import require_type
from nscc.diagnostics.diagnostic import Rejected, Severity
from nscc.options import Options
from nscc.pipeline import Compiled
from nscc.program.analyse import analyse
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.toml.arguments import argument
from nscc.toml.kinds import ANY_NUMBER
from nscc.words.legality import refuse_pictures
from nscc_runtime.run_kinds import KINDS
from nscc_training.code_choices import ShutterSpec, over_array
from nscc_training.codes_files import Codes, codes_bytes
from nscc_training.design.looking import LookSchedule
from nscc_training.design.text import frame_text, looking_text

if TYPE_CHECKING:
    from nscc_training.encoders import Encoder

CODES_FILE = "codes.npz"
"""The file of codes beside a program."""
TARGET_FILE = "target.toml"
SENSOR_FILE = "sensor.toml"
"""Files of the user's chip and sensor, beside the program."""
CAPTURE_FILE = "capture.toml"
"""The conditions that a run was trained for."""
MOST_LISTED = 4096
"""Largest tile that is written into the program's text; larger tiles are stored in a file."""
_MOST_DIGITS = 1 << 15
"""Most codebook digits in the program's text; more are stored in a file."""


@dataclass(frozen=True)
class Chip:
    """The chip for which shutters are learned.

    Parameters
    ----------
    target : str
        Name or file of the target.
    slot_us : float
        Length of a slot in microseconds.
    require : str, optional
        A condition on legal codes.
    table : Target, optional
        Contents of the target file; later changes of the file have no influence.
    """

    target: str = "scamp5"
    slot_us: float = 125.0
    require: str | None = None
    table: Target | None = None

    def __post_init__(self) -> None:
        """Raise WrongArgument for invalid values."""
        require_type("Chip", "target", self.target, str, "str(path)")
        argument("Chip", "slot_us", ANY_NUMBER, self.slot_us)

    @property
    def file(self) -> str | None:
        """The target file for the compiler's options; None if the target is a name."""
        return self.target if self.target.endswith(".toml") else None


class ProgramFiles(NamedTuple):
    """A program's `text`, and `codes`, the bytes of its code file (.npz) with an array for each
    field, and the `book` of a codebook; empty for class a."""

    text: str
    codes: bytes


def program_of(encoder: Encoder, chip: Chip, remark: str = "") -> ProgramFiles:
    """Return the program of an encoder's current shutters.

    Parameters
    ----------
    encoder : Encoder
    chip : Chip
    remark : str
        Comment at the start of the program.

    Returns
    -------
    ProgramFiles
        Text of the program, and the codes that it reads. It is not compiled.
    """
    from nscc_training.encoders import Encoder

    require_type("program_of", "encoder", encoder, Encoder, "nscc_training.make_encoder")
    require_type("program_of", "chip", chip, Chip, "nscc_training.Chip()")
    codes = encoder.codes()
    if encoder.spec.kind == "looks":
        target = chip.table or load_target(chip.target, Path())
        schedule = LookSchedule(*(tuple(codes[name][0].tolist()) for name in ("at", "level")))
        named = chip.target if chip.file is None else None
        slots, slot_us = encoder.spec.slots, chip.slot_us
        text = looking_text(schedule, slots, slot_us, target, named, remark)
        return ProgramFiles(text, codes_bytes(codes))
    return program(encoder.spec, codes, chip, remark)


def program(spec: ShutterSpec, codes: Codes, chip: Chip, remark: str = "") -> ProgramFiles:
    """Return the program of codes of the class in `spec` for `chip`, with `remark` as a comment at
    the top. It is not compiled.

    `codes` are int64 (rows, cols) of the tile by field, with `book` for a codebook. A tile of more
    than `MOST_LISTED` pixels is not written into the text: it must cover the array, and the text
    names the code file. Empty `codes` give a program without pixels."""
    packed = codes_bytes(codes) if codes else b""
    lines = [*(f"# {line}" for line in remark.splitlines()), "nsl 1", ""]
    # A file's path is relative to the current folder, not to the program, so it is an option
    # of the compiler instead of a part of the text.
    if chip.file is None:
        lines.append(f"target {chip.target}")
    lines += [frame_text(spec.slots, chip.slot_us), ""]
    if spec.kind == "c":
        lines.append(f"let len = {spec.length}")
    elif spec.kind == "codebook":
        lines += _book(codes["book"], packed)
    lines += _rules(spec)
    if chip.require is not None:
        lines.append(f"require {chip.require}")
    fields = [name for name in codes if name != "book"]
    if fields:
        lines += ["", *_pixels(spec, codes, fields, packed)]
    return ProgramFiles("\n".join(lines) + "\n", packed)


def compiled(
    files: ProgramFiles, chip: Chip, *, level: int = 1, every_code: bool = False
) -> Compiled:
    """Compile and prove the program `files`, text and codes, for `chip`. Raise Rejected with the
    compiler's errors.

    `level` is the optimisation level. With `every_code` the program must work for all codes that
    its class allows, not only for those of its pixels."""
    with tempfile.TemporaryDirectory() as folder:
        if files.codes:
            (Path(folder) / CODES_FILE).write_bytes(files.codes)
        target = chip.table or chip.file
        options = Options(level=level, codes="open" if every_code else "fixed", target=target)
        return compile_source(Source("shutter.nsl", files.text), Path(folder), options)


def begun_with(path: Path, spec: ShutterSpec, chip: Chip) -> tuple[dict[str, Ints], Bools | None]:
    """Return the codes of the program at `path` on the pixels of a tile, and the shutters that it
    opens for them, bool (buckets, N, rows, cols).

    For pixels that look, return the boundaries and levels of their looks, and None. `spec` is what
    the run expects. Raises ValueError for a program with other slots, fields, looks or buckets, or
    whose pixels are not a repetition of this tile, and Rejected with the compiler's errors."""
    target = chip.table or load_target(chip.target, Path())
    compiled_program = compile_file(path, Options(level=0, target=target))
    container = compiled_program.built
    refuse_pictures(
        container,
        "a run cannot begin with a program that has images or planes",
        "training changes the codes of pixels, and decoders read exposures",
        "begin with a program that has the same shutters, without images and planes",
    )
    if container.slots != spec.slots:
        raise ValueError(f"the program has {container.slots} slots, but the run has {spec.slots}")
    # Pixels that look have boundaries and levels in place of shutters.
    if spec.kind == "looks":
        comparisons = container.machine.comparisons
        if len(comparisons) != spec.tile[1]:
            raise ValueError(
                f"it looks {len(comparisons)} times, but the run looks {spec.tile[1]} times"
            )
        moments = np.array([[comparison.boundary for comparison in comparisons]])
        levels = np.array([[comparison.level for comparison in comparisons]])
        return {"at": moments, "level": levels}, None
    if not KINDS.of(container).open_times_known:
        raise ValueError(f"its pixels look at the light, but those of class {spec.kind} do not")
    if container.pixel_codes is None:
        raise ValueError("the program has no pixel codes: add a `pixels` statement")
    table = container.table
    expected_fields = [r.split()[1] for r in _RULES[spec.kind] if r.startswith("code ")]
    if set(table.fields) != set(expected_fields):
        have, want = (", ".join(names) or "none" for names in (table.fields, expected_fields))
        raise ValueError(f"its code has the fields: {have}; class {spec.kind} has: {want}")
    if len(container.buckets) > spec.buckets:
        raise ValueError(f"the program has {len(container.buckets)} buckets, but the run has one")
    rows, cols = container.pixel_codes.shape
    tile_codes = container.pixel_codes[: spec.tile[0], : spec.tile[1]]
    # A run learns the codes of one tile, so the array must repeat that tile.
    if not np.array_equal(over_array(tile_codes, rows, cols), container.pixel_codes):
        raise ValueError(
            f"its pixels are not a repeated tile of {spec.tile[0]} x {spec.tile[1]}: give the run "
            "the program's own tile"
        )
    codes = {name: table.codes[tile_codes][..., k] for k, name in enumerate(table.fields)}
    if spec.kind == "codebook":
        codes["book"] = _book_of(compiled_program, path, target)
    return codes, table.shutters[table.shutter_of_code[tile_codes]].transpose(2, 3, 0, 1)


def _book_of(compiled_program: Compiled, path: Path, target: Target) -> Ints:
    """Return the codebook (K, N) of a compiled program, 1 where a slot is open, with the rows that
    no pixel uses. `path` is the program's file, for the files that it names, and `target` its chip.
    """
    source = compiled_program.program.source
    table = analyse(
        source, compiled_program.tree, base=path.parent, codes="open", target=target
    ).table
    return np.asarray(table.shutters[table.shutter_of_code, 0], np.int64)


def words_per_slot(compiled_program: Compiled) -> float:
    """Return the number of instruction words of a frame divided by its slots; 0 for a chip without
    words. The program must have a container: it compiled. A container is a compiled program."""
    container = compiled_program.built
    return container.words_per_frame / container.slots


def legal_codes(spec: ShutterSpec, chip: Chip) -> Ints:
    """Return all codes, int64 (codes, fields), that the class in `spec` and the `require` of `chip`
    allow; there may be none. Raise Rejected if `require` is no valid condition, or the chip cannot
    be loaded."""
    source = Source("shutter.nsl", program(spec, {}, chip).text)
    tree, problems = parse(source)
    if any(problem.severity is Severity.ERROR for problem in problems):
        raise Rejected(problems)
    target = chip.table or load_target(chip.target, Path())
    return analyse(source, tree, base=Path(), codes="open", target=target).table.codes


_RULES = {
    "a": ["open when true"],
    "b": ["code stop : 1..N", "open when n < stop"],
    "c": ["code start : 0..N - len", "open when start <= n < start + len"],
    "d": [
        "code start : 0..N - 1",
        "code stop : 1..N",
        "require start < stop",
        "open when start <= n < stop",
    ],
    "e": ["code bits : bit[N]", "open when bits[n]"],
    "codebook": ["code id : row of book", "open when book[id]"],
}
"""Statements that declare the code's fields and the rule that opens a pixel, by class."""


def _rules(spec: ShutterSpec) -> list[str]:
    """Return the statements of a program that declare the code's fields, and when its one or two
    buckets open, one statement a line. The rule is that of the class in `spec`."""
    *fields, opened = _RULES[spec.kind]
    if spec.buckets == 1:
        return [*fields, opened]
    rule = opened.removeprefix("open when ")
    operand = f"({rule})" if "<" in rule else rule
    return [
        *fields,
        f"bucket first open when {rule}",
        f"bucket second open when not {operand}",
    ]


def _book(book: Ints, packed: bytes) -> list[str]:
    """Return the lines that declare the codebook `book` (K, N). One of more than `_MOST_DIGITS`
    digits is read from the file of codes, whose content is `packed`; its digest is then named, too.
    """
    if book.size > _MOST_DIGITS:
        return [f'shutters book from "{CODES_FILE}" sha256 "{sha256(packed).hexdigest()}"']
    rows = ("".join(map(str, row)) for row in book.tolist())
    grouped = ("_".join(row[k : k + 4] for k in range(0, len(row), 4)) for row in rows)
    return ["shutters book [", *(f"    {row}," for row in grouped), "]"]


def _pixels(spec: ShutterSpec, codes: Codes, fields: list[str], packed: bytes) -> list[str]:
    """Return the lines that give the codes of the tile, for each of `fields`.

    Those of a tile of more than `MOST_LISTED` places (`spec`) are read from the file of codes,
    whose content is `packed`; its digest is then named, too."""
    if spec.places > MOST_LISTED:
        return [f'pixels from "{CODES_FILE}" sha256 "{sha256(packed).hexdigest()}"']
    lines = []
    for name in fields:
        width = len(str(int(codes[name].max())))
        rows = [", ".join(f"{v:{width}}" for v in row) for row in codes[name].tolist()]
        head = f"pixels {name} = tile ["
        lines += [head, *(f"    [{row}]," for row in rows[:-1]), f"    [{rows[-1]}]", "]"]
    return lines
