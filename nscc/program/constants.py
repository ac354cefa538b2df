"""Compile-time constants: lets and N, evaluated in the order of their dependencies."""

from __future__ import annotations

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label
from nscc.program.arithmetic import Fault
from nscc.program.evaluate import evaluate
from nscc.program.expressions import FAILED, Meaning, Scope, check, names_in
from nscc.program.limits import MOST_SLOTS
from nscc.program.names import Declarations
from nscc.program.problems import Problems, clipped
from nscc.program.scopes import constants_scope
from nscc.source import Span
from nscc.syntax.tree import EqualSlots, Expr, ListedSlots

_MOST_CYCLES = 20


def constant(expr: Expr, scope: Scope, problems: Problems, role: str) -> int | None:
    """Return the value of a compile-time integer, or None after reporting an error."""
    checked = check(expr, "integer", scope, problems, role)
    if checked is None:
        return None
    value = evaluate(checked, {}, {})
    if isinstance(value.faults, Fault):
        problems.error(*value.faults)
        return None
    return int(value.data)


def resolve_constants(
    declared: Declarations, target: Target | None, problems: Problems
) -> dict[str, Meaning]:
    """Return the meaning of N, rows, cols and every let; those with errors are `failed`.

    Reports cycles (NS0203) and a number of slots outside 1..MOST_SLOTS (NS0308)."""
    return _Resolver(declared, target, problems).run()


class _Resolver:
    def __init__(self, declared: Declarations, target: Target | None, problems: Problems) -> None:
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
        """Resolve all constants without cyclic dependencies, then report cycles up to a limit."""
        self.scope = constants_scope(self.declared, self.known)
        if isinstance(self.declared.frame, ListedSlots):
            self._slots(len(self.declared.frame.lengths), self.declared.frame.span)
        self.needs: dict[str, list[str]] = {}
        self.needed_by: dict[str, list[str]] = {name: [] for name in self.exprs}
        for name, (expr, _) in self.exprs.items():
            needs = dict.fromkeys(k.text for k in names_in(expr) if k.text in self.exprs)
            self.needs[name] = list(needs)
            for need in needs:
                self.needed_by[need].append(name)
        self.missing = {name: len(needs) for name, needs in self.needs.items()}
        self.done: set[str] = set()
        self._settle([name for name, missing in self.missing.items() if missing == 0])
        cycles = 0
        for name in self.exprs:
            while name not in self.done and cycles < _MOST_CYCLES:
                cycles += 1
                cycle = self._cycle(name)
                self._report(cycle)
                for member in cycle:
                    self._learn(member, FAILED)
                    self.done.add(member)
                self._settle(self._released(cycle))
        for name in self.exprs:
            if name not in self.done:
                self._learn(name, FAILED)
        return self.known

    def _settle(self, ready: list[str]) -> None:
        while ready:
            name = ready.pop()
            if name in self.done:
                continue
            self.done.add(name)
            self._resolve(name)
            ready.extend(self._released([name]))

    def _released(self, names: list[str]) -> list[str]:
        free = []
        for user in (user for name in names for user in self.needed_by[name]):
            self.missing[user] -= 1
            if self.missing[user] == 0 and user not in self.done:
                free.append(user)
        return free

    def _resolve(self, name: str) -> None:
        expr, place = self.exprs[name]
        role = "the number of slots" if name == "N" else "a let"
        value = constant(expr, self.scope, self.problems, role)
        if value is None:
            self._learn(name, FAILED)
        elif name == "N":
            self._slots(value, place)
        else:
            self._learn(name, Meaning("constant", value))

    def _slots(self, count: int, place: Span) -> None:
        if 1 <= count <= MOST_SLOTS:
            self._learn("N", Meaning("constant", count))
            return
        self._learn("N", FAILED)
        message = f"invalid number of slots: {clipped(count)}"
        self.problems.error("NS0308", message, place, f"a frame has 1 to {MOST_SLOTS} slots")

    def _learn(self, name: str, meaning: Meaning) -> None:
        self.known[name] = meaning
        if name not in self.declared.refused or name == "N":
            self.scope[name] = meaning

    def _cycle(self, start: str) -> list[str]:
        """Return a dependency cycle among the unresolved names, searching from `start`."""
        path: dict[str, None] = {}
        name = start
        while name not in path:
            path[name] = None
            name = next(need for need in self.needs[name] if need not in self.done)
        order = list(path)
        return order[order.index(name) :]

    def _report(self, cycle: list[str]) -> None:
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
