"""Suggestions of the name that the user probably meant."""

from __future__ import annotations

import re
from collections.abc import Iterable

_LONGEST = 64
"""Names longer than this are not compared, because a misspelling is unlikely."""


def closest(name: str, candidates: Iterable[str]) -> str | None:
    """Return the candidate most similar to `name`, ignoring case; None if none is similar enough.

    A candidate that equals a word of `name` (between `-`, `_` or blanks) comes first. Of equally
    similar candidates, the alphabetically first is returned. `name` itself is never returned. A
    name of more than `_LONGEST` characters has no similar one."""
    if len(name) > _LONGEST:
        return None
    by_folded: dict[str, str] = {}
    for candidate in sorted(set(candidates)):
        # A single letter is similar to every name that contains it.
        alike = len(candidate) > 1 or len(name) <= 2
        if alike and len(candidate) <= _LONGEST and candidate != name:
            by_folded.setdefault(candidate.casefold(), candidate)
    folded = name.casefold()
    if folded in by_folded:
        return by_folded[folded]

    from difflib import SequenceMatcher  # imported only if a name is wrong: keeps start-up short

    matcher = SequenceMatcher(None, "", folded, autojunk=False)
    by_word = next((by_folded[p] for p in re.split("[-_ ]", folded) if p in by_folded), None)
    if by_word is not None:
        return by_word
    # One wrong letter of a short name is a large share of it. The ratio is difflib's: 1 for equal
    # names, 0 for names without a common letter.
    best, least = None, 0.5 if len(folded) <= 3 else 0.65
    for candidate, original in by_folded.items():
        matcher.set_seq1(candidate)
        ratio = matcher.ratio()
        # The threshold itself is enough; of equal ratios, the first candidate stays.
        if ratio > least or (best is None and ratio == least):
            best, least = original, ratio
    return best


def meant(
    name: str, candidates: Iterable[str], otherwise: str = "", written: str = "{}"
) -> tuple[str, ...]:
    """Return the help "did you mean ..?" with the candidate most similar to `name`, in a tuple.

    `written` is a format for the candidate, with {} in its place. Without a similar candidate, the
    help is `otherwise`; if that is "", the tuple is empty."""
    nearest = closest(name, candidates)
    help_text = did_you_mean(written.format(nearest)) if nearest else otherwise
    return (help_text,) if help_text else ()


def did_you_mean(text: str) -> str:
    """Return the help "did you mean ..?" for a suggested text."""
    return f"did you mean `{text}`?"
