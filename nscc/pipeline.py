"""The way through the compiler: one visible list of passes, and the proof at its end.

`nscc.compiler` stands above it, and offers ways out where a program does not fit.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from nscc import checks
from nscc.cache.results import Results, results_of_user
from nscc.chips.load import load_target
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.lower import fit
from nscc.lower.assemble import assemble
from nscc.lower.exposure_plan import LoweringOption, Misfit, Planned, frame_time, plan_exposures
from nscc.lower.gates import Gated, find_gates
from nscc.lower.lowered import Choice, Lowered, lay_out
from nscc.program.analyse import analyse
from nscc.program.program import Codes, Program
from nscc.prove.proof import Proof, prove
from nscc.prove.stream_proof import prove_stream
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.syntax.tree import File
from nscc.words.container import Container
from nscc.words.legality import decoded

if TYPE_CHECKING:
    from nscc.looks.looking_plan import LookingPlan
    from nscc.stream.sending import Sending

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
class Job:
    """What every pass may know beside the value before it: the options, the folder that paths in
    the program are relative to, and the search results that are known."""

    options: Options
    base: Path
    results: Results | None


@dataclass(frozen=True)
class Parsed:
    """A program's text with its tree."""

    source: Source
    tree: File


Found = Sequence[Diagnostic]
"""What a pass has to say; an error among it ends the compilation."""


def parse_text(source: Source, job: Job) -> tuple[Parsed, Found]:
    """A source becomes a tree, whole or with gaps.

    Refuses what the grammar does not know: NS01xx.
    """
    tree, errors = parse(source)
    return Parsed(source, tree), errors


def make_program(parsed: Parsed, job: Job) -> tuple[Program, Found]:
    """A tree becomes a decode table for a target: names, ranges, classes, codes x slots.

    Refuses what has no meaning (NS02xx, NS03xx, NS04xx), and targets and files that cannot be read.
    """
    chip = job.options.target
    if isinstance(chip, str):
        chip = load_target(chip, Path())
    program = analyse(
        parsed.source, parsed.tree, base=job.base, codes=job.options.codes, target=chip
    )
    return program, program.messages


def make_plans(program: Program, job: Job) -> tuple[Planned, Found]:
    """A program becomes exposure plans, one for each lowering that can serve it.

    Refuses shutters beyond the states of a pixel (NS0412), buckets beyond its analog registers
    (NS0413) and a lowering that cannot serve them (NS0414).
    """
    fault = fit.capacity_fault(program)
    if fault is not None:
        return Planned(program, frame_time(program), (), (), {}), [fault]
    planned = plan_exposures(program, job.options.lowering)
    return planned, [] if planned.plans else [fit.plan_fault(program, planned.misfits)]


def choose_gates(planned: Planned, job: Job) -> tuple[Gated, Found]:
    """Plans become gates with their encodings, priced by laying them out; the best first.

    Plans that cannot be better than one that fits are not tried, unless all are to be priced.
    Refuses programs for which no gates are found (NS0502), which proves nothing, and what a
    generator from outside does not do as it says (NS0905). Warns where a generator fails (NS0504).
    """
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
        # That nothing fits is never taken from the cache.
        results.distrust()
        gated = search()
    messages = list({fault.generator: fault.diagnostic() for fault in gated.faults}.values())
    if not gated.decodings:
        messages.append(fit.gates_fault(gated.program, gated.misfits, level=options.level))
    return gated, messages


def lay_out_words(gated: Gated, job: Job) -> tuple[Choice, Found]:
    """Gates become kernels and launches at the frame's boundaries; the best lowering is the first.

    Refuses what the store (NS0501), the slots' time (NS0601), the retention of memory (NS0602) or
    the user's limit (NS0603) does not allow.
    """
    most_words = job.options.max_words_per_slot
    layouts = (
        lay_out(gated.program, decoding, gated.time, most_words) for decoding in gated.decodings
    )
    failed = tuple(dict.fromkeys(fault.generator for fault in gated.faults))
    choice = Choice(tuple(layouts), gated.misfits, failed)
    return choice, fit.faults(choice, level=job.options.level)


def make_container(choice: Choice, job: Job) -> tuple[Container, Found]:
    """The best lowering becomes a container of instruction code words.

    Refuses images and planes that need more than the chip has (NS0535, NS0540, NS0541).
    """
    container, program = assemble(choice.best, job.options.level), choice.best.program
    if program.pictures is None:
        return container, []
    from nscc.neighbours.passes import with_pictures

    return with_pictures(container, program, job.options.level)


def plan_looking(program: Program, job: Job) -> tuple[LookingPlan | Misfit, Found]:
    """A program that looks becomes one plan: what each boundary does to which pixels.

    Refuses buckets beyond the analog registers (NS0413) and lowerings that lose light (NS0414).
    """
    from nscc.looks.passes import plan_of

    return plan_of(program, job.options.lowering)


def find_looking_gates(plan: LookingPlan, job: Job) -> tuple[Sequence[Lowered], Found]:
    """A plan becomes words for several encodings of what pixels know, the best first.

    Refuses programs for which no gates are found (NS0502), which proves nothing.
    """
    from nscc.looks.passes import lowered_of

    return lowered_of(plan, job.options.level, job.options.max_words_per_slot)


def lay_out_looking(layouts: Sequence[Lowered], job: Job) -> tuple[Choice, Found]:
    """The best of them. Refuses as `lay_out_words` does."""
    choice = Choice(tuple(layouts[:1]), {})
    return choice, fit.faults(choice, level=job.options.level)


