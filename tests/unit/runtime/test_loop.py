"""Compiled loops: what a declaration allows, and where the machine code comes from."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Annotated, Any, NamedTuple, TypeVar

import numpy as np
import pytest
from numpy.typing import NDArray
from typing_extensions import TypeAliasType

import nscc_runtime
import nscc_training
from nscc.arrays import Floats, Ints
from nscc_runtime import loop as loops
from nscc_runtime import machine_code
from nscc_runtime.compile_ahead import modules
from nscc_runtime.emulator.loops import expose_without_effects
from nscc_runtime.loop import Written, compiled, loop, record
from nscc_runtime.loop_given import LoopParameter


@record
class Sizes:
    """For `scaled`."""

    count: int
    factor: float
    word: np.uint64


@record
class Step:
    """For `scaled`."""

    index: int
    part: float


@compiled
def product(sizes: Sizes, step: Step) -> float:
    return sizes.factor * step.part


@loop
def scaled(
    sizes: Sizes,
    steps: Annotated[NDArray[Any], Step, "count"],
    start: Annotated[Ints, "count+1"],
    out: Written[Annotated[Floats, "count"]],
) -> None:
    for i in range(sizes.count):
        out[steps[i].index] = product(sizes, steps[i]) + start[i + 1]


@pytest.fixture(scope="module", autouse=True)
def _own_folder(tmp_path_factory):
    """No machine code of this file's loops beside the tests."""
    folder = tmp_path_factory.mktemp("code")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(machine_code, "folders", lambda module: (folder,))
        yield


def given(**changed):
    values = {
        "sizes": Sizes(count=2, factor=0.5, word=2**64 - 1),
        "steps": np.array([(1, 10.0), (0, 20.0)], np.dtype(Step)),
        "start": np.array([0, 100, 200]),
        "out": np.zeros(2),
    }
    return {**values, **changed}


def test_a_loop_reads_records_and_arrays_of_them():
    values = given()
    scaled(**values)
    # out[1] = 10 x 0.5 + 100 and out[0] = 20 x 0.5 + 200.
    assert values["out"].tolist() == [210.0, 105.0]


def test_a_loop_reads_a_view_from_where_it_begins(tmp_path):
    """A view that begins at element 1, in memory and in a read-only mapped file, reads and writes
    only its own elements."""
    whole = np.array([-1, 0, 100, 200, -1])
    np.save(tmp_path / "whole.npy", whole)
    mapped = np.load(tmp_path / "whole.npy", mmap_mode="r")
    for values in (whole, mapped):
        out = np.zeros(4)
        scaled(**given(start=values[1:4], out=out[1:3]))
        assert out.tolist() == [0.0, 210.0, 105.0, 0.0]


def read_only():
    out = np.zeros(2)
    out.flags.writeable = False
    return out


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"sizes": Step(index=0, part=1.0)}, "sizes is Step, not Sizes"),
        ({"start": np.zeros(3)}, "start is an array of float64, not an array of int64"),
        ({"start": [0, 1, 2]}, "start is list, not an array of int64"),
        ({"start": np.zeros(3, ">i8")}, "start is an array of >i8, not an array of int64"),
        ({"start": np.zeros(2, np.int64)}, "start has 1 count, others have 2"),
        ({"start": np.zeros((3, 1), np.int64)}, "start has 2 axes, not 1"),
        ({"out": np.zeros(4)[::2]}, "out does not lie in one piece, row after row"),
        ({"out": read_only()}, "out is to be written, and is read-only"),
        ({"steps": np.zeros(2)}, "steps is an array of float64, not an array of"),
        ({"other": 1, "also": 1}, "scaled: does not take also, other"),
    ],
)
def test_arguments_that_differ_from_their_declaration_are_refused_by_name(changed, message):
    with pytest.raises(TypeError, match=message):
        scaled(**given(**changed))


class Lines(NamedTuple):
    """For `summed`."""

    parts: Annotated[Floats, "count"]
    places: Annotated[Ints, "count"]
    out: Written[Annotated[Floats, "count"]]


class Alike(NamedTuple):
    """For `summed`: fields of one type."""

    first: Annotated[Floats, "count"]
    second: Annotated[Floats, "count"]


