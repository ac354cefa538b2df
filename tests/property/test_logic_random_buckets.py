"""Programs with one to three threshold buckets: no generator raises, every solution is right."""

from __future__ import annotations

from hypothesis import example, given
from hypothesis import strategies as st
from program_oracle import program_of

from nscc.diagnostics.diagnostic import Rejected
from nscc.logic.generate import GENERATORS
from nscc.logic.problem import GaveUp, Machine
from nscc.logic.replay import fault
from nscc.lower.decoding import problem_of
from nscc.lower.exposure_plan import frame_time, levels, plan_exposure

thresholds = st.sampled_from(["n < {}", "n >= {}", "n <= {}", "n > {}", "n == {}", "n != {}"])


@st.composite
def programs(draw):
    """Text of a program whose buckets compare the slot with one to three fields."""
    slots = draw(st.integers(2, 21))
    lines = ["nsl 1", f"frame {slots} slots of 1ms"]
    names = "abc"[: draw(st.integers(1, 3))]
    for name in names:
        low = draw(st.integers(0, 2))
        lines.append(f"code {name} : {low}..{low + draw(st.integers(0, slots))}")
    for i in range(draw(st.integers(1, 3))):
        rule = draw(thresholds).format(draw(st.sampled_from(names)))
        if draw(st.booleans()):
            rule += " and " + draw(thresholds).format(draw(st.sampled_from(names)))
        lines.append(f"bucket bucket{i} open when {rule}")
    return "\n".join(lines) + "\n"


# Demands that have planes of their own are nobody's event: fields once merged differently then.
MERGED = (
    "nsl 1 frame 14 slots of 1ms code a : 0..14 bucket one open when n > a bucket two open when "
    "n >= a"
)
UNMERGED = (
    "nsl 1 frame 6 slots of 1ms code a : 0..6 code b : 0..4 bucket one open when n != a bucket two "
    "open when n > a"
)


@example(MERGED, "edges", 13)
@example(UNMERGED, "edges", 13)
@given(programs(), st.sampled_from(["accumulate", "edges"]), st.integers(6, 13))
def test_every_generator_serves_threshold_buckets_or_gives_up(text, lowering, registers):
    try:
        program = program_of(text, "open")
    except Rejected:
        return
    # Large tables take too long for a random test.
    if len(program.table.shutters) > 300:
        return
    opens = levels(program)
    plan = plan_exposure(program, lowering, opens)
    problem, _ = problem_of(program, plan, frame_time(program), opens)
    machine = Machine(registers, True, None, None, False)
    for name, generator in GENERATORS.items():
        if not problem.demands or generator.kind in ("cascade", "last"):
            continue
        try:
            for solution in generator.solve(problem, machine, 5_000):
                assert fault(problem, machine, solution) is None, name
        except GaveUp:
            continue
