"""`nscc lsp` as a real client sees it, over standard input and output."""

from __future__ import annotations

import asyncio
import json
import os
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from random import Random
from typing import Any

import pytest
from checkout import ROOT
from lsprotocol import types
from pytest_lsp import LanguageClient, make_test_lsp_client
from random_edits import PROGRAMS, edited

from nscc_cli.main import main

SENT = "nsl 1\nframe slots [1ms, 2ms]\nlet a = 1 + 1\ncode stop : 1..a\nopen when n < stop\n"


Scenario = Callable[[LanguageClient], Awaitable[None]]


def served(scenario: Scenario) -> None:
    """Runs a scenario with a client whose server was started for it, and ends both."""

    async def session() -> None:
        client = make_test_lsp_client()
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
        await client.start_io(sys.executable, "-m", "nscc_cli", "lsp", "--stdio", env=environment)
        capabilities = types.ClientCapabilities()
        await client.initialize_session(types.InitializeParams(capabilities=capabilities))
        await scenario(client)
        await client.shutdown_session()

    asyncio.run(session())


class Text:
    """A text that is open in the client."""

    def __init__(self, client: LanguageClient, path: Path) -> None:
        self.client, self.uri, self.version, self.text = client, path.as_uri(), 0, ""
        self.asked = types.TextDocumentIdentifier(self.uri)

    async def write(self, text: str) -> list[types.Diagnostic]:
        """Gives the server a text; what it says of it."""
        self.text, self.version = text, self.version + 1
        if self.version == 1:
            item = types.TextDocumentItem(self.uri, "nsl", 1, text)
            self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        else:
            named = types.VersionedTextDocumentIdentifier(self.version, self.uri)
            change = types.TextDocumentContentChangeWholeDocument(text)
            self.client.text_document_did_change(types.DidChangeTextDocumentParams(named, [change]))
        while True:
            said = await self.client.wait_for_notification("textDocument/publishDiagnostics")
            if said.uri == self.uri and said.version == self.version:
                return list(said.diagnostics)

    def position(self, wanted: str) -> types.Position:
        """Where a piece of the text begins."""
        return self.at(self.text.index(wanted))

    def at(self, offset: int) -> types.Position:
        """The position of a character offset, counted in another way than the server does."""
        lines = self.text[:offset].replace("\r\n", "\n").replace("\r", "\n").split("\n")
        return types.Position(len(lines) - 1, len(lines[-1].encode("utf-16-le")) // 2)

    def whole(self) -> types.Range:
        return types.Range(types.Position(0, 0), self.at(len(self.text)))


async def messages_come_as_one_types(client: LanguageClient, tmp_path: Path) -> None:
    text = Text(client, tmp_path / "a.nsl")
    assert await text.write(SENT) == []
    (wrong,) = await text.write(SENT.replace("n < stop", "n < stpo"))
    assert (wrong.code, wrong.source) == ("NS0214", "nscc")
    assert wrong.severity == types.DiagnosticSeverity.Error
    assert wrong.range.start == types.Position(4, 14)
    assert wrong.range.end == types.Position(4, 18)
    (fix,) = await client.text_document_code_action_async(
        types.CodeActionParams(
            text.asked,
            types.Range(text.position("stpo"), text.position("stpo")),
            types.CodeActionContext([wrong]),
        )
    )
    (edit,) = fix.edit.changes[text.uri]
    assert (edit.range, edit.new_text) == (wrong.range, "stop")
    assert not fix.is_preferred
    mended = "nsl 1\nframe 8 slots of 1ms\nopen when true\n"
    await text.write(mended.replace("1ms", "1 ms"))
    only = types.CodeActionContext([], only=["source"])
    everything = types.CodeActionParams(text.asked, text.whole(), only)
    (mend,) = await client.text_document_code_action_async(everything)
    assert [edit.new_text for edit in mend.edit.changes[text.uri]] == [mended]
    client.text_document_did_close(types.DidCloseTextDocumentParams(text.asked))
    said = await client.wait_for_notification("textDocument/publishDiagnostics")
    assert (said.uri, list(said.diagnostics)) == (text.uri, [])


async def what_is_asked_is_answered(client: LanguageClient, tmp_path: Path) -> None:
    text = Text(client, tmp_path / "ä b.nsl")
    await text.write(SENT)
    at = types.TextDocumentPositionParams(text.asked, text.position("stop\n"))
    where = {"text_document": at.text_document, "position": at.position}
    hovered = await client.text_document_hover_async(types.HoverParams(**where))
    assert "1..2" in hovered.contents.value
    items = await client.text_document_completion_async(types.CompletionParams(**where))
    assert {"n", "a", "stop"} <= {item.label for item in items}
    symbols = await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(text.asked)
    )
    assert [symbol.name for symbol in symbols] == ["frame", "a", "stop", "open"]
    defined = await client.text_document_definition_async(types.DefinitionParams(**where))
    assert defined.range.start == text.position("stop : ")
    context = types.ReferenceContext(include_declaration=False)
    (referred,) = await client.text_document_references_async(
        types.ReferenceParams(context=context, **where)
    )
    assert referred.range.start == at.position
    remarks = await client.text_document_inlay_hint_async(
        types.InlayHintParams(text.asked, text.whole())
    )
    assert [remark.position.line for remark in remarks] == [1, 2]
    assert remarks[0].label.endswith("us")
    assert remarks[1].label == "= 2"


