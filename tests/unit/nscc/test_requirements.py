"""Which extra brings a package: as the metadata of the installation says."""

from __future__ import annotations

from importlib import metadata

import pytest

from nscc import requirements

ASKED = [
    "numpy>=2.0",
    'OpenEXR>=3.3; extra == "all"',
    'torch>=2.11,<2.14; extra == "all"',
    'pyserial>=3.5 ; extra == "all"',
    'openexr>=3.3; extra == "device"',
    'pyserial>=3.5 ; python_version > "3" and extra == "device"',
    "OpenEXR>=3.3; extra == 'run'",
]


@pytest.fixture(autouse=True)
def _read_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    """In every test of this file, each call reads the extras again instead of from the cache."""
    monkeypatch.setattr(requirements, "extras", requirements.extras.__wrapped__)


@pytest.mark.parametrize(
    ("module", "line"),
    [
        ("numpy.linalg", "pip install nscc"),
        ("OpenEXR", "pip install 'nscc[run]'"),
        ("serial.tools", "pip install 'nscc[device]'"),
        ("what_these_need", "pip install 'nscc[all]'"),
    ],
)
def test_the_pip_command_for_a_missing_module_names_its_smallest_extra(
    module: str, line: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(metadata, "requires", lambda _name: ASKED)
    assert requirements.line_for(module) == line


def test_the_pip_command_installs_all_extras_if_nscc_is_not_installed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def missing(name: str) -> list[str]:
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "requires", missing)
    assert requirements.line_for("torch") == "pip install 'nscc[all]'"
