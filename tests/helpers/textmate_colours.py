"""As much of TextMate's way to colour a line as the grammar of shutter programs uses."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

Token = tuple[int, int, int, str]
"""Row from 0, first column and the one after the last, the innermost scope."""


def colours(grammar: Mapping[str, Any], text: str) -> list[Token]:
    """What is coloured of a text; a rule that begins never ends."""
    patterns = list(_flat(grammar, grammar["patterns"]))
    found: list[Token] = []
    for row, line in enumerate(text.split("\n")):
        at = 0
        while at < len(line):
            tries = (
                (rule, re.compile(rule.get("match") or rule["begin"]).search(line, at))
                for rule in patterns
            )
            hits = [(hit.start(), k, rule, hit) for k, (rule, hit) in enumerate(tries) if hit]
            if not hits:
                break
            _, _, rule, hit = min(hits, key=lambda each: each[:2])
            captures = rule.get("captures") or rule.get("beginCaptures") or {"0": rule}
            for group, scope in captures.items():
                found.append((row, *hit.span(int(group)), scope["name"]))
            if "begin" in rule:
                assert rule["end"] == "(?!)"
                patterns = list(_flat(grammar, rule["patterns"]))
            at = max(hit.end(), at + 1)
    return found


def _flat(grammar: Mapping[str, Any], patterns: list[Any]) -> Iterator[Mapping[str, Any]]:
    for rule in patterns:
        include = rule.get("include")
        yield grammar["repository"][include.removeprefix("#")] if include else rule
