"""The version is the same wherever it is stated, and the changelog keeps its form."""

from __future__ import annotations

import json
import re

from checkout import ROOT

from nscc import __version__

SECTION_ENTRIES = 15
VERSION_LINES = 60


def versions() -> dict[str, str]:
    """The text of each version in the changelog, newest first."""
    _, *sections = re.split(r"^## ", (ROOT / "CHANGELOG.md").read_text(), flags=re.MULTILINE)
    return dict(section.split("\n", 1) for section in sections)


def test_the_version_is_stated_once() -> None:
    citation = (ROOT / "CITATION.cff").read_text()
    assert re.search(r"^version: (.*)$", citation, re.MULTILINE).group(1) == __version__
    released = [title for title in versions() if title != "Unreleased"]
    date = re.search(r'^date-released: "(.*)"$', citation, re.MULTILINE).group(1)
    assert released[0] == f"{__version__} ({date})"
    assert f"nscc-{__version__}-py3-none-any.whl" in (ROOT / "docs/start.md").read_text()
    package = json.loads((ROOT / "editors/vscode/package.json").read_text())
    assert package["version"] == __version__


def test_the_installation_is_told_with_one_text() -> None:
    start = (ROOT / "docs/start.md").read_text()
    told = start.partition("<!-- install -->")[2].partition("<!-- installed -->")[0]
    [commands] = re.findall(r"^```sh\n.*?^```$", told, flags=re.MULTILINE | re.DOTALL)
    assert commands in (ROOT / "README.md").read_text()
    home = (ROOT / "docs/index.md").read_text()
    assert "pip install" not in home
    assert ":start-after: <!-- install -->\n:end-before: <!-- installed -->" in home


def test_versions_in_the_changelog_are_short_and_divided() -> None:
    for title, text in versions().items():
        assert text.count("\n") <= VERSION_LINES, title
        parts = re.split(r"^### (.*)$", text, flags=re.MULTILINE)
        names, contents = parts[1::2], parts[2::2]
        assert set(names) <= {"Added", "Changed", "Fixed"}, title
        assert not parts[0].strip(), f"{title}: entries before the first heading"
        for name, content in zip(names, contents, strict=True):
            entries = re.findall(r"^\* ", content, re.MULTILINE)
            assert 0 < len(entries) <= SECTION_ENTRIES, f"{title}, {name}"
