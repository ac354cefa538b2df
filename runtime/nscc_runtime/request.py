"""The options of a capture: their kinds, meanings and defaults, without the simulators."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

from nscc.diagnostics.diagnostic import Rejected, rejected
from nscc.toml.kinds import SEED, FilePath, Flag, Instance, Integer, TextKind
from nscc.toml.schema import key

if TYPE_CHECKING:
    from nscc_runtime.effects import Selection
    from nscc_runtime.host_setting import HostSetting
    from nscc_runtime.kept_plans import Turn
    from nscc_runtime.light import Light
    from nscc_runtime.planning.plan import Plan
    from nscc_runtime.planning.tolerance import ToleranceInput

Fidelity = Literal["planned", "reference"]
_NONE = type(None)


@dataclass(frozen=True)
class Request:
    """How to expose a scene.

    With `by_plan`, a plan chooses which of `effects` are simulated, to `tolerance` (5e, 0.1lsb, 1%
    of the mean signal, 0.15noise of the frame's own noise, or electrons); if `effects` are not
    automatic, the plan keeps all of them. The plan is the given `plan`, read from a file, or made
    now; if `plan` names a file that does not exist, its text is returned. Programs with images have
    no plan: with `by_plan`, sums simulate all of `effects`. Without `by_plan` words are executed
    one by one, without effects or with `effects` by the reference. `audit` measures the error of a
    plan on all pixels, in the loop over words. With a `turn`, the plan of an earlier scene is
    reused if it is valid for this scene. `repeat`: number of frames, None for a single frame
    without an axis of repeats. `params`, `inputs`: what the user gave; `settings` is what follows
    from them. Results do not depend on `threads` (None: all processors)."""

    effects: Selection = key(
        Instance(
            (str, _NONE, "nscc_runtime.effects:Selection"),
            "text",
            ("for instance effects='auto', 'all', 'none' or 'shot,read'",),
        ),
        "Sensor effects: auto, all, none (the default), or names; +NAME turns one on, -NAME off",
    )
    tolerance: ToleranceInput = key(
        Instance(
            (str, int, float, _NONE, "nscc_runtime.planning.tolerance:Tolerance"),
            "text or a number",
        ),
        "Largest RMS error of a plan; %: of the mean signal. Default: 0.15noise, a fraction of the "
        "frame's own noise",
        "0.15noise",
        notation="5e|0.1lsb|1%",
        default_text="",
    )
    fidelity: Fidelity = key(
        TextKind(get_args(Fidelity)),
        "reference: simulate effects slot by slot, exactly (slow). planned (default): within a "
        "tolerance",
        "planned",
        default_text="",
    )
    audit: bool = key(
        Flag(),
        "Measure the error of the plan on all pixels; exit with status 1 above the tolerance",
        False,
    )
    plan: Plan | Path | None = key(
        FilePath("a plan or a plan file", ("nscc_runtime.planning.plan:Plan",)),
        "Use this plan; if it does not exist, write it",
        None,
    )
    seed: int = key(SEED, "Seed of a frame's noise", 0)
    device_seed: int = key(SEED, "Seed of fixed patterns", 0)
    repeat: int | None = key(Integer(1, 10_000), "Expose K frames", None)
    threads: int | None = key(Integer(1, inf), "Number of threads", None)
    params: Any = key(
        Instance((dict, list, tuple, _NONE), "a mapping, or a list with one for each frame"),
        "Values of parameters, set before the frame",
        None,
    )
    inputs: Any = key(
        Instance((dict, list, tuple, _NONE), "a mapping, or a list with one for each frame"),
        "Bits of input planes, loaded before the frame",
        None,
    )
    by_plan: bool = True
    turn: Turn | None = None
    settings: tuple[HostSetting, ...] = ()
    """What the host sets before each frame of a program of version 4; the last one also holds for
    all later frames. Empty for the starts of parameters and input planes."""
    next_lights: tuple[Light, ...] = ()
    """Lights of all frames after the first, for images and planes; empty for equal lights."""

    @classmethod
    def of(
        cls,
        *,
        effects: str | Selection | None = None,
        tolerance: ToleranceInput | None = None,
        plan: Plan | Path | None = None,
        audit: bool = False,
        fidelity: Fidelity = "planned",
        mark: str = "",
        **options: Any,
    ) -> Request:
        """Return the request for a user's options. `effects` None means no effects, or "auto" if a
        plan, an audit or a tolerance is requested.

        `plan`: a plan, or the path of a plan file, which need not exist. `fidelity` "reference"
        simulates `effects` slot by slot. `mark`: prefix of option names in messages, such as "--".
        `options`: further fields. Raises Rejected: NS0739 (status 2) for options that exclude each
        other, NS0756 for unknown effects."""
        from nscc_runtime.effects import selected

        given_options = {
            "tolerance": tolerance is not None,
            "audit": audit,
            "plan": plan is not None,
        }
        # Tolerance, audit and plan all ask for a plan, so they imply the effects "auto".
        planning_options = [name for name, present in given_options.items() if present]
        text = effects if effects is not None else "auto" if planning_options else "none"
        chosen = selected(text) if isinstance(text, str) else text
        reference = fidelity == "reference"
        if reference and (planning_options or chosen.auto):
            named = ", ".join(mark + name for name in planning_options) or f"{mark}effects auto"
            raise _contradiction(
                f"{named} with {mark}fidelity reference",
                "the reference simulates the selected effects without a plan",
                f"leave {named} out, or {mark}fidelity reference",
            )
        # A plan file that does not exist yet will be written; an existing one replaces the
        # choice.
        file = plan if isinstance(plan, Path) else None
        plan_exists = file.exists() if file is not None else plan is not None
        if plan_exists and (effects is not None or tolerance is not None):
            named = f"{mark}{'effects' if effects is not None else 'tolerance'}"
            plan_name = "a plan" if file is None else f"the plan '{file}'"
            raise _contradiction(
                f"{named} with {plan_name}",
                "an existing plan already fixes the effects and the tolerance",
                f"leave {named} out, or name a file that does not exist to write a new plan",
            )
        by_plan = not reference and (bool(planning_options) or not chosen.without_effects)
        if tolerance is not None:
            options["tolerance"] = tolerance
        return cls(chosen, by_plan=by_plan, plan=plan, audit=audit, fidelity=fidelity, **options)


def _contradiction(options: str, note: str, help_text: str) -> Rejected:
    """Return the error NS0739, for the caller to raise, for options that exclude each other.
    `options`: their names as a clause, such as "--audit with --fidelity reference"."""
    return rejected(
        "NS0739", f"{options}: these options exclude each other", notes=(note,), helps=(help_text,)
    )
