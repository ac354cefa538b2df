"""One run of a program over a scene on the emulated chip: by a plan, or words slot by slot. `nscc
run` is this with files around it, `nscc_runtime.capture` is it for Python."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, field, replace
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from nscc.diagnostics.diagnostic import Diagnostic, Rejected, Severity
from nscc.diagnostics.rejection import rejected
from nscc.words.container import Container
from nscc.words.file import to_bytes
from nscc.words.legality import refuse_pictures
from nscc_runtime import frame_file
from nscc_runtime.container_cache import OfContainer
from nscc_runtime.effects import Selection, marks, selected
from nscc_runtime.frame_file import Frame, Provenance
from nscc_runtime.frame_series import gathered
from nscc_runtime.kept_plans import Statistics, Turn
from nscc_runtime.light import Light
from nscc_runtime.planless import planless
from nscc_runtime.planning.tolerance import DEFAULT, OPTION_MAX, ToleranceInput, check_tolerance
from nscc_runtime.progress import Progress, unseen
from nscc_runtime.sensor import Sensor
from nscc_runtime.timings import Timings

if TYPE_CHECKING:  # a frame without effects starts without planning
    from nscc_runtime.loop import Loop
    from nscc_runtime.planning.audit import Audit
    from nscc_runtime.planning.plan import Plan
    from nscc_runtime.planning.planned_scene import PlannedScene

Fidelity = Literal["planned", "reference"]


@dataclass(frozen=True)
class Request:
    """How to expose a scene.

    With `planned`, effects are simulated to `tolerance` (5e, 0.1lsb, 1% of the mean signal,
    0.15noise of the frame's own, or electrons), the worst pixel to `tolerance_max`, where there is
    one, by a plan: the one given, that of a file, or one made now, whose text is given back if
    `plan` names a file that does not exist. Otherwise words are executed slot by slot, without
    effects or with all of `effects` exactly. `audit` compares a plan's frames with that reference.
    With a `turn` the plan of an earlier scene serves this one, too, where it covers it.
    `repeat` frames, or one (None). `threads`, by default as many as there are processors, change no
    bit. A `torch_device` draws and adds up the frames of a plan by sums, many at once.
    """

    effects: Selection
    planned: bool = True
    tolerance: ToleranceInput = DEFAULT
    tolerance_max: ToleranceInput | None = None
    audit: bool = False
    plan: Plan | Path | None = None
    seed: int = 0
    device_seed: int = 0
    repeat: int | None = None
    threads: int | None = None
    torch_device: str | None = None
    turn: Turn | None = None
    next_lights: tuple[Light, ...] = ()
    """Of images and planes: the light of each frame behind the first, where it is another one."""

    @classmethod
    def of(
        cls,
        *,
        effects: str | Selection | None = None,
        tolerance: ToleranceInput | None = None,
        tolerance_max: ToleranceInput | None = None,
        plan: Plan | Path | None = None,
        audit: bool = False,
        fidelity: Fidelity = "planned",
        mark: str = "",
        **options: Any,
    ) -> Request:
        """What a user asks for: no effects, or `auto` where a plan or a promise is wanted.

        `fidelity` "reference" simulates `effects` slot by slot. Raises Rejected: NS0739 (status 2)
        for options that contradict each other, which messages name with `mark` before them, NS0756
        for effects that there are not.
        """
        tolerances = {"tolerance": tolerance, "tolerance_max": tolerance_max}
        tolerances = {name: value for name, value in tolerances.items() if value is not None}
        given_options = {"audit": audit, "plan": plan is not None}
        planning_options = [
            *tolerances,
            *(name for name, present in given_options.items() if present),
        ]
        text = effects if effects is not None else "auto" if planning_options else "none"
        chosen = selected(text) if isinstance(text, str) else text
        reference = fidelity == "reference"
        if reference and (planning_options or chosen.auto):
            named = (
                ", ".join(_option(mark, name) for name in planning_options) or f"{mark}effects auto"
            )
            raise _contradiction(
                f"{named} with {mark}fidelity reference",
                "the reference simulates the selected effects without a plan",
                f"leave {named} out, or {mark}fidelity reference",
            )
        file = plan if isinstance(plan, Path) else None
        plan_exists = file.exists() if file is not None else plan is not None
        if plan_exists and (effects is not None or tolerances):
            first = next(iter(["effects"] if effects is not None else tolerances))
            named = _option(mark, first)
            plan_name = "a plan" if file is None else f"the plan '{file}'"
            raise _contradiction(
                f"{named} with {plan_name}",
                "an existing plan already fixes the effects and the tolerance",
                f"leave {named} out, or name a file that does not exist to write a new plan",
            )
        planned = not reference and (bool(planning_options) or not chosen.noiseless)
        options.update(tolerances)
        return cls(chosen, planned=planned, plan=plan, audit=audit, **options)


@dataclass(frozen=True)
class Listener:
    """Who is told how a run goes: a line of text, where somebody reads it, a warning (which may
    raise), and progress. `timings` gathers the seconds that were spent."""

    say: Callable[[str], None] | None = None
    warn: Callable[[Diagnostic], None] = lambda _diagnostic: None
    progress: Progress = unseen
    timings: Timings = field(default_factory=Timings)
    lines_said: set[str] = field(default_factory=set)
    """Lines that are said once."""


@dataclass(frozen=True, eq=False)
class Simulated:
    """What became of it: the frame(s) and where they come from.

    `effects` are those that were simulated. With a plan: the plan, its audit if there was one, the
    text of a plan's file to be written, and what to raise once the frame is written if the audit
    says that the promise was broken.
    """

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
    """Expose the scene. Raises Rejected where the program, the scene or the plan is unfit."""
    listener = listener or Listener()
    try:
        simulated = _simulated(container, light, sensor, request, listener)
    finally:
        if request.turn is not None:
            request.turn.plans.passed(request.turn.number)
    eaten = _eaten(simulated.frame)
    if eaten is not None:
        listener.warn(eaten)
    return simulated


def _simulated(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    if container.target.streamed and (request.plan is not None or request.audit):
        raise planless("--plan" if request.plan is not None else "--audit")
    if container.target.streamed:
        check_tolerance(request.tolerance, sensor)
        if request.tolerance_max is not None:
            check_tolerance(request.tolerance_max, sensor, OPTION_MAX)
    if container.target.streamed and not request.effects.noiseless:
        return _streamed(container, light, sensor, request, listener)
    if container.pictures is not None:
        return _pictured(container, light, sensor, request, listener)
    if request.planned and not container.target.streamed:
        return _planned(container, light, sensor, request, listener)
    with listener.timings.measure("expose_s"):
        frame = _exact(container, light, sensor, request, listener)
    fidelity = "planned" if request.effects.noiseless else "reference"
    digest = _digest(container)
    plan = frame_file.unplanned(request.effects, light.motion is not None)
    seeds = request.seed, request.device_seed
    return Simulated(frame, Provenance(digest, sensor, *seeds, fidelity, plan), request.effects)


def _streamed(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    """A chip without logic: plane by plane, with all effects that were named and that it has."""
    from nscc_runtime.noise.noise_loops import fill_normals
    from nscc_runtime.reference.stream import absent_effects, stream_frames

    _say_compiling(listener, fill_normals, "noise")
    absent = absent_effects(container, request.effects)
    effects = request.effects.without(*absent)
    with listener.timings.measure("expose_s"):
        exposed = stream_frames(
            container, light, sensor, effects,
            seed=request.seed, device_seed=request.device_seed, count=request.repeat or 1,
            threads=request.threads,
        )  # fmt: skip
        frame = _gathered(exposed, request.repeat, listener)
    digest = _digest(container)
    plan = frame_file.unplanned(request.effects, light.motion is not None, absent)
    plan["slot_loop_reasons"] = ["light is sorted slot by slot, as planes of bits say"]
    seeds = request.seed, request.device_seed
    return Simulated(frame, Provenance(digest, sensor, *seeds, "reference", plan), effects)


def _pictured(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    """Images and planes: slot by slot and word by word, with all effects that were named."""
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.neighbours.pictured_program import PicturedProgram

    if request.plan is not None or request.audit:
        option = "--plan" if request.plan is not None else "--audit"
        refuse_pictures(
            container, f"{option} needs a plan", f"leave {option} out: all is simulated"
        )
    lights = (light, *request.next_lights)
    for each in lights:
        check(container, each)
    program = PicturedProgram(container, sensor, request.effects, request.threads)
    if request.effects.auto and listener.say is not None:
        listener.say("images and planes: all effects are simulated, slot by slot, without a plan")
    with listener.timings.measure("expose_s"):
        seeds = request.seed, request.device_seed
        exposed = (
            program.film(lights, *seeds)
            if request.next_lights
            else program.frames(light, *seeds, request.repeat or 1)
        )
        frame = _gathered(exposed, request.repeat, listener)
    digest = _digest(container)
    plan = frame_file.unplanned(request.effects, light.motion is not None)
    plan["slot_loop_reasons"] = ["images and planes are computed of every pixel and its neighbours"]
    fidelity = "planned" if request.effects.noiseless else "reference"
    origin = Provenance(digest, sensor, *seeds, fidelity, plan)
    return Simulated(frame, origin, request.effects)


def _exact(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Frame:
    """Words slot by slot: without effects, or by the reference."""
    repeat = request.repeat
    if container.machine is not None:
        return _gathered(_looking(container, light, sensor, request, listener), repeat, listener)
    if request.effects.noiseless:
        from nscc_runtime.emulator import expose
        from nscc_runtime.emulator.loops import expose_block

        _say_compiling(listener, expose_block, "emulator")
        exact = expose(container, light, device_seed=request.device_seed, threads=request.threads)
        frame = frame_file.read_out(exact, container.target, sensor)
        return frame_file.repeated(frame, repeat) if repeat else frame
    from nscc_runtime.noise.noise_loops import fill_normals
    from nscc_runtime.reference import frames

    _say_compiling(listener, fill_normals, "noise")
    exposed = frames(
        container, light, sensor, request.effects,
        seed=request.seed, device_seed=request.device_seed, count=repeat or 1,
        threads=request.threads,
    )  # fmt: skip
    return _gathered(exposed, repeat, listener)


def _looking(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Iterable[Frame]:
    """The frames of a program whose pixels look: kept states go on from one to the next."""
    from nscc_runtime.looked_frames import frames
    from nscc_runtime.looking.path_loop import run_paths
    from nscc_runtime.noise.noise_loops import fill_normals

    noiseless = request.effects.noiseless
    if noiseless:
        _say_compiling(listener, run_paths, "emulator")
    else:
        _say_compiling(listener, fill_normals, "noise")
    return frames(
        container, light, sensor, request.effects, seed=request.seed,
        device_seed=request.device_seed, count=request.repeat or 1, threads=request.threads,
        by_words=not noiseless,
    )  # fmt: skip


def _planned(
    container: Container, light: Light, sensor: Sensor, request: Request, listener: Listener
) -> Simulated:
    """By a plan: made here, or read from its file."""
    from nscc_runtime.emulator.capture import check
    from nscc_runtime.planning.make import measured_again
    from nscc_runtime.planning.plan_file import plan_text, read_plan
    from nscc_runtime.planning.scenes import planning_of

    timings, device_seed = listener.timings, request.device_seed
    planning = planning_of(
        container, sensor, light, device_seed, request.threads, request.torch_device
    )
    _say_compiling(listener, planning.loop, "planner")
    check(container, light)
    digest = _digest(container)
    with timings.measure("analyse_s"):
        planning.ready()
    file = request.plan if isinstance(request.plan, Path) else None
    plan_given = file is not None and file.exists()
    with timings.measure("plan_s"):
        if file is not None and plan_given:
            plan = measured_again(planning, read_plan(file, digest, sensor))
        elif request.plan is None or isinstance(request.plan, Path):
            plan = _make_plan(planning, container, light, sensor, request)
        else:
            plan = request.plan
    if plan.breach is not None and (request.effects.auto or plan_given):
        listener.warn(_over(plan, plan.breach, plan_given))
    with timings.measure("expose_s"):
        exposed = planning.frames(plan, request.seed, request.repeat or 1)
        frame = _gathered(exposed, request.repeat, listener)
    report, broken = None, None
    if request.audit:
        with timings.measure("audit_s"):
            report = planning.audit(plan, request.seed, request.repeat or 1)
        broken = None if report.holds else _broken(plan, report, plan_given or plan is request.plan)
    origin = Provenance(
        digest, sensor, request.seed, device_seed, "planned", plan.as_json(),
        None if report is None else asdict(report),
    )  # fmt: skip
    text = plan_text(plan, digest, sensor) if file is not None and not plan_given else None
    return Simulated(frame, origin, plan.kept, plan, report, text, broken)


def _make_plan(
    scene: PlannedScene, container: Container, light: Light, sensor: Sensor, request: Request
) -> Plan:
    """A plan made for this scene, or an earlier one that covers it. Who asks for a plan's file or
    for an audit gets every figure of the table."""
    from nscc_runtime.planning.make import PlanRequest, make_plan

    turn, repeat = request.turn, request.repeat or 1
    plan_request = PlanRequest(
        request.effects, request.tolerance, request.tolerance_max, repeat,
        figures=request.audit or request.plan is not None,
    )  # fmt: skip
    if turn is None or not request.effects.auto:
        return make_plan(scene, plan_request)

    def make(frames: int) -> Plan:
        return make_plan(scene, replace(plan_request, frames=frames * repeat))

    plan_key = container, sensor, request.device_seed, plan_request
    statistics = Statistics.of(light, scene.open_part)
    return turn.plans.plan(turn, plan_key, statistics, make, scene.serves)


def _gathered(frames_made: Iterable[Frame], repeat: int | None, listener: Listener) -> Frame:
    """The frame, or all of `repeat` with an axis in front."""
    frames = listener.progress(frames_made, "exposing", repeat or 1)
    if repeat:
        return gathered(frames, repeat)
    frame: Frame
    (frame,) = frames
    return frame


def _eaten(frame: Frame) -> Diagnostic | None:
    """The warning that light has eaten reset levels."""
    bit, marked = marks()["level"].bit, frame.saturated_by
    pixels = np.bitwise_or.reduce(marked, axis=tuple(range(marked.ndim - 2))) & bit
    count = int(np.count_nonzero(pixels))
    if not count:
        return None
    affected = "pixel reads less than it" if count == 1 else "pixels read less than they"
    return Diagnostic(
        "NS0793",
        f"{count} {affected} received, possibly 0: light had filled PIX before the reset level "
        "was read",
        severity=Severity.WARNING,
        notes=(f"black suns are {count / pixels.size:.2%} of the pixels",),
        helps=("saturated_by has bit 16 there; less light reduces their number",),
        data={"pixels": count},
    )


def _over(plan: Plan, breach: str, plan_given: bool) -> Diagnostic:
    """The warning that what the user forced off, or the plan given, costs more than allowed."""
    forced = [
        decision.name
        for decision in plan.decisions
        if decision.forced and decision.decision == "dropped"
    ]
    why = (
        "the plan was made for another scene" if plan_given else f"turned off: {', '.join(forced)}"
    )
    return Diagnostic(
        "NS0749",
        breach,
        severity=Severity.WARNING,
        notes=(why,),
        helps=(_instead(plan_given),),
        data={
            "predicted_e": plan.predicted_e,
            "tolerance_e": plan.tolerance_e,
            "other_states": plan.other_states,
        },
    )


def _instead(plan_given: bool) -> str:
    return (
        "make a new plan for this scene"
        if plan_given
        else "let the planner decide on these effects"
    )


def _broken(plan: Plan, report: Audit, plan_given: bool) -> Rejected:
    """The promise did not hold (status 1)."""
    if plan.breach is not None:
        advice = f"use --fidelity reference for this scene, or {_instead(plan_given)}"
    else:
        advice = (
            "use --fidelity reference for this scene; a plan that predicts an error within "
            "the tolerance should not fail: please report it"
        )
    return rejected(
        "NS0749",
        report.breach(plan) or "the promise is broken",
        notes=(
            "its error was not measured before"
            if plan.predicted_e is None
            else f"predicted were {plan.predicted_e:.3g} e",
        ),
        helps=(advice,),
        data={
            "measured_rms_e": report.measured_rms_e,
            "tolerance_e": plan.tolerance_e,
            "other_states": report.other_states,
        },
        status=1,
    )


def _sha256(container: Container) -> str:
    return sha256(to_bytes(container)).hexdigest()


_digest = OfContainer(_sha256)
"""By which frames and plans name a program."""


def _option(mark: str, name: str) -> str:
    """An argument as a message calls it: of the command line where there is a mark before it."""
    return mark + (name.replace("_", "-") if mark else name)


def _contradiction(options: str, note: str, help_text: str) -> Rejected:
    return rejected(
        "NS0739", f"{options}: these options exclude each other", notes=(note,), helps=(help_text,)
    )


def _say_compiling(listener: Listener, loop: Loop[Any], subject: str) -> None:
    if listener.say is not None and not loop.is_compiled():
        line = loop.compiling(f"the {subject}'s loops")
        if line not in listener.lines_said:
            listener.lines_said.add(line)
            listener.say(line)
