"""The names that are visible in each part of a program, and the values of its constants."""

from __future__ import annotations

from contextlib import suppress
from graphlib import CycleError, TopologicalSorter

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label
from nscc.program.evaluate import Fault, evaluate
from nscc.program.expressions import FAILED, VARIABLE, Meaning, Scope, Type, check, names_in
from nscc.program.limits import MOST_SLOTS
from nscc.program.names import LOOKS, PREDEFINED, Declarations
from nscc.program.problems import Problems, clipped
from nscc.source import Span
from nscc.syntax.tree import CodeBits, EqualSlots, Expr, ListedSlots, StateBit

_SLOT = "n is the slot: only rules may use it"
_PLACE = "x and y are the position of a pixel: only `pixels FIELD = ...` may use them"
_PLACE_IN_RULE = (
    "pixels differ only in their codes: declare a `code` field, set it with `pixels FIELD = "
    "...` from x and y, and use the field in the rule"
)
_FIELD = "a field has a value only in rules and in `require`"
_FIELD_IN_PIXELS = (
    "the pixel values of a field are computed from x, y, rows and cols, not from other fields"
)
_LOOKED = "a sense or a state has a value only in rules, in `next` and in `reset when`"
_KEPT_PLANE = "a state that steps on images and planes has a value only after the last slot"
_PARAM = (
    "the host sets a parameter: only levels of comparisons, counts of `repeat` and offsets of "
    "shifts may use it; for what differs between pixels, declare `input plane NAME`"
)
_BOOK = "only rules may use the digits of a codebook"


def constants_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that `let`, ranges, counts and tiles may use: constants.

    `constants` has the meanings of N, rows, cols and `let` names. All other names of the program
    are included as "misplaced", with the explanation for an error. Names whose declaration has an
    error are "failed"."""
    scope = {
        "n": Meaning("misplaced", note=_SLOT),
        "x": Meaning("misplaced", note=_PLACE),
        "y": Meaning("misplaced", note=_PLACE),
    }
    scope.update(dict.fromkeys(declared.codes, Meaning("misplaced", note=_FIELD)))
    scope.update(dict.fromkeys(declared.books, Meaning("misplaced", note=_BOOK)))
    if declared.version > 1:
        looked = (*declared.senses, *declared.states, LOOKS)
        note = _KEPT_PLANE if declared.keeps_planes else _LOOKED
        scope.update(dict.fromkeys(looked, Meaning("misplaced", note=note)))
    scope.update(dict.fromkeys(declared.params, Meaning("misplaced", note=_PARAM)))
    scope.update(constants)
    return _without_refused(scope, declared)


def pixels_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that `pixels FIELD = EXPR` may use: constants, x and y.

    `constants` has the meanings of N, rows, cols and `let` names. Other names are included as
    "misplaced", with the explanation for an error."""
    scope = constants_scope(declared, constants)
    scope.update(x=VARIABLE, y=VARIABLE)
    scope.update(dict.fromkeys(declared.codes, Meaning("misplaced", note=_FIELD_IN_PIXELS)))
    return _without_refused(scope, declared)


def require_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that `require` may use: constants and fields.

    `constants` has the meanings of N, rows, cols and `let` names. Other names are included as
    "misplaced", with the explanation for an error."""
    scope = constants_scope(declared, constants)
    scope.update(dict.fromkeys(("x", "y"), Meaning("misplaced", note=_PLACE_IN_RULE)))
    for name, statement in declared.codes.items():
        bits = isinstance(statement, CodeBits)
        scope[name] = Meaning("variable", bits=bits, wide=name in declared.wide)
    return _without_refused(scope, declared)


def rule_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that rules may use: constants, fields, codebooks, the slot n, states and
    senses.

    Other names (x and y) are "misplaced", with the explanation for an error."""
    scope = next_scope(declared, constants)
    scope.update(dict.fromkeys(declared.books, Meaning("book")))
    return _without_refused(scope, declared)


def next_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that `next` and `reset when` may use: constants, fields, n, senses, states
    and `looks`.

    Other names, such as codebooks, are "misplaced", with the explanation for an error. If states
    change with images, they are misplaced, too."""
    scope = require_scope(declared, constants)
    scope["n"] = VARIABLE
    if declared.version > 1:
        scope[LOOKS] = VARIABLE
        scope.update(dict.fromkeys(declared.senses, Meaning("variable", type="boolean")))
        for name, state in () if declared.keeps_planes else declared.states.items():
            type_: Type = "boolean" if isinstance(state, StateBit) else "integer"
            scope[name] = Meaning("variable", type=type_)
    return _without_refused(scope, declared)


def at_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the names that the boundaries of a sense may use: constants and the boundary n.

    Other names are "misplaced", with the explanation for an error."""
    scope = constants_scope(declared, constants)
    scope["n"] = VARIABLE
    return _without_refused(scope, declared)


def _without_refused(scope: dict[str, Meaning], declared: Declarations) -> dict[str, Meaning]:
    """Mark names whose declarations have errors as "failed", so that they cause no further
    messages.

    Predefined names stay as they are. The scope is changed and returned."""
    scope.update(dict.fromkeys(declared.refused - PREDEFINED.keys() - {LOOKS}, FAILED))
    return scope


_MOST_CYCLES = 20
"""Most cyclic definitions reported for one program."""


