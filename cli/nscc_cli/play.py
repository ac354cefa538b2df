"""`nscc play`: serve the playground page to this computer's browser."""

from __future__ import annotations

import json
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from secrets import compare_digest, token_urlsafe
from threading import Lock
from typing import Any

import click

from nscc.containers import is_compiled
from nscc.diagnostics.rejection import rejected
from nscc.syntax.parse import read_source
from nscc_cli.options import PATH
from nscc_cli.playground.page_files import SERVER, TYPES, page_file
from nscc_cli.playground.requests import Playground
from nscc_cli.support import common_command, say_done

_HOST = "127.0.0.1"
_MOST_BYTES = 1 << 24
"""Size of the largest request: a program and a picture of the array."""
_HEADERS = {
    "Connection": "close",
    "Cache-Control": "no-store",
    "Content-Security-Policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' blob: data:; form-action 'none'; frame-ancestors 'none'; base-uri 'none'",
    "Referrer-Policy": "no-referrer",  # the address contains the token
    "X-Content-Type-Options": "nosniff",
}


@common_command("play")
@click.argument("program", metavar="[FILE]", required=False, type=PATH)
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    help="The port of the page (default: any free one).",
)
@click.option("--no-browser", is_flag=True, help="Print the address, but open no browser.")
def command(program: Path | None, port: int, no_browser: bool) -> None:
    """Try programs in a page of your browser: check, words, frames, reconstructions.

    The page compiles and exposes on this computer. Only its browsers reach the page, by an address
    that contains a random word. The page can save FILE; programs may name files in its folder."""
    if program is not None:
        if is_compiled(program):
            raise rejected(
                "NS0796",
                f"'{program}' is compiled already, and the page edits the text of a program",
                helps=("give the .nsl file instead",),
            )
        read_source(program)
    folder = Path.cwd() if program is None else program.parent
    pages = _Pages(Playground(folder, program))
    try:
        server = ThreadingHTTPServer((_HOST, port), partial(_Handler, pages))
    except OSError as error:
        raise rejected(
            "NS0796",
            f"port {port} cannot be opened: {error.strerror}",
            helps=("leave --port out to use any free port",),
        ) from error
    with server:
        pages.port = server.server_address[1]
        address = f"http://{_HOST}:{pages.port}/{pages.token}/"
        click.echo(address)
        say_done("Ctrl-C ends it")
        if not no_browser:
            import webbrowser

            webbrowser.open(address)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            say_done("")


@dataclass
class _Pages:
    """What the threads of the server share; requests are answered one after the other."""

    playground: Playground
    token: str = field(default_factory=lambda: token_urlsafe(18))
    port: int = 0
    lock: Lock = field(default_factory=Lock)


class _Handler(BaseHTTPRequestHandler):
    """Answers the requests of one connection. Other pages and computers cannot ask: the address
    needs the token, and the header `Host` must name this computer."""

    def __init__(self, pages: _Pages, *arguments: Any) -> None:
        """Answer with these pages."""
        self.pages = pages
        super().__init__(*arguments)

    def do_GET(self) -> None:
        """Send a file of the page, or an error for unknown ones."""
        name = self._path()
        if name is None:
            return
        if name == "config.json":
            self._send(json.dumps(SERVER).encode(), TYPES[".json"])
        elif (data := page_file(name or "index.html")) is not None:
            self._send(data, TYPES[Path(name or "index.html").suffix])
        else:
            self._fail(HTTPStatus.NOT_FOUND, f"the page has no file {name[:60]!r}")

    def do_POST(self) -> None:
        """Answer a request of the page, at most `_MOST_BYTES` of JSON, with JSON."""
        kind = self._path()
        if kind is None:
            return
        try:
            length = int(self.headers.get("Content-Length", ""))
        except ValueError:
            length = -1
        if not 0 <= length <= _MOST_BYTES:
            self._fail(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, f"at most {_MOST_BYTES} bytes")
            return
        try:
            values = json.loads(self.rfile.read(length))
        except ValueError:
            values = None
        if not isinstance(values, dict):
            self._fail(HTTPStatus.BAD_REQUEST, "a request is a JSON object")
            return
        with self.pages.lock:
            answer = self.pages.playground.answer(kind, values)
        self._send(json.dumps(answer).encode(), TYPES[".json"])

    def log_message(self, *_arguments: Any) -> None:
        """Print nothing for each request."""

    def _path(self) -> str | None:
        """Return the path below the token; None, and send an error, for strangers."""
        pages = self.pages
        hosts = {f"{host}:{pages.port}" for host in (_HOST, "localhost")}
        token, _, name = self.path.partition("?")[0].removeprefix("/").partition("/")
        if self.headers.get("Host") in hosts and compare_digest(
            token.encode(), pages.token.encode()
        ):
            return name
        self._fail(HTTPStatus.FORBIDDEN, "open the address that `nscc play` printed")
        return None

    def _fail(self, status: HTTPStatus, text: str) -> None:
        """Answer with an error."""
        self._send(f"{text}\n".encode(), "text/plain; charset=utf-8", status)

    def _send(self, data: bytes, kind: str, status: HTTPStatus = HTTPStatus.OK) -> None:
        """Answer with data; do nothing if the page was closed."""
        with suppress(ConnectionError):  # the page was closed
            self._write(data, kind, status)

    def _write(self, data: bytes, kind: str, status: HTTPStatus) -> None:
        """Send a response with this status, content type (`kind`) and data."""
        self.send_response(status)
        for header, value in _HEADERS.items():
            self.send_header(header, value)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)
