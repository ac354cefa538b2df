"""Public functions and classes have numpydoc docstrings with all parameters and results."""

from __future__ import annotations

import importlib
from collections.abc import Iterator

import pytest

pytest.importorskip("numpydoc")
pytest.importorskip("torch")
from numpydoc.validate import validate

PACKAGES = ("nscc", "nscc_runtime", "nscc_training")
CHECKS = {"GL08", "SS01", "SS05", "PR01", "PR02", "PR03", "PR04", "PR10", "RT01", "YD01"}
"""Docstring and summary present, summary in the imperative; parameters documented, known, in order,
with types and spaces around the colon; a Returns or Yields section."""
EXCEPTIONS = {
    "nscc.Target": {"PR01"},  # each key describes itself: `nscc targets scamp5 --toml`
}


def public_names() -> Iterator[str]:
    """The names in `__all__` of each package, with the public members of classes."""
    for package in PACKAGES:
        module = importlib.import_module(package)
        for name in module.__all__:
            if name.startswith("__"):
                continue
            yield f"{package}.{name}"
            value = getattr(module, name)
            if isinstance(value, type):
                members = (vars(value)[member] for member in vars(value))
                documented = (classmethod, staticmethod, property)
                for member, content in zip(vars(value), members, strict=True):
                    public = not member.startswith("_")
                    if public and (callable(content) or isinstance(content, documented)):
                        yield f"{package}.{name}.{member}"


@pytest.mark.parametrize("name", [*public_names()])
def test_public_docstrings_pass_numpydoc(name: str) -> None:
    errors = {code: text for code, text in validate(name)["errors"] if code in CHECKS}
    for code in EXCEPTIONS.get(name, set()):
        assert errors.pop(code, None), f"{name}: {code} needs no exception any more"
    assert not errors
