"""The compiler's list of passes, from text to proof.

`nscc.compiler` calls it and adds alternatives if a program does not fit."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from nscc import checks
from nscc.arrays import Bools
from nscc.cache.results import Results, results_of_user
from nscc.chips.load import load_target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity, rejected
from nscc.kinds import KindTable
from nscc.lazy import LazyFunctions
from nscc.lower import fit
from nscc.lower.exposure_plan import Planned, frame_time, plan_exposures
from nscc.lower.gates import Gated, find_gates
from nscc.lower.lowered import Choice, Lowered, assemble, lay_out
from nscc.mappings import NamedValues
from nscc.operations import Op
from nscc.options import Options
from nscc.program.analyse import analyse
from nscc.program.problems import counted
from nscc.program.program import Program
from nscc.prove.pixels import ReplayPixels
from nscc.prove.proof import (
    Failure,
    Proof,
    Replay,
    prove,
    readout_failure,
    shutters,
    unproved_error,
)
from nscc.record import Record
from nscc.source import Source
from nscc.syntax.parse import declared_at, parse
from nscc.syntax.tree import File
from nscc.words.container import Container
from nscc.words.legality import decoded

if TYPE_CHECKING:
    from networkx import DiGraph

LEVELS = (0, 1, 2, 3)
"""Optimisation levels; a higher level allows more steps in the search for gates."""


class Job(Record):
    """What all passes need besides the program: its text, the options, and more.

    `base` is the folder for relative paths. `results` are stored search results, None without a
    cache."""

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
    """Return the text with its syntax tree, which lacks the invalid statements, and the errors
    NS01xx."""
    tree, errors = parse(source)
    return Parsed(source, tree), errors


def make_program(parsed: Parsed, job: Job) -> tuple[Program, Found]:
    """Return the checked program of the syntax tree in `parsed`, with its decode table of codes and
    slots, and its messages.

    Raises Rejected with NS02xx, NS03xx and NS04xx for invalid statements, and for targets and files
    that cannot be read."""
    chip = job.options.target
    if isinstance(chip, str):
        chip = load_target(chip, Path())
    program = analyse(
        parsed.source, parsed.tree, base=job.base, codes=job.options.codes, target=chip
    )
    return program, program.messages


class Pass(Record):
    """A compiler pass.

    `run` takes the value of the previous pass and the job, and returns the new value and its
    diagnostics. `verify` raises checks.Inconsistent if the new value is inconsistent. `text`
    returns the value as text, for `--print-after`."""

    name: str
    run: Callable[[Any, Job], tuple[Any, Found]]
    verify: Callable[[Any], None]
    text: Callable[[Any], str]


_TEXTS = LazyFunctions("nscc.emit.listing")
_SUMMARY = LazyFunctions("nscc.emit.summary")


def make_plans(program: Program, job: Job) -> tuple[Planned, Found]:
    """Return an exposure plan for each lowering (way to compute the exposure) that supports the
    program, and the error if there is none.

    `job` has the options, of which `lowering` may allow only one lowering. The errors are NS0412
    for more shutters than a pixel's registers can distinguish, NS0413 for more buckets than analog
    registers, and NS0414 for a lowering that does not support the program."""
    fault = fit.capacity_fault(program)
    if fault is not None:
        return Planned(program, frame_time(program), opens=(), plans=(), misfits={}), [fault]
    lowering = job.options.lowering
    planned = plan_exposures(program, lowering)
    faults = [] if planned.plans else [fit.plan_fault(program, planned.misfits, lowering)]
    return planned, faults


def choose_gates(planned: Planned, job: Job) -> tuple[Gated, Found]:
    """Return gates and encodings for the exposure plans of `planned`, with their costs, the best
    first; and diagnostics. An exposure plan says which analog words run at which boundary.

    `job` has the options and the stored search results. Plans that cannot be better than one that
    fits are not tried, unless all costs are requested. The errors are NS0502 if no gates are found,
    which does not prove that none exist, and NS0905 if a generator of another package returns
    invalid gates; NS0504 warns of a generator (a method that finds gates) that fails."""
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
    # One warning for each generator, although it may fail for several plans.
    messages = list({fault.generator: fault.diagnostic() for fault in gated.faults}.values())
    if not gated.decodings:
        messages.append(fit.gates_fault(gated.program, gated.misfits, level=options.level))
    return gated, messages


def lay_out_words(gated: Gated, job: Job) -> tuple[Choice, Found]:
    """Return the kernels (lists of words) and the boundaries at which they start, the best lowering
    (way to compute the exposure) first; and errors.

    `gated` has the gates of all exposure plans, and `job` the options. The errors are for a program
    that exceeds the store (NS0501), the slots' time (NS0601), the retention time of registers
    (NS0602) or the user's limit (NS0603)."""
    most_words = job.options.max_words_per_slot
    layouts = (
        lay_out(gated.program, decoding, gated.time, most_words) for decoding in gated.decodings
    )
    failed = tuple(dict.fromkeys(fault.generator for fault in gated.faults))
    choice = Choice(tuple(layouts), gated.misfits, failed)
    return choice, fit.faults(choice, level=job.options.level)


