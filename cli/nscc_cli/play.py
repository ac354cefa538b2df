"""`nscc play`: serve the playground page to this computer's browser."""

from __future__ import annotations

import json
from contextlib import suppress
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from secrets import compare_digest, token_urlsafe
from threading import Lock
from typing import Any

import click

from nscc.containers import is_compiled
from nscc.diagnostics.diagnostic import rejected
from nscc.syntax.parse import read_source
from nscc_cli.options import PATH, flag
from nscc_cli.playground import PAGE
from nscc_cli.playground.requests import Playground
from nscc_cli.support import common_command, say_done

_HOST = "127.0.0.1"
_MOST_BYTES = 1 << 24
"""Size of the largest request: a program and a picture of the array."""
_HEADERS = {
    "Cache-Control": "no-store",
    "Content-Security-Policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' blob: data:; form-action 'none'; frame-ancestors 'none'; base-uri 'none'",
    "Referrer-Policy": "no-referrer",  # the address contains the token
    "X-Content-Type-Options": "nosniff",
}


@common_command("play")
@click.argument("program", metavar="[FILE]", required=False, type=PATH)
@flag("--no-browser", "Print the address, but open no browser.")
def command(program: Path | None, no_browser: bool) -> None:
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
    playground = Playground(Path.cwd() if program is None else program.parent, program)
    # 18 random bytes, which another page cannot guess.
    token = token_urlsafe(18)
    handler = partial(_Handler, playground, Lock(), token)
    with ThreadingHTTPServer((_HOST, 0), handler) as server:  # any free port
        address = f"http://{_HOST}:{server.server_port}/{token}/"
        click.echo(address)
        say_done("Ctrl-C ends it")
        if not no_browser:
            import webbrowser

            webbrowser.open(address)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            say_done("")


class _Handler(SimpleHTTPRequestHandler):
    """Answers the requests of one connection, and sends the files of the page.

    `playground` computes the answers, one at a time because of `lock`. Other pages and computers
    cannot ask: the address needs the `token`, and the header `Host` must name this computer."""

    error_message_format, error_content_type = "%(message)s\n", "text/plain; charset=utf-8"

    def __init__(self, playground: Playground, lock: Lock, token: str, *connection: Any) -> None:
        """Answer one connection with the page of this playground. `connection` are the further
        arguments of http.server."""
        self.playground, self.lock, self.token = playground, lock, token
        super().__init__(*connection, directory=PAGE.as_posix())

    def handle(self) -> None:
        """Answer, unless the page was closed meanwhile."""
        with suppress(ConnectionError):
            super().handle()

    def parse_request(self) -> bool:
        """Read the head of a request and remove the token from its path. Return whether it is
        valid.

        A request without the token, or with another `Host`, is answered with an error (403)."""
        if not super().parse_request():
            return False
        port = self.connection.getsockname()[1]
        token, _, name = self.path.removeprefix("/").partition("/")
        self.path = f"/{name}"
        is_here = self.headers.get("Host") in (f"{_HOST}:{port}", f"localhost:{port}")
        if is_here and compare_digest(token.encode(), self.token.encode()):
            return True
        self.send_error(403, "open the address that `nscc play` printed")
        return False

    def do_POST(self) -> None:
        """Answer a request of the page: a JSON object, whose kind (see `Playground.answer`) is the
        path of the address. The answer is a JSON object, too.

        Anything else, and more than `_MOST_BYTES`, is answered with an error (400)."""
        try:
            length = int(self.headers.get("Content-Length", ""))
            values = json.loads(self.rfile.read(length)) if 0 <= length <= _MOST_BYTES else None
        except ValueError:
            values = None
        if not isinstance(values, dict):
            self.send_error(400, f"a request is a JSON object of at most {_MOST_BYTES} bytes")
            return
        with self.lock:
            answer = json.dumps(self.playground.answer(self.path[1:], values)).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(answer)))
        self.end_headers()
        self.wfile.write(answer)

    def end_headers(self) -> None:
        """Add the headers that keep the page and its address to this computer."""
        for header, value in _HEADERS.items():
            self.send_header(header, value)
        super().end_headers()

    def log_message(self, *_arguments: Any) -> None:
        """Print nothing for each request."""
