"""`nscc play` answers the page that it serves, and nobody else."""

from __future__ import annotations

import http.client
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from nscc_command import invoke
from play_session import play_session

from nscc_cli.playground import PAGE

PROGRAM = "nsl 1\nframe 8 slots of 1ms\nopen when n < 4\n"


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with play_session(tmp_path_factory.mktemp("play"), PROGRAM) as served:
        yield urlsplit(served)


def ask(address: Any, method: str, path: str, body: str = "", **headers: str) -> tuple[int, Any]:
    connection = http.client.HTTPConnection(address.hostname, address.port, timeout=60)
    connection.request(method, path, body, headers)
    response = connection.getresponse()
    data = response.read()
    connection.close()
    is_json = response.headers["Content-Type"] == "application/json"
    return response.status, json.loads(data) if is_json else data


def test_the_address_is_this_computer_with_a_secret(address: Any) -> None:
    """The page is served on 127.0.0.1 only. Its path is a random key of 24 letters."""
    assert address.hostname == "127.0.0.1"
    # 18 random bytes in base64 are 24 letters.
    assert len(address.path.strip("/")) == 24


def test_the_page_and_all_its_files_are_served(address: Any) -> None:
    """Below the key the server sends each file of the page as it is. Only `config.json` is made: it
    says `server`."""
    status, page = ask(address, "GET", address.path)
    assert status == 200
    assert page == (PAGE / "index.html").read_bytes()
    for file in {*PAGE.iterdir()} - {PAGE / "config.json"}:
        assert ask(address, "GET", address.path + file.name) == (200, file.read_bytes())
    assert ask(address, "GET", f"{address.path}config.json") == (200, {"engine": "server"})


@pytest.mark.parametrize("name", ["requests.py", "../requests.py", "%2e%2e/requests.py", "/etc"])
def test_other_files_are_not_served(address: Any, name: str) -> None:
    """The server's own source, a parent folder in any spelling and `/etc` give status 404."""
    assert ask(address, "GET", address.path + name)[0] == 404


def test_requests_without_the_key_or_from_other_hosts_are_refused(address: Any) -> None:
    """A path without the key, and a Host header of another site, give status 403."""
    host = {"Host": "evil.example"}
    for path, headers in (("/", {}), ("/guess/start", {}), (f"{address.path}start", host)):
        for method in ("GET", "POST"):
            status, text = ask(address, method, path, "{}", **headers)
            assert status == 403
            assert b"nscc play" in text


def test_the_requests_start_and_check_are_answered(address: Any) -> None:
    """`start` gives the file and its text. `check` without a program gives the error NS0796 in its
    answer."""
    status, start = ask(address, "POST", f"{address.path}start", "{}")
    assert status == 200
    assert start["file"] == {"name": "mine.nsl", "text": PROGRAM}
    status, answer = ask(address, "POST", f"{address.path}check", "{}")
    assert status == 200
    assert answer["messages"][0]["code"] == "NS0796"


@pytest.mark.parametrize("body", ["", "[]", "{", "\xff"], ids=["none", "list", "cut", "letters"])
def test_requests_that_are_no_objects_fail(address: Any, body: str) -> None:
    """An empty body, a list, broken JSON and other letters give status 400."""
    assert ask(address, "POST", f"{address.path}check", body)[0] == 400


def test_long_requests_are_not_read(address: Any) -> None:
    """A declared length of 100 MB gives status 400 before any byte is read."""
    status, _ = ask(address, "POST", f"{address.path}check", **{"Content-Length": "99999999"})
    assert status == 400


def test_wrong_arguments_of_play_are_refused_with_a_help(tmp_path: Path) -> None:
    """A container instead of a program gives NS0796, which asks for the .nsl file. A missing file
    has status 2, too."""
    compiled = invoke(["play", "mine.icw"], tmp_path)
    assert (compiled.status, compiled.codes) == (2, ["NS0796"])
    assert "give the .nsl file" in compiled.err
    assert invoke(["play", "missing.nsl"], tmp_path).status == 2
