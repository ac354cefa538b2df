"""The passes are what runs: each value is seen, has a text, and is verified before the next one."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest
from checkout import ROOT
from nscc_command import invoke

from nscc import pipeline
from nscc.checks import Inconsistent
from nscc.emit.listing import print_tree
from nscc.looks.looks_kind import Looks
from nscc.lower.exposure_plan import LOWERINGS
from nscc.operations import Op, WordEffect
from nscc.pipeline import PASSES, Options, ProgramKind, run_passes
from nscc.prove.proof import Failure
from nscc.source import Source
from nscc.stream.planes_kind import BitPlanes
from nscc.syntax.parse import parse, read_source

TEXT = "nsl 1 frame 8 slots of 1ms code stop : 1..7 open when n < stop pixels stop = 1 + x % 7\n"

LOOKS = (ROOT / "tests/cases/pass/looks.nsl").read_text()


def compiled(**options):
    """TEXT through all passes: (pass, value) after each, and what comes out."""
    seen = []
    given = Options(level=0, cache=False, **options)
    made = run_passes(Source("p.nsl", TEXT), Path(), given, lambda *each: seen.append(each))
    return seen, made


def test_every_value_is_seen_in_the_order_of_the_passes() -> None:
    seen, made = compiled()
    assert tuple(each.name for each, _ in seen) == PASSES
    values = {each.name: value for each, value in seen}
    assert values["program"] is made.program
    assert values["schedule"] is made.layout
    assert values["words"] is made.container
    assert values["prove"] is made.proof


def test_a_pass_needs_only_the_value_before_it() -> None:
    seen, _ = compiled(price_all=True)
    values = {each.name: value for each, value in seen}
    options = Options(level=0, price_all=True)
    job = pipeline.Job(values["program"].source, options, Path(), None)
    for (_, before), (each, value) in pairwise(seen):
        again, _ = each.run(before, job)
        assert each.text(again) == each.text(value)
        assert each.text(again).endswith("\n")


@pytest.mark.parametrize("name", PASSES)
def test_every_pass_can_be_printed(name: str, tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(TEXT)
    outcome = invoke(["build", "p.nsl", "-O", "0", "--print-after", name], tmp_path)
    assert outcome.status == 0
    assert [outcome.out] == [each.text(value) for each, value in compiled()[0] if each.name == name]


@pytest.mark.parametrize("name", PASSES)
def test_every_pass_of_a_program_that_looks_can_be_printed(name: str, tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(LOOKS)
    outcome = invoke(["build", "p.nsl", "-O", "0", "--print-after", name], tmp_path)
    assert outcome.status == 0
    assert outcome.out.endswith("\n")


def test_gates_of_a_program_that_looks_are_emitted(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(LOOKS)
    outcome = invoke(["build", "p.nsl", "-O", "0", "--emit", "gates=-"], tmp_path)
    assert outcome.status == 0
    assert "encoding: " in outcome.out


def test_passes_of_a_program_that_does_not_fit_are_printed(tmp_path: Path) -> None:
    (tmp_path / "p.nsl").write_text(TEXT.replace("1ms", "1us"))
    outcome = invoke(["build", "p.nsl", "--print-after", "schedule"], tmp_path)
    assert outcome.codes == ["NS0601"]
    assert "does not fit" in outcome.out


def test_plans_and_gates_of_all_lowerings_are_shown() -> None:
    for each, value in compiled(price_all=True)[0][2:4]:
        shown = each.text(value)
        assert [shown.count(f"lowering {lowering}") for lowering in LOWERINGS] == [1, 1, 1]


def spoilt_plan(planned):
    """A step in other pixels."""
    plan = planned.plans[0]
    steps = [s._replace(predicate=s.predicate ^ 1) if s.predicate else s for s in plan.steps]
    return replace(planned, plans=(replace(plan, steps=tuple(steps)), *planned.plans[1:]))


def spoilt_gates(gated):
    """Other codes."""
    first = gated.decodings[0]
    planes = tuple(plane ^ 1 for plane in first.solution.planes)
    solution = replace(first.solution, planes=planes)
    return replace(gated, decodings=(replace(first, solution=solution), *gated.decodings[1:]))


def spoilt_schedule(choice):
    """The frame's words in another order."""
    laid = choice.best.schedule
    best = replace(choice.best, schedule=replace(laid, launches=laid.launches[::-1]))
    return replace(choice, lowerings=(best,))


