"""The Language Server Protocol on pygls: passes editors' requests to `nscc.editing`.

Each change sends the whole text. One thread handles all requests in order, so that the server
keeps receiving changes meanwhile. A text is not checked if a newer version has replaced it."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

from lsprotocol import types
from pygls import uris
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer

from nscc import __version__
from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.editing.complete import Listing, Text, complete, complete_listing
from nscc.editing.document import Document, fixes_at, outline, text_with_safe_fixes
from nscc.editing.hover import hints, hover
from nscc.editing.mentions import CannotRename, alike, declaration, mention_at, renameable, renamed
from nscc.source import Span
from nscc.syntax.format import format_source
from nscc_cli import protocol_values as values
from nscc_cli.protocol_values import Positions

Answer = Callable[[Any, Positions, Any], object]
"""A function that answers a request about a text, from the text, its positions and the request's
parameters."""
_REQUEST_FAILED = -32803
"""LSPErrorCodes.RequestFailed: a valid request that cannot be carried out."""
_FIX_ALL = types.CodeActionKind("source.fixAll")


class Server(LanguageServer):
    """The language server: the open texts by URI, their versions, and the thread that handles
    requests about them."""

    def __init__(self) -> None:
        """Begin without open texts. One worker thread handles all requests in order, while the main
        thread receives changes."""
        super().__init__(
            "nscc", __version__, text_document_sync_kind=types.TextDocumentSyncKind.Full
        )
        self.documents: dict[str, Text] = {}
        self.versions: dict[str, int] = {}
        self.worker = ThreadPoolExecutor(1)

    def take(self, uri: str, text: str, version: int) -> None:
        """Store `text` as version `version` of the document `uri`, and start checking it. The
        ending of `uri` decides whether it is an assembly text (.asm) or a program; a byte order
        mark is dropped."""
        self.versions[uri] = version
        path = Path(uris.to_fs_path(uri) or uri.rpartition(":")[2])
        kind = Listing if path.suffix.lower() == ".asm" else Document
        self.documents[uri] = kind(path.as_posix(), text.removeprefix("\ufeff"), path.parent)
        self.check(uri)

    def check(self, uri: str) -> None:
        """Check the document `uri` on the worker thread, and send its diagnostics to the editor
        unless the text changes meanwhile."""
        document, version = self.documents[uri], self.versions[uri]

        def publish(finished: asyncio.Future[list[types.Diagnostic] | None]) -> None:
            """Send the diagnostics of a finished check to the editor, unless a newer text has
            replaced the checked one."""
            diagnostics = None if finished.cancelled() else finished.result()
            if diagnostics is not None and self.documents.get(uri) is document:
                message_params = types.PublishDiagnosticsParams(uri, diagnostics, version)
                self.text_document_publish_diagnostics(message_params)

        def checked_diagnostics() -> list[types.Diagnostic] | None:
            """Return the diagnostics of the text, or None if a newer text has replaced it, so that
            it need not be checked."""
            if self.documents.get(uri) is not document:
                return None
            return [
                values.diagnostic(diagnostic, document, uri) for diagnostic in _checked(document)
            ]

        asyncio.get_running_loop().run_in_executor(
            self.worker, checked_diagnostics
        ).add_done_callback(publish)

    async def answer(self, question: Answer, params: Any, kinds: tuple[type[Any], ...]) -> Any:
        """Return what `question` answers, on the worker thread, about the text that `params` name.
        Return None for a text that is not open or not of one of `kinds`.

        Raises JsonRpcException if a name cannot be renamed; the editor shows its text."""
        text = self.documents.get(params.text_document.uri)
        if not isinstance(text, kinds):
            return None
        try:
            return await asyncio.get_running_loop().run_in_executor(
                self.worker, lambda: question(text, Positions(text.text), params)
            )
        except CannotRename as reason:
            raise JsonRpcException(str(reason), _REQUEST_FAILED) from None


def _checked(document: Text) -> tuple[Diagnostic, ...]:
    """Return the diagnostics of `nscc check` for `document`. An unexpected exception becomes a
    diagnostic (NS0901), so that the server goes on."""
    try:
        return document.checked.diagnostics
    except Exception as error:
        error_text = " ".join(str(error).split())[:200]
        return (
            Diagnostic(
                "NS0901",
                f"nscc itself failed: {type(error).__name__}: {error_text}",
                helps=("save the text and run `nscc check`: it writes a reproducer to report",),
            ),
        )


def make_server() -> Server:
    """Return a language server that is ready to run. No text is open yet; it answers all requests
    of `_ANSWERS`."""
    logging.getLogger("pygls.protocol.json_rpc").addFilter(_is_no_refusal)
    server = Server()
    _take_texts(server)
    for feature, (question, options) in _ANSWERS.items():
        completes = feature == types.TEXT_DOCUMENT_COMPLETION
        kinds = (Document, Listing) if completes else (Document,)
        _add(server, feature, options, partial(server.answer, question, kinds=kinds))
    return server


def _add(server: Server, feature: str, options: Any, answer: Callable[..., Any]) -> None:
    """Register `answer` with the server as the handler of a feature of the protocol, such as
    completion. `options` are what the server tells the editor about it."""

    @server.feature(feature, options)
    async def answered(params: Any) -> Any:
        """Answer a request."""
        return await answer(params)


def _is_no_refusal(record: logging.LogRecord) -> bool:
    """Return False for log records of refused requests, so that they are not logged: the editor
    shows them."""
    return record.exc_info is None or not isinstance(record.exc_info[1], JsonRpcException)


def _take_texts(server: Server) -> None:
    """Register handlers with `server` for opened, changed and closed texts, and for changed files
    beside them."""

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def did_open(params: types.DidOpenTextDocumentParams) -> None:
        """Store and check the text of a document that the editor has opened."""
        opened = params.text_document
        server.take(opened.uri, opened.text, opened.version)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(params: types.DidChangeTextDocumentParams) -> None:
        """Store and check the text of a changed document. The editor sends whole texts; only the
        last counts."""
        changed = params.text_document
        for change in params.content_changes[-1:]:
            server.take(changed.uri, change.text, changed.version)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(params: types.DidCloseTextDocumentParams) -> None:
        """Forget the closed text that `params` names, and remove its diagnostics in the editor."""
        uri = params.text_document.uri
        server.documents.pop(uri, None)
        server.versions.pop(uri, None)
        server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri, []))

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def files_changed(params: types.DidChangeWatchedFilesParams) -> None:
        """Check all documents again: a file that they name has changed."""
        for uri, document in [*server.documents.items()]:
            server.take(uri, document.text, server.versions[uri])

    @server.feature(types.SHUTDOWN)
    @server.feature(types.EXIT)
    def end(_: None) -> None:
        """Forget all documents, so that nothing more is published."""
        server.documents.clear()  # nothing is published of texts whose check still runs


def _hover(document: Document, at: Positions, params: types.HoverParams) -> types.Hover | None:
    """Return the hover text at the position in `params`, or None if there is nothing to say. `at`
    converts the positions of the text."""
    hover_text = hover(document, at.offset(params.position))
    if hover_text is None:
        return None
    text = types.MarkupContent(types.MarkupKind.Markdown, hover_text.text)
    return types.Hover(text, at.range(hover_text.span))


def _completions(
    text: Text, at: Positions, params: types.CompletionParams
) -> list[types.CompletionItem]:
    """Return the words and names that may stand at the position in `params`, which `at` converts to
    an offset, in a program or an assembly text."""
    offset = at.offset(params.position)
    span, offers = (
        complete_listing(text, offset) if isinstance(text, Listing) else complete(text, offset)
    )
    place = at.range(span)
    return [
        types.CompletionItem(
            offer.text,
            kind=values.OFFERED[offer.kind],
            detail=offer.detail or None,
            text_edit=types.TextEdit(place, offer.text),
        )
        for offer in offers
    ]


def _symbols(document: Document, at: Positions, _params: object) -> list[types.DocumentSymbol]:
    """Return the outline of a document: one symbol for each entry of
    `nscc.editing.document.outline`."""
    return [
        types.DocumentSymbol(
            entry.name,
            values.DECLARED[entry.kind],
            at.range(entry.span),
            at.range(entry.at),
            detail=entry.detail,
        )
        for entry in outline(document)
    ]


def _hints(
    document: Document, at: Positions, params: types.InlayHintParams
) -> list[types.InlayHint]:
    """Return the hints (short texts that the editor shows within lines) in the range of `params`,
    both ends included. `at` converts the positions of the text."""
    shown = at.span(params.range)
    inside = (hint for hint in hints(document) if shown.start <= hint.offset <= shown.end)
    return [types.InlayHint(at.of(h.offset), h.text, padding_left=True) for h in inside]


def _definition(
    document: Document, at: Positions, params: types.DefinitionParams
) -> types.Location | None:
    """Return where the name at the position in `params` is declared. Return None if no name stands
    there, or the program does not declare it."""
    mention = mention_at(document, at.offset(params.position))
    definition = mention and declaration(document, mention)
    if not definition:
        return None
    return types.Location(params.text_document.uri, at.range(definition.span))


def _references(
    document: Document, at: Positions, params: types.ReferenceParams
) -> list[types.Location]:
    """Return the places of all uses of the name at the position in `params`, with its declaration
    if the editor asks for it."""
    mention = mention_at(document, at.offset(params.position))
    mentions = alike(document, mention) if mention else []
    uri, also_declaration = params.text_document.uri, params.context.include_declaration
    shown = (m for m in mentions if also_declaration or not m.declares)
    return [types.Location(uri, at.range(m.span)) for m in shown]


def _fixes(
    document: Document, at: Positions, params: types.CodeActionParams
) -> list[types.CodeAction]:
    """Return the fixes, safe or not, that apply in the range of `params`, and one action that
    applies all safe fixes; only actions of the kinds that the editor asks for."""
    uri, only = params.text_document.uri, params.context.only
    actions = [
        types.CodeAction(
            fix.title,
            types.CodeActionKind.QuickFix,
            diagnostics=[values.diagnostic(diagnostic, document, uri)],
            is_preferred=fix.sure,
            edit=values.edits(uri, [(fix.span, fix.replacement)], at),
        )
        for diagnostic, fix in fixes_at(document, at.span(params.range))
    ]
    better = text_with_safe_fixes(document)
    if better is not None:
        edit = values.edits(uri, [(_document_span(document), better)], at)
        actions.append(types.CodeAction("Apply all safe fixes", _FIX_ALL, edit=edit))
    return [action for action in actions if only is None or _is_of(action.kind, only)]


def _formatted(document: Document, at: Positions, _params: object) -> list[types.TextEdit]:
    """Return a list with the edit that puts the text into the standard style. The list is empty if
    the text has this style already, or has errors."""
    try:
        text = format_source(document.source)
    except Rejected:  # the error is shown already
        return []
    whole_range = at.range(_document_span(document))
    return [] if text == document.text else [types.TextEdit(whole_range, text)]


def _name(document: Document, at: Positions, params: types.PrepareRenameParams) -> types.Range:
    """Return the range of the name at the position in `params`. Raise CannotRename if it cannot be
    renamed."""
    return at.range(renameable(document, at.offset(params.position)).span)


def _renamed(document: Document, at: Positions, params: types.RenameParams) -> types.WorkspaceEdit:
    """Return the edits that replace the name at the position in `params` by its new name, wherever
    it is used. Raise CannotRename if that is not possible."""
    places = renamed(document, at.offset(params.position), params.new_name)
    changes = [(place, params.new_name) for place in places]
    return values.edits(params.text_document.uri, changes, at)


_ANSWERS: dict[str, tuple[Answer, Any]] = {
    types.TEXT_DOCUMENT_HOVER: (_hover, None),
    types.TEXT_DOCUMENT_COMPLETION: (
        _completions, types.CompletionOptions(trigger_characters=['"', "/"])
    ),
    types.TEXT_DOCUMENT_DOCUMENT_SYMBOL: (_symbols, None),
    types.TEXT_DOCUMENT_INLAY_HINT: (_hints, None),
    types.TEXT_DOCUMENT_DEFINITION: (_definition, None),
    types.TEXT_DOCUMENT_REFERENCES: (_references, None),
    types.TEXT_DOCUMENT_CODE_ACTION: (
        _fixes, types.CodeActionOptions([types.CodeActionKind.QuickFix, _FIX_ALL])
    ),
    types.TEXT_DOCUMENT_FORMATTING: (_formatted, None),
    types.TEXT_DOCUMENT_PREPARE_RENAME: (_name, None),
    types.TEXT_DOCUMENT_RENAME: (_renamed, types.RenameOptions(prepare_provider=True)),
}  # fmt: skip
"""Functions of a text, its positions and the parameters of a request, with the options of the
request."""


def _is_of(kind: str | None, kinds: Sequence[str]) -> bool:
    """Return whether `kind`, a kind of editor action, is one of `kinds` or a subkind, as
    `source.fixAll` is of `source`.

    None is of no kind."""
    return kind is not None and any(
        (kind + ".").startswith(known_kind + ".") for known_kind in kinds
    )


def _document_span(document: Document) -> Span:
    """Return the span of the whole text."""
    return Span(0, len(document.text))
