"""docs/python.md, and what the packages say of themselves: run word by word."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
from checkout import ROOT

pytestmark = pytest.mark.pages

PAGE = ROOT / "docs" / "python.md"
PACKAGES = ("nscc", "nscc_runtime", "nscc_training")


def blocks(language: str) -> list[str]:
    """The fenced blocks of a language on the page."""
    return re.findall(rf"^```{language}\n(.*?)^```$", PAGE.read_text(), re.M | re.S)


# The page says that its frame gives this one.
@pytest.mark.filterwarnings(r"ignore:warning\[NS0842\]")
def test_the_page_works_from_top_to_bottom(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("torch")
    from cpu_torchvision import declare_operators

    declare_operators()
    pytest.importorskip("deepinv")
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    printed = []
    for text in blocks("python"):
        capsys.readouterr()
        exec(compile(text, PAGE.name, "exec"), names)
        printed.append(capsys.readouterr().out)
    for shown in blocks("text"):
        assert shown in printed


DOCUMENTED = (
    "nscc",
    "nscc.shutter_program",
    "nscc_runtime",
    "nscc_runtime.exposing",
    "nscc_training",
    "nscc_training.deepinv",
)


@pytest.mark.parametrize("name", DOCUMENTED)
def test_examples_in_docstrings_of_modules_work(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if name.startswith("nscc_training"):
        pytest.importorskip("torch")
        from cpu_torchvision import declare_operators

        declare_operators()
        pytest.importorskip("deepinv")
    shutil.copytree(ROOT / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    text = inspect.getdoc(importlib.import_module(name))
    shown = textwrap.dedent("\n".join(re.findall(r"^(?: {4}.*)?$", text or "", re.M)))
    assert "import nscc" in shown
    exec(compile(shown, name, "exec"), {})


@pytest.mark.parametrize("package", PACKAGES)
def test_public_names_are_documented_and_no_module_has_their_name(package: str) -> None:
    """A module with a public name would replace the name in its package once it is imported."""
    if package == "nscc_training":
        pytest.importorskip("torch")
    module = importlib.import_module(package)
    submodules = {each.name for each in pkgutil.iter_modules(module.__path__)}
    assert not submodules & {*module.__all__}
    assert [*module.__all__] == sorted(module.__all__)
    for name in {*module.__all__} - {"__version__"}:
        found = getattr(module, name)
        assert inspect.getdoc(found), name
        assert name in dir(module)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = module.nothing


@pytest.mark.parametrize("package", PACKAGES)
def test_the_page_names_everything_public(package: str) -> None:
    public = {*importlib.import_module(package).__all__} - {"__version__"}
    [row] = re.findall(rf"^\| `{package}` \| (.*?) \|", PAGE.read_text(), re.M)
    assert set(re.findall(r"`(\w+)`", row)) == public


def test_importing_the_packages_imports_no_large_module() -> None:
    code = (
        "import sys, nscc, nscc_runtime, nscc_training; "
        "heavy = ('numpy', 'lark', 'numba', 'torch', 'nscc.pipeline'); "
        "print([name for name in heavy if name in sys.modules])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout == "[]\n"


PROGRAM = "nscc.compile('nsl 1 frame 2 slots of 1ms open when true')"


@pytest.mark.parametrize(
    ("module", "use", "needs", "extra"),
    [
        ("torch", "nscc_training.load_run", "nscc_training.load_run needs torch", "(train|all)"),
        (
            "llvmlite",
            f"nscc_runtime.capture({PROGRAM}, 'builtin:hdr')",
            "the emulator needs llvmlite",
            "(run|all)",
        ),
    ],
)
def test_a_missing_package_is_named_with_the_pip_command(
    module: str, use: str, needs: str, extra: str
) -> None:
    code = (
        f"import sys; sys.modules[{module!r}] = None; import nscc, nscc_runtime, nscc_training\n"
        f"try: {use}\n"
        "except ModuleNotFoundError as error: print(error, error.name)"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    wanted = rf"{needs}: pip install 'nscc\[{extra}\]' {module}\n"
    assert re.fullmatch(wanted, found.stdout)
