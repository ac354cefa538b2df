"""Configurations: TOML in, TOML out, every mistake told at once and with its place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.toml.files import file_bytes, file_text, file_values
from nscc.toml.schema import Found, Key
from nscc_training.settings import SCHEMA, RunSettings


def load_config(path: Path, changes: Sequence[str] = ()) -> RunSettings:
    """The settings of a file, with `changes`, each SECTION.KEY=VALUE, on top.

    Raises Rejected, status 2: NS0813 for a file that cannot be read or is no TOML, NS0814 for keys
    that are none, NS0815 for wrong values; all that is wrong at once.
    """
    values, problems, _ = file_values(SCHEMA, file_bytes(SCHEMA, path), str(path))
    return _settings(values, problems, changes)


def settings_of(values: Mapping[str, Any], changes: Sequence[str] = ()) -> RunSettings:
    """The settings of a dictionary of sections; as `load_config`."""
    return _settings(*SCHEMA.read(values), changes)


def config_toml(settings: RunSettings, *, remarks: bool = False) -> str:
    """A complete file that `load_config` reads back; with `remarks`, what each key means."""

    def remark(key: Key) -> str:
        return f"{key.meaning} ({key.kind.allowed})" if remarks else ""

    head = (
        "A training run of nscc: `nscc train CONFIG.toml --out RUN`.",
        "Every key has its default here; those that are left out keep it.",
    )
    values = {
        key.path: getattr(getattr(settings, key.section), key.attribute) for key in SCHEMA.keys
    }
    return file_text(SCHEMA, values, remark, head if remarks else ())


def _settings(values: Found, problems: Sequence[Diagnostic], changes: Sequence[str]) -> RunSettings:
    changed, change_problems = SCHEMA.changed(changes)
    if problems or change_problems:
        raise Rejected([*problems, *change_problems], status=2)
    settings = RunSettings()
    for path, value in (values | changed).items():
        key = SCHEMA.by_path[path]
        section = replace(getattr(settings, key.section), **{key.attribute: value})
        settings = replace(settings, **{key.section: section})
    return settings