SPOILT = {
    "parse": lambda parsed: replace(parsed, source=Source("p.nsl", "nsl 1")),
    "program": lambda program: replace(program, buckets=()),
    "plan": spoilt_plan,
    "gates": spoilt_gates,
    "schedule": spoilt_schedule,
    "words": lambda container: replace(container, readouts=()),
    "prove": lambda proof: replace(proof, failure=Failure("a frame without light", 1)),
}


@pytest.mark.parametrize("name", PASSES)
def test_an_invalid_value_of_a_pass_is_an_internal_error(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def spoilt(each):
        def run(value, job):
            made, found = each.run(value, job)
            return SPOILT[name](made), found

        return replace(each, run=run) if each.name == name else each

    for owner, attribute in (
        (pipeline, "_READING"),
        (ProgramKind, "passes"),
        (pipeline, "_WRITING"),
    ):
        monkeypatch.setattr(owner, attribute, tuple(map(spoilt, getattr(owner, attribute))))
    with pytest.raises(Inconsistent):
        compiled()
    (tmp_path / "p.nsl").write_text(TEXT)
    # 70 is the status of a fault of nscc.
    assert invoke(["build", "p.nsl", "-O", "0"], tmp_path).status == 70


def dropped_comparisons(tried):
    """The first solution without its comparisons."""
    first = tried[0]
    items = {
        boundary: tuple(
            item
            for item in each
            if not isinstance(item, Op) or item.operation.effect is not WordEffect.FLAG_ANALOG
        )
        for boundary, each in first.looking.items.items()
    }
    return [replace(first, looking=replace(first.looking, items=items))]


def other_closings(plan):
    """Buckets that close in other pixels."""
    first = plan.moments[0]
    falls = tuple(fall ^ 1 for fall in first.falls)
    return replace(plan, moments=(replace(first, falls=falls), *plan.moments[1:]))


def shorter_slots(sending):
    """Slots that end before the next plane is loaded."""
    program = sending.program
    frame = replace(program.frame, slot_us=(1.0,) * len(program.frame.slot_us))
    return replace(sending, program=replace(program, frame=frame))


@pytest.mark.parametrize(
    ("kind", "name", "spoil"),
    [
        (Looks, "plan", other_closings),
        (Looks, "plan", lambda plan: replace(plan, moments=plan.moments[:-1])),
        (Looks, "gates", dropped_comparisons),
        (
            BitPlanes,
            "plan",
            lambda way: replace(way, route=replace(way.route, bits=~way.route.bits)),
        ),
        (BitPlanes, "schedule", shorter_slots),
    ],
)
def test_passes_of_other_chips_and_of_looks_are_verified(
    kind: type, name: str, spoil, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = ROOT / (
        "tests/cases/pass/dual_tap.nsl" if kind is BitPlanes else "examples/auto_exposure.nsl"
    )
    given = Options(level=0, cache=False)

    def spoilt(each):
        def run(value, job):
            made, found = each.run(value, job)
            return spoil(made), found

        return replace(each, run=run) if each.name == name else each

    run_passes(read_source(path), path.parent, given)
    monkeypatch.setattr(kind, "passes", tuple(map(spoilt, kind.passes)))
    with pytest.raises(Inconsistent):
        run_passes(read_source(path), path.parent, given)


def test_the_tree_is_printed_node_by_node() -> None:
    source = Source("p.nsl", "nsl 1\nframe 8 slots of 1ms\nopen when n < 2\n")
    assert print_tree(parse(source)[0], source).splitlines() == [
        "Version 1:1",
        "  Int 1:5 value=1",
        "EqualSlots 2:1",
        "  Int 2:7 value=8",
        "  Time 2:18 us=1000",
        "Open 3:1",
        "  Compare 3:11 ops=('<',)",
        "    Name 3:11 text=n",
        "    Int 3:15 value=2",
    ]


@pytest.mark.parametrize(("count", "shown", "cut"), [(20, 20, []), (25, 20, [".. and 5 more"])])
def test_long_lists_of_the_tree_are_cut(count: int, shown: int, cut: list[str]) -> None:
    numbers = ", ".join(map(str, range(count)))
    source = Source("p.nsl", f"nsl 1\nframe 8 slots of 1ms\npixels a = tile [[{numbers}]]\n")
    lines = [line.strip() for line in print_tree(parse(source)[0], source).splitlines()]
    row = lines[lines.index("TileRow 3:18") + 1 :]
    assert len([line for line in row if line.startswith("Int")]) == shown
    assert [line for line in lines if ".. and" in line] == cut
