"""Messages for services that show them beside the code: SARIF logs and GitHub's annotations."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from checkout import ROOT

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Severity
from nscc.diagnostics.reports import sarif, workflow_commands
from nscc.source import Source, Span
from nscc_cli.main import main

SOURCE = Source("a dir/ä.nsl", "nsl 1\nopen wen n < 3\n")
FOUND = Diagnostic(
    "NS0107",
    "100% wrong: a, b",
    Severity.WARNING,
    SOURCE,
    Label(Span(11, 14), "here"),
    related=(Label(Span(0, 3), "there"),),
    notes=("a note",),
    helps=("a help",),
    fixes=(Fix("write `when`", Span(11, 14), "when"),),
    data={"n": 1},
)


def log(text: str) -> dict[str, Any]:
    """The one run of a SARIF log."""
    document = json.loads(text)
    assert document["version"] == "2.1.0"
    (run,) = document["runs"]
    return dict(run)


def test_an_annotation_is_one_line_with_its_place() -> None:
    assert workflow_commands([FOUND]) == (
        "::warning title=NS0107 unexpected-word,file=a dir/ä.nsl,line=2,col=6,endLine=2,"
        "endColumn=9::100%25 wrong: a, b%0Aa note%0Aa help%0Awrite `when`\n"
    ).replace("unexpected-word", _name("NS0107"))


def _name(code: str) -> str:
    (page,) = (ROOT / "nscc/diagnostics/pages").glob(f"{code}-*.md")
    return page.stem[7:]


def test_annotations_need_no_place_and_may_span_lines() -> None:
    """A note without a place has only a title. A line break is written as `%0A`, and a label over
    lines has no column."""
    note = Diagnostic("NS0901", "a\nb", Severity.NOTE)
    assert workflow_commands([note]).startswith("::notice title=NS0901")
    assert workflow_commands([note]).endswith("::a%0Ab\n")
    whole = Diagnostic("NS0107", "x", Severity.ERROR, SOURCE, Label(Span(0, 14)))
    assert "endColumn" not in workflow_commands([whole])


def test_a_sarif_log_says_all_of_a_message() -> None:
    run = log(sarif([FOUND, Diagnostic("NS0901", "fault")]))
    first, second = run["results"]
    assert [rule["id"] for rule in run["tool"]["driver"]["rules"]] == ["NS0107", "NS0901"]
    assert (first["ruleId"], first["ruleIndex"], first["level"]) == ("NS0107", 0, "warning")
    place = first["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"] == "a%20dir/%C3%A4.nsl"
    region = {"startLine": 2, "startColumn": 6, "endLine": 2, "endColumn": 9}
    assert place["region"] == region
    change = first["fixes"][0]["artifactChanges"][0]["replacements"][0]
    assert change == {"deletedRegion": region, "insertedContent": {"text": "when"}}
    assert first["relatedLocations"][0]["message"]["text"] == "there"
    assert first["properties"] == {"n": 1}
    assert second == {
        "ruleId": "NS0901",
        "ruleIndex": 1,
        "level": "error",
        "message": {"text": "fault"},
    }


def test_one_document_holds_all_that_a_command_says(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bad, worse, good = (tmp_path / name for name in ("bad.nsl", "worse.nsl", "good.nsl"))
    bad.write_text("nsl 1\nframe 8 slots of 1ms\nopen wen n < 3\n")
    worse.write_text("frame 8\n")
    good.write_text("nsl 1\nframe 8 slots of 1ms\nopen when n < 3\n")
    paths = [str(path) for path in (bad, worse, good)]
    assert main(["check", "--message-format", "sarif", *paths]) == 1
    codes = [each["ruleId"] for each in log(capsys.readouterr().err)["results"]]
    assert {"NS0107", "NS0104"} <= set(codes)
    assert main(["fmt", "--message-format=sarif", str(good)]) == 0
    assert log(capsys.readouterr().err)["results"] == []
    assert main(["check", "--message-format=sarif", "--nonsense", str(good)]) == 2
    assert len(log(capsys.readouterr().err)["results"]) == 1
