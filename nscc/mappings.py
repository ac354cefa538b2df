"""Types of dicts whose values have several types. Another dict names the type of its values."""

from __future__ import annotations

from typing import Any

JsonObject = dict[str, Any]
"""An object of a JSON or TOML document, as it is written or was read: texts, numbers, true, false,
None, lists and objects by key. What a document contains stands in the docs of its format."""
NamedValues = dict[str, Any]
"""Python values by name that go on as they are: keyword arguments, options of a command, or fields
of a record."""
