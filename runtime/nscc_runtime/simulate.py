"""One run of a program over a scene on the emulated chip: by a plan, or with all selected effects.

`nscc run` adds files to it, and `nscc_runtime.capture` is its Python interface."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.words.container import Container
from nscc.words.file import to_bytes
from nscc_runtime import frame_file, run_messages
from nscc_runtime.caches import OfContainer
from nscc_runtime.effects import Selection, Sensor
from nscc_runtime.frame_file import Frame, Provenance
from nscc_runtime.frame_series import gathered
from nscc_runtime.light import Light
from nscc_runtime.planning.tolerance import ToleranceInput, check_tolerance
from nscc_runtime.pool import keep_memory
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.request import Request
from nscc_runtime.run_kinds import KINDS, refuse_planless
from nscc_runtime.timings import Timings

if TYPE_CHECKING:  # a frame without effects starts without planning
    from nscc_runtime.loop import Loop
    from nscc_runtime.planning.audit import Audit
    from nscc_runtime.planning.plan import Plan, PlanRequest
    from nscc_runtime.planning.planned_scene import PlannedScene


@dataclass(frozen=True)
class Listener:
    """The callbacks of a run.

    `say`: called with lines of text, None if nobody reads them. `warn`: called with warnings; it
    may raise. `progress`: shows progress. `timings`: collects the seconds spent."""

    say: Callable[[str], None] | None = None
    warn: Callable[[Diagnostic], None] = lambda _diagnostic: None
    progress: Progress = unseen
    timings: Timings = field(default_factory=Timings)
    lines_said: set[str] = field(default_factory=set)
    """Lines that were said already, because each is said only once."""


@dataclass(frozen=True, eq=False)
class Simulated:
    """The result of a run: the frame(s) and their origin.

    `effects`: the effects that were simulated. With a plan: the plan, its audit if requested, the
    text of a plan file to write, and `broken`, the error to raise after writing the frame if the
    audit failed."""

    frame: Frame
    origin: Provenance
    effects: Selection
    plan: Plan | None = None
    audit: Audit | None = None
    plan_file: str | None = None
    broken: Rejected | None = None


def simulate(
    container: Container,
    light: Light,
    sensor: Sensor,
    request: Request,
    listener: Listener | None = None,
) -> Simulated:
    """Expose `light` as `request` says, by a plan if the program supports plans and effects are
    wanted.

    `listener` (None: nobody listens) receives messages, progress, timings, and a warning about
    black suns. Raises Rejected if the program, the light or the plan is unsuitable; a failed audit
    is not raised but returned as `broken`."""
    keep_memory()
    listener = listener or Listener()
    try:
        simulated = _simulated(container, light, sensor, request, listener)
    finally:
        # Also after an error, because scenes with higher numbers wait.
        if request.turn is not None:
            request.turn.plans.passed(request.turn.number)
    eaten = run_messages.eaten(simulated.frame)
    if eaten is not None:
        listener.warn(eaten)
    return simulated


def _simulated(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    """Expose frames of `light` by a plan, or with the selected effects if the program supports no
    plan or none is wanted.

    `listener` receives messages and timings. Raises Rejected (NS0750) for a plan or an audit of a
    program without plans, and as `simulate`."""
    if request.plan is not None or request.audit:
        refuse_planless(container, "--plan" if request.plan is not None else "--audit")
    kind = KINDS.of(container)
    reason = kind.without_plan
    if reason:
        # The tolerance is not used, but a wrong one is still an error.
        check_tolerance(request.tolerance, sensor)
    if request.by_plan and not reason:
        return _by_plan(container, light, sensor, request, listener)
    without_effects = request.effects.without_effects
    if kind.note_without_plan and request.effects.auto:
        _say_once(listener, kind.note_without_plan)
    absent = {} if without_effects else kind.absent_effects(container, request.effects)
    effects = request.effects.without(*absent) if absent else request.effects
    # Fixed shutters and chips without logic: runs/without_plan.py; images: runs/images_run.py;
    # looks: runs/looks_run.py.
    exposing = kind.exposing(container, light, sensor, effects, request)
    if exposing.loop is not None:
        _say_compiling(listener, exposing.loop, exposing.subject)
    with listener.timings.measure("expose_s"):
        made = exposing.run()
        frame = made if isinstance(made, Frame) else _gathered(made, request.repeat, listener)
    moving, word_reasons = light.motion is not None, exposing.word_reasons()
    plan = frame_file.unplanned(request.effects, moving, word_reasons, absent)
    origin = Provenance(
        digest_of(container),
        sensor,
        request.seed,
        request.device_seed,
        fidelity="planned"
        if without_effects or (kind.is_fast and request.by_plan)
        else "reference",
        plan=plan,
        params=tuple(setting.plain(container) for setting in request.settings),
    )
    return Simulated(frame, origin, effects=effects)


def _by_plan(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    """Simulate `light` by a plan (the effects that are simulated) that is made here, read from a
    file, or passed in the `request`. Tell `listener` the timings, progress and warnings. If the
    audit exceeds its limit, the result has the error as `broken`; if `request.plan` names a new
    file, it has the file's text."""
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.execution.block_loop import run_blocks
    from nscc_runtime.planning.audit import audit
    from nscc_runtime.planning.plan_file import plan_text
    from nscc_runtime.planning.planned_scene import PlannedScene

    timings, seed = listener.timings, request.seed
    check(container, light)
    _say_compiling(listener, run_blocks, "planner")
    with timings.measure("analyse_s"):
        scene = PlannedScene(container, sensor, light, request.device_seed, request.threads)
    digest = digest_of(container)
    # A plan may be given as a file or a value, or `plan` names a file that this call writes.
    file = request.plan if isinstance(request.plan, Path) else None
    is_new_file = file is not None and not file.exists()
    plan_given = request.plan is not None and not is_new_file
    with timings.measure("plan_s"):
        plan = _plan_of(scene, digest, request, plan_given)
    # The plan of the user may be unable to keep the tolerance on this scene.
    if plan.breach is not None and (request.effects.auto or plan_given):
        listener.warn(run_messages.over(plan, plan.breach, plan_given))
    with timings.measure("expose_s"):
        exposed = scene.frames(plan.kept, seed, request.repeat or 1)
        frame = _gathered(exposed, request.repeat, listener)
    report, broken = None, None
    if request.audit:
        with timings.measure("audit_s"):
            report = audit(scene, plan)
        if not report.holds:
            broken = run_messages.broken(plan, report, plan_given)
    origin = Provenance(
        digest,
        sensor,
        seed,
        request.device_seed,
        fidelity="planned",
        plan=plan,
        audit=None if report is None else asdict(report),
    )
    text = plan_text(plan, digest, sensor) if is_new_file else None
    return Simulated(
        frame, origin, effects=plan.kept, plan=plan, audit=report, plan_file=text, broken=broken
    )


