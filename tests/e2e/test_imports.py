"""Who imports whom: four floors and no stair up, no circle, and a short start-up.

Every import of every file counts, those inside functions and those for type checkers too.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tomllib
from functools import cache
from itertools import chain
from pathlib import Path

import pytest
from checkout import ROOT
from import_graph import arrows_up, circles, file_graph, folder_graph, imported, modules
from packaging.requirements import Requirement

from nscc.requirements import distribution_of

FLOORS = {
    "nscc": "nscc",
    "nscc_runtime": "runtime/nscc_runtime",
    "nscc_training": "training/nscc_training",
    "nscc_cli": "cli/nscc_cli",
}
"""From the ground up: each may import those before it."""

ROOMS = (
    ("arrays", "mappings", "record"),
    ("codec",),
    (
        "columns",
        "html",
        "npy",
        "operations",
        "requirements",
        "source",
        "truth",
        "version",
    ),
    ("lazy",),
    ("diagnostics", "macros"),
    ("examples", "experiment_store", "files", "plugins"),
    ("toml",),
    ("chips",),
    ("logic", "words"),
    ("cache", "kinds", "prove"),
    ("syntax",),
    ("installation", "program"),
    ("lower",),
    ("checks", "options"),
    ("pipeline",),
    ("container_proof", "emit", "limits"),
    ("looks", "neighbours", "stream"),
    ("compiler",),
    ("compare", "containers", "editing"),
    ("shutter_program",),
    ("cell_magic",),
)
"""The compiler's rooms from the ground up: one may import those of earlier lines."""

EXTERNAL = {"nscc": {"lark", "networkx", "numpy"}}
"""What a floor may import that is neither nscc's nor Python's, where that is limited."""

OF_THE_COMMAND_LINE = ("lsp",)
"""Extras that only ways to talk to users need."""

HEAVY = (
    "cv2",
    "matplotlib",
    "networkx",
    "numba",
    "numpy.random",
    "PIL",
    "pygls",
    "scipy",
    "serial",
    "torch",
)


@cache
def files() -> dict[str, Path]:
    found: dict[str, Path] = {}
    for folder in FLOORS.values():
        found |= modules(ROOT / folder)
    return found


def test_no_package_imports_a_package_above_it() -> None:
    """Of cli, training, runtime and nscc, each imports only those after it."""
    assert arrows_up(file_graph(files()), FLOORS) == []


def test_files_do_not_import_each_other_in_cycles() -> None:
    assert circles(file_graph(files())) == []


def test_folders_do_not_import_each_other_in_cycles() -> None:
    """The test checks the files and folders in every folder, each with everything below it."""
    graph = file_graph(files())
    folders = {name.rpartition(".")[0] for name in graph if "." in name}
    assert [
        circle for each in sorted(folders) for circle in circles(folder_graph(graph, each))
    ] == []


@pytest.mark.parametrize("floor", EXTERNAL)
def test_imports_few_packages_of_others(floor: str) -> None:
    """Beside the standard library and the project's packages, a package imports only those that
    `EXTERNAL` lists for it."""
    own = set(FLOORS) | set(sys.stdlib_module_names)
    wanted = {
        each.partition(".")[0]
        for name, path in modules(ROOT / FLOORS[floor]).items()
        for each in imported(name, path)
    }
    assert wanted - own <= EXTERNAL[floor]


