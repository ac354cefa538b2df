"""A user's own decoder, data or loss: `module:name`, looked for in the current folder too."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

from nscc.diagnostics.rejection import rejected


def is_import_path(text: str) -> bool:
    """Whether a configured name means something of the user's."""
    return ":" in text


def imported(text: str, what: str) -> Any:
    """The object at `module:name`; Rejected (NS0812) where it cannot be had."""
    module, _, name = text.partition(":")
    here = str(Path.cwd())
    added = here not in sys.path
    if added:
        sys.path.insert(0, here)
    try:
        found: Any = importlib.import_module(module)
        for part in name.split("."):
            found = getattr(found, part)
    except Exception as error:  # whatever the user's module raises while it is imported
        raise rejected(
            "NS0812",
            f"the {what} '{text[:100]}' cannot be imported",
            notes=(f"{type(error).__name__}: {' '.join(str(error).split())[:200]}",),
            helps=("an import path is `module:name`, importable from the current folder",),
        ) from error
    finally:
        if added and here in sys.path:
            sys.path.remove(here)
    if not callable(found):
        raise rejected(
            "NS0812",
            f"the {what} '{text[:100]}' is a {type(found).__name__}, which cannot be called",
            helps=("name a class or a function",),
        )
    return found
