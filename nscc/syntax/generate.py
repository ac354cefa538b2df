"""Makes the parser's tables from the grammar.

    python -m nscc.syntax.generate

writes `tables.json` beside this file. Lark reads the grammar and builds the LALR automaton here,
ahead of time: importing lark and doing so costs half of what `nscc check` may take. A test keeps
the file in step with the grammar.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

START = "statement"
TABLES = Path(__file__).with_name("tables.json")


def grammar_path() -> Path:
    """The grammar: beside this module in an installed package, in grammars/ in a checkout."""
    installed = Path(__file__).with_name("nsl.lark")
    if installed.exists():
        return installed
    return Path(__file__).resolve().parents[2] / "grammars" / "nsl.lark"


def tables_text(grammar: str) -> str:
    """The tables of a grammar as JSON text, the same whatever the hash seed.

    `literals`: the words and signs that stand for themselves. `patterns`: [terminal, regular
    expression], in the order to try them. `rules`: [left side, action, length, kept positions];
    the action is the alias or rule name to build, "" to hand on the one kept child, "+" to gather
    a list. `actions`: for each state and terminal, s for a step to state s, -1 - r for a reduction
    by rule r. `gotos`: for each state, the next one after a rule's left side. State 0 is the start,
    `end` the state of a whole statement.
    """
    from lark import Lark
    from lark.lexer import PatternStr
    from lark.parsers.lalr_analysis import LALR_Analyzer

    lark = Lark(grammar, parser="lalr", start=[START], maybe_placeholders=False)
    literals = {
        t.name: t.pattern.value for t in lark.terminals if isinstance(t.pattern, PatternStr)
    }
    patterns = [t for t in lark.terminals if t.name not in literals]
    patterns.sort(key=lambda t: (-t.pattern.max_width, t.name))
    rules = sorted(lark.rules, key=_rule_key)
    analyzer = LALR_Analyzer(lark.parser.parser_conf)
    analyzer.compute_lalr()  # type: ignore[no-untyped-call]
    actions, gotos, end = _renumbered(analyzer.parse_table, rules, literals)
    rows = {
        "end": end,
        "literals": sorted(literals.values()),
        "patterns": [[t.name, t.pattern.value] for t in patterns],
        "rules": [_rule_row(rule) for rule in rules],
        "actions": actions,
        "gotos": gotos,
    }
    return "{\n" + ",\n".join(f'"{name}": {_lines(rows[name])}' for name in rows) + "\n}\n"


def _rule_key(rule: Any) -> tuple[str, tuple[str, ...]]:
    return rule.origin.name, tuple(symbol.name for symbol in rule.expansion)


def _rule_row(rule: Any) -> list[Any]:
    kept = [i for i, s in enumerate(rule.expansion) if not getattr(s, "filter_out", False)]
    name = str(rule.origin.name)
    if name.startswith("__"):
        action = "+"
    elif rule.alias is None and rule.options.expand1 and len(kept) == 1:
        action = ""
    else:
        action = rule.alias or name
    return [name, action, len(rule.expansion), kept]


def _renumbered(
    table: Any, rules: list[Any], literals: dict[str, str]
) -> tuple[list[dict[str, int]], list[dict[str, int]], int]:
    """Actions, gotos, end; states are numbered as a search from the start finds them."""
    from lark.parsers.lalr_analysis import Shift

    number = {table.start_states[START]: 0}
    queue = [table.start_states[START]]
    rule_number = {rule: i for i, rule in enumerate(rules)}
    left_sides = {rule.origin.name for rule in rules}
    actions: list[dict[str, int]] = []
    gotos: list[dict[str, int]] = []
    for state in queue:
        actions.append({})
        gotos.append({})
        for symbol, (action, target) in sorted(table.states[state].items()):
            if action is not Shift:
                actions[-1][literals.get(symbol, symbol)] = -1 - rule_number[target]
                continue
            if target not in number:
                number[target] = len(queue)
                queue.append(target)
            if symbol in left_sides:
                gotos[-1][symbol] = number[target]
            else:
                actions[-1][literals.get(symbol, symbol)] = number[target]
    return actions, gotos, number[table.end_states[START]]


def _lines(value: Any) -> str:
    """A list with an item a line, so that a change of the grammar is a change of few lines."""
    if not isinstance(value, list):
        return json.dumps(value)
    return "[\n" + ",\n".join(json.dumps(item) for item in value) + "\n]"


if __name__ == "__main__":
    TABLES.write_text(tables_text(grammar_path().read_text(encoding="utf-8")), encoding="utf-8")
