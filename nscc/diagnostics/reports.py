"""Diagnostics for code-review services: SARIF 2.1.0 (OASIS) and GitHub workflow commands."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from urllib.parse import quote

from nscc.diagnostics.diagnostic import Diagnostic, Fix, Label, Severity
from nscc.diagnostics.render import names
from nscc.mappings import JsonObject
from nscc.source import Source
from nscc.version import __version__

_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"
_KINDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}


def workflow_commands(diagnostics: Iterable[Diagnostic]) -> str:
    """Return GitHub workflow commands for the diagnostics, one per line; "" without diagnostics."""
    return "".join(map(_annotation, diagnostics))


def _annotation(diagnostic: Diagnostic) -> str:
    """Return a diagnostic as a GitHub workflow command, such as `::error file=..,line=..::text`.

    The line ends in a line break. Without a label the command names only the file, and without a
    source no place."""
    name = names().get(diagnostic.code, "")
    properties = {"title": f"{diagnostic.code} {name}".strip()}
    source = diagnostic.source
    if source is not None:
        properties["file"] = source.name
        if diagnostic.label is not None:
            region = _region(source, diagnostic.label)
            properties["line"] = str(region["startLine"])
            properties["col"] = str(region["startColumn"])
            properties["endLine"] = str(region["endLine"])
            if region["endLine"] == region["startLine"]:  # only for spans on one line
                properties["endColumn"] = str(region["endColumn"])
    fields = ",".join(
        f"{key}={_escaped(value).replace(':', '%3A').replace(',', '%2C')}"
        for key, value in properties.items()
    )
    return f"::{_KINDS[diagnostic.severity]} {fields}::{_escaped(full_text(diagnostic))}\n"


def sarif(diagnostics: Sequence[Diagnostic]) -> str:
    """Return a SARIF log with one run, as JSON text, also without diagnostics; results are in the
    order of `diagnostics`."""
    codes = sorted({diagnostic.code for diagnostic in diagnostics})
    rules = [{"id": code, "name": names().get(code, code)} for code in codes]
    driver = {"name": "nscc", "version": __version__, "rules": rules}
    run = {
        "tool": {"driver": driver},
        "columnKind": "unicodeCodePoints",
        "results": [_result(diagnostic, codes) for diagnostic in diagnostics],
    }
    return json.dumps({"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _result(diagnostic: Diagnostic, codes: Sequence[str]) -> JsonObject:
    """Return a diagnostic as a SARIF `result` object.

    The place is left out if the diagnostic has no source. `codes` are the codes of the log's rules
    in their order, which give the rule's index."""
    source = diagnostic.source
    result: JsonObject = {
        "ruleId": diagnostic.code,
        "ruleIndex": codes.index(diagnostic.code),
        "level": str(diagnostic.severity),
        "message": {"text": full_text(diagnostic)},
    }
    if source is not None:
        result["locations"] = [_location(source, diagnostic.label)]
        related = [_location(source, label) for label in diagnostic.related]
        if related:
            result["relatedLocations"] = related
        if diagnostic.fixes:
            result["fixes"] = [_fix(source, fix) for fix in diagnostic.fixes]
    if diagnostic.data:
        result["properties"] = dict(diagnostic.data)
    return result


def _location(source: Source, label: Label | None) -> JsonObject:
    """Return a SARIF `location`: the file, and with a label its region and its text."""
    location: JsonObject = {"artifactLocation": {"uri": quote(source.name)}}
    if label is None:
        return {"physicalLocation": location}
    location["region"] = _region(source, label)
    text = {"message": {"text": label.text}} if label.text else {}
    return {"physicalLocation": location, **text}


def _fix(source: Source, fix: Fix) -> JsonObject:
    """Return a SARIF `fix` object, which replaces the fix's region by its text."""
    change = {
        "artifactLocation": {"uri": quote(source.name)},
        "replacements": [
            {
                "deletedRegion": _region(source, fix),
                "insertedContent": {"text": fix.replacement},
            }
        ],
    }
    return {"description": {"text": fix.title}, "artifactChanges": [change]}


def _region(source: Source, at: Label | Fix) -> dict[str, int]:
    """Return the SARIF region of the place of `at` in `source`; lines and columns count from 1.

    The end is after the last character."""
    (row, column), (end_row, end_column) = map(source.row_column, (at.span.start, at.span.end))
    return {"startLine": row, "startColumn": column, "endLine": end_row, "endColumn": end_column}


def full_text(diagnostic: Diagnostic) -> str:
    """Return all texts of a diagnostic without its place: message, notes, helps, fixes and ways
    out.

    Each begins on a new line."""
    ways = [f"{i}. {way}" for i, way in enumerate(diagnostic.ways_out, 1)]
    fixes = [fix.title for fix in diagnostic.fixes]
    return "\n".join([diagnostic.message, *diagnostic.notes, *diagnostic.helps, *fixes, *ways])


def _escaped(text: str) -> str:
    """Return a text with the escapes that GitHub's workflow commands require for %, CR and LF."""
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
