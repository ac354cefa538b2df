"""Kept search results: the same bytes with and without them, and no harm from a hostile file."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass, replace
from functools import partial
from hashlib import sha256
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from marks import slow
from nscc_command import invoke

from nscc.cache import digest as digests
from nscc.cache.digest import digest, version_digest
from nscc.cache.results import LEAST_LEVEL, Results, results_of_user
from nscc.cache.store import Store
from nscc.chips.load import builtin_target
from nscc.codec import from_plain, to_json, to_plain
from nscc.compiler import compile_source
from nscc.emit.report import report, report_bytes
from nscc.logic.generate import GeneratorFault, solutions
from nscc.logic.problem import Demand, Gate, Machine, Problem, Solution
from nscc.pipeline import Options
from nscc.source import Source
from nscc.syntax.parse import parse
from nscc.words.file import to_bytes

TEXTS = {
    "few": "frame 4 slots of 1ms code stop : 0..4 open when n < stop",
    "b": "frame 20 slots of 1ms code stop : 0..20 open when n < stop",
    "c": "frame 16 slots of 1ms code s : 0..12 open when s <= n < s + 4",
    "d": "frame 8 slots of 1ms code a : 0..7 code b : 1..8 require a < b open when a <= n < b",
    "book": "frame 10 slots of 1ms shutters book [1100111000, 0011101111, 0101010101, 1010011010]"
    " code id : row of book open when book[id]",
    "buckets": "frame 21 slots of 1ms code split : 1..20"
    " bucket early open when n < split bucket late open when n >= split",
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of results, empty: tables of the grammar, which it holds too, are made before."""
    parse(Source("p.nsl", f"nsl 1 {TEXTS['few']}\n"))
    monkeypatch.setenv("NSCC_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache"


@pytest.fixture
def searches(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Grows by one for each search for gates, by the level it is made at."""
    made: list[int] = []

    def counted(problem, machine, level, faults):
        made.append(level)
        yield from solutions(problem, machine, level, faults)

    monkeypatch.setattr("nscc.lower.gate_search.solutions", counted)
    return made


def built(text: str, **options: object) -> tuple[bytes, bytes]:
    """The container and the report of a program, every lowering priced."""
    given = Options(codes="open", price_all=True, **options)  # type: ignore[arg-type]
    compiled = compile_source(Source("p.nsl", f"nsl 1 {text}\n"), Path(), given)
    values = report(compiled.layout, compiled.proof)
    return to_bytes(compiled.container), report_bytes(values)


@pytest.mark.parametrize("name", ["few", "c", "book", *map(slow, ("b", "d", "buckets"))])
def test_a_cached_build_is_equal_and_needs_no_search(
    name: str, folder: Path, searches: list[int]
) -> None:
    plain = built(TEXTS[name], cache=False)
    assert not folder.exists()
    first = built(TEXTS[name])
    made = len(searches)
    second = built(TEXTS[name])
    assert plain == first == second
    assert len(searches) == made, "the second time nothing is searched"
    assert Store(folder).entries() == sum(each >= LEAST_LEVEL for each in searches) // 2


@pytest.mark.parametrize("level", [0, 1])
def test_low_levels_store_no_solutions(level: int, folder: Path) -> None:
    """At levels 0 and 1 nothing is searched, so the folder of the cache is not even made."""
    built(TEXTS["b"], level=level)
    assert not folder.exists()


@pytest.mark.slow
def test_the_key_contains_everything_that_decides_the_result(
    folder: Path, searches: list[int]
) -> None:
    chip = builtin_target("scamp5")
    variants = [
        (TEXTS["d"], {}),
        (TEXTS["d"], {"level": 3}),
        (TEXTS["d"].replace("1ms", "2ms"), {}),
        (TEXTS["d"].replace("a < b", "a + 1 < b"), {}),
        (TEXTS["d"], {"target": "scamp7"}),
        (TEXTS["d"], {"target": replace(chip, launch_us=2.0)}),
        (TEXTS["d"], {"target": replace(chip, store_words=10_000)}),
        (TEXTS["d"], {"target": replace(chip, or_sources=4)}),
        (TEXTS["d"], {"target": replace(chip, where_reads_flag=True)}),
    ]
    for text, options in variants:
        before = len(searches)
        built(text, **options)
        assert len(searches) > before, (text, options)
    before = len(searches)
    for text, options in variants:
        built(text, **options)
    assert len(searches) == before
    built(TEXTS["b"])
    before = len(searches)
    built(TEXTS["b"].replace(" code", "\n# the layout of the text decides nothing\ncode"))
    assert len(searches) == before


def test_another_compiler_does_not_use_stored_results(
    folder: Path, searches: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A changed compiler, and one whose files cannot be read (None), searches again as often as the
    first time."""
    built(TEXTS["c"])
    before = len(searches)
    monkeypatch.setattr("nscc.cache.results.version_digest", lambda: "edited")
    built(TEXTS["c"])
    assert len(searches) == 2 * before
    monkeypatch.setattr("nscc.cache.results.version_digest", lambda: None)
    built(TEXTS["c"])
    assert len(searches) == 3 * before


def test_the_version_digest_changes_with_every_source_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(digests, "_ROOT", tmp_path)
    (tmp_path / "logic").mkdir()
    (tmp_path / "logic" / "a.py").write_text("x = 1\n")
    seen = set()
    for change in (
        lambda: None,
        lambda: (tmp_path / "logic" / "a.py").write_text("x = 2\n"),
        lambda: (tmp_path / "logic" / "a.py").rename(tmp_path / "logic" / "b.py"),
        lambda: (tmp_path / "t.toml").write_text("rows = 1\n"),
    ):
        change()
        version_digest.cache_clear()
        seen.add(version_digest())
    assert len(seen) == 4
    (tmp_path / "logic" / "b.pyc").write_text("no source")
    version_digest.cache_clear()
    assert version_digest() in seen
    version_digest.cache_clear()


def test_the_version_digest_changes_with_the_sources_of_added_generators(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = ModuleType("mine")
    monkeypatch.setitem(sys.modules, "mine", module)
    versions = {}
    for name, file, text in (
        ("none", None, None),
        ("added", "mine.py", "x = 1\n"),
        ("edited", "mine.py", "x = 2\n"),
        ("a package", "mine/__init__.py", "x = 1\n"),
        ("unreadable", "gone.py", None),
    ):
        if text is not None:
            (tmp_path / file).parent.mkdir(exist_ok=True)
            (tmp_path / file).write_text(text)
        module.__file__ = str(tmp_path / (file or "none"))
        found = {} if file is None else {"sums": "mine"}
        monkeypatch.setattr(digests, "sources", lambda group, found=found: found)
        version_digest.cache_clear()
        versions[name] = version_digest()
    version_digest.cache_clear()
    assert versions.pop("unreadable") is None
    assert len(set(versions.values())) == len(versions) == 4


def test_builds_without_a_cache_write_the_same_bytes(
    folder: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    (tmp_path / "p.nsl").write_text(f"nsl 1 {TEXTS['b']}\n")
    assert invoke(["build", "p.nsl", "-o", "a.icw", "--no-cache"], tmp_path).status == 0
    assert not folder.exists()
    monkeypatch.setenv("NSCC_CACHE", "off")
    assert invoke(["build", "p.nsl", "-o", "b.icw"], tmp_path).status == 0
    assert not folder.exists()
    assert results_of_user() is None
    monkeypatch.delenv("NSCC_CACHE")
    assert invoke(["check", "p.nsl"], tmp_path).status == 0
    assert not folder.exists(), "check lowers at -O1"
    assert invoke(["build", "p.nsl", "-o", "c.icw"], tmp_path).status == 0
    assert Store(folder).entries() == 1
    assert len({(tmp_path / f"{name}.icw").read_bytes() for name in "abc"}) == 1


def test_builds_work_if_the_cache_folder_cannot_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The build ends without a message. Only `nscc doctor` says that nscc runs without a cache."""
    monkeypatch.setenv("NSCC_CACHE_DIR", "/dev/null/cache")
    (tmp_path / "p.nsl").write_text(f"nsl 1 {TEXTS['b']}\n")
    done = invoke(["build", "p.nsl", "-o", "a.icw"], tmp_path)
    assert (done.status, done.codes) == (0, [])
    said = invoke(["doctor"], tmp_path)
    assert said.status == 0
    assert "runs without a cache" in said.out


def test_doctor_prints_the_folder_and_size_of_the_cache(folder: Path, tmp_path: Path) -> None:
    """`nscc doctor` says where the cache is, how many results it holds and how to remove it."""
    built(TEXTS["b"], level=2)
    said = invoke(["doctor"], tmp_path).out
    assert str(folder) in said
    assert f"{Store(folder).entries()} results" in said
    assert "remove the folder" in said


def entries_of(folder: Path) -> dict[str, list[object]]:
    """The entries' values, by key."""
    store = Store(folder)
    found = {path.name: store.read(path.name) for path in sorted(folder.iterdir())}
    return {key: json.loads(data) for key, data in found.items() if data is not None}


def keep(folder: Path, key: str, value: object) -> None:
    """An entry with a good checksum, whatever is in it."""
    Store(folder).write(key, json.dumps(value).encode())


def hostile(solution: Solution) -> dict[str, object]:
    """What somebody might put in the place of an entry, with a checksum that is right."""
    plain = to_plain(solution)
    silent = replace(solution, answers=tuple(() for _ in solution.answers))
    swapped = replace(solution, planes=solution.planes[::-1])
    wordy = replace(solution, opening=((Gate("SET", "p0", ()), Gate("NOT", "p0", ("p0",))) * 600,))
    return {
        "nothing": [],
        "null": None,
        "a number": 5,
        "text": "solution",
        "an object": {"encoding": "x"},
        "too few fields": plain[:-1],
        "too many fields": [*plain, 1],
        "wrong type": [1, *plain[1:]],
        "no demand answered": to_plain(silent),
        "codes of other shutters": to_plain(swapped),
        "more words than the store": to_plain(wordy),
        "fewer answers": to_plain(replace(solution, answers=solution.answers[1:])),
        "no planes": to_plain(replace(solution, planes=(), holders=())),
        "a billion registers": to_plain(replace(solution, scratch=10**9)),
        "negative registers": to_plain(replace(solution, states=-3)),
        "unknown gate": to_plain(replace(solution, opening=((Gate("XOR", "p0", ()),),))),
        "unknown register": to_plain(replace(solution, opening=((Gate("SET", "R5", ()),),))),
        "an unknown register, or none, read": to_plain(
            replace(solution, opening=((Gate("NOT", "p0", ("PIX",)),),))
        ),
    }


def deep(levels: int) -> bytes:
    return b"[" * levels + b"]" * levels


@pytest.mark.parametrize(
    ("name", "lowering"),
    [("few", "edges"), *(slow(name, "auto") for name in ("few", "b", "d", "book"))],
)
def test_hostile_entries_do_no_harm(name: str, lowering: str, folder: Path) -> None:
    build = partial(built, TEXTS[name], lowering=lowering)
    plain = build(cache=False)
    build()
    good = entries_of(folder)
    assert good
    solution = from_plain(Solution, next(iter(good.values())))
    for what in hostile(solution):
        for key, value in good.items():
            bad = hostile(from_plain(Solution, value))[what]
            keep(folder, key, bad)
        found = build()
        # Words that are right, though others would be cheaper, are beyond what can be noticed.
        assert found[0] == plain[0] or what == "state in a FLAG that is in use", what
        assert json.loads(found[1])["proof"]["holds"]
        for key, value in good.items():
            keep(folder, key, value)
    for key in good:
        Store(folder).write(key, deep(100_000))
    assert build() == plain
    assert entries_of(folder) == good, "what was wrong is written anew"


def test_a_program_that_does_not_fit_gives_the_same_messages_with_and_without_the_cache(
    folder: Path, tmp_path: Path
) -> None:
    small = invoke(["targets", "scamp5", "--toml"], tmp_path).out.replace("1024", "10")
    (tmp_path / "small.toml").write_text(small)
    (tmp_path / "p.nsl").write_text(f"nsl 1 {TEXTS['d']}\n")
    arguments = ["build", "p.nsl", "-o", "p.icw", "--target", "small.toml"]
    arguments += ["--print-after", "program"]
    said = [
        invoke([*arguments, *more], tmp_path) for more in (["--no-cache"], [], [], ["--no-cache"])
    ]
    assert said[0].status == 1
    assert said[0].codes[-1] == "NS0501"
    assert said[1:] == said[:1] * 3


@pytest.mark.parametrize("lowering", ["accumulate", "edges"])
@pytest.mark.parametrize("name", TEXTS)
def test_every_solution_of_the_generators_can_be_stored_and_read_back(
    name: str, lowering: str, tmp_path: Path
) -> None:
    """The test stores all solutions that the generators find, not only the best one."""
    asked: list[tuple[Problem, Machine]] = []

    def overhear(problem: Problem, machine: Machine, level: int, faults: list[GeneratorFault]):
        asked.append((problem, machine))
        yield from solutions(problem, machine, level, faults)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("nscc.lower.gate_search.solutions", overhear)
        built(TEXTS[name], lowering=lowering, cache=False)
    problem, machine = asked[0]
    results = Results(Store(tmp_path))
    for number, solution in enumerate(solutions(problem, machine, 2)):
        key, _ = results.find(problem, machine, 2, number)
        results.keep(key, solution)
        _, again = results.find(problem, machine, 2, number)
        assert again == solution
        assert to_json(again) == to_json(solution)


@dataclass(frozen=True)
class Pair:
    """Two values."""

    first: object
    second: object


def test_digests_of_different_values_differ() -> None:
    values = [
        None, True, False, 0, 1, -1, 1 << 4000, 0.0, -0.0, 1.0, "", "1", "None", "i1", (), ((),),
        ("a", "b"), ("ab",), (("a",), "b"), {"a": 1}, {"a": 2}, {"b": 1}, {"a": 1, "b": 2},
        {"b": 2, "a": 1}, Pair(1, 2), Pair(2, 1), Pair(None, None), Pair((1, 2), ()),
        Demand(1, "rise", 0, 3, False), Demand(1, "rise", 0, 3, True), Gate("OR", "p0", ("p1",)),
        np.arange(4), np.arange(4.0), np.arange(4).reshape(2, 2), np.array([0, 1, 2, 4]),
        np.zeros((0, 3)), np.zeros((3, 0)),
    ]  # fmt: skip
    found = [digest(value) for value in values]
    assert len(set(found)) == len(values)
    assert found == [digest(value) for value in values]
    assert all(len(text) == len(sha256().hexdigest()) for text in found)
    assert digest([1, 2]) == digest((1, 2))
    with pytest.raises(TypeError, match="no digest for set"):
        digest(Pair({1}, 2))


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"{",
        b"\xff",
        b"NaN",
        b"[]",
        b'["x", ["1"], ["p"], 0, 1, [], [[]], []]',
        b'["x", ["zz"], ["p"], 0, 1, [], [[]], [], false]',
        b'["x", [1], ["p"], 0, 1, [], [[]], [], false]',
        b'["x", ["1"], [null], 0, 1, [], [[]], [], false]',
        b'["x", ["1"], ["p"], 1.5, 1, [], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, "1", [], [[]], [], false]',
        b'[null, ["1"], ["p"], 0, 1, [], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, 1, [[1]], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, 1, [[["NOT", "t0", ["p0"]]]], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, 1, [[[[], "t0", ["p0"], null]]], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, 1, [[["NOT", "t0", ["p0"], ""]]], [[]], [], false]',
        b'["x", ["1"], ["p"], 0, 1, [], [[]], [], false, 1]',
        deep(50_000),
    ],
)
def test_a_damaged_stored_solution_is_ignored(text: bytes, tmp_path: Path) -> None:
    problem = Problem((Demand(1, "open", 0, 1, False),), 2, ((1,),), True, {})
    machine = Machine.of(builtin_target("scamp5"))
    results = Results(Store(tmp_path))
    good = Solution("x", (1,), ("p",), 0, 0, (), (((Gate("WHERE", "FLAG", ("p0",)),),),), ())
    key, _ = results.find(problem, machine, 2)
    results.keep(key, good)
    assert results.find(problem, machine, 2) == (key, good)
    Store(tmp_path).write(key, text)
    assert results.find(problem, machine, 2) == (key, None)