def make_looking_container(choice: Choice, job: Job) -> tuple[Container, Found]:
    """The best lowering becomes a container that carries its machine. Refuses nothing."""
    from nscc.looks.passes import container_of

    return container_of(choice.best, job.options.level), []


def plan_sending(program: Program, job: Job) -> tuple[Any, Found]:
    """A program for a chip without logic becomes a way for the light of every slot.

    Refuses buckets that pixels cannot sort light into (NS0509), and options for words (NS0510).
    """
    from nscc.stream.passes import plan_of

    lowering, most_words = job.options.lowering, job.options.max_words_per_slot
    options_for_words = [f"--lowering {lowering}"] * (lowering != "auto")
    return plan_of(program, options_for_words + ["--max-words-per-slot"] * (most_words is not None))


def time_sending(sending: Sending, job: Job) -> tuple[Sending, Found]:
    """The way with the times at which planes are sent. Refuses slots shorter than that (NS0508)."""
    from nscc.stream.passes import timed

    return timed(sending)


def make_planes(sending: Sending, job: Job) -> tuple[Container, Found]:
    """A way becomes a container of planes. Refuses nothing."""
    from nscc.stream.passes import container_of

    return container_of(sending), []


def prove_words(container: Container, job: Job) -> tuple[Proof, Found]:
    """A container's words, decoded and replayed, or its planes, followed pixel by pixel, become a
    proof. Refuses nothing: what does not satisfy the program is a fault of the compiler."""
    if container.target.streamed:
        return prove_stream(container), []
    try:
        kernels = decoded(container)
    except Rejected as rejected:
        raise checks.Inconsistent("words that the target does not have") from rejected
    return prove(container, kernels), []


@dataclass(frozen=True)
class Pass:
    """A step from one value to the next.

    `run` takes the value before and the job, and gives its own value with what it found. `verify`
    raises checks.Inconsistent where the value is not what it promises.
    """

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
"""What runs, in this order. `nscc build --print-after PASS` shows the value that a pass made."""

LOOKING_PASSES = (
    *_READING,
    Pass("plan", plan_looking, checks.check_looking_plan),
    Pass("gates", find_looking_gates, checks.check_looking_gates),
    Pass("schedule", lay_out_looking, checks.check_schedule),
    Pass("words", make_looking_container, checks.check_words),
    Pass("prove", prove_words, checks.check_proof),
)
"""The same for programs whose shutters depend on the light: what is wanted of the gates is a
machine's steps, not a table's shutters."""

STREAM_PASSES = (
    *_READING,
    Pass("plan", plan_sending, checks.check_route),
    Pass("schedule", time_sending, checks.check_loadings),
    Pass("words", make_planes, checks.check_words),
    Pass("prove", prove_words, checks.check_proof),
)
"""The same for chips without logic, whose pixels decode nothing: there are no gates."""


def _passes(values: Mapping[str, Any]) -> Iterator[Pass]:
    """What runs on a program, which the first two passes have read by the time that it counts."""
    read = len(_READING)
    yield from PASSES[:read]
    program: Program = values["program"]
    chip = STREAM_PASSES if program.target.streamed else PASSES
    yield from (chip if program.machine is None else LOOKING_PASSES)[read:]


Observer = Callable[[str, Any], None]
"""Sees (pass name, value) after each pass, before the value is verified."""


@dataclass(frozen=True, repr=False)
class Compiled:
    """A program that compiled: its words, proved, and what there is to say about it.

    `choice`, `container` and `proof` are None only where `unproved_is_error` is off and only a
    search can tell whether the program fits. For a chip without logic nothing is chosen: there
    `sending` stands in place of `choice`.
    """

    tree: File
    program: Program
    choice: Choice | None
    container: Container | None
    proof: Proof | None
    diagnostics: tuple[Diagnostic, ...]
    sending: Sending | None = None

    @property
    def lowered(self) -> Lowered | None:
        """The lowering that was chosen."""
        return None if self.choice is None else self.choice.best

    @property
    def shortest_slot_us(self) -> float:
        """The shortest slot that leaves time for its words, or for loading its plane of bits.

        ValueError where only a search can tell whether the program fits.
        """
        plan = self.lowered or self.sending
        if plan is None:
            raise ValueError("nothing was laid out")
        return plan.shortest_slot_us

    def __repr__(self) -> str:
        words = "no words" if self.container is None else f"{self.container!r}"
        return f"Compiled({self.program.source.name!r}, class {self.program.class_name}: {words})"


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
        raise ValueError(f"level {options.level} is not one of {LEVELS}")
    see = see or (lambda _name, _value: None)
    results = results_of_user() if options.cache else None
    job = Job(options, base, results)
    try:
        return _run(source, job, see)
    except Exception:
        if results is None or not results.read:
            raise
    # What came from the cache led nowhere: a file there is not what it says it is.
    results.distrust()
    return _run(source, job, see)


def all_lowerings(program: Program, options: Options) -> Choice:
    """A program that compiled with these options, laid out in every way that it can be lowered."""
    priced = replace(options, price_all=True)
    job = Job(priced, Path(), results_of_user() if options.cache else None)
    value: Any = program
    for step in (make_plans, choose_gates, lay_out_words):
        value, _ = step(value, job)
    return cast(Choice, value)


def _run(source: Source, job: Job, see: Observer) -> Compiled:
    """One pass after the other, each value seen and verified before the next one takes it."""
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
