"""The wheel by itself: built, installed into a bare environment elsewhere, and used from there.

The environment sees the distributions that the wheel asks for, and no others: each is linked
from the environment that runs the tests, so that nothing is downloaded. `make test-slow` lets pip
resolve and install them for real.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tarfile
from collections.abc import Iterator, Sequence
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement

LARGEST_BASE = 120_000_000
"""Bytes that `pip install nscc` may bring, those that Python compiles at once included."""

OWN = {"nscc", "nscc_cli", "nscc_runtime", "nscc_training"}

pytestmark = pytest.mark.xdist_group("wheel")


@pytest.fixture(scope="session")
def dist(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the sdist and the wheel that was built from that sdist."""
    folder = tmp_path_factory.mktemp("dist")
    build = [sys.executable, "-m", "build", "--no-isolation", "--outdir", folder, root]
    done(build, folder)
    return folder


@pytest.fixture(scope="session")
def elsewhere(dist: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A bare environment, outside the checkout, with the wheel in it and what it asks for."""
    home = tmp_path_factory.mktemp("elsewhere")
    done([sys.executable, "-m", "venv", "--without-pip", home / "venv"], home)
    site = site_packages(home / "venv")
    [wheel] = dist.glob("*.whl")
    pip = [sys.executable, "-m", "pip", "--python", home / "venv"]
    done([*pip, "install", "--no-deps", "--no-index", "--quiet", wheel], home)
    (site / "needed.pth").write_text(f"{linked(needed_by(site), home / 'needed')}\n")
    return home


def test_only_own_names_in_site_packages(elsewhere: Path) -> None:
    found = {path.name for path in site_packages(elsewhere / "venv").iterdir()}
    assert {name for name in found if not name.endswith((".dist-info", ".pth"))} == OWN


def test_wheel_holds_grammar_targets_pages_and_types(elsewhere: Path) -> None:
    site = site_packages(elsewhere / "venv")
    assert (site / "nscc/syntax/nsl.lark").is_file()
    assert (site / "nscc/chips/tables/scamp5.toml").is_file()
    assert len(list((site / "nscc/diagnostics/pages").glob("NS*.md"))) > 50
    assert (site / "nscc_training/protocol_files/sci8.toml").is_file()
    for run in ("hdr", "clip"):
        assert (site / f"nscc_training/shipped_runs/{run}/decoder.safetensors").is_file()
    assert (site / "nscc_training/searched_codes.npz").is_file()
    for name in OWN:
        assert (site / name / "py.typed").is_file()


def test_sdist_contains_examples_tests_and_docs(dist: Path, root: Path) -> None:
    [sdist] = dist.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        packed = {Path(*Path(name).parts[1:]) for name in archive.getnames()}
    for kind in ("examples/*.nsl", "grammars/*", "tests/**/*.py", "tests/cases/*/*", "docs/*.md"):
        missing = {path.relative_to(root) for path in root.glob(kind)} - packed
        assert not missing
    assert {Path("Makefile"), Path("constraints.txt"), Path("LICENSE"), Path(".ci/run")} <= packed


def test_compiles_an_example_and_says_what_running_needs(elsewhere: Path, root: Path) -> None:
    nscc = elsewhere / "venv" / "bin" / "nscc"
    program = elsewhere / "hdr_2x2.nsl"
    done([nscc, "examples", "hdr_2x2"], elsewhere)
    assert program.read_bytes() == (root / "examples" / program.name).read_bytes()
    done([nscc, "build", program.name], elsewhere)
    done([nscc, "prove", "hdr_2x2.icw"], elsewhere)
    done([nscc, "doctor"], elsewhere)
    place = "import nscc, nscc_cli, nscc_runtime, nscc_training; print(nscc.__file__)"
    python = elsewhere / "venv" / "bin" / "python"
    assert done([python, "-c", place], elsewhere).startswith(str(elsewhere))
    for arguments, extra in (
        ("run hdr_2x2.icw --scene builtin:hdr", "run"),
        ("view hdr_2x2.icw -o shutters.png", "view"),
        ("device info /dev/null", "device"),
        ("reconstruct hdr hdr_2x2.icw -o out.npz", "train"),
    ):
        refused = outcome_of([nscc, *arguments.split()], elsewhere)
        assert (refused.returncode, "[NS0904]" in refused.stderr) == (2, True), refused.stderr
        assert f"pip install 'nscc[{extra}]'" in refused.stderr


@pytest.mark.slow
def test_runs_an_example_with_what_the_extra_names(elsewhere: Path, root: Path) -> None:
    nscc = elsewhere / "venv" / "bin" / "nscc"
    program = root / "examples" / "hdr_2x2.nsl"
    needed = needed_by(site_packages(elsewhere / "venv"), "run")
    links = linked(needed, elsewhere / "needed_to_run")
    run = [nscc, "run", program, "--scene", "builtin:hdr"]
    done([*run, "-o", "frame.npz"], elsewhere, links)
    done([*run, "--audit", "-o", "p.npz"], elsewhere, links)
    assert (elsewhere / "frame.npz").stat().st_size > 1000
    done([*run[:1], "run", "--like", "hdr", *run[3:], "-o", "like.exr"], elsewhere, links)


@pytest.mark.slow
def test_pip_installs_all_that_is_needed(dist: Path, root: Path, tmp_path: Path) -> None:
    done([sys.executable, "-m", "venv", tmp_path / "venv"], tmp_path)
    [wheel] = dist.glob("*.whl")
    python = tmp_path / "venv" / "bin" / "python"
    constraints = root / "constraints.txt"
    done([python, "-m", "pip", "install", "--quiet", "-c", constraints, wheel], tmp_path)
    done([tmp_path / "venv" / "bin" / "nscc", "doctor"], tmp_path)
    site = site_packages(tmp_path / "venv")
    tools = {"pip", "setuptools", "pkg_resources", "_distutils_hack"}
    own = (path for path in site.iterdir() if path.name.partition("-")[0] not in tools)
    files = (file for each in own for file in (each, *each.rglob("*")) if file.is_file())
    assert sum(file.stat().st_size for file in files) < LARGEST_BASE


def done(command: Sequence[str | Path], folder: Path, *paths: Path) -> str:
    """Standard output of a command that must succeed; see `outcome_of`."""
    outcome = outcome_of(command, folder, *paths)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
    return outcome.stdout


def outcome_of(
    command: Sequence[str | Path], folder: Path, *paths: Path
) -> subprocess.CompletedProcess[str]:
    """What comes of a command in an environment without the checkout, but with these paths."""
    bare = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "PYTHONHOME")}
    if paths:
        bare["PYTHONPATH"] = os.pathsep.join(map(str, paths))
    return subprocess.run(
        [str(part) for part in command], cwd=folder, env=bare, capture_output=True, text=True
    )


def site_packages(environment: Path) -> Path:
    """Where the environment's distributions lie."""
    [site] = environment.glob("lib/python*/site-packages")
    return site


def needed_by(site: Path, extra: str = "") -> list[str]:
    """The names of all distributions that nscc as installed in `site` asks for, directly or not."""
    [own] = metadata.distributions(name="nscc", path=[str(site)])
    waiting, found = list(requirements(own, extra)), set[str]()
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting.extend(requirements(metadata.distribution(name)))
    return sorted(found)


def requirements(distribution: metadata.Distribution, extra: str = "") -> Iterator[str]:
    """What a distribution asks for here, with one of its extras or none."""
    for text in distribution.requires or ():
        requirement = Requirement(text)
        if requirement.marker is None or requirement.marker.evaluate({"extra": extra}):
            yield requirement.name


def linked(names: Sequence[str], links: Path) -> Path:
    """A new folder `links` with all that these distributions put into site-packages."""
    links.mkdir()
    for name in names:
        link_distribution(name, links)
    return links


def link_distribution(name: str, links: Path) -> None:
    """Make what a distribution put into site-packages visible in the folder `links`."""
    distribution = metadata.distribution(name)
    tops = {file.parts[0] for file in distribution.files or () if file.parts[0] != ".."}
    for top in sorted(tops - {"__pycache__"}):
        link = links / top
        if not link.exists():
            link.symlink_to(Path(str(distribution.locate_file(top))).resolve())
