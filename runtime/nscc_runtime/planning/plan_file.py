"""Read and write plan files (`--plan`), and print plans as tables."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

from nscc.codec import from_json, from_plain, to_json
from nscc.diagnostics.diagnostic import rejected
from nscc.files import read_whole
from nscc.npy import InvalidArrays
from nscc_runtime.effects.registry import by_name
from nscc_runtime.frame_arrays import read_frame_arrays
from nscc_runtime.planning.audit import Audit
from nscc_runtime.planning.plan import Plan
from nscc_runtime.planning.tolerance import unit_of
from nscc_runtime.sensor import Sensor, sensor_sha256

PLAN_SCHEMA = "nscc-plan-3"


@dataclass(frozen=True)
class StoredPlan:
    """A plan (the effects that are simulated), and the digests of the program and of the sensor
    that it was made for."""

    program_sha256: str
    sensor_sha256: str
    plan: Plan


_STORED = tuple(field.name for field in fields(StoredPlan))


def plan_text(plan: Plan, program_sha256: str, sensor: Sensor) -> str:
    """Return the JSON text of a plan file, with a final newline. `program_sha256`: digest of the
    program's container (a compiled program). A plan is a choice of the effects that are simulated.
    """
    stored = StoredPlan(program_sha256, sensor_sha256(sensor), plan)
    return to_json(stored, PLAN_SCHEMA) + "\n"


def read_plan(path: Path, program_sha256: str, sensor: Sensor) -> Plan:
    """Return the plan in the plan file or frame file `path`, for a given program, whose container
    has the digest `program_sha256`, and a given sensor.

    Raises Rejected (status 2): NS0747 if the file cannot be read or contains no plan of this
    version, NS0748 if the plan was made for another program or sensor. A plan is a choice of the
    effects that are simulated. A container is a compiled program."""
    stored = _read(path)
    for name, here in (
        ("program_sha256", program_sha256),
        ("sensor_sha256", sensor_sha256(sensor)),
    ):
        its = getattr(stored, name)
        if its != here:
            raise rejected(
                "NS0748",
                f"the plan '{path}' was made for another {name.removesuffix('_sha256')}",
                notes=(f"its {name} is {its[:12]}.., but here it is {here[:12]}..",),
                helps=("make a new plan: give --plan a name that does not exist",),
            )
    return stored.plan


def stored_plan(path: Path) -> Plan:
    """Return the plan (the effects that are simulated) in a plan file or a frame file (.npz),
    whatever its program. Raises Rejected (NS0747) for any other file, and for a frame that was
    exposed without a plan."""
    return _read(path).plan


def _read(path: Path) -> StoredPlan:
    """Return the plan stored in a plan file or, if the name ends in .npz, in a frame file. Raises
    Rejected (NS0747) if there is none, or it is damaged, names unknown effects, or has a tolerance
    that cannot be read."""
    try:
        if path.suffix.lower() == ".npz":
            meta = read_frame_arrays(path, lambda _name: False)[1]
            if (meta.get("plan") or {}).get("tolerance") is None:
                raise ValueError("its frame was exposed without a plan")
            stored: StoredPlan = from_plain(StoredPlan, {name: meta.get(name) for name in _STORED})
        else:
            stored = from_json(StoredPlan, read_whole(path), PLAN_SCHEMA)
        unknown = {decision.name for decision in stored.plan.decisions} - {*by_name()}
        if unknown:
            raise ValueError(f"the effect {min(unknown)[:40]!a} is unknown")
        if unit_of(stored.plan.tolerance) is None:
            raise ValueError(f"its tolerance is {stored.plan.tolerance[:40]!a}")
    except (OSError, ValueError, InvalidArrays) as error:
        reason = (
            f"it cannot be read: {error.strerror}" if isinstance(error, OSError) else str(error)
        )
        raise rejected(
            "NS0747",
            f"'{path}' contains no plan of this version of nscc",
            notes=(" ".join(reason.split())[:160],),
            helps=("make it again: `nscc run .. --plan FILE` writes a plan to a new file",),
        ) from error
    return stored


def plan_table(plan: Plan, report: Audit | None = None) -> str:
    """Return the plan (the effects that are simulated) as a table, followed by the audit if there
    is one."""
    return str(plan) if report is None else f"{plan}\n{report}"
