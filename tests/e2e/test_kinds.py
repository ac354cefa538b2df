"""Only the tables of kinds, and a few listed files, ask of which kind a program is."""

from __future__ import annotations

import re
from types import SimpleNamespace

import pytest
from checkout import ROOT

from nscc.kinds import KindTable

FOLDERS = ("nscc", "runtime/nscc_runtime", "training/nscc_training", "cli/nscc_cli")
ASKS = re.compile(
    r"\b(machine|pictures|container\.stream) is (not )?None|\.streamed\b"
    r"|\bkind [!=]= \"(scamp|stream)\""
    r"|(\bif|\bnot|\band|\bor|\bbool\()\s*\(?[\w.]*(machine\.stages|pictures\.outputs)"
    r"|machine\.stages\s+(if|and|or|>|==)|pictures\.outputs\s+(if|and|or)\b"
)
"""Tests of what only some kinds of programs have. A machine without stages and pictures without
outputs stand for "none": code that goes through them needs no test."""
MAY_ASK = {
    "nscc/kinds.py": "the table that recognises kinds",
    "nscc/chips/target.py": "the chip's own description",
    "nscc/words/container.py": "what a container has",
    "nscc/words/file.py": "blocks of a file",
    "nscc/words/disassembly.py": "blocks of a text",
    "nscc/words/soundness.py": "consistency of a file",
    "nscc/words/machine_soundness.py": "consistency of a file",
    "nscc/words/legality.py": "the refusals that others call",
    "nscc/stream/sending_report.py": "planes that are not made yet",
    "runtime/nscc_runtime/emulator/capture.py": "`expose`, which takes every program",
    "runtime/nscc_runtime/reference/capture.py": "`frames`, which takes every program",
}


def test_only_listed_files_test_the_kind_of_a_program() -> None:
    """Elsewhere the class of the kind decides. A file that asks for the kind must stand in
    `MAY_ASK`."""
    asking = [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for folder in FOLDERS
        for path in sorted((ROOT / folder).rglob("*.py"))
        if str(path.relative_to(ROOT)) not in MAY_ASK
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if ASKS.search(line)
    ]
    # Let the class of the kind do it, in the package's table: `nscc.kinds` explains how.
    assert asking == []


def test_every_listed_file_tests_the_kind_of_a_program() -> None:
    """A file of `MAY_ASK` that no longer asks for the kind must leave the list."""
    assert [name for name in MAY_ASK if not ASKS.search((ROOT / name).read_text())] == []


class Fixed:
    def parts(self) -> list[str]:
        return ["fixed"]


class Looks(Fixed):
    def parts(self) -> list[str]:
        return ["looks", *super().parts()]


class Images(Fixed):
    def parts(self) -> list[str]:
        return ["images", *super().parts()]


@pytest.mark.parametrize(
    ("outputs", "stages", "parts"),
    [
        ((), 0, ["fixed"]),
        ((), 2, ["looks", "fixed"]),
        (("p",), 0, ["images", "fixed"]),
        (("p",), 2, ["images", "looks", "fixed"]),
    ],
)
def test_images_follow_the_exposure_of_every_kind(
    outputs: tuple[str, ...], stages: int, parts: list[str]
) -> None:
    """The images of a program follow its exposure, whatever its kind."""
    table = KindTable(Fixed, looks=f"{__name__}:Looks", images=f"{__name__}:Images")
    program = SimpleNamespace(
        target=SimpleNamespace(kind="scamp"),
        machine=SimpleNamespace(stages=stages),
        pictures=SimpleNamespace(outputs=outputs),
    )
    assert table.of(program).parts() == parts
    assert table.of(program) is table.of(program)
