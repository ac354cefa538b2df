"""The compiler's list of passes, from text to proof.

`nscc.compiler` calls it and adds alternatives if a program does not fit."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast, get_args

from nscc import checks
from nscc.cache.results import Results, results_of_user
from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lower import fit
from nscc.lower.exposure_plan import LOWERINGS, LoweringOption, Planned, frame_time, plan_exposures
from nscc.lower.gates import Gated, find_gates
from nscc.lower.lowered import Choice, Lowered, assemble, lay_out
from nscc.program.analyse import analyse
from nscc.program.program import Codes, Program
from nscc.prove.proof import Proof, prove, prove_stream, unproved_error
from nscc.record import Record
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.syntax.tree import File
from nscc.toml.kinds import Flag, Instance, Integer, TextKind
from nscc.toml.schema import key
from nscc.words.container import Container
from nscc.words.legality import decoded

if TYPE_CHECKING:
    from nscc.stream.passes import Sending

LEVELS = (0, 1, 2, 3)
"""Optimisation levels; a higher level allows more steps in the search for gates."""


@dataclass(frozen=True)
class Options:
    """Options of the compiler.

    `price_all` computes the costs of all lowerings, for the report. If `unproved_is_error` is false
    and only a longer search can decide whether the program fits, this is a note instead of an
    error."""

    level: int = key(
        Integer(0, 3), "Effort of the search for fewer words", 2,
        option="-O", default_text="2; check: 1",
    )  # fmt: skip
    codes: Codes = key(
        TextKind(get_args(Codes)), "Compile for the codes in use, or for every legal one", "fixed"
    )
    lowering: LoweringOption = key(
        TextKind(("auto", *LOWERINGS)), "How the exposure is computed", "auto",
        default_text="auto, the cheapest",
    )  # fmt: skip
    target: Target | str | None = key(
        Instance((Target, str, os.PathLike), "a chip's name, its file or a Target"),
        "The chip, instead of the chip in the program", None, notation="NAME|FILE.toml",
    )  # fmt: skip
    cache: bool = key(
        Flag(),
        "Store search results of -O2 and -O3 and reuse them (default), or search again",
        True, option="--cache/--no-cache",
    )  # fmt: skip
    max_words_per_slot: int | None = key(
        Integer(1, inf),
        "Reject programs that execute more words than this in any slot", None, notation="W",
    )  # fmt: skip
    price_all: bool = False
    unproved_is_error: bool = True


class Job(Record):
    """The context of all passes: the text, options, the folder for relative paths, and stored
    search results."""

    source: Source
    options: Options
    base: Path
    results: Results | None


class Parsed(Record):
    """A program's text with its tree."""

    source: Source
    tree: File


Found = Sequence[Diagnostic]
"""The diagnostics of a pass; an error among them ends the compilation."""


def parse_text(source: Source, job: Job) -> tuple[Parsed, Found]:
    """Parse a source text to a tree, which lacks the invalid statements.

    Errors: NS01xx for invalid syntax."""
    tree, errors = parse(source)
    return Parsed(source, tree), errors


def make_program(parsed: Parsed, job: Job) -> tuple[Program, Found]:
    """Analyse a tree: names, ranges, classes, and the decode table of codes x slots for a target.

    Errors: NS02xx, NS03xx and NS04xx for invalid statements, and for targets and files that cannot
    be read."""
    chip = job.options.target
    if isinstance(chip, str):
        chip = load_target(chip, Path())
    program = analyse(
        parsed.source, parsed.tree, base=job.base, codes=job.options.codes, target=chip
    )
    return program, program.messages


def make_plans(program: Program, job: Job) -> tuple[Planned, Found]:
    """Make an exposure plan for each lowering that supports the program.

    Errors: NS0412 for more shutters than a pixel's registers can distinguish, NS0413 for more
    buckets than analog registers, NS0414 for a lowering that does not support the program."""
    fault = fit.capacity_fault(program)
    if fault is not None:
        return Planned(program, frame_time(program), (), (), {}), [fault]
    planned = plan_exposures(program, job.options.lowering)
    return planned, [] if planned.plans else [fit.plan_fault(program, planned.misfits)]


