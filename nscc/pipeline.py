"""The way through the compiler: one visible list of passes, and the proof at its end.

`nscc.compiler` stands above it, and offers ways out where a program does not fit.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from nscc.cache.results import Results, results_of_user
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lower.assemble import assemble
from nscc.lower.choose import Choice, LoweringOption, choose
from nscc.lower.fit import (
    as_note,
    capacity_fault,
    faults,
    misfit_fault,
    only_search_can_tell,
)
from nscc.lower.lowered import Lowered
from nscc.program.analyse import analyse
from nscc.program.program import Codes, Program
from nscc.prove.proof import Proof, prove
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.syntax.tree import File
from nscc.target.load import load_target
from nscc.target.target import Target
from nscc.words.container import Container

PASSES = ("parse", "program", "lower", "plan", "gates", "schedule", "words", "prove")
"""Every value between two passes can be seen with `nscc build --print-after PASS`."""

LEVELS = (0, 1, 2, 3)
"""How many steps the search for gates may take: the same level always takes the same ones."""


@dataclass(frozen=True)
class Options:
    """How to compile.

    `level` is one of LEVELS. `target` (a value, or a name or file as `--target` takes it) overrides
    the program's own. `price_all` lowers in every way, for the report's alternatives. Without
    `unproved_is_error`, what only a search can tell is a note. Without `cache`, no search result is
    read or kept. `max_words_per_slot` limits the words, digital and analog, of every boundary.
    """

    level: int = 2
    codes: Codes = "fixed"
    lowering: LoweringOption = "auto"
    target: Target | str | None = None
    price_all: bool = False
    unproved_is_error: bool = True
    cache: bool = True
    max_words_per_slot: int | None = None


@dataclass(frozen=True)
class Compiled:
    """A program that compiled: its words, proved, and what there is to say about it.

    `lowered`, `container` and `proof` are None only where `unproved_is_error` is off and only a
    search can tell whether the program fits.
    """

    tree: File
    program: Program
    choice: Choice
    lowered: Lowered | None
    container: Container | None
    proof: Proof | None
    diagnostics: tuple[Diagnostic, ...]


class ProofFailed(Exception):
    """The compiler's own words do not satisfy the program: a fault of the compiler."""


Observer = Callable[[str, Any], None]
"""Sees (pass name, value) after each pass."""


class Unfit(Rejected):
    """A program without faults of its own that does not fit its target."""

    def __init__(self, program: Program, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__(diagnostics)
        self.program = program


def run_passes(
    source: Source, base: Path, options: Options, see: Observer | None = None
) -> Compiled:
    """Compiles a program's text; `base` is the folder that its paths are relative to.

    Raises Rejected with everything that is wrong with it: Unfit if it is only too large.
    """
    if options.level not in LEVELS:
        raise ValueError(f"level {options.level} is none of {LEVELS}")
    see = see or (lambda _name, _value: None)
    results = results_of_user() if options.cache else None
    try:
        return _compile(source, base, options, see, results)
    except Exception:
        if results is None or not results.read:
            raise
    # What came from the cache led nowhere: a file there is not what it says it is.
    results.distrust()
    return _compile(source, base, options, see, results)


def _compile(
    source: Source, base: Path, options: Options, see: Observer, results: Results | None
) -> Compiled:
    """The passes themselves."""
    chip = options.target
    if isinstance(chip, str):
        chip = load_target(chip, Path())
    tree, found = parse(source)
    see("parse", (tree, source))
    _stop_on_errors(found)
    program = analyse(source, tree, base=base, codes=options.codes, target=chip)
    see("program", program)
    messages = [*found, *program.messages]
    fault = capacity_fault(program)
    if fault is not None:
        raise Unfit(program, [*messages, fault])
    choice = _choose(program, options, results)
    see("lower", choice)
    lowered = choice.best
    if lowered is None:
        fault = misfit_fault(program, choice, level=options.level)
        return _unfit(tree, program, choice, [fault], messages, options)
    see("plan", lowered.plan)
    see("gates", lowered)
    see("schedule", lowered)
    wrong = faults(choice, lowered, level=options.level)
    if wrong:
        return _unfit(tree, program, choice, wrong, messages, options)
    container = assemble(lowered, options.level)
    see("words", container)
    proof = prove(container, lowered.schedule.kernels)
    see("prove", proof)
    if proof.failure is not None:
        raise ProofFailed(f"{source.name}: {proof.failure}")
    return Compiled(tree, program, choice, lowered, container, proof, tuple(messages))


def _choose(program: Program, options: Options, results: Results | None) -> Choice:
    """The lowerings; that none of them fits is never taken from the cache."""

    def tried() -> Choice:
        return choose(
            program,
            options.lowering,
            options.level,
            price_all=options.price_all,
            results=results,
            most_words=options.max_words_per_slot,
        )

    choice = tried()
    if results is not None and results.read and (choice.best is None or not choice.best.fits):
        results.distrust()
        choice = tried()
    return choice


def _unfit(
    tree: File,
    program: Program,
    choice: Choice,
    wrong: list[Diagnostic],
    messages: list[Diagnostic],
    options: Options,
) -> Compiled:
    """Rejects what does not fit; what only a search can tell may pass as a note."""
    if options.unproved_is_error or not all(only_search_can_tell(d) for d in wrong):
        raise Unfit(program, [*messages, *wrong])
    notes = [as_note(d) for d in wrong]
    return Compiled(tree, program, choice, None, None, None, (*messages, *notes))


def _stop_on_errors(found: tuple[Diagnostic, ...]) -> None:
    if any(d.severity is Severity.ERROR for d in found):
        raise Rejected(found)
