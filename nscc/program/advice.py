"""Warnings and notes about valid programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nscc.program.classes import Recognised
from nscc.program.evaluate import Books
from nscc.program.expressions import Checked, names_in
from nscc.program.names import Declarations, Rule
from nscc.program.problems import Problems, counted
from nscc.program.program import Field
from nscc.syntax import tree
from nscc.words.container import DecodeTable


def judge_rules(
    rules: Sequence[Rule],
    has_fields: bool,
    table: DecodeTable,
    survey: DecodeTable,
    basis: str,
    problems: Problems,
) -> None:
    """Warn about rules that never open (NS0350) and, if there are fields, always open (NS0351).

    Rules that never open are found among the compiled codes (`table`, described by `basis`),
    because the frame would stay dark. Rules that always open are found among the codes in `survey`
    (all codes if there are few), because the used codes may need long exposures. A bucket that is
    always open beside coded buckets is an ordinary exposure of the same scene, and is not reported.
    """
    for k, rule in enumerate(rules):
        shutters = table.shutters[:, k, :]
        who = f"the bucket `{rule.name.text}`" if isinstance(rule, tree.Bucket) else "the shutter"
        if not shutters.any():
            text = f"false in every slot, {basis}" if has_fields else "false in every slot"
            problems.warning("NS0350", f"{who} never opens", rule.rule.span, text)
        elif has_fields and survey.shutters.all():
            message = f"{who} is always open, whatever the code"
            camera = ("for an ordinary camera write `open when true` without fields",)
            helps = () if isinstance(rule, tree.Bucket) else camera
            problems.warning("NS0351", message, rule.rule.span, "true in every slot", helps=helps)


def judge_names(
    declared: Declarations,
    fields: Sequence[Field],
    rules: Sequence[Checked],
    books: Books,
    problems: Problems,
) -> None:
    """Warn about fields that no rule reads (NS0352); note unused lets and codebooks (NS0355).

    `rules` are all expressions that shutters depend on; a sense's level may also be a field."""
    read = _names_read(declared)
    in_rules = frozenset[str]().union(*(rule.variables for rule in rules))
    in_rules |= {s.level.text for s in declared.senses.values() if isinstance(s.level, tree.Name)}
    for field in fields:
        if not field.first_bit and field.name not in in_rules:
            place = declared.codes[field.name].name.span
            why = "all its values give the same shutter"
            problems.warning("NS0352", f"no rule depends on the field `{field.name}`", place, why)
    for name, let in declared.lets.items():
        if name not in read:
            problems.note("NS0355", f"`{name}` is not used", let.name.span, "not used")
    in_rules_or_fields = {book for rule in rules for book in rule.books}
    in_rules_or_fields |= {field.book for field in fields if field.book is not None}
    for name in books:
        if name not in in_rules_or_fields:
            place = declared.books[name].name.span
            problems.note("NS0355", f"the codebook `{name}` is not used", place, "not used")


def judge_bumps(shape: Recognised, rule: Rule, table: DecodeTable, problems: Problems) -> None:
    """Warn about bumps of fixed length that the end of the frame cuts (NS0354)."""
    if shape.name == "c" and shape.cut:
        problems.warning(
            "NS0354",
            f"{counted(shape.cut, 'shutter has', 'shutters have')} a bump that the end of "
            "the frame cuts short",
            rule.rule.span,
            f"a frame has the slots 0..{table.shutters.shape[2] - 1}",
            notes=(shape.reason,),
            helps=("limit the starts to N - len: `code start : 0..N - len`",),
        )


def _names_read(declared: Declarations) -> set[str]:
    """Return every name in the expressions of the file."""
    exprs: list[tree.Expr] = [let.value for let in declared.lets.values()]
    exprs += [r.condition for r in declared.requires]
    exprs += [r.rule for r in declared.rules]
    if isinstance(declared.frame, tree.EqualSlots):
        exprs.append(declared.frame.count)
    for code in declared.codes.values():
        if isinstance(code, tree.CodeRange):
            exprs += [code.low, code.high]
        elif isinstance(code, tree.CodeBits):
            exprs.append(code.count)
    for pixels in declared.pixels.values():
        if isinstance(pixels, tree.PixelsExpr):
            exprs.append(pixels.value)
        elif isinstance(pixels, tree.PixelsTile):
            values = (value for row in pixels.rows for value in row.values)
            exprs += [value for value in values if not isinstance(value, tree.Int)]
    exprs += _looked_at(declared)
    return {name.text for expr in exprs for name in names_in(expr)}


def _looked_at(declared: Declarations) -> Iterator[tree.Expr]:
    """Yield the expressions in statements of language version 2."""
    for sense in declared.senses.values():
        yield sense.at
        levels = sense.level.items if isinstance(sense.level, tree.Levels) else (sense.level,)
        yield from (level for level in levels if not isinstance(level, tree.Amount | tree.Levels))
    for state in declared.states.values():
        yield state.start
        if isinstance(state, tree.StateRange):
            yield from (state.low, state.high)
    for step in declared.nexts.values():
        yield step.value
        if step.condition is not None:
            yield step.condition
    if declared.reset is not None:
        yield declared.reset.condition
