"""The names that are visible in each part of a program, and their meanings."""

from __future__ import annotations

from nscc.program.expressions import FAILED, VARIABLE, Meaning, Scope, Type
from nscc.program.names import LOOKS, PREDEFINED, Declarations
from nscc.syntax.tree import CodeBits, StateBit

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
_BOOK = "only rules may use the digits of a codebook"


def constants_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the scope of `let`, ranges, counts and tiles: constants; other names have
    explanations."""
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
    scope.update(constants)
    return _without_refused(scope, declared)


def pixels_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the scope of `pixels FIELD = EXPR`: constants, x and y."""
    scope = constants_scope(declared, constants)
    scope.update(x=VARIABLE, y=VARIABLE)
    scope.update(dict.fromkeys(declared.codes, Meaning("misplaced", note=_FIELD_IN_PIXELS)))
    return _without_refused(scope, declared)


def require_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the scope of `require`: constants and fields."""
    scope = constants_scope(declared, constants)
    scope.update(dict.fromkeys(("x", "y"), Meaning("misplaced", note=_PLACE_IN_RULE)))
    for name, statement in declared.codes.items():
        bits = isinstance(statement, CodeBits)
        scope[name] = Meaning("variable", bits=bits, wide=name in declared.wide)
    return _without_refused(scope, declared)


def rule_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the scope of rules: constants, fields, codebooks, the slot n, states and answers."""
    scope = next_scope(declared, constants)
    scope.update(dict.fromkeys(declared.books, Meaning("book")))
    return _without_refused(scope, declared)


def next_scope(declared: Declarations, constants: Scope) -> dict[str, Meaning]:
    """Return the scope of `next` and `reset when`: constants, fields, n, senses, states, looks."""
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
    """Return the scope of the boundaries of a sense: constants and the boundary n."""
    scope = constants_scope(declared, constants)
    scope["n"] = VARIABLE
    return _without_refused(scope, declared)


def _without_refused(scope: dict[str, Meaning], declared: Declarations) -> dict[str, Meaning]:
    scope.update(dict.fromkeys(declared.refused - PREDEFINED.keys() - {LOOKS}, FAILED))
    return scope
