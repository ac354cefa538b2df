"""Import of a user's own decoder, data or loss, `module:name`, also from the current folder."""

from __future__ import annotations

import importlib
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc_training.problems import is_out_of_memory, one_line


def is_import_path(text: str) -> bool:
    """Return whether the configured name `text` is an import path, `module:name`: whether it has a
    colon."""
    return ":" in text


def imported(text: str, role: str) -> Any:
    """Import the object that `text`, `module:name`, names, also from the current folder, and return
    it. The name may have dots (`module:Class.method`). Python's search path is restored.

    `role` (decoder, data or loss) names it in messages. Raises Rejected (NS0812) if it cannot be
    imported or called."""
    module, _, name = text.partition(":")
    current_folder = str(Path.cwd())
    added = current_folder not in sys.path
    if added:
        sys.path.insert(0, current_folder)
    try:
        target: Any = importlib.import_module(module)
        for attribute in name.split("."):
            target = getattr(target, attribute)
    except Exception as error:  # whatever the user's module raises while it is imported
        raise rejected(
            "NS0812",
            f"the {role} '{text[:100]}' cannot be imported",
            notes=(f"{type(error).__name__}: {one_line(error)}",),
            helps=("an import path is `module:name`, importable from the current folder",),
        ) from error
    finally:
        if added and current_folder in sys.path:
            sys.path.remove(current_folder)
    if not callable(target):
        raise rejected(
            "NS0812",
            f"the {role} '{text[:100]}' is a {type(target).__name__}, which cannot be called",
            helps=("name a class or a function",),
        )
    return target


@contextmanager
def own_code(text: str, role: str) -> Iterator[None]:
    """Run the `with` block, and raise Rejected (NS0822), with file and line, for an exception of
    user code in it.

    `text` is the import path of the code, `role` its use (decoder, data or loss). Errors of nscc
    and lack of memory pass unchanged."""
    try:
        yield
    except Rejected:
        raise
    except Exception as error:  # the user's code may raise anything
        if is_out_of_memory(error):
            raise
        last = traceback.extract_tb(error.__traceback__)[-1]
        location = f"{Path(last.filename).name}, line {last.lineno}"
        raise own_failed(
            text, role, f"{type(error).__name__}: {one_line(error)} ({location})"
        ) from error


def own_failed(text: str, role: str, reason: str) -> Rejected:
    """Return the error (NS0822) for user code that does not do what its `role` requires (decoder,
    data or loss).

    `text` is the import path of the code, and `reason` says what it did."""
    return rejected(
        "NS0822",
        f"the {role} '{text[:100]}' fails",
        notes=(reason,),
        helps=("`nscc explain NS0822` describes how it is called and what it must return",),
    )