class Compiled(Record):
    """A successfully compiled program: its proved words and its diagnostics.

    `tree` is the syntax tree. `layout` is the value of the pass `schedule`: a `Choice`, or a
    `Sending` for a chip without logic. `layout`, `container` and `proof` are None only if
    `unproved_is_error` is false and it is unknown whether the program fits."""

    tree: File
    program: Program
    layout: Any
    container: Container | None
    proof: Proof | None
    diagnostics: tuple[Diagnostic, ...]

    @property
    def built(self) -> Container:
        """The container. Raises ValueError if it is unknown whether the program fits."""
        if self.container is None:
            raise ValueError(
                "no words were found, so it is unknown whether the program fits the chip"
            )
        return self.container

    @property
    def lowered(self) -> Lowered | None:
        """The chosen words of a frame; None for a chip without logic, or if it is unknown whether
        the program fits."""
        return getattr(self.layout, "best", None)

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot in microseconds that fits its words, or the loading of its bit plane.

        Raises ValueError if it is unknown whether the program fits."""
        if self.layout is None:
            raise ValueError(
                "the shortest slot is unknown, because it is unknown whether the program fits"
            )
        return float(self.layout.shortest_slot_us)

    def __repr__(self) -> str:
        """Return name, class and container (a compiled program) as one line."""
        words = "no words" if self.container is None else f"{self.container!r}"
        return f"Compiled({self.program.source.name!r}, class {self.program.class_name}: {words})"


class ProgramKind:
    """What the compiler does for a kind of program: plan, lower, prove and describe it.

    This class is for programs whose shutters depend on the code of a pixel only ("fixed" shutters).
    The classes of other kinds change it, and may be combined: they call `super`."""

    passes: ClassVar[tuple[Pass, ...]] = (
        Pass("plan", make_plans, checks.check_plans, _TEXTS.plans_text),
        Pass("gates", choose_gates, checks.check_gates, _TEXTS.all_gates_text),
        Pass("schedule", lay_out_words, checks.check_schedule, _TEXTS.choice_text),
    )
    """The passes from the program to the layout of its words. The last one is `schedule`."""
    subject = "words"
    """What a container has, in messages: words, or planes."""
    shutters_known = True
    """Whether the shutters are known before the exposure."""
    one_lowering_for = ""
    """The subject of "there is one lowering for ..."; empty if there are several."""
    has_simpler_programs = True
    """Whether programs with other rules are suggested for one that does not fit."""

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        """Return the container (a compiled program) of `layout`, the value of the pass `schedule`,
        and diagnostics.

        `job` has the options. With images and planes there may be errors: NS0535, NS0540 and NS0541
        if they exceed the chip's resources."""
        return assemble(layout.best, job.options.level), ()

    def replay(self, container: Container, kernels: Sequence[Sequence[Op]]) -> ReplayPixels:
        """Return the simulated pixels on which the proof runs the words `kernels`."""
        return Replay(container, kernels)

    def after_frame(self, container: Container) -> Failure | None:
        """Return the first error in the words that run after the exposure, or None."""
        return readout_failure(container)

    def prove(self, container: Container, kernels: Sequence[Sequence[Op]]) -> Proof:
        """Return the proof that decoded words, or bit planes, do what the container says. A
        container is a compiled program."""
        return prove(container, kernels, self.replay, self.after_frame)

    def replayed(self, container: Container, name: str) -> Bools:
        """Return the distinct shutters that the words open, bool (shutters, buckets, N), in the
        order of the decode table.

        Raises Rejected (NS0442, status 1) if the words do not implement shutters. `name` is the
        container (a compiled program) in the message."""
        opened = shutters(container, decoded(container))
        if opened is None:
            raise rejected(
                "NS0442",
                f"the words of {name} do not implement shutters: the light of some slot has a "
                "weight other than 0 or 1",
                helps=("`nscc prove` shows the error in the words",),
                status=1,
            )
        return opened

    def with_planes(self, container: Container) -> Container:
        """Return a container with the bit planes that follow from its pixel codes. Only chips
        without logic have such planes; here the container is returned as it is."""
        return container

    def product(self, product: str, compiled: Compiled, stem: str) -> dict[str, bytes]:
        """Return the product `product` of `nscc build --emit`, such as "asm", as {file name:
        content}; file names begin with `stem`.

        The products that every kind has are made elsewhere (`nscc.emit.products`)."""
        return dict(LazyFunctions("nscc.emit.products").word_product(product, compiled, stem, self))

    def gates_text(self, lowered: Any) -> str:
        """Return the gates of a lowering (way to compute the exposure) as text."""
        return str(_TEXTS.gates_text(lowered.decoding, lowered.program))

    def network(self, lowered: Any) -> DiGraph:
        """Return the gates of a lowering (way to compute the exposure) as a network."""
        network: DiGraph = LazyFunctions("nscc.emit.network").network_of(lowered)
        return network

    def words_text(self, container: Container) -> str:
        """Return the words, or a description of the planes, for `--print-after words`."""
        from nscc.words.disassembly import disassemble

        return disassemble(container)

    def report(self, compiled: Compiled) -> NamedValues:
        """Return the build report as JSON values."""
        return dict(LazyFunctions("nscc.emit.report").report(compiled.layout, compiled.proof))

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        """Return the rows (label, text) of a summary that follow those on class and codes; fewer if
        it is unknown whether the program fits."""
        return list(_SUMMARY.word_rows(compiled))

    def cost_text(self, compiled: Compiled) -> str:
        """Return two lines on the cost of words or bit planes."""
        return str(_SUMMARY.word_cost_text(compiled))

    def size_text(self, container: Container) -> str:
        """Return what a frame executes, or is sent, in a few words."""
        return counted(container.words_per_frame, "word")

    def readout_us(self, container: Container) -> float:
        """Return the time to read out all buckets, in microseconds."""
        return container.target.readout_us * len(container.readouts)

    def frame_text(self, compiled: Compiled) -> str:
        """Return the cost of a frame in sentences; the last one is only its subject, which the
        caller completes."""
        return str(_SUMMARY.word_frame_text(compiled.lowered))

    def slot_text(self, compiled: Compiled, slot: int) -> str:
        """Return the cost of slot number `slot`, from 0, as the end of a sentence."""
        return str(_SUMMARY.word_slot_text(compiled.lowered, slot))


