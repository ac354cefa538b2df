"""The examples in docstrings give the results that are written below them."""

import doctest
import importlib

import pytest
from checkout import ROOT

_PACKAGES = {"nscc": ROOT, "nscc_runtime": ROOT / "runtime", "nscc_training": ROOT / "training"}
_MODULES = sorted(
    ".".join(path.relative_to(folder).with_suffix("").parts)
    for package, folder in _PACKAGES.items()
    for path in (folder / package).rglob("*.py")
    if ">>> " in path.read_text(encoding="utf-8")
)


@pytest.mark.parametrize("name", _MODULES)
def test_the_examples_of_a_module_give_what_they_say(name: str) -> None:
    if name.startswith("nscc_training"):
        pytest.importorskip("torch")
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert (failed, tried > 0) == (0, True)