def choose_gates(planned: Planned, job: Job) -> tuple[Gated, Found]:
    """Find gates and encodings for the plans, with their costs; the best comes first.

    Plans that cannot be better than one that fits are not tried, unless all costs are requested.
    Errors: NS0502 if no gates are found, which does not prove that none exist; NS0905 if a
    generator of another package returns invalid gates. Warning: NS0504 if a generator fails."""
    options, results = job.options, job.results
    search = partial(
        find_gates,
        planned,
        options.level,
        price_all=options.price_all,
        results=results,
        most_words=options.max_words_per_slot,
    )
    gated = search()
    if results is not None and results.read and not gated.fits:
        # The result that nothing fits is never taken from the cache.
        results.distrust()
        gated = search()
    messages = list({fault.generator: fault.diagnostic() for fault in gated.faults}.values())
    if not gated.decodings:
        messages.append(fit.gates_fault(gated.program, gated.misfits, level=options.level))
    return gated, messages


def lay_out_words(gated: Gated, job: Job) -> tuple[Choice, Found]:
    """Assign kernels and launches to the frame's boundaries; the best lowering comes first.

    Errors: a program that exceeds the store (NS0501), the slots' time (NS0601), the retention time
    of registers (NS0602) or the user's limit (NS0603)."""
    most_words = job.options.max_words_per_slot
    layouts = (
        lay_out(gated.program, decoding, gated.time, most_words) for decoding in gated.decodings
    )
    failed = tuple(dict.fromkeys(fault.generator for fault in gated.faults))
    choice = Choice(tuple(layouts), gated.misfits, failed)
    return choice, fit.faults(choice, level=job.options.level)


def make_container(choice: Choice, job: Job) -> tuple[Container, Found]:
    """Convert the best lowering to a container of instruction words.

    Errors: NS0535, NS0540 and NS0541 for images and planes that exceed the chip's resources."""
    container, program = assemble(choice.best, job.options.level), choice.best.program
    if not program.pictures.outputs:
        return container, []
    from nscc.neighbours.passes import with_pictures

    return with_pictures(container, program, job.options.level, job.results)


def lay_out_looking(layouts: Sequence[Lowered], job: Job) -> tuple[Choice, Found]:
    """Choose the best words; errors are as for `lay_out_words`."""
    choice = Choice(tuple(layouts[:1]), {})
    return choice, fit.faults(choice, level=job.options.level)


def prove_words(container: Container, job: Job) -> tuple[Proof, Found]:
    """Prove a container by replaying its words, or by following the light of its bit planes.

    A failed proof is a bug of the compiler, not an error of the program. Errors: those of
    `unproved_error`."""
    if container.target.streamed:
        return prove_stream(container), []
    try:
        kernels = decoded(container)
    except Rejected as rejected:
        raise checks.Inconsistent("words that the target does not have") from rejected
    proof = prove(container, kernels)
    failure = proof.failure
    if failure is None or failure.unproved is None:
        return proof, []
    from nscc.neighbours.passes import place_of

    span = place_of(job.source, failure.unproved)
    return proof, [unproved_error(failure, job.source, span)]


class Pass(Record):
    """A compiler pass.

    `run` takes the previous value and the job, and returns the new value and its diagnostics.
    `verify` raises checks.Inconsistent if the new value violates its invariants."""

    name: str
    run: Callable[[Any, Job], tuple[Any, Found]]
    verify: Callable[[Any], None]


_READING = (
    Pass("parse", parse_text, lambda parsed: checks.check_tree(parsed.source, parsed.tree)),
    Pass("program", make_program, checks.check_program),
)
PASSES = (
    *_READING,
    Pass("plan", make_plans, checks.check_plans),
    Pass("gates", choose_gates, checks.check_gates),
    Pass("schedule", lay_out_words, checks.check_schedule),
    Pass("words", make_container, checks.check_words),
    Pass("prove", prove_words, checks.check_proof),
)
"""The passes in order. `nscc build --print-after PASS` prints the value after a pass."""


def _looks() -> Any:
    """Import the passes for programs with senses on first use."""
    from nscc.looks import passes

    return passes


LOOKING_PASSES = (
    *_READING,
    Pass(
        "plan", lambda program, job: _looks().plan_of(program, job.options.lowering),
        checks.check_looking_plan,
    ),
    Pass(
        "gates",
        lambda plan, job: _looks().lowered_of(
            plan, job.options.level, job.options.max_words_per_slot
        ),
        checks.check_looking_gates,
    ),
    Pass("schedule", lay_out_looking, checks.check_schedule),
    Pass(
        "words", lambda choice, job: (_looks().container_of(choice.best, job.options.level), []),
        checks.check_words,
    ),
    Pass("prove", prove_words, checks.check_proof),
)  # fmt: skip
"""The passes for programs whose shutters depend on the light: the gates implement a state
machine."""


def _stream() -> Any:
    """Import the passes for chips without logic on first use."""
    from nscc.stream import passes

    return passes