KINDS = KindTable(
    ProgramKind,
    images="nscc.neighbours.images_kind:Images",
    looks="nscc.looks.looks_kind:Looks",
    stream="nscc.stream.planes_kind:BitPlanes",
)
"""The kinds of programs that the compiler knows."""


def prove_words(container: Container, job: Job) -> tuple[Proof, Found]:
    """Return the proof of a container (a compiled program), by replaying its words or following the
    light of its bit planes; and errors.

    `job` has the program's text, for the place of an error. A failed proof is a fault of the
    compiler, not an error of the program. The errors are NS0533 and NS0544, for an image or plane
    that cannot be proved. Raises Inconsistent for words that the target does not have."""
    try:
        kernels = decoded(container)
    except Rejected as error:
        raise checks.Inconsistent("words that the target does not have") from error
    proof = KINDS.of(container).prove(container, kernels)
    failure = proof.failure
    if failure is None or failure.unproved is None:
        return proof, []
    span = declared_at(job.source, failure.unproved)
    return proof, [unproved_error(failure, job.source, span)]


_READING = (
    Pass("parse", parse_text, lambda p: checks.check_tree(p.source, p.tree), _TEXTS.parsed_text),
    Pass("program", make_program, checks.check_program, _TEXTS.program_text),
)
_WRITING = (
    Pass(
        "words",
        lambda layout, job: KINDS.of(layout.program).assemble(layout, job),
        checks.check_words,
        lambda c: KINDS.of(c).words_text(c),
    ),
    Pass("prove", prove_words, checks.check_proof, _TEXTS.proof_text),
)
PASSES = ("parse", "program", "plan", "gates", "schedule", "words", "prove")
"""The names of the passes, in order. `nscc build --print-after PASS` prints the value after one."""