def constant(expr: Expr, scope: Scope, problems: Problems, role: str) -> int | None:
    """Return the value of an integer expression of constants; None after reporting an error.

    `scope` must contain no variables. Among the errors are wrong names and types, a division by
    zero, and numbers beyond 2^62 - 1. `role` names the expression in the error, such as "the start
    of a range"."""
    checked = check(expr, "integer", scope, problems, role)
    if checked is None:
        return None
    value = evaluate(checked, {}, {})
    if isinstance(value.faults, Fault):
        value.faults.report(problems)
        return None
    return int(value.data)


def resolve_constants(
    declared: Declarations, target: Target | None, problems: Problems
) -> dict[str, Meaning]:
    """Return the meaning of N, rows, cols and every `let`, by name; those with errors are "failed".

    rows and cols come from `target`, and are "failed" if it is None. Reports cycles (NS0203) and a
    number of slots outside 1..MOST_SLOTS (NS0308)."""
    return _Resolver(declared, target, problems).run()


class _Resolver:
    """Computes the values of all `let` constants and of N, each after those that it needs.

    `known` has the meanings so far, and `scope` the names that the next expression may use."""

    def __init__(self, declared: Declarations, target: Target | None, problems: Problems) -> None:
        """Collect the expressions of constants; rows and cols come from the target, and are
        "failed" without one."""
        self.declared = declared
        self.problems = problems
        self.known: dict[str, Meaning] = {"rows": FAILED, "cols": FAILED, "N": FAILED}
        if target is not None:
            self.known["rows"] = Meaning("constant", target.rows)
            self.known["cols"] = Meaning("constant", target.cols)
        self.exprs: dict[str, tuple[Expr, Span]] = {
            name: (let.value, let.name.span) for name, let in declared.lets.items()
        }
        if isinstance(declared.frame, EqualSlots):
            self.exprs["N"] = (declared.frame.count, declared.frame.count.span)

    def run(self) -> dict[str, Meaning]:
        """Return the meaning of all constants by name; report up to `_MOST_CYCLES` cycles.

        Constants in a cycle, and those that depend on it, are "failed"."""
        self.scope = constants_scope(self.declared, self.known)
        if isinstance(self.declared.frame, ListedSlots):
            self._set_slots(len(self.declared.frame.lengths), self.declared.frame.span)
        needs = {
            name: [k.text for k in names_in(expr) if k.text in self.exprs]
            for name, (expr, _) in self.exprs.items()
        }
        waiting = dict.fromkeys(self.exprs)
        # Each round resolves all names outside of cycles, then reports one cycle and drops it.
        for _ in range(_MOST_CYCLES):
            order = TopologicalSorter(
                {name: [need for need in needs[name] if need in waiting] for name in waiting}
            )
            with suppress(CycleError):  # the names outside of cycles are resolved all the same
                order.prepare()
            while ready := order.get_ready():
                for name in ready:
                    expr, span = self.exprs[name]
                    role = "the number of slots" if name == "N" else "a let"
                    value = constant(expr, self.scope, self.problems, role)
                    if value is None:
                        self._set_meaning(name, FAILED)
                    elif name == "N":
                        self._set_slots(value, span)
                    else:
                        self._set_meaning(name, Meaning("constant", value))
                    del waiting[name]
                order.done(*ready)
            if not waiting:
                return self.known
            cycle = _cycle(needs, waiting)
            self._report(cycle)
            for name in cycle:
                self._set_meaning(name, FAILED)
                del waiting[name]
        for name in waiting:
            self._set_meaning(name, FAILED)
        return self.known

    def _set_slots(self, count: int, span: Span) -> None:
        """Set N to `count`; report an error (NS0308) at `span` if it is not in 1..MOST_SLOTS; then
        N is "failed"."""
        if 1 <= count <= MOST_SLOTS:
            self._set_meaning("N", Meaning("constant", count))
            return
        self._set_meaning("N", FAILED)
        message = f"invalid number of slots: {clipped(count)}"
        self.problems.error("NS0308", message, span, f"a frame has 1 to {MOST_SLOTS} slots")

    def _set_meaning(self, name: str, meaning: Meaning) -> None:
        """Store the meaning of a name.

        A name whose declaration has an error stays "failed" in the scope, so that its use is not
        reported."""
        self.known[name] = meaning
        if name not in self.declared.refused or name == "N":
            self.scope[name] = meaning

    def _report(self, cycle: list[str]) -> None:
        """Report (NS0203) that the names of `cycle` depend on each other in a cycle. Each of
        `cycle` needs the next, and the last needs the first."""
        shown = [*cycle, cycle[0]] if len(cycle) <= 8 else [*cycle[:4], "...", cycle[-1], cycle[0]]
        chain = " -> ".join(shown)
        first, *following = cycle
        self.problems.error(
            "NS0203",
            f"`{first}` is defined by itself: {chain}",
            self.exprs[first][1],
            "depends on its own value",
            related=tuple(
                Label(self.exprs[name][1], f"`{name}` is part of the circle")
                for name in following[:8]
            ),
            helps=("give one of them a number",),
        )


def _cycle(needs: dict[str, list[str]], waiting: dict[str, None]) -> list[str]:
    """Return names that depend on each other in a cycle, found from the first `waiting` name, in
    the order of dependence.

    `needs` has the names that each name needs. Every waiting name needs another one."""
    path: dict[str, None] = {}
    name = next(iter(waiting))
    while name not in path:
        path[name] = None
        name = next(need for need in needs[name] if need in waiting)
    order = list(path)
    return order[order.index(name) :]
