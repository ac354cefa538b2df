"""Read and write plan files (`--plan`), and print plans as tables."""

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

PLAN_SCHEMA = "nscc-plan-2"


def plan_text(plan: Plan, program_sha256: str, sensor: Sensor) -> str:
    """Return the JSON text of a plan file, with the digests of its program and sensor."""
    made_for = {"program_sha256": program_sha256, "sensor_sha256": sensor_sha256(sensor)}
    values = {"schema": PLAN_SCHEMA, **made_for, "plan": plan.as_json()}
    return json.dumps(values, indent=2) + "\n"


def read_plan(path: Path, program_sha256: str, sensor: Sensor) -> Plan:
    """Read a plan file for a given program and sensor.

    Raises Rejected (status 2): NS0747 if the file does not contain a plan of this version, NS0748
    if the plan was made for another program or sensor."""
    plan, made_for = _read(path)
    is_for = program_sha256, sensor_sha256(sensor)
    for plan_sha256, actual_sha256, kind in zip(
        made_for, is_for, ("program", "sensor"), strict=True
    ):
        if plan_sha256 != actual_sha256:
            raise rejected(
                "NS0748",
                f"the plan '{path}' was made for another {kind}",
                notes=(
                    f"its {kind}_sha256 is {plan_sha256[:12]}.., but here it is "
                    f"{actual_sha256[:12]}..",
                ),
                helps=("make a new plan: give --plan a name that does not exist",),
            )
    return plan


def plan_of(path: Path) -> Plan:
    """Return the plan in a plan file or a frame file. Raises NS0747 for any other file."""
    return _read(path)[0]


def _read(path: Path) -> tuple[Plan, tuple[str, str]]:
    """Return the plan, and the SHA-256 digests of its program and sensor."""
    try:
        if path.suffix.lower() == ".npz":
            values = read_frame_arrays(path, lambda _name: False)[1]
            if (values["plan"] or {"tolerance": None}).get("tolerance", "") is None:
                raise ValueError("its frame was exposed without a plan")
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
            f"'{path}' contains no plan of this version of nscc",
            notes=(_reason(error),),
            helps=("`nscc run .. --plan FILE` writes a plan to a file that does not exist",),
        ) from error


def _reason(error: Exception) -> str:
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
    """Return the plan as a table, followed by the audit if there is one."""
    return str(plan) if report is None else f"{plan}\n{report}"
