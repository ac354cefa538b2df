"""The pages of `nscc explain`: one for each code, in `nscc/diagnostics/pages`."""

from __future__ import annotations

import re

from nscc.diagnostics.diagnostic import rejected
from nscc.diagnostics.render import PAGES, names
from nscc.diagnostics.suggest import closest, did_you_mean

_CODE = re.compile(r"(?:(?:error|warning|note)\[)?(?:NS)?0*(\d{1,4})(?:\]:?.*)?", re.IGNORECASE)
"""A code as typed or copied: `NS0412`, `ns412`, `412`, `error[NS0412]: ..`."""


def page(code_or_name: str) -> str:
    """Return the page, Markdown text, of a code (`NS0412` in any case, `412`) or of a name
    (`too-many-shutters`).

    Raises Rejected (NS0790, status 2) for an unknown code or name."""
    known = names()
    query = code_or_name.strip()
    match = _CODE.fullmatch(query)
    code = f"NS{int(match[1]):04d}" if match else ""
    if code not in known:
        code = next((c for c, name in known.items() if name == query.lower()), "")
    if not code:
        nearest = closest(query.upper(), list(known)) or closest(
            query.lower(), list(known.values())
        )
        raise rejected(
            "NS0790",
            f"unknown message code or name '{query[:60]}'",
            helps=(
                *((did_you_mean(nearest),) if nearest else ()),
                "`nscc explain` lists all codes",
            ),
        )
    return (PAGES / f"{code}-{known[code]}.md").read_text(encoding="utf-8")


def index() -> str:
    """Return a text with one line for each diagnostic code, ascending: the code, its name and the
    title of its page."""
    lines = []
    for code, name in names().items():
        with open(PAGES / f"{code}-{name}.md", encoding="utf-8") as file:
            title = file.readline().partition(":")[2].strip()
        lines.append(f"{code}  {name:<28} {title}")
    return "\n".join(lines) + "\n"