STREAM_PASSES = (
    *_READING,
    Pass(
        "plan",
        lambda program, job: _stream().plan_of(
            program, job.options.lowering, job.options.max_words_per_slot
        ),
        checks.check_route,
    ),
    Pass("schedule", lambda sending, _job: _stream().timed(sending), checks.check_loadings),
    Pass("words", lambda sending, _job: (_stream().container_of(sending), []), checks.check_words),
    Pass("prove", prove_words, checks.check_proof),
)
"""The passes for chips without logic, which need no gates."""


def _passes(values: Mapping[str, Any]) -> Iterator[Pass]:
    """Yield the passes for a program, whose kind is known after the first two passes."""
    read = len(_READING)
    yield from PASSES[:read]
    program: Program = values["program"]
    chip = STREAM_PASSES if program.target.streamed else PASSES
    yield from (LOOKING_PASSES if program.machine.stages else chip)[read:]


Observer = Callable[[str, Any], None]
"""A function called with (pass name, value) after each pass, before the value is verified."""


class Compiled(Record):
    """A successfully compiled program: its proved words and its diagnostics.

    `choice`, `container` and `proof` are None only if `unproved_is_error` is false and it is
    unknown whether the program fits. For a chip without logic, `sending` replaces `choice`."""

    tree: File
    program: Program
    choice: Choice | None
    container: Container | None
    proof: Proof | None
    diagnostics: tuple[Diagnostic, ...]
    sending: Sending | None = None

    @property
    def lowered(self) -> Lowered | None:
        """The chosen lowering; None for a chip without logic, or if it is unknown whether the
        program fits."""
        return None if self.choice is None else self.choice.best

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot in microseconds that fits its words, or the loading of its bit plane.

        Raises ValueError if it is unknown whether the program fits."""
        plan = self.lowered or self.sending
        if plan is None:
            raise ValueError("nothing was laid out")
        return plan.shortest_slot_us

    def __repr__(self) -> str:
        words = "no words" if self.container is None else f"{self.container!r}"
        return f"Compiled({self.program.source.name!r}, class {self.program.class_name}: {words})"


class Unfit(Rejected):
    """Raised for a valid program that does not fit its target."""

    def __init__(self, program: Program, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__(diagnostics)
        self.program = program


def run_passes(
    source: Source, base: Path, options: Options, see: Observer | None = None
) -> Compiled:
    """Compile a program's text; paths in it are relative to the folder `base`.

    Raises Rejected with all errors, or Unfit if the program only does not fit its target."""
    if options.level not in LEVELS:
        raise ValueError(f"level {options.level} is not one of {LEVELS}")
    see = see or (lambda _name, _value: None)
    results = results_of_user() if options.cache else None
    job = Job(source, options, base, results)
    try:
        return _run(source, job, see)
    except Exception:
        if results is None or not results.read:
            raise
    # The cached solution does not work: the cache file is wrong.
    results.distrust()
    return _run(source, job, see)


def all_lowerings(program: Program, options: Options) -> Choice:
    """Return all lowerings of a program that compiled with these options, with their words."""
    priced = replace(options, price_all=True)
    results = results_of_user() if options.cache else None
    job = Job(program.source, priced, Path(), results)
    value: Any = program
    for step in (make_plans, choose_gates, lay_out_words):
        value, _ = step(value, job)
    return cast(Choice, value)


def _run(source: Source, job: Job, see: Observer) -> Compiled:
    """Run all passes in order; each value is observed and verified before the next pass."""
    values: dict[str, Any] = {}
    messages: list[Diagnostic] = []
    value: Any = source
    for compiler_pass in _passes(values):
        value, diagnostics = compiler_pass.run(value, job)
        values[compiler_pass.name] = value
        see(compiler_pass.name, value)
        errors = [d for d in diagnostics if d.severity is Severity.ERROR]
        unproved = all(map(fit.only_search_can_tell, errors))
        if errors and (job.options.unproved_is_error or not unproved):
            all_messages = [*messages, *diagnostics]
            raise (
                Unfit(values["program"], all_messages)
                if "program" in values
                else Rejected(all_messages)
            )
        if errors:
            return _compiled(values, [*messages, *map(fit.as_note, errors)], fits=False)
        messages += diagnostics
        compiler_pass.verify(value)
    return _compiled(values, messages, fits=True)


def _compiled(values: dict[str, Any], messages: Found, *, fits: bool) -> Compiled:
    names = ("schedule", "words", "prove")
    laid_out, container, proved = (values[name] if fits else None for name in names)
    tree, program = values["parse"].tree, values["program"]
    choice, sending = (None, laid_out) if program.target.streamed else (laid_out, None)
    return Compiled(tree, program, choice, container, proved, tuple(messages), sending)
