"""The pages of the codes: one shape, one name each. That their programs do what they say is tested
end to end."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nscc.diagnostics.render import PAGES, names

HEADINGS = ["What it means", "Bad", "Good", "What to do"]


def test_codes_and_names_are_unique() -> None:
    """There is a page for each code, and no two codes have the same name."""
    found = names()
    assert len(found) == len(list(PAGES.glob("*.md")))
    assert sorted(found.values()) == sorted(set(found.values()))


@pytest.mark.parametrize("path", sorted(PAGES.glob("*.md")), ids=lambda path: path.stem)
def test_a_page_has_the_fixed_headings(path: Path) -> None:
    """The file is named after code and name. Its second and third sections each show a program or a
    command."""
    text = path.read_text(encoding="utf-8")
    assert re.fullmatch(r"NS\d{4}(-[a-z0-9]+)+\.md", path.name)
    assert re.match(rf"# {path.name[:6]}: \S.*\n\n## ", text)
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == HEADINGS
    for section in text.split("## ")[2:4]:
        assert re.search(r"^```(nsl|console)\n.*?^```$", section, re.MULTILINE | re.DOTALL)