async def texts_are_changed(client: LanguageClient, tmp_path: Path) -> None:
    text = Text(client, tmp_path / "a.nsl")
    await text.write(SENT.replace("n < stop", "n<stop"))
    (edit,) = await client.text_document_formatting_async(
        types.DocumentFormattingParams(text.asked, types.FormattingOptions(4, True))
    )
    assert (edit.range, edit.new_text) == (text.whole(), SENT)
    where = {"text_document": text.asked, "position": text.position("stop : ")}
    place = await client.text_document_prepare_rename_async(types.PrepareRenameParams(**where))
    assert place.start == where["position"]
    renamed = await client.text_document_rename_async(types.RenameParams(new_name="until", **where))
    assert len(renamed.changes[text.uri]) == 2
    with pytest.raises(Exception, match="is predefined"):
        await client.text_document_rename_async(types.RenameParams(new_name="n", **where))
    nothing = {"text_document": text.asked, "position": text.position("frame")}
    with pytest.raises(Exception, match="no name"):
        await client.text_document_prepare_rename_async(types.PrepareRenameParams(**nothing))
    await text.write("nsl 1\nframe 8")
    options = types.FormattingOptions(4, True)
    formatted = types.DocumentFormattingParams(text.asked, options)
    assert not await client.text_document_formatting_async(formatted)


async def assembly_text_is_checked(client: LanguageClient, tmp_path: Path) -> None:
    text = Text(client, tmp_path / "a.asm")
    wrong, *_ = await text.write(".target scamp5\n.kernl k0\n")
    assert (wrong.code, wrong.range.start) == ("NS0713", types.Position(1, 0))
    where = types.CompletionParams(text.asked, types.Position(1, 4))
    items = await client.text_document_completion_async(where)
    assert ".kernel" in {item.label for item in items}
    assert not await client.text_document_document_symbol_async(
        types.DocumentSymbolParams(text.asked)
    )


async def a_file_beside_the_text_changes(client: LanguageClient, tmp_path: Path) -> None:
    text = Text(client, tmp_path / "a.nsl")
    (missing,) = await text.write('nsl 1\ntarget "own.toml"\nframe 8 slots of 1ms\nopen when true')
    assert missing.code == "NS0231"
    (tmp_path / "own.toml").write_text((ROOT / "examples/small_chip.toml").read_text())
    changed = types.FileEvent((tmp_path / "own.toml").as_uri(), types.FileChangeType.Created)
    client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([changed]))
    said = await client.wait_for_notification("textDocument/publishDiagnostics")
    assert list(said.diagnostics) == []


def test_one_server_answers_every_scenario(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """All scenarios, each with its own texts, talk to the same server."""

    async def session(client: LanguageClient) -> None:
        for scenario in (
            messages_come_as_one_types,
            what_is_asked_is_answered,
            texts_are_changed,
            assembly_text_is_checked,
            a_file_beside_the_text_changes,
        ):
            (tmp_path / scenario.__name__).mkdir()
            await scenario(client, tmp_path / scenario.__name__)

    served(session)
    assert capsys.readouterr().err == ""


async def ask_everything(text: Text, choose: Random) -> None:
    """Every question at a random place; an answer that is an error fails."""
    client = text.client
    at = text.at(choose.randint(0, len(text.text)))
    where: dict[str, Any] = {"text_document": text.asked, "position": at}
    actions = types.CodeActionParams(text.asked, text.whole(), types.CodeActionContext([]))
    await asyncio.gather(
        client.text_document_hover_async(types.HoverParams(**where)),
        client.text_document_completion_async(types.CompletionParams(**where)),
        client.text_document_document_symbol_async(types.DocumentSymbolParams(text.asked)),
        client.text_document_inlay_hint_async(types.InlayHintParams(text.asked, text.whole())),
        client.text_document_definition_async(types.DefinitionParams(**where)),
        client.text_document_code_action_async(actions),
        client.text_document_formatting_async(
            types.DocumentFormattingParams(text.asked, types.FormattingOptions(4, True))
        ),
    )


async def follow(
    client: LanguageClient, path: Path, seed: int, edits: int, capsys: pytest.CaptureFixture[str]
) -> None:
    """Random edits: after each the server says what `nscc check` says of the same text."""
    choose = Random(seed)
    text = Text(client, path)
    program = choose.choice(PROGRAMS)
    for _ in range(edits):
        program = edited(choose, program)
        said = await text.write(program)
        path.write_text(program, encoding="utf-8", newline="")
        main(["check", "--message-format", "json", str(path)])
        wanted = map(json.loads, capsys.readouterr().err.splitlines())
        assert [found_by_server(each) for each in said] == [
            found_by_check(each, text) for each in wanted
        ], program
        await ask_everything(text, choose)


def found_by_server(said: types.Diagnostic) -> tuple[object, ...]:
    names = {1: "error", 2: "warning", 3: "note"}
    return (
        said.code,
        names[int(said.severity or 0)],
        said.message.split("\n")[0],
        said.range.start,
        said.range.end,
    )


def found_by_check(found: dict[str, Any], text: Text) -> tuple[object, ...]:
    """Rows of the command line end at line feeds, and its columns count characters."""
    places = [types.Position(0, 0)] * 2
    if found["location"] is not None:
        lines = [0, *(k + 1 for k, character in enumerate(text.text) if character == "\n")]
        ends = (found["location"], found["end_location"])
        places = [text.at(lines[end["row"] - 1] + end["column"] - 1) for end in ends]
    return found["code"], found["severity"], found["message"].split("\n")[0], *places


def test_the_server_follows_random_edits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    served(lambda client: follow(client, tmp_path / "a.nsl", 1, 25, capsys))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(40))
def test_the_language_server_survives_ten_thousand_edits(
    seed: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    served(lambda client: follow(client, tmp_path / "a.nsl", 100 + seed, 250, capsys))
