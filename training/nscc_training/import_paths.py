"""A user's own decoder, data or loss: `module:name`, looked for in the current folder too."""

from __future__ import annotations

import importlib
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Rejected
from nscc.diagnostics.rejection import rejected
from nscc_training.problems import is_out_of_memory, one_line


def is_import_path(text: str) -> bool:
    """Whether a configured name means something of the user's."""
    return ":" in text


def imported(text: str, role: str) -> Any:
    """The object at `module:name`; Rejected (NS0812) where it cannot be had."""
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
    """Whatever the user's code raises in this block is Rejected (NS0822), with its place."""
    try:
        yield
    except Rejected:
        raise
    except Exception as error:  # the user's code may raise anything
        if is_out_of_memory(error):
            raise
        last = traceback.extract_tb(error.__traceback__)[-1]
        place = f"{Path(last.filename).name}, line {last.lineno}"
        raise own_failed(
            text, role, f"{type(error).__name__}: {one_line(error)} ({place})"
        ) from error


def own_failed(text: str, role: str, reason: str) -> Rejected:
    """NS0822: the user's code does not do what training needs of it."""
    return rejected(
        "NS0822",
        f"the {role} '{text[:100]}' does not work",
        notes=(reason,),
        helps=("`nscc explain NS0822` says what it is called with and has to give",),
    )
