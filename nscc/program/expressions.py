"""Checks of the names and types of expressions, without evaluation.

There are two types, integer and boolean, which do not mix. An expression is checked in one pass
over its nodes in evaluation order, by a loop instead of recursion, so that a chain of ten thousand
operators is no problem."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal, assert_never

from nscc.program.problems import Problems, clipped
from nscc.source import Span
from nscc.syntax import tree

Type = Literal["integer", "boolean"]

LIMIT = tree.MOST_INTEGER

MinMax = ("min", "max")


@dataclass(eq=False, repr=False)
class Meaning:
    """The meaning of a name in some part of a program.

    A `constant` has a `value`. A `variable` differs between codes, slots or pixels; `bits` means
    that it may be indexed, and `wide` that it has too many bits for a number. `book` is a codebook.
    `failed` means that an error is already reported. `misplaced` means that the name is known but
    not allowed here, for the reason `note`. `type` is the type of a variable."""

    kind: Literal["constant", "variable", "book", "failed", "misplaced"]
    value: int = 0
    note: str = ""
    bits: bool = False
    wide: bool = False
    type: Type = "integer"


Scope = Mapping[str, Meaning]
FAILED = Meaning("failed")
VARIABLE = Meaning("variable")


@dataclass(eq=False, repr=False)
class Checked:
    """An expression with valid names and types.

    `nodes` are in evaluation order, operands before their operator; the last is the expression
    itself, of the given `type`. `constants` contains the values of constant names. `variables` are
    the fields and n, x, y that it reads, `books` its codebooks."""

    nodes: tuple[tree.Expr, ...]
    type: Type
    constants: Mapping[str, int]
    variables: frozenset[str]
    books: frozenset[str]


def operands(node: tree.Expr) -> tuple[tree.Expr, ...]:
    """Return the direct subexpressions of a node of the syntax tree in evaluation order.

    The name before brackets, of a codebook or bit field, is not an operand."""
    match node:
        case tree.Int() | tree.Bool() | tree.Name():
            return ()
        case tree.Unary():
            return (node.operand,)
        case tree.Binary():
            return (node.left, node.right)
        case tree.Compare():
            return (node.first, *node.later_operands)
        case tree.IfElse():
            return (node.condition, node.then, node.otherwise)
        case tree.Index():
            return (node.index,)
        case tree.Call():
            return node.arguments
        case tree.Place():
            return (node.right, node.down)
        case tree.Amount():
            return ()
    assert_never(node)


def in_evaluation_order(expr: tree.Expr) -> tuple[tree.Expr, ...]:
    """Return every node of the syntax tree of `expr`, each after its operands, left before
    right."""
    backwards: list[tree.Expr] = []
    waiting = [expr]
    while waiting:
        node = waiting.pop()
        backwards.append(node)
        waiting.extend(operands(node))
    return tuple(reversed(backwards))


def names_in(expr: tree.Expr) -> Iterator[tree.Name]:
    """Yield every name in `expr`, including those of indexed books and bit fields.

    The order is that of evaluation; a name that occurs twice is yielded twice. Names of functions
    are not included."""
    for node in in_evaluation_order(expr):
        if isinstance(node, tree.Name):
            yield node
        elif isinstance(node, tree.Index):
            yield node.base


def nodes_in(statement: tree.Statement) -> Iterator[tree.Node]:
    """Yield a statement and all nodes of the syntax tree inside it, in any order; names and numbers
    are nodes, too."""
    waiting: list[tree.Node] = [statement]
    while waiting:
        node = waiting.pop()
        yield node
        # Field 0 is the span, which is no node.
        for name in node.field_names[1:]:
            value = getattr(node, name)
            members = value if isinstance(value, tuple) else (value,)
            waiting += [member for member in members if isinstance(member, tree.Node)]


def check(
    expr: tree.Expr, expected: Type, scope: Scope, problems: Problems, role: str
) -> Checked | None:
    """Return an expression with its names and types checked; None after reporting errors.

    `expected` is the required type of `expr`; another type is reported (NS0301). `role` names it in
    messages ("a rule", "the end of a range"). Names that are "failed" in `scope` make the result
    None without a further report."""
    return _Checker(scope, problems).run(expr, expected, role)


class _Checker:
    """Checks one expression and collects the names that it reads; `sound` becomes False at an
    error."""

    def __init__(self, scope: Scope, problems: Problems) -> None:
        """Begin with the names in `scope`, which this kind of expression may use; errors go to
        `problems`."""
        self.scope = scope
        self.problems = problems
        self.sound = True
        self.constants: dict[str, int] = {}
        self.variables: set[str] = set()
        self.books: set[str] = set()

    def run(self, expr: tree.Expr, expected: Type, role: str) -> Checked | None:
        """Return the checked expression; None after reporting errors.

        It is called once for a checker. `role` names the expression in messages, for example "a
        shutter rule"; `expected` is its type."""
        nodes = in_evaluation_order(expr)
        types: list[Type | None] = []
        for node in nodes:
            count = len(operands(node))
            operand_types = types[len(types) - count :]
            del types[len(types) - count :]
            types.append(self._type(node, operand_types))
        actual = types[0]  # of the whole expression, the only type that is left
        if actual is not None and actual != expected:
            message = f"{role} must be {_a(expected)}, not {_a(actual)}"
            self._mismatch(expr.span, message, _a(actual), _CONVERT[expected])
        if not self.sound or actual is None:
            return None
        return Checked(
            nodes, actual, self.constants, frozenset(self.variables), frozenset(self.books)
        )

    def _type(self, node: tree.Expr, operand_types: list[Type | None]) -> Type | None:
        """Return the type of a node of the syntax tree from the types of its operands, and report
        errors in it.

        `operand_types` are in the order of `operands`, None for unknown ones. Return None if the
        type is unknown after an error."""
        match node:
            case tree.Int():
                if node.value > LIMIT:
                    message = f"the number {clipped(node.value)} is too large"
                    self._error("NS0305", message, node.span, "numbers go up to 2^62 - 1")
                return "integer"
            case tree.Bool():
                return "boolean"
            case tree.Name():
                return self._name(node)
            case tree.Unary():
                expected: Type = "boolean" if node.op == "not" else "integer"
                self._expect(expected, operand_types, [node.operand], f"`{node.op}`")
                return expected
            case tree.Binary():
                expected = "boolean" if node.op in ("and", "or", "xor") else "integer"
                self._expect(expected, operand_types, [node.left, node.right], f"`{node.op}`")
                return expected
            case tree.Compare():
                self._compare(node, operand_types)
                return "boolean"
            case tree.IfElse():
                self._expect(
                    "boolean", operand_types[:1], [node.condition], "the condition after `if`"
                )
                return self._branches(node, operand_types[1], operand_types[2])
            case tree.Index():
                self._expect("integer", operand_types, [node.index], "an index")
                self._base(node.base)
                return "boolean"
            case tree.Call():
                name = node.function.text
                if name not in MinMax:
                    self._unknown(node.function, "a function", MinMax)
                    return None
                self._expect("integer", operand_types, node.arguments, f"`{name}`")
                return "integer"
            case tree.Place() | tree.Amount():
                text = "a level" if isinstance(node, tree.Amount) else "a bit of a neighbour"
                self._error("NS0531", f"{text} is no integer", node.span, text)
                return None
        assert_never(node)

    def _name(self, node: tree.Name) -> Type | None:
        """Return the type of a name, and record it as constant or variable; None after an error.

        A name that is "failed" gives None without a report. `_Checker._base` handles names before
        brackets."""
        meaning = self.scope.get(node.text)
        if meaning is None:
            kinds = ("constant", "variable", "failed")
            readable = [name for name, m in self.scope.items() if m.kind in kinds]
            self._unknown(node, "anything that can stand here", readable)
            return None
        match meaning.kind:
            case "constant":
                self.constants[node.text] = meaning.value
                return "integer"
            case "variable":
                self.variables.add(node.text)
                if meaning.wide:
                    self._error(
                        "NS0513",
                        f"`{node.text}` has too many bits for arithmetic",
                        node.span,
                        "a bit field of more than 62 bits",
                        helps=(f"read single bits: `{node.text}[n]`",),
                    )
                return meaning.type
            case "failed":
                self.sound = False
                return None
            case "misplaced":
                self._misplaced(node, meaning)
                return None
            case "book":
                message = f"`{node.text}` is a codebook and needs an index"
                helps = (f"`{node.text}[id]` is digit n of row id, a boolean",)
                self._error("NS0209", message, node.span, "a whole codebook", helps=helps)
                return None
        assert_never(meaning.kind)

    def _base(self, base: tree.Name) -> None:
        """Check that a name before brackets is a codebook or a bit field, and record that it is
        read.

        Anything else is reported (NS0209, or as an unknown name)."""
        meaning = self.scope.get(base.text)
        if meaning is None:
            indexable = [k for k, m in self.scope.items() if m.kind == "book" or m.bits]
            self._unknown(base, "a codebook or bit field", indexable)
        elif meaning.kind == "book":
            self.books.add(base.text)
            self.variables.add("n")
        elif meaning.kind == "variable" and meaning.bits:
            self.variables.add(base.text)
        elif meaning.kind == "failed":
            self.sound = False
        elif meaning.kind == "misplaced":
            self._misplaced(base, meaning)
        else:
            message = f"`{base.text}` cannot be indexed"
            label = "neither a bit field nor a codebook"
            helps = (
                "`NAME[i]` needs a field declared as `code NAME : bit[K]`",
                "`BOOK[id]` needs a codebook declared with `shutters`",
            )
            self._error("NS0209", message, base.span, label, helps=helps)

    def _compare(self, node: tree.Compare, operand_types: list[Type | None]) -> None:
        """Check a chain of comparisons such as `a < b == c` and report wrong operands.
        `operand_types` are those of all operands from left to right; an unknown type (None) is not
        reported.

        `==` and `!=` compare two integers or two booleans; other comparisons need integers."""
        compared = [node.first, *node.later_operands]
        for k, op in enumerate(node.ops):
            first_type, second_type = operand_types[k], operand_types[k + 1]
            if op not in ("==", "!="):
                # A part in the middle of a chain is reported by the comparison on its left.
                first = k if k == 0 or node.ops[k - 1] in ("==", "!=") else k + 1
                self._expect(
                    "integer", operand_types[first : k + 2], compared[first : k + 2], f"`{op}`"
                )
            elif first_type is not None and second_type is not None and first_type != second_type:
                # 0 or 1 beside a boolean probably means its value.
                bit = any(isinstance(p, tree.Int) and p.value < 2 for p in compared[k : k + 2])
                self._mismatch(
                    compared[k].span.to(compared[k + 1].span),
                    f"`{op}` compares {_a(first_type)} with {_a(second_type)}",
                    "integers and booleans do not mix",
                    _ALONE if bit else _CONVERT["boolean"],
                )

    def _branches(
        self, node: tree.IfElse, then: Type | None, otherwise: Type | None
    ) -> Type | None:
        """Return the common type of both branches, `then` and `otherwise`, of `A if C else B`; None
        after reporting that they differ.

        A branch whose type is unknown (None) has the type of the other."""
        if then is None or otherwise is None:
            return then or otherwise
        if then != otherwise:
            message = f"`if else` gives {_a(then)} or {_a(otherwise)}, but both must have one type"
            self._mismatch(node.span, message, "integers and booleans do not mix")
            return None
        return then

    def _expect(
        self,
        expected: Type,
        operand_types: list[Type | None],
        nodes: Iterable[tree.Node],
        role: str,
    ) -> None:
        """Report each of the operands `nodes` whose type, in `operand_types` at the same index, is
        known and not `expected`; `role` names the operator in messages."""
        for actual, node in zip(operand_types, nodes, strict=True):
            if actual is not None and actual != expected:
                message = f"{role} needs {_a(expected)}, not {_a(actual)}"
                self._mismatch(node.span, message, _a(actual), _CONVERT[expected])

    def _mismatch(self, span: Span, message: str, label: str, helps: tuple[str, ...] = ()) -> None:
        """Report an operand of the wrong type (NS0301) at `span`; the expression is then
        invalid."""
        self._error("NS0301", message, span, label, helps=helps)

    def _misplaced(self, node: tree.Name, meaning: Meaning) -> None:
        """Report a name that has a meaning, but not here (NS0208); the note of `meaning` says
        why."""
        message = f"`{node.text}` cannot be used here"
        self._error("NS0208", message, node.span, "", notes=(meaning.note,))

    def _unknown(self, node: tree.Name, category: str, known: Iterable[str]) -> None:
        """Report that the name `node` does not exist in this `category`, with similar `known` names
        as suggestions. `category` has an article, such as "a function"."""
        self.sound = False
        constant = node.text.lower()
        # `True` of other languages: suggest `true`, which is no name.
        known = (constant,) if constant in ("true", "false") else known
        self.problems.unknown(category, node.text, node.span, known)

    def _error(self, code: str, message: str, span: Span, label: str, **details: Any) -> None:
        """Report an error and mark the expression as invalid; `details` are further fields of
        `Diagnostic`."""
        self.sound = False
        self.problems.error(code, message, span, label, **details)


_CONVERT: dict[Type, tuple[str, ...]] = {
    "integer": ("`1 if CONDITION else 0` converts a boolean to an integer",),
    "boolean": ("a comparison converts integers to a boolean: `A != 0`, `A < B`",),
}


_ALONE = (
    "a condition needs no comparison: write it alone instead of `== 1`, and with `not` instead "
    "of `== 0`",
)


def _a(type_: Type) -> str:
    """Return a type with its article."""
    return "an integer" if type_ == "integer" else "a boolean"
