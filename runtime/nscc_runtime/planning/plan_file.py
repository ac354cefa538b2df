"""Plans outside the program: the file of `--plan`, and the table that a person reads."""

from __future__ import annotations

import json
from pathlib import Path

from nscc.diagnostics.rejection import rejected
from nscc.files import read_whole
from nscc.npy import InvalidArrays
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.plan import Plan
from nscc_runtime.sensor import Sensor, sensor_sha256

PLAN_SCHEMA = "nscc-plan-1"


def plan_text(plan: Plan, program_sha256: str, sensor: Sensor) -> str:
    """A plan's file, which says what it was made for."""
    made_for = {"program_sha256": program_sha256, "sensor_sha256": sensor_sha256(sensor)}
    values = {"schema": PLAN_SCHEMA, **made_for, "plan": plan.as_json()}
    return json.dumps(values, indent=2) + "\n"


def read_plan(path: Path, program_sha256: str, sensor: Sensor) -> Plan:
    """A plan from its file; NS0747 where it is none, NS0748 where it was made for something else
    (status 2).
    """
    plan, made_for = _read(path)
    is_for = program_sha256, sensor_sha256(sensor)
    for found, here, what in zip(made_for, is_for, ("program", "sensor"), strict=True):
        if found != here:
            raise rejected(
                "NS0748",
                f"the plan '{path}' was made for another {what}",
                notes=(f"its {what}_sha256 is {found[:12]}.., but here it is {here[:12]}..",),
                helps=("make a new plan: give --plan a name that does not exist",),
            )
    return plan


def plan_of(path: Path) -> Plan:
    """Return the plan in a plan's file, or of a frame file; NS0747 for another file."""
    return _read(path)[0]


def _read(path: Path) -> tuple[Plan, tuple[str, str]]:
    """The plan, and the digests of the program and the sensor that it was made for."""
    try:
        if path.suffix.lower() == ".npz":
            values = read_frame_arrays(path, lambda _name: False)[1]
        else:
            values = json.loads(read_whole(path))
            if values["schema"] != PLAN_SCHEMA:
                raise ValueError(f"its schema is {str(values['schema'])[:40]!r}")
        made_for = str(values["program_sha256"]), str(values["sensor_sha256"])
        return Plan.from_json(values["plan"]), made_for
    except (
        OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError, InvalidArrays
    ) as error:  # fmt: skip
        raise rejected(
            "NS0747",
            f"invalid plan '{path}': it does not belong to this version of nscc",
            notes=(_reason(error),),
            helps=("give --plan a name that does not exist: nscc writes a new plan there",),
        ) from error


def _reason(error: Exception) -> str:
    """What is wrong with a file, in words."""
    words = " ".join(str(error).split())[:120]
    if isinstance(error, OSError):
        return f"it cannot be read: {error.strerror}"
    if isinstance(error, UnicodeDecodeError):
        return "it is not text"
    if isinstance(error, json.JSONDecodeError):
        return f"it is not JSON: {words}"
    if isinstance(error, KeyError):
        return f"{words} is missing"
    if isinstance(error, (TypeError, AttributeError, RecursionError)):
        return "its values have other types than those of a plan"
    return words


def plan_table(plan: Plan, report: Audit | None = None) -> str:
    """The plan as a person reads it, and what an audit measured."""
    return str(plan) if report is None else f"{plan}\n{report}"