def _passes(values: Mapping[str, Any]) -> Iterator[Pass]:
    """Yield the passes for a program; `values` are the results so far by the pass's name, to which
    the caller adds: "program" must be there when the third pass is requested."""
    yield from _READING
    yield from KINDS.of(values["program"]).passes
    yield from _WRITING


Observer = Callable[[Pass, Any], None]
"""A function called with (pass, value) after each pass, before the value is verified."""


class Unfit(Rejected):
    """Raised for a valid program that does not fit its target, with the `program`."""

    def __init__(self, program: Program, diagnostics: Sequence[Diagnostic]) -> None:
        """Store the program, which is valid, and the diagnostics on why it does not fit its
        chip."""
        super().__init__(diagnostics)
        self.program = program


def run_passes(
    source: Source, base: Path, options: Options, see: Observer | None = None
) -> Compiled:
    """Return the compiled program of a text; files that it names are relative to the folder `base`.

    `see` is called after each pass with the pass and its value. Raises ValueError for an unknown
    optimisation level, Rejected with all errors, or Unfit if the program only does not fit its
    target."""
    if options.level not in LEVELS:
        raise ValueError(f"level {options.level} is not one of {LEVELS}")
    see = see or (lambda _pass, _value: None)
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


def with_all_lowerings(compiled: Compiled, options: Options) -> Compiled:
    """Return a compiled program with the words of all lowerings (ways to compute the exposure), for
    its report. Container and proof stay as they are; `options` are those of its compilation."""
    results = results_of_user() if options.cache else None
    job = Job(compiled.program.source, replace(options, price_all=True), Path(), results)
    value: Any = compiled.program
    for compiler_pass in KINDS.of(compiled.program).passes:
        value, _ = compiler_pass.run(value, job)
    return replace(compiled, layout=value)


def _run(source: Source, job: Job, see: Observer) -> Compiled:
    """Run all passes for the text `source` in order, with what `job` gives them; `see` receives
    each pass and its value, which is then verified.

    Raises Rejected at the first pass with errors, as Unfit if the program is valid but does not
    fit."""
    values: NamedValues = {}
    messages: list[Diagnostic] = []
    value: Any = source
    for compiler_pass in _passes(values):
        value, diagnostics = compiler_pass.run(value, job)
        values[compiler_pass.name] = value
        see(compiler_pass, value)
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


def _compiled(values: NamedValues, messages: Found, *, fits: bool) -> Compiled:
    """Return the result of a compilation from the values of all passes, by name, and from all
    messages.

    Unless the program `fits`, layout, words and proof are None."""
    names = ("schedule", "words", "prove")
    layout, container, proof = (values[name] if fits else None for name in names)
    tree, program = values["parse"].tree, values["program"]
    return Compiled(tree, program, layout, container, proof, diagnostics=tuple(messages))