@compiled
def added(lines: Lines, alike: Alike, i: int) -> None:
    lines.out[lines.places[i]] = lines.parts[i] + alike.first[i] - 2.0 * alike.second[i]


@loop
def summed(sizes: Sizes, lines: Lines, before: Floats, alike: Alike) -> None:
    for i in range(sizes.count):
        added(lines, alike, i)
        lines.out[lines.places[i]] += before[0]


def of_lines(**changed):
    lines = Lines(np.array([1.0, 2.0]), np.array([1, 0]), np.zeros(2))
    alike = Alike(np.array([10.0, 20.0]), np.array([100.0, 200.0]))
    values = {"lines": lines, "before": np.array([1000.0]), "alike": alike}
    return {"sizes": Sizes(count=2, factor=0.0, word=0), **values, **changed}


def test_a_loop_reads_and_writes_the_arrays_of_records_in_any_order_of_arguments():
    values = of_lines()
    summed(**values)
    # `places` swaps the elements: out[1] = 1 + 10 - 2 * 100 + 1000, out[0] = 2 + 20 - 2 * 200 +
    # 1000
    assert values["lines"].out.tolist() == [622.0, 811.0]
    values["lines"].out[:] = 0.0
    summed(**dict(reversed(values.items())))
    assert values["lines"].out.tolist() == [622.0, 811.0]


@pytest.mark.parametrize(
    ("field", "value", "message"),
    [
        ("out", read_only(), "lines.out is to be written, and is read-only"),
        ("parts", np.zeros(3), "lines.parts has 3 count, others have 2"),
        ("places", np.zeros(2), "lines.places is an array of float64, not an array of int64"),
    ],
)
def test_every_array_of_a_record_is_checked_against_its_declaration(field, value, message):
    """A read-only output, another length, another dtype and a plain tuple each give a TypeError
    that names the field."""
    with pytest.raises(TypeError, match=message):
        summed(**of_lines(lines=of_lines()["lines"]._replace(**{field: value})))
    with pytest.raises(TypeError, match="lines is tuple, not Lines"):
        summed(**of_lines(lines=tuple(of_lines()["lines"])))


def test_missing_and_nameless_values_are_refused():
    """The error names the missing arguments. Values without names are refused."""
    with pytest.raises(TypeError, match="scaled: lacks out, start, steps"):
        scaled(sizes=given()["sizes"])
    with pytest.raises(TypeError, match="by name"):
        scaled(given()["sizes"])


def test_a_record_has_all_its_fields():
    """A misspelt field is named beside the missing one. A count of 1.5 is no whole number."""
    with pytest.raises(TypeError, match="Sizes: lacks word; does not take words"):
        Sizes(count=1, factor=1.0, words=0)
    with pytest.raises(TypeError):
        Sizes(count=1.5, factor=1.0, word=0)


def test_the_name_of_an_object_file_depends_on_constants_and_called_functions(monkeypatch):
    def name():
        return loops.ObjectFile(__name__, [scaled]).name

    before = name()
    assert name() == before
    other = compiled(lambda sizes, step: sizes.factor - step.part)
    with monkeypatch.context() as patch:
        patch.setitem(scaled.function.__globals__, "product", other)
        assert name() != before
    with monkeypatch.context() as patch:
        # Loops are found by their names in the object code.
        patch.setattr(scaled, "name", "renamed")
        assert name() != before
    assert name() == before


@pytest.fixture
def no_compiler(monkeypatch):
    """Compiling takes seconds: count it instead."""
    calls = []

    def build(_loops, _for_web):
        calls.append(1)
        return b"machine code"

    monkeypatch.setattr(machine_code, "build", build)
    return calls


def code(monkeypatch, *places):
    monkeypatch.setattr(machine_code, "folders", lambda module: places)
    return expose_without_effects.file.code()


def test_a_loop_is_compiled_once_and_read_afterwards(tmp_path, no_compiler, monkeypatch):
    """The second call reads the one file of the cache: the compiler ran once."""
    place = tmp_path / "cache"
    assert code(monkeypatch, place) == b"machine code"
    assert code(monkeypatch, place) == b"machine code"
    assert len(no_compiler) == 1
    assert len(list(place.iterdir())) == 1


