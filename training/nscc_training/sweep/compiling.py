"""Points of kind compile (costs of a program) and limits (largest program of a class)."""

from __future__ import annotations

from collections.abc import Collection
from hashlib import sha256

from nscc.limits.families import families
from nscc.limits.survey import limit_of
from nscc.options import Options
from nscc.pipeline import KINDS
from nscc.toml.kinds import TextKind
from nscc.toml.schema import Key
from nscc_training.experiments.engine import Figures
from nscc_training.sweep.point import PointFault, PointKind, PointTask, Values
from nscc_training.sweep.point_programs import (
    axis,
    compiled_of,
    declared_axes,
    program_fault,
    program_files,
    program_keys,
    silent,
    target_fault,
    target_keys,
    target_of,
)


def _compile(values: Values, _task: PointTask) -> Figures:
    """Return the figures of a point of kind compile: words, registers and times of the program that
    `values` name. A chip without logic has times only."""
    compiled_program = compiled_of(values)
    source = compiled_program.program.source.text
    build_report = KINDS.of(compiled_program.program).report(compiled_program)
    figures = {
        "program_class": build_report["class"],
        "shutters": build_report["codes"]["shutters"],
        "lowered": build_report["lowering"],
        "shortest_slot_us": build_report["shortest_slot_us"],
        "frame_us": build_report["frame_us"],
        "program_sha256": sha256(source.encode()).hexdigest()[:12],
    }
    logic = build_report.get("logic")
    if logic is None:  # a chip without logic has no words to count
        return figures
    return {
        **figures,
        "encoding": logic["encoding"],
        "registers": len(build_report["digital_registers"]),
        "words_total": build_report["words_total"],
        "words_a_slot": round(build_report["words_per_slot"]["mean"], 6),
        "largest_slot_words": build_report["words_per_slot"]["max"],
        "words_stored": build_report["words_stored"],
        "logic_ops": logic["ops"],
        "logic_words": logic["words"],
        "logic_bound": logic["bound"],
        "logic_largest_slot": logic["max_slot_words"],
    }


def _compile_fault(values: Values, named: Collection[str]) -> PointFault | None:
    """Return what is wrong with the values of a point of kind compile, or None. `named` are the
    keys that the grid states."""
    chosen = () if "class" in values else ("seed",)
    return program_fault(values, named) or silent(named, chosen, "codes of its own")


COMPILE = PointKind(
    "compile",
    "words, registers and times of a program, as its report has them",
    program_keys,
    _compile,
    ("words_a_slot",),
    program_files,
    _compile_fault,
)


def _limit_keys() -> tuple[Key, ...]:
    """Return the keys that points of kind limits may have in a grid."""
    names = tuple(family.name for family in families())
    return (
        axis("family", TextKind(names), "a class at every size"),
        axis(
            "slot",
            TextKind(pattern=r"[0-9]{1,9}(\.[0-9]{1,6})?(ns|us|ms|s)", phrase="a time: 10us"),
            "the length of its slots",
            "1ms",
        ),
        *declared_axes(Options, level=1),
        *target_keys(),
    )


def _limit_fault(values: Values, _named: Collection[str]) -> PointFault | None:
    """Return what is wrong with the values of a point of kind limits, or None: a missing `family`,
    a missing chip, or changed values of a chip that is not named. The keys that the grid states do
    not matter."""
    if "family" not in values:
        return PointFault(
            "", "the key family is missing: a class at every size", 'add family = "d"'
        )
    if not values["target"]:
        return PointFault(
            "", "a limit needs a chip, but target is missing", 'add target = "scamp5"'
        )
    return target_fault(values)


def _limit(values: Values, _task: PointTask) -> Figures:
    """Return the figures of a point of kind limits: the largest size of a family of programs that
    fits the chip, and the smallest size that is proved not to fit.

    Either is None if it is not known; sizes are in the unit of the family, which the figures name.
    """
    family = next(family for family in families() if family.name == values["family"])
    target = target_of(values)
    assert target is not None
    options = Options(level=values["level"], target=target, codes="open", cache=False)
    search = limit_of(family, target, options, values["slot"])
    # The search yields its progress and returns the limit when it ends.
    while True:
        try:
            next(search)
        except StopIteration as end:
            limit = end.value
            break
    built = limit.built
    return {
        "unit": family.unit,
        "built_up_to": built.size if built else None,
        "impossible_from": limit.impossible,
        **({} if built is None else built.figures),
        "tried": len(limit.trials),
        "impossible_reason": limit.impossible_reason or None,
        "unknown_reason": limit.unknown_reason or None,
    }


LIMITS = PointKind(
    "limits",
    "how large a class may be on a chip: `nscc targets --limits` point by point",
    _limit_keys,
    _limit,
    ("built_up_to",),
    program_files,
    _limit_fault,
)
