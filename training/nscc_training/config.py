"""Training configurations as TOML: read them, reporting all errors with their places, and write
them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.toml.schema import Key, KeyValues, file_bytes, file_text, file_values
from nscc_training.settings import SCHEMA, RunSettings


def load_config(path: Path, changes: Sequence[str] = ()) -> RunSettings:
    """Read the settings in a TOML file, with `changes`, each a text SECTION.KEY=VALUE; a change
    replaces the file's value, and of two changes of a key the last counts. Missing keys have their
    defaults.

    Raises Rejected (status 2) with all errors at once: NS0813 for a file that cannot be read or is
    not TOML, NS0814 for unknown keys, NS0815 for invalid values."""
    values, problems, _ = file_values(SCHEMA, file_bytes(SCHEMA, path), str(path))
    return _settings(values, problems, changes)


def settings_of(values: Mapping[str, Any], changes: Sequence[str] = ()) -> RunSettings:
    """Return the settings in a dictionary of sections (`{"train": {"steps": 100}}`), with `changes`
    as texts SECTION.KEY=VALUE; missing keys have their defaults. Raises Rejected (status 2) with
    all errors at once: NS0814 for unknown keys, NS0815 for invalid values."""
    return _settings(*SCHEMA.read(values), changes)


def config_toml(settings: RunSettings, *, remarks: bool = False) -> str:
    """Return a complete configuration file with these settings. With `remarks`, comments give the
    meaning and the allowed values of each key."""

    def remark(key: Key) -> str:
        """Return the comment on a key: its meaning and its allowed values."""
        return f"{key.meaning} ({key.kind.allowed})" if remarks else ""

    head = (
        "A training run of nscc: `nscc train CONFIG.toml --out RUN`.",
        "Every key has its default here; those that are left out keep it.",
    )
    return file_text(SCHEMA, values_of(settings), remark, head if remarks else ())


def values_of(settings: RunSettings) -> dict[str, Any]:
    """Return the value of each setting by the path of its key, such as `train.steps`."""
    return {key.path: getattr(getattr(settings, key.section), key.attribute) for key in SCHEMA.keys}


def _settings(
    values: KeyValues, problems: Sequence[Diagnostic], changes: Sequence[str]
) -> RunSettings:
    """Return the default settings, replaced by `values` (by path of the key) and then by `changes`,
    texts such as `train.steps=100`.

    Raises Rejected (status 2) with all `problems` together: those that were found while `values`
    were read, and those of `changes`."""
    changed, change_problems = SCHEMA.changed(changes)
    if problems or change_problems:
        raise Rejected([*problems, *change_problems], status=2)
    settings = RunSettings()
    for path, value in (values | changed).items():
        key = SCHEMA.by_path[path]
        section = replace(getattr(settings, key.section), **{key.attribute: value})
        settings = replace(settings, **{key.section: section})
    return settings