def _plan_of(scene: PlannedScene, digest: str, request: Request, plan_given: bool) -> Plan:
    """Return the plan of a request for `scene`: the one that the user gave (`plan_given`), with its
    error measured on this scene; one made for this scene; or, with a turn and automatic effects,
    one made for an earlier scene and valid here.

    `digest`: that of the program, which a plan file must have. A plan for a file or an audit has
    every figure. Raises Rejected for a plan file that is invalid or of another program."""
    from nscc_runtime.planning.make import make_plan, measured_again, served_plan
    from nscc_runtime.planning.plan_file import read_plan

    if isinstance(request.plan, Path) and plan_given:
        plan = read_plan(request.plan, digest, scene.sensor)
        return measured_again(scene, plan, figures=True)
    if request.plan is not None and not isinstance(request.plan, Path):
        return measured_again(scene, request.plan)
    turn, repeat = request.turn, request.repeat or 1
    figures = request.audit or request.plan is not None
    plan_request = _plan_request(request.effects, request.tolerance, repeat, figures)
    # Effects that the user named are not left to a plan of another scene.
    if turn is None or not request.effects.auto:
        return make_plan(scene, plan_request)
    key = scene.container, scene.sensor, scene.device_seed, plan_request
    return turn.plans.plan(
        turn,
        key,
        lambda frames: make_plan(scene, replace(plan_request, frames=frames * repeat)),
        lambda plan: served_plan(scene, plan, request.tolerance),
    )


@lru_cache(64)
def _plan_request(
    effects: Selection, tolerance: ToleranceInput, frames: int, figures: bool
) -> PlanRequest:
    """Return the `PlanRequest` of these fields, cached, because it caches names of effects."""
    from nscc_runtime.planning.plan import PlanRequest

    return PlanRequest(effects, tolerance, frames, figures)


def _gathered(frames_made: Iterable[Frame], repeat: int | None, listener: Listener) -> Frame:
    """Return the only frame of `frames_made` if `repeat` is None, else all `repeat` frames as one
    with a leading axis, also if it is 1. Report progress to `listener`. The number of frames must
    be right."""
    frames = listener.progress(frames_made, "exposing", repeat or 1)
    if repeat:
        return gathered(frames, repeat)
    frame: Frame
    (frame,) = frames
    return frame


digest_of = OfContainer(lambda container: sha256(to_bytes(container)).hexdigest())
"""The SHA-256 digest that identifies a program in frames and plans."""


def _say_compiling(listener: Listener, loop: Loop[Any], subject: str) -> None:
    """Tell the listener, once, that loops are compiled, and compile them, if `loop` is not compiled
    yet: also loops that this scene may not need, so that no later run says it again. `subject`: who
    needs them, such as "planner"."""
    if listener.say is not None and not loop.is_compiled():
        _say_once(listener, loop.compiling(f"the {subject}'s loops"))
        loop.load()


def _say_once(listener: Listener, line: str) -> None:
    """Tell the listener a line, unless it has been told already."""
    if listener.say is not None and line not in listener.lines_said:
        listener.lines_said.add(line)
        listener.say(line)
