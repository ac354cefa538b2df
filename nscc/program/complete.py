"""Completion of valid declarations to a program: codes, decode table, class, advice."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from nscc.arrays import Ints32
from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label, Rejected
from nscc.program.advice import (
    Excess,
    judge_bumps,
    judge_looked_names,
    judge_looking,
    judge_names,
    judge_rules,
    largest_part,
    most_looks,
    shutters_in_the_dark,
)
from nscc.program.classes import Recognised, recognise
from nscc.program.field_planes import Plane, first_pixel, pixel_text
from nscc.program.limits import PROOF_LIMIT, SURVEY_LIMIT
from nscc.program.names import LOOKS, Declarations
from nscc.program.pixel_codes import codes_in_use, rows_of
from nscc.program.problems import Problems, counted
from nscc.program.program import BucketRule, Codes, Program, SlotGrid
from nscc.program.table import (
    UNCOUNTED,
    CodeArray,
    NoValue,
    Rules,
    TooMuch,
    allowed,
    code_text,
    decode,
    legal_codes,
)
from nscc.program.values import judge_values
from nscc.source import Span
from nscc.syntax import tree
from nscc.words.container import DecodeTable
from nscc.words.machine import NO_LOOKS, StateMachine
from nscc.words.pictures import NO_PICTURES, Pictures

if TYPE_CHECKING:
    from nscc.program.looking import Looking


@dataclass(eq=False, repr=False)
class Completion:
    """The second half of the analysis: from valid declarations to codes, shutters, class and
    warnings.

    `frame` has the slots, and `rules` the valid fields, conditions and rules. `codes` is "fixed"
    for the codes in use or "open" for all legal ones. `looking` is None if pixels do not look at
    their light. `planes` has the value of every field at every pixel if the file has `pixels`, else
    it is empty."""

    problems: Problems
    declared: Declarations
    target: Target
    frame: SlotGrid
    rules: Rules
    planes: dict[str, Plane]
    codes: Codes
    looking: Looking | None = None
    pictures: Pictures = NO_PICTURES

    def __post_init__(self) -> None:
        """Find whether pixels have codes (`has_data`), and whether all legal codes are compiled
        ("open") or only those in use ("fixed")."""
        has_pixels, fields = self.declared.has_pixels, self.rules.fields
        # Without fields there is one code, which every pixel has.
        self.has_data = has_pixels or not fields
        self.mode: Codes = self.codes if has_pixels and fields else "open"
        self.buckets = tuple(
            BucketRule(rule.name.text if isinstance(rule, tree.Bucket) else "frame", rule.span)
            for rule in self.declared.rules
        )

    def run(self) -> Program:
        """Return the checked program, with its decode table and its class.

        Raises Rejected for codes that violate `require` (NS0312), rules without a value for some
        code (the code of the fault, such as NS0302), programs without a legal code (NS0317) and too
        many codes (NS0450)."""
        planes = [self.planes[field.name] for field in self.rules.fields] if self.planes else []
        in_use, at_pixel = codes_in_use(planes, (self.target.rows, self.target.cols))
        # The codes of pixels are checked before others, because their error names a pixel.
        if self.has_data and self.rules.fields:
            self._require(in_use, at_pixel)
        if self.looking is not None:
            return self._looking(self.looking, in_use, at_pixel)
        if self.mode == "fixed":
            table = self._decode(in_use, "fixed")
            survey, legal = self._survey(table)
        else:
            codes, at_pixel = self._legal(in_use, at_pixel)
            survey = table = self._decode(codes, "open")
            legal = len(codes)
        problems, declared, fields = self.problems, self.declared, self.rules.fields
        if not fields:
            basis = "for every pixel"
        elif self.mode == "fixed" and survey is table:
            basis = "in the codes that the pixels use"
        else:
            basis = "in all codes that the fields allow"
        recognised = recognise(self.rules, [b.name for b in self.buckets], survey, basis)
        basis = "for every code in use" if self.mode == "fixed" else "for every code"
        judge_rules(
            declared.rules,
            has_fields=bool(fields),
            table=table,
            survey=survey,
            basis=basis,
            problems=problems,
        )
        judge_names(declared, fields, self.rules.rules, self.rules.books, problems)
        judge_values([*self.rules.requires, *self.rules.rules], self._ranges(), problems)
        judge_bumps(recognised, declared.rules[0], survey, problems)
        return self._program(table, legal, at_pixel, recognised)

    def _ranges(self) -> dict[str, tuple[int, int]]:
        """Return the ranges (low, high), both included, of the slot n and of the fields that are
        numbers, by name. Bit fields are left out."""
        fields = [field for field in self.rules.fields if field.bits is None]
        numbers = {field.name: (field.low, field.high) for field in fields}
        return {"n": (0, len(self.frame.slot_us) - 1), **numbers}

    def _judge_looked_values(self, looking: Looking) -> None:
        """Warn about comparisons in the rules, `reset when` and `next` of a program whose pixels
        look at their light."""
        slots, looks = len(self.frame.slot_us), len(looking.looks)
        states = {s.name: (s.low, s.high) for s in looking.states if not s.boolean}
        ranges = {**self._ranges(), **states, LOOKS: (0, looks)}
        nexts = [e for e in looking.expressions if e is not looking.reset]
        in_slots = [e for e in (*self.rules.rules, looking.reset) if e is not None]
        judge_values([*self.rules.requires, *in_slots], ranges, self.problems)
        # A state changes at a boundary, and after at least one look.
        judge_values(nexts, {**ranges, "n": (1, slots), LOOKS: (1, looks)}, self.problems)

    def _looking(self, looking: Looking, in_use: CodeArray, at_pixel: Ints32) -> Program:
        """Return the program if its pixels look at their light: with a state machine instead of
        fixed shutters.

        `in_use` are the codes of pixels (codes, fields) and `at_pixel` their rows, (rows, cols).
        `looking` has the checked senses and states. Raises Rejected for rules without a value (with
        the error code of the fault, such as NS0302) or a machine that is too large (NS0450)."""
        from nscc.program.machine import MachineBuilder
        from nscc.program.open_time import with_open_times

        # "open" compiles all legal codes, "fixed" only those that pixels have.
        codes, legal = in_use, None
        if self.mode == "open":
            codes, at_pixel = self._legal(in_use, at_pixel)
            legal = len(codes)
        try:
            machine, behaviour = MachineBuilder(self.rules, looking, codes, self.target).build()
        except NoValue as problem:
            raise self._refused(problem, self.declared.rules[0].rule.span) from problem
        except TooMuch as problem:
            fields = [field.name for field in self.rules.fields]
            excess = largest_part(self.declared, looking, fields, codes)
            if fields:
                excess.helps.extend(
                    [*self._fewer_codes(self.mode), "reduce the ranges of the fields"]
                )
            raise self._too_much_looked(problem, excess) from problem
        try:
            machine, untold = with_open_times(machine, self.frame.slot_us)
        except TooMuch as problem:
            raise self._too_much_looked(problem, most_looks(self.declared, looking)) from problem
        # Warnings about names and values that have no effect come last.
        problems, rules = self.problems, self.rules
        judge_looking(self.declared, machine, untold, self.target, problems)
        judge_looked_names(self.declared, looking, rules.rules, machine, problems)
        expressions = [*rules.rules, *looking.expressions]
        judge_names(self.declared, rules.fields, expressions, rules.books, problems)
        self._judge_looked_values(looking)
        self.problems.stop_on_errors()
        names = tuple(field.name for field in self.rules.fields)
        table = DecodeTable(names, codes, behaviour, shutters_in_the_dark(machine))
        looks = counted(len(machine.looks), "boundary", "boundaries")
        reason = f"pixels look at the light at {looks}"
        return self._program(table, legal, at_pixel, Recognised("looking", reason), machine)

    def _program(
        self,
        table: DecodeTable,
        legal: int | None,
        at_pixel: Ints32,
        recognised: Recognised,
        machine: StateMachine = NO_LOOKS,
    ) -> Program:
        """Return the checked program.

        `legal` is the number of codes that `require` allows, None if it was not counted. `table`
        has the compiled codes and their shutters. `at_pixel` (rows, cols) are the rows of `table`
        that pixels use; `recognised` is the class. `machine` is the state machine if pixels look at
        their light."""
        target_span = None
        match self.declared.target:
            case tree.TargetByName(name=place) | tree.TargetFromFile(path=place):
                target_span = place.span
        return Program(
            source=self.problems.source,
            target=self.target,
            target_span=target_span,
            frame=self.frame,
            fields=self.rules.fields,
            buckets=self.buckets,
            mode=self.mode,
            table=table,
            legal_codes=legal,
            pixel_codes=at_pixel if self.has_data else None,
            class_name=recognised.name,
            class_reason=recognised.reason,
            messages=self.problems.sorted(),
            machine=machine,
            pictures=self.pictures,
        )

    def _require(self, in_use: CodeArray, at_pixel: Ints32) -> None:
        """Check that `require` allows the code of every pixel.

        `in_use` are the codes (codes, fields) and `at_pixel` each pixel's row, (rows, cols). Raises
        Rejected: the fault of a condition without a value (such as NS0302), NS0450 for too much
        work, else NS0312, which names the first pixel and the first condition that forbids its
        code."""
        try:
            legal = allowed(self.rules, in_use)
        except (NoValue, TooMuch) as problem:
            raise self._refused(problem, self.declared.requires[0].condition.span) from problem
        if legal.all():
            return
        breaking = ~legal[at_pixel]
        y, x = first_pixel(breaking)
        count = int(breaking.sum())
        code = in_use[at_pixel[y, x]]
        statements: list[tree.Node] = list(self.declared.pixels.values())
        if self.declared.pixels_file is not None:
            statements.append(self.declared.pixels_file)
        conditions = zip(self.declared.requires, self.rules.requires, strict=True)
        # The message shows the first condition that forbids this code.
        broken = next(
            statement
            for statement, condition in conditions
            if not allowed(replace(self.rules, requires=[condition]), code[None, :])[0]
        )
        self.problems.error(
            "NS0312",
            f"the {pixel_text(x, y)} has {code_text(self.rules, code)}, which `require` forbids",
            min((s.span for s in statements), key=lambda span: span.start),
            f"{counted(count, 'pixel breaks', 'pixels break')} it",
            related=(Label(broken.condition.span, "the condition"),),
            data={"x": x, "y": y, "pixels": count},
        )
        self.problems.stop_on_errors()

    def _decode(self, codes: CodeArray, mode: Codes) -> DecodeTable:
        """Return the decode table of these codes (codes, fields), which are sorted and distinct;
        `mode` says whether they are all legal ones ("open").

        Raises Rejected for rules without a value for some code, or too many codes."""
        try:
            return decode(self.rules, codes)
        except (NoValue, TooMuch) as problem:
            raise self._refused(problem, self._limit_span(), mode) from problem

    def _legal(self, in_use: CodeArray, at_pixel: Ints32) -> tuple[CodeArray, Ints32]:
        """Return all codes that `require` allows, int64 (codes, fields), and each pixel's row of
        them, (rows, cols).

        `in_use` and `at_pixel` are the codes of pixels (codes, fields) and their rows. Without
        pixel values or fields, the second result is `at_pixel` as it is. Raises Rejected (NS0317)
        if no code is allowed, for a `require` without a value, and for too many codes."""
        try:
            legal = legal_codes(self.rules)
        except (NoValue, TooMuch) as problem:
            raise self._refused(problem, self._limit_span(), "open") from problem
        if len(legal) == 0:
            conditions = self.declared.requires
            text = "together with the other conditions"
            if len(conditions) == 1:
                combinations = counted(self.rules.combinations, "combination")
                text = f"false for {combinations} of field values"
            message = "`require` excludes every code"
            self.problems.error("NS0317", message, conditions[0].condition.span, text)
            self.problems.stop_on_errors()
        if self.declared.has_pixels and self.rules.fields:
            rows, _ = rows_of(legal, list(in_use.T))
            at_pixel = rows[at_pixel]
        return legal, at_pixel

    def _survey(self, table: DecodeTable) -> tuple[DecodeTable, int | None]:
        """Return the table from which the class is determined, and the number of legal codes.

        The table has all legal codes if there are few, else it is `table`, the used codes. The
        number is None if it cannot be determined quickly, or `require` has no value for some code.
        """
        rules = self.rules
        total = rules.combinations
        legal = None if rules.requires or total >= UNCOUNTED else total
        if total > SURVEY_LIMIT:
            return table, legal
        try:
            codes = legal_codes(rules)
            legal = len(codes)
            if legal * len(rules.rules) * rules.slots <= SURVEY_LIMIT:
                return decode(rules, codes), legal
        except (NoValue, TooMuch):
            # If only the codes in use are compiled, codes that no pixel has are not checked.
            pass
        return table, legal

    def _refused(self, problem: NoValue | TooMuch, span: Span, mode: Codes = "fixed") -> Rejected:
        """Report the problem and return the exception with all diagnostics so far, for the caller
        to raise.

        `mode` is "open" if all legal codes are compiled. TooMuch becomes NS0450 at `span`; NoValue
        becomes one error for each missing value."""
        if isinstance(problem, TooMuch):
            reduce_help = "reduce the ranges of the fields, or use fewer slots"
            if problem.available == PROOF_LIMIT:
                most = PROOF_LIMIT // (self.rules.slots * len(self.rules.rules))
                slots = counted(self.rules.slots, "slot")
                reduce_help += f": nscc proves at most {most} codes of {slots}"
            self.problems.error(
                "NS0450",
                f"too many codes and slots: {problem.message}",
                span,
                "needs this many",
                related=(Label(self.frame.count_span, "the slots"),),
                helps=(*self._fewer_codes(mode), reduce_help),
                data=_proved(problem),
            )
        else:
            for finding in problem.findings:
                notes, data = (finding.text,), {"count": finding.count}
                finding.fault.report(self.problems, notes=notes, data=data)
        return Rejected(self.problems.sorted())

    def _too_much_looked(self, problem: TooMuch, excess: Excess) -> Rejected:
        """Return the exception (NS0450) for a state machine that is too large, for the caller to
        raise.

        Its place is the statement that multiplies the size most (`excess.place`); without one, the
        field with the widest range."""
        self.problems.error(
            "NS0450",
            f"too many codes, states and answers: {problem.message}",
            excess.place or self._limit_span(),
            excess.text,
            helps=tuple(excess.helps),
            data=_proved(problem),
        )
        return Rejected(self.problems.sorted())

    def _fewer_codes(self, mode: Codes) -> list[str]:
        """Return helps on compiling fewer codes, if `mode` and the program allow it.

        `mode` is "open" if all legal codes are compiled. The list is empty otherwise, and without
        fields."""
        if mode != "open" or not self.rules.fields:
            return []
        if self.declared.has_pixels:
            return ["`--codes fixed` compiles only the codes that the pixels use"]
        return ["add the pixel values: then nscc compiles only the used codes"]

    def _limit_span(self) -> Span:
        """Return the place to change if there are too many codes: the field with the widest range,
        else the frame.

        Of fields with equal ranges it is the first."""
        if not self.rules.fields:
            return self.frame.count_span
        return max(self.rules.fields, key=lambda f: f.high - f.low).span


def _proved(problem: TooMuch) -> dict[str, object]:
    """Return the data of the error NS0450, for programs that read messages: what is needed and
    available, and that no search could help."""
    return {
        "resource": "proof",
        "required": problem.required,
        "available": problem.available,
        "proved": True,
    }
