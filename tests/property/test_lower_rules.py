"""Rules over one to three fields: as `test_lower_random_tables`, from text to words."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from lowering_oracle import container_of, does_as_told, lowered_as
from program_oracle import program_of

from nscc.diagnostics.diagnostic import Rejected
from nscc.lower.exposure_plan import LOWERINGS, Misfit
from nscc.prove.proof import prove
from nscc.words.legality import decoded

times = st.sampled_from(["n", "n", "n + 1", "n / 2", "n % 5", "2 * n", "N - n"])
fields = st.sampled_from(["a", "b", "c", "a + b", "a - c", "(a + 1) * 2", "3"])
signs = st.sampled_from(["<", "<=", "==", "!=", ">"])
comparisons = st.builds("({} {} {})".format, times, signs, fields)
rules = st.recursive(
    st.one_of(
        comparisons,
        st.sampled_from(["(a <= n < b)", "(n != c)", "bits[n % 3]", "(n % (b + 1) == 0)"]),
    ),
    lambda inner: st.one_of(
        st.builds("({} {} {})".format, inner, st.sampled_from(["and", "or", "xor"]), inner),
        inner.map("(not {})".format),
    ),
    max_leaves=4,
)


@st.composite
def programs(draw):
    """Text of a program whose fields may be large, small, fixed, or tied by a condition."""
    slots = draw(st.sampled_from([1, 4, 9, 16, 20]))
    lines = ["nsl 1", f"frame {slots} slots of 1ms", "code bits : bit[3]"]
    for name in "abc":
        low = draw(st.integers(0, 3))
        high = low + draw(st.sampled_from([0, 1, 3, 7, slots]))
        lines.append(f"code {name} : {low}..{high}")
    if draw(st.booleans()):
        lines.append(f"require {draw(fields)} {draw(signs)} {draw(fields)}")
    if draw(st.booleans()):
        lines.append(f"open when {draw(rules)}")
    else:
        lines += [f"bucket one open when {draw(rules)}", f"bucket two open when {draw(rules)}"]
    return "\n".join(lines) + "\n"


@given(programs(), st.sampled_from(LOWERINGS), st.integers(0, 1))
def test_words_open_the_shutters_of_random_rules(text, lowering, level):
    try:
        program = program_of(text, "open")
    except Rejected:
        return
    lowered = lowered_as(program, lowering, level)
    # The rule does not fit the chip: there are no words.
    if isinstance(lowered, Misfit):
        return
    container = container_of(lowered, level)
    assert does_as_told(container)
    assert prove(container, decoded(container)).holds
