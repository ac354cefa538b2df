"""Nothing in the product is unused: vulture finds no name that only its definition mentions."""

from __future__ import annotations

import ast

from checkout import ROOT
from vulture import Vulture

PRODUCT = ("nscc", "runtime/nscc_runtime", "training/nscc_training", "cli/nscc_cli")
USERS = ("docs/nscc_site", "docs/motion_cells.py", "training/results")
"""What uses the product without being a part of it; tests do not count."""

CALLED_BY_LIBRARIES = [
    "__getattr__", "__dir__", "_repr_html_", "_render_traceback_",
    "closure",  # of an optimizer's step in torch
    "setup_context", "A_dagger", "A_A_adjoint",  # torch, DeepInverse
    "stdio", "command_class",  # click
    "find_class",  # pickle
    "do_POST", "log_message", "error_message_format", "error_content_type",  # http.server
    "thread_type",  # PyAV
    "external_attr", "linkage",  # read by zipfile and llvmlite
]  # fmt: skip
DECLARED_AS_TEXT = [
    "StillUNet",
    "ClipUNet",
    "Refined",
    "Divided",
    "Classifier",  # decoders
    "Images",
    "Looks",
    "BitPlanes",
    "ImagesRun",
    "LooksRun",
    "BitPlanesRun",  # kinds of programs
]
"""Classes, which a table names as MODULE:CLASS."""

KEPT = [
    "PixelShutters",  # public: the operator for DeepInverse
    "RIGHT",  # one of four directions
    "write_shipped",  # docs/reconstruct.md
    "shipped_cell",  # docs/tutorials/network.md
    "resent",  # a count that tests of the protocol read
]
OF_THE_PROTOCOL = [
    "EMPTY",
    "COMPLETE",
    "REFUSED",
    "WRONG_STATE",
    "TOO_LARGE",
    "NO_FRAME",
    "released",
    "latest_us",
    "MOST_LAUNCHES",
]
"""Numbers and fields that loaders send and hosts need not look at."""

EXCEPTIONS = [*CALLED_BY_LIBRARIES, *DECLARED_AS_TEXT, *KEPT, *OF_THE_PROTOCOL]
DECORATED = ["@command.command*", "@click.command", "@common_command", "@server.feature"]
"""Commands of click, and answers of the language server."""


def test_vulture_finds_nothing_unused() -> None:
    finder = Vulture(ignore_names=EXCEPTIONS, ignore_decorators=DECORATED)
    finder.scavenge([str(ROOT / folder) for folder in (*PRODUCT, *USERS)])
    unused = [
        f"{item.filename}:{item.first_lineno}: {item.name}"
        for item in finder.get_unused_code(min_confidence=60)
        if not any(item.filename.is_relative_to(ROOT / folder) for folder in USERS)
    ]
    assert unused == []


def test_every_exception_of_the_vulture_test_is_needed() -> None:
    finder = Vulture()
    finder.scavenge([str(ROOT / folder) for folder in (*PRODUCT, *USERS)])
    names = {item.name for item in finder.get_unused_code(min_confidence=60)}
    assert names >= set(EXCEPTIONS)


def test_no_zip_in_the_product_drops_items_of_a_longer_sequence() -> None:
    """Where sequences of different lengths are paired, the product first cuts them to one
    length."""
    files = [path for folder in PRODUCT for path in (ROOT / folder).rglob("*.py")]
    assert [str(path) for path in files if _cuts_pairs(path.read_text())] == []


def _cuts_pairs(text: str) -> bool:
    """Whether a module calls `zip` with `strict=False`."""
    return any(
        isinstance(node, ast.Call)
        and ast.unparse(node.func) == "zip"
        and any(ast.unparse(each) == "strict=False" for each in node.keywords)
        for node in ast.walk(ast.parse(text))
    )


def test_a_zip_that_is_not_strict_is_noticed() -> None:
    assert _cuts_pairs("for a, b in zip(x, y, strict=False): pass")
    assert not _cuts_pairs("kind = guess_type(name, strict=False)")