def test_every_imported_package_is_a_dependency_or_in_an_extra() -> None:
    """The error for a missing package names its extra; the compiler needs no extra."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    of_floor = dict.fromkeys(FLOORS, extras) | {"nscc": (), "nscc_cli": OF_THE_COMMAND_LINE}
    for floor, folder in FLOORS.items():
        texts = chain(project["dependencies"], *(extras[extra] for extra in of_floor[floor]))
        asked = {Requirement(text).name.lower() for text in texts}
        for name, path in modules(ROOT / folder).items():
            tops = {each.partition(".")[0] for each in imported(name, path)}
            others = tops - set(FLOORS) - set(sys.stdlib_module_names)
            assert {distribution_of(top).lower() for top in others} <= asked, name


def test_the_runtime_executes_words_and_knows_no_compiler() -> None:
    compiling = {"compiler", "containers", "limits", "pipeline"}
    rooms = {"emit", "logic", "lower", "program", "prove", "syntax"}
    wanted = {
        each.split(".")[1]
        for name, path in modules(ROOT / FLOORS["nscc_runtime"]).items()
        for each in imported(name, path)
        if each.startswith("nscc.")
    }
    assert not wanted & (compiling | rooms)


def test_folders_of_the_compiler_import_only_folders_of_lower_levels() -> None:
    level = {room: number for number, rooms in enumerate(ROOMS) for room in rooms}
    wrong = [
        f"{name} imports {other}"
        for name, other in folder_graph(file_graph(modules(ROOT / "nscc")), "nscc").edges
        if level[name.removeprefix("nscc.")] <= level[other.removeprefix("nscc.")]
    ]
    assert not wrong


def test_cyclic_and_upward_imports_are_found(tmp_path: Path) -> None:
    """The imports are deferred, for types only, relative, and through an `__init__`. One cycle goes
    through two folders."""
    texts = {
        "low/__init__.py": "",
        "low/one.py": "def late():\n    from low.two import x\n",
        "low/two.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import low.one\n",
        "low/three.py": "import high\n",
        "high/__init__.py": "from high.a.first import x\n",
        "high/a/first.py": "from ..b import second\n",
        "high/a/other.py": "",
        "high/b/second.py": "import json\n",
        "high/b/back.py": "import high.a.other as it\n",
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    graph = file_graph(modules(tmp_path / "low") | modules(tmp_path / "high"))
    assert arrows_up(graph, ("low", "high")) == ["low.three imports high"]
    assert circles(graph) == [["low.one", "low.two"]]
    assert circles(folder_graph(graph, "high")) == [["high.a", "high.b"]]
    assert circles(folder_graph(graph, "low")) == [["low.one", "low.two"]]
    assert not circles(folder_graph(graph, "high.a"))


@pytest.mark.parametrize(
    "arguments",
    [
        ["--version"],
        ["--help"],
        ["check", "examples/hdr_2x2.nsl", "examples/class_d.nsl"],
        ["check", "tests/cases/fail/burst16.nsl"],
        ["build", "examples/class_c.nsl", "-O1", "--emit", "gates=-"],
        ["explain", "NS0214"],
        ["targets"],
    ],
    ids=lambda arguments: " ".join(arguments[:1]),
)
def test_start_up_imports_nothing_heavy(arguments: list[str], root: Path) -> None:
    # What other distributions add is looked for only where it is listed.
    heavy = HEAVY if arguments[0] in ("--help", "targets") else (*HEAVY, "importlib.metadata")
    code = (
        "import sys; from nscc_cli.main import main; main(sys.argv[1:]); "
        f"print([name for name in {heavy!r} if name in sys.modules])"
    )
    outcome = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        cwd=root,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
    )
    assert outcome.stdout.splitlines()[-1] == "[]", outcome.stderr


OF_SOME_PROGRAMS = (
    "json",
    "numpy.ma",
    "nscc.emit.report",
    "nscc.logic.cascade",
    "nscc.logic.cover",
    "nscc.logic.encodings",
    "nscc.logic.events",
    "nscc.looks.passes",
    "nscc.looks.looks_proof",
    "nscc.neighbours.passes",
    "nscc.neighbours.pictures_proof",
    "nscc.stream.passes",
)
_GATES = ["nscc.logic.cover", "nscc.logic.encodings", "nscc.logic.events"]
_LOOKS = ["nscc.looks.passes", "nscc.looks.looks_proof"]
_IMAGES = ["nscc.neighbours.passes", "nscc.neighbours.pictures_proof"]


@pytest.mark.parametrize(
    ("program", "needed"),
    [
        ("class_a", []),
        ("class_b", _GATES),
        ("class_d", _GATES),
        ("first_light", ["nscc.logic.cover", *_LOOKS]),
        ("bright_spots", _IMAGES),
        ("edges", ["json", *_IMAGES]),  # stored words of kernels
    ],
)
def test_check_imports_only_modules_that_the_program_needs(
    program: str, needed: list[str], root: Path
) -> None:
    code = (
        "import sys; from nscc_cli.main import main; status = main(sys.argv[1:]); "
        f"print(status, [name for name in {OF_SOME_PROGRAMS!r} if name in sys.modules])"
    )
    outcome = subprocess.run(
        [sys.executable, "-c", code, "check", f"examples/{program}.nsl"],
        cwd=root,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
    )
    assert outcome.stdout.splitlines()[-1] == f"0 {needed}", outcome.stderr
