"""Analysis of a program: names, types, ranges and codes, with all errors at once."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Rejected
from nscc.program.complete import Completion
from nscc.program.constants import constants_scope, require_scope, resolve_constants, rule_scope
from nscc.program.expressions import Meaning, check
from nscc.program.field_planes import PlaneMaker
from nscc.program.fields import make_books, make_fields
from nscc.program.names import Declarations, gather
from nscc.program.problems import Problems
from nscc.program.program import Codes, Program, SlotGrid, chunks_of
from nscc.program.table import Rules
from nscc.source import Source, Span
from nscc.syntax.parse import parse
from nscc.syntax.tree import EqualSlots, File, ListedSlots, TargetByName, TargetFromFile
from nscc.words.pictures import NO_PICTURES

SHORTEST_US = Fraction(1, 10**6)
LONGEST_US = Fraction(10**12)


def analyse(
    source: Source, tree: File, *, base: Path, codes: Codes = "fixed", target: Target | None = None
) -> Program:
    """Return the checked program of a syntax tree.

    Paths in it are relative to the folder `base`. `target` replaces the target statement; None
    keeps it. `codes` is "fixed" to compile only the codes that pixels use, or "open" for all legal
    codes. A file without `pixels` is compiled for every legal code, whatever `codes` says; a file
    without fields has a single code, which every pixel has. Raises Rejected with all errors, in the
    order of the text (NS02xx, NS03xx; NS0450 if a limit of enumeration is exceeded)."""
    problems = Problems(source)
    declared = gather(tree, problems)
    chosen = target or target_of(declared, base, problems)
    constants = resolve_constants(declared, chosen, problems)
    frame = None
    if declared.frame is not None:
        frame = _make_frame(declared.frame, constants["N"], problems)
    books = make_books(declared.books, constants["N"], base, problems)
    scope = constants_scope(declared, constants)
    fields = make_fields(declared, scope, books, problems)
    # Each has a scope of its own: rules may read the slot, conditions may not.
    scope = require_scope(declared, constants)
    conditions = [
        check(r.condition, "boolean", scope, problems, "a condition") for r in declared.requires
    ]
    scope = rule_scope(declared, constants)
    rules = [check(r.rule, "boolean", scope, problems, "a rule") for r in declared.rules]
    if chosen is not None and not chosen.has_logic and declared.looking:
        _refuse_looking(declared, chosen, problems)
    # The modules for looks and images are imported only for programs that need them.
    looking, pictures = None, NO_PICTURES
    if declared.looking:
        from nscc.program.looking import make_looking

        looking = make_looking(declared, constants, chosen, problems)
    if declared.has_pictures and chosen is not None:
        from nscc.program.picture_statements import PictureMaker

        pictures = PictureMaker(declared, constants, chosen, base, problems).make()
    planes = PlaneMaker(
        declared, fields, constants, target=chosen, base=base, problems=problems
    ).make()
    problems.stop_on_errors()
    # Without an error, the frame and the chip are known.
    assert frame is not None
    assert chosen is not None
    chunks = (chunk for field in fields.values() if field is not None for chunk in chunks_of(field))
    known = Rules(
        tuple(chunks),
        [condition for condition in conditions if condition is not None],
        [rule for rule in rules if rule is not None],
        {name: book for name, book in books.items() if book is not None},
        len(frame.slot_us),
    )
    return Completion(
        problems,
        declared,
        target=chosen,
        frame=frame,
        rules=known,
        planes=planes,
        codes=codes,
        looking=looking,
        pictures=pictures,
    ).run()


def _make_frame(
    statement: EqualSlots | ListedSlots, slots: Meaning, problems: Problems
) -> SlotGrid | None:
    """Return the frame; None if N has an error, or after reporting invalid slot lengths (NS0309).

    `slots` is the meaning of N. Slot lengths are from 1 ps to 10^6 s; at most eight invalid ones
    are reported."""
    times = (statement.length,) if isinstance(statement, EqualSlots) else statement.lengths
    invalid = [time for time in times if not SHORTEST_US <= time.us <= LONGEST_US]
    for time in invalid[:8]:
        text = "zero or negative" if time.us <= 0 else "too short" if time.us < 1 else "too long"
        notes = ("a slot must be between 1 ps and 10^6 s long",)
        problems.error("NS0309", "slot length out of range", time.span, text, notes=notes)
    if invalid or slots.kind != "constant":
        return None
    if isinstance(statement, EqualSlots):
        lengths = (float(statement.length.us),) * slots.value
        count_span = statement.count.span
    else:
        lengths = tuple(float(time.us) for time in times)
        count_span = Span(times[0].span.start, times[-1].span.end)
    return SlotGrid(lengths, len(set(lengths)) == 1, statement.span, count_span)


def ranges_of(source: Source, target: Target, base: Path) -> dict[str, tuple[int, int]]:
    """Return the ranges (low, high) of the fields that a text declares, by name.

    Both ends are included. Codebooks in files are looked up in the folder `base`. Fields with
    errors are left out. Bit fields of more than 62 bits have one range for each chunk."""
    problems = Problems(source)
    declared = gather(parse(source)[0], problems)
    constants = resolve_constants(declared, target, problems)
    books = make_books(declared.books, constants["N"], base, problems)
    fields = make_fields(declared, constants_scope(declared, constants), books, problems)
    chunks = (chunk for field in fields.values() if field is not None for chunk in chunks_of(field))
    return {chunk.name: (chunk.low, chunk.high) for chunk in chunks}


def target_of(declared: Declarations, base: Path, problems: Problems) -> Target | None:
    """Return the chip that a file names, by default scamp5; None after reporting why it cannot be
    loaded.

    `declared.target` is a name or a path of a .toml file, which is relative to the folder `base`.
    """
    from nscc.chips.load import DEFAULT_NAME, load_target

    match declared.target:
        case None:
            return load_target(DEFAULT_NAME, base)
        case TargetByName(name=name):
            text, span = name.text, name.span
        case TargetFromFile(path=path):
            text, span = path.value, path.span
    try:
        return load_target(text, base, source=problems.source, span=span)
    except Rejected as rejected:
        problems.adopt(rejected, span)
        return None


def _refuse_looking(declared: Declarations, target: Target, problems: Problems) -> None:
    """Report the error (NS0510) that this chip has no logic, and raise Rejected.

    The place is the first statement that needs logic: a sense, a state, a reset or a readout of
    states. The program has at least one of them."""
    looking = (*declared.senses.values(), *declared.states.values(), *declared.nexts.values())
    statements = [*looking, *([declared.reset] if declared.reset else [])]
    spans = (
        *(statement.span for statement in statements),
        *(name.span for name in declared.reads.values()),
    )
    place = min(spans, key=lambda span: span.start)
    problems.error(
        "NS0510",
        f"the pixels of {target.name} have no logic: they cannot look at the light or keep states",
        place,
        "needs a processor in every pixel",
        notes=(
            "on this chip, a bit that is known before the exposure routes the light of each slot",
        ),
        helps=(
            "compile for a chip with such pixels: `target scamp5`",
            "or give every pixel a fixed shutter",
        ),
    )
    problems.stop_on_errors()
