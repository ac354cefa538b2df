"""The compiler's entry points: the pipeline, and alternatives for programs that do not fit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lower.fit import has_ways_out
from nscc.lower.lowered import Lowered
from nscc.options import Options
from nscc.pipeline import Compiled, Observer, Unfit, run_passes
from nscc.program.program import Codes, Program
from nscc.source import Source
from nscc.syntax import tree
from nscc.syntax.parse import parse, read_source

CHECK = Options(level=1, unproved_is_error=False)
"""Options of `nscc check`: a short search; a note tells if only a longer search can decide."""


def compile_file(
    path: Path, options: Options | None = None, see: Observer | None = None
) -> Compiled:
    """Return the compiled program of a `.nsl` file; its `target` and data files are relative to it.

    `options` None means the defaults. `see` is called after each pass with the pass and its value
    (None: not). Raises Rejected with all errors."""
    return compile_source(read_source(path), path.parent, options or Options(), see)


def compile_source(
    source: Source, base: Path, options: Options, see: Observer | None = None
) -> Compiled:
    """Return the compiled program of a text; files that it names are relative to the folder `base`.

    `see` is called after each pass with the pass and its value (None: not). Raises Rejected with
    all errors. If the only errors are that the program does not fit, or is too large to prove,
    similar programs are compiled, and the diagnostics suggest those that fit."""
    try:
        return run_passes(source, base, options, see)
    except Rejected as rejected:
        program = rejected.program if isinstance(rejected, Unfit) else None
        diagnostics = _with_ways_out(rejected.diagnostics, source, program, base, options)
        raise Rejected(diagnostics, rejected.status) from None


def _with_ways_out(
    diagnostics: tuple[Diagnostic, ...],
    source: Source,
    program: Program | None,
    base: Path,
    options: Options,
) -> list[Diagnostic]:
    """Return the diagnostics of a text that does not fit, with similar programs that fit added to
    them as `ways_out`, or a help that none was found. `program` is None if the text has errors, or
    too many shutters to list.

    `base` is the folder for relative paths, and `options` are those of the compilation. Diagnostics
    of errors that a similar program cannot avoid stay as they are."""
    errors = [d for d in diagnostics if d.severity is Severity.ERROR]
    avoidable = [has_ways_out(d) for d in errors]
    if not any(avoidable) or (program is None and not all(avoidable)):
        return list(diagnostics)
    from nscc.limits.ways_out import ways_out  # imported only for programs that do not fit

    alike = replace(options, price_all=False, unproved_is_error=True)
    if program is not None:
        alike = replace(alike, target=program.target)

    def attempt(source: Source, codes: Codes, level: int) -> Lowered | None:
        """Compile the similar program `source` up to its lowering (a way to compute the exposure),
        with these `codes` and at this optimisation `level`; return None if it is rejected."""
        try:
            return run_passes(source, base, replace(alike, codes=codes, level=level)).lowered
        except Rejected:
            return None

    ways = ways_out(source, program, attempt, options.level)
    texts = tuple(way.text for way in ways)
    data = {key: value for way in ways for key, value in way.data.items()}
    none = () if ways else ("no smaller program was found that fits; nscc looked no further",)
    return [
        replace(d, helps=(*d.helps, *none), ways_out=texts, data={**d.data, **data})
        if has_ways_out(d)
        else d
        for d in diagnostics
    ]


def files_of(program: Path) -> set[Path]:
    """Return the program's path and the paths of the targets, codebooks, kernels and pixel codes
    that it names.

    The files need not exist. If the program cannot be read, return only its own path."""
    files = {program}
    try:
        statements = parse(read_source(program))[0].statements
    except Rejected:
        return files
    for statement in statements:
        if isinstance(statement, tree.TargetFromFile | tree.FromFile | tree.PixelsFromFile):
            files.add(program.parent / statement.path.value)
    return files