def test_damaged_code_is_never_run(tmp_path, no_compiler, monkeypatch):
    """An empty, cut or changed file is compiled again and rewritten: five compilations in all."""
    code(monkeypatch, tmp_path)
    (file,) = tmp_path.iterdir()
    data = file.read_bytes()
    assert hashlib.sha256(b"machine code").digest() + b"machine code" == data
    for damaged in (b"", data[:20], data[:-1], data[:-1] + b"x"):
        file.write_bytes(damaged)
        assert code(monkeypatch, tmp_path) == b"machine code"
        assert file.read_bytes() == data
    assert len(no_compiler) == 5


def test_machine_code_is_stored_in_the_second_folder_if_the_first_cannot_be_written(
    tmp_path, no_compiler, monkeypatch
):
    """The first place is a file and no folder, so the code is read from the second next time.
    Without a second it is compiled each time."""
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    second = tmp_path / "second"
    for _ in range(2):
        assert code(monkeypatch, blocked, second) == b"machine code"
    assert len(no_compiler) == 1
    assert code(monkeypatch, blocked) == b"machine code"


def test_a_warm_start_imports_neither_numba_nor_scipy():
    program = """
import importlib, sys
from nscc_runtime.compile_ahead import modules
from nscc_runtime.loop import object_file
for module in modules("nscc_runtime"):
    importlib.import_module(module)
    for each in object_file(module).loops:
        each.load()
sys.exit(any(name in sys.modules for name in ("numba", "scipy")))
"""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    for _ in range(2):  # the first may have to compile
        done = subprocess.run([sys.executable, "-c", program], check=False, env=environment)
    assert done.returncode == 0


def test_every_loop_is_found():
    """Each module of both packages that declares a `@loop` is compiled ahead, so that no run waits
    for a compiler and the web pages' library contains the loop."""
    for package in (nscc_runtime, nscc_training):
        (root,) = package.__path__
        declaring = {
            ".".join((package.__name__, *path.relative_to(root).with_suffix("").parts))
            for path in Path(root).rglob("*.py")
            if "\n@loop\n" in path.read_text(encoding="utf-8")
        }
        assert len(declaring) >= 2
        assert declaring <= {*modules(package.__name__)}


def test_an_object_file_that_cannot_be_written_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """If renaming fails, the code is returned, no file is left, and nothing is read later."""

    def refuse(*_: object) -> None:
        raise OSError("no space left")

    monkeypatch.setattr("os.replace", refuse)
    assert machine_code.object_code("loops.o", [tmp_path], lambda: b"code") == b"code"
    assert not [*tmp_path.iterdir()]
    assert machine_code.read_object_file("loops.o", [tmp_path]) is None


def test_machine_code_of_other_users_is_not_executed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "cache"
    assert machine_code.object_code("loops.o", [folder], lambda: b"code") == b"code"
    assert machine_code.read_object_file("loops.o", [folder]) == b"code"
    for place in (folder, folder / "loops.o"):
        mode = place.stat().st_mode & 0o777
        place.chmod(mode | 0o020)
        assert machine_code.read_object_file("loops.o", [folder]) is None
        place.chmod(mode)
    with monkeypatch.context() as patch:
        patch.setattr(os, "geteuid", lambda: 12345)
        assert machine_code.read_object_file("loops.o", [folder]) is None
    (folder / "loops.o").chmod(0o666)
    assert machine_code.object_code("loops.o", [folder], lambda: b"mine") == b"mine"
    assert machine_code.read_object_file("loops.o", [folder]) == b"mine"


def test_array_types_of_old_and_new_numpy_are_understood() -> None:
    """`NDArray` was a generic array, and is an alias whose argument is the type of numbers."""
    number = TypeVar("number", bound=np.generic)
    array: Any = np.ndarray[tuple[Any, ...], np.dtype[number]]
    alias: Any = TypeAliasType("alias", array, type_params=(number,))
    for kind in (array, alias):
        assert LoopParameter.of("codes", kind[np.uint8]).kind == np.uint8
