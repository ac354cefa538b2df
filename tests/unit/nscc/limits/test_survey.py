"""`nscc targets --limits` on chips so small that every size can be tried by hand."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from nscc_command import invoke

from nscc.chips.load import load_target, target_toml
from nscc.compiler import compile_source
from nscc.diagnostics.diagnostic import Rejected
from nscc.limits.families import families
from nscc.limits.survey import limits_json, limits_text, survey
from nscc.pipeline import Options
from nscc.source import Source

SCAMP5 = load_target("scamp5", Path())
TINY = replace(
    SCAMP5,
    name="tiny",
    digital_registers=("R0", "R1", "R2", "R3"),
    mask_register=None,
    masked_register=None,
)


def surveyed(target, *slots, level=1):
    """The limits of a chip, by family and slot."""
    search = survey(target, Options(level=level), slots)
    while True:
        try:
            next(search)
        except StopIteration as end:
            return {(limit.family.name, limit.slot): limit for limit in end.value}


def fits(target, family, size, slot):
    """Whether a size of a family compiles, asked of the pipeline directly."""
    source = Source("size.nsl", family.text(size, slot))
    try:
        done = compile_source(source, Path(), Options(level=1, codes="open", target=target))
    except Rejected:
        return False
    return done.proof.holds


@pytest.fixture(scope="module")
def tiny():
    return surveyed(TINY, "1ms")


def test_built_sizes_compile_and_trials_are_reported(tiny):
    """Each trial's answer is that of the compiler, and the built size is the largest that fits."""
    for (name, slot), limit in tiny.items():
        if name == "a":
            continue
        for trial in limit.trials:
            assert fits(TINY, limit.family, trial.size, slot) == trial.fits, (name, trial.size)
        sizes = [trial.size for trial in limit.trials if trial.fits]
        assert (limit.built.size if limit.built else None) == max(sizes, default=None)


def test_impossible_sizes_do_not_compile_and_are_never_built(tiny):
    """A size with a proof that it is impossible does not compile. The built size lies below it."""
    for (name, slot), limit in tiny.items():
        if limit.impossible is None:
            assert limit.family.shutters(limit.family.ceiling) <= 16, name
            continue
        assert "digital registers" in limit.impossible_reason
        first = max(limit.impossible, limit.family.least)
        assert not fits(TINY, limit.family, first, slot)
        assert limit.built is None or limit.built.size < limit.impossible


def test_limits_of_a_tiny_chip_equal_those_computed_by_hand(tiny):
    """Where one shutter acts, 3 of 4 registers distinguish the others: 8 + 1 stops or starts, or 8
    stops and never. In 5 slots of bumps, 5 of 15 are open in slot 0. 4 bits are free."""
    impossible = {name: limit.impossible for (name, _), limit in tiny.items()}
    assert impossible["b 1..N"] == 10
    assert impossible["b 0..N"] == 9
    assert impossible["c len 4"] == 13
    assert impossible["d"] == 5
    assert impossible["e"] == 5
    assert tiny["e", "1ms"].built.size == 4
    assert tiny["e", "1ms"].unknown_reason == ""
    assert tiny["codebook, 64 rows", "1ms"].built is None


def test_a_slot_too_short_for_the_light_is_proved():
    """In slots of 1 us the light's words have no room: every size but the least is proved
    impossible."""
    limits = surveyed(TINY, "1us")
    for name in ("b 1..N", "d", "e", "c len 4"):
        limit = limits[name, "1us"]
        assert limit.impossible == limit.family.least + 1
        assert "analog words, one launch and the loop" in limit.impossible_reason
        assert limit.unknown_reason == ""
    assert limits["a", "1us"].impossible is None


def test_a_full_store_leaves_the_limit_unknown():
    """With a store of 24 words some families end with an unknown limit, because a longer search
    might find fewer words."""
    small = replace(TINY, store_words=24)
    limits = surveyed(small, "1ms")
    full = [limit for limit in limits.values() if "stored words" in limit.unknown_reason]
    built = {limit.family.name: limit.built and limit.built.size for limit in full}
    assert built == {"d": 3, "e": 3, "codebook, 16 rows": None, "codebook, 16 slots": 4}
    for limit in full:
        assert "[NS0501], but a longer search may succeed" in limit.unknown_reason
        assert limit.built is None or limit.built.figures["words_stored"] <= 24


@pytest.mark.slow
def test_a_survey_of_limits_is_deterministic():
    one, other = surveyed(TINY, "10us"), surveyed(TINY, "10us")
    assert limits_text(TINY, 1, list(one.values())) == limits_text(TINY, 1, list(other.values()))


def test_the_printed_table_of_limits_agrees_with_the_json_values(tiny):
    values = limits_json(TINY, 1, list(tiny.values()))
    text = limits_text(TINY, 1, list(tiny.values()))
    assert json.loads(json.dumps(values)) == values
    assert [row["class"] for row in values["limits"]] == [family.name for family in families()]
    for row in values["limits"]:
        (line,) = (line for line in text.splitlines() if line.startswith(f"  {row['class']}  "))
        built = row["built_up_to"]
        assert (f"{built} {row['unit']}" if built else "none") in line
        if row["impossible_from"]:
            assert f"{row['impossible_from']} {row['unit']}" in line
            assert f"impossible  from {row['impossible_from']}: {row['impossible_reason']}" in text
        if row["unknown"]:
            assert row["unknown"]["reason"] in text


def test_targets_limits_prints_the_survey(tmp_path):
    """The command prints the slot asked for and no other, as text and as JSON."""
    (tmp_path / "tiny.toml").write_text(target_toml(TINY))
    arguments = ["targets", "tiny.toml", "--limits", "--slot", "10us"]
    shown = invoke(arguments, tmp_path)
    assert (shown.status, shown.err) == (0, "")
    assert shown.out.startswith("tiny at -O1")
    assert "slots of 10us" in shown.out
    assert "slots of 1ms" not in shown.out
    found = json.loads(invoke([*arguments, "--json"], tmp_path).out)
    assert (found["target"], found["level"], found["digital_registers"]) == ("tiny", 1, 4)
    assert {row["slot"] for row in found["limits"]} == {"10us"}


@pytest.mark.parametrize(
    ("arguments", "code", "part"),
    [
        (["--limits", "--toml"], "NS0780", "one of them"),
        (["scamp5", "--json"], "NS0780", "--json needs --limits"),
        (["--slot", "1ms"], "NS0780", "--slot needs --limits"),
        (["--limits", "--slot", "fast"], "NS0783", "invalid time 'fast'"),
        (["--limits", "--slot", "0us"], "NS0783", "longer than 0"),
        (["--limits", "-O", "4"], "NS0783", "-O"),
    ],
)
def test_targets_limits_refuses_wrong_usage(tmp_path, arguments, code, part):
    outcome = invoke(["targets", *arguments], tmp_path)
    assert (outcome.status, outcome.codes, outcome.out) == (2, [code], "")
    assert part in outcome.err
