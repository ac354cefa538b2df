"""`nscc run`: expose one frame of a scene with a program."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Severity, rejected
from nscc.mappings import NamedValues
from nscc_cli import options as shared
from nscc_cli.completion import KEPT, RUN
from nscc_cli.frames import (
    ExposedFrame,
    frame_path,
    parse_keep,
    refuse_swapped,
    run_capture_of,
    scene_of,
    sensor_of,
    summary,
    write_frame,
)
from nscc_cli.options import OUT, PATH, flag, out_option, values_given
from nscc_cli.programs import load_program
from nscc_cli.runtime_options import (
    chip_at,
    fit_option,
    host_value_options,
    link_options,
    placing_options,
)
from nscc_cli.support import (
    common_command,
    given_options,
    progress,
    refuse_ignored,
    say,
    say_done,
)
from nscc_runtime.request import Request
from nscc_runtime.scene_settings import Scene

if TYPE_CHECKING:
    from nscc_training.run_files import RunCapture

_SIMULATION = (
    "effects",
    "tolerance",
    "fidelity",
    "audit",
    "plan",
    "seed",
    "device_seed",
)
"""Options of the emulator, which have no meaning for a device."""


def _refuse_tolerance_max(
    _context: click.Context, _option: click.Parameter, value: str | None
) -> None:
    """Raise a usage error if the option `--tolerance-max`, which earlier versions had, has a
    `value`."""
    if value is not None:
        raise click.UsageError(
            "nscc run no longer has --tolerance-max: use --tolerance, which limits the RMS error; "
            "--verbose shows the error of the worst pixel"
        )


@common_command("run")
@click.argument("program", metavar="[FILE.nsl|FILE.icw]", required=False, type=PATH)
@shared.section(
    shared.SCENE,
    shared.declared(Scene, "name"),
    click.option(
        "--like",
        type=RUN,
        metavar="RUN",
        help="Expose as the run was trained: with its exposure and sensor, and without "
        "a FILE its program.",
    ),
)
@placing_options
@fit_option
@shared.section(
    shared.SCENE,
    shared.declared(Scene, "color"),
    shared.declared(Scene, "first", show=True),
    shared.declared(Scene, "single"),
)
@shared.section(
    shared.EFFECTS,
    shared.declared(Request, *_SIMULATION),
    shared.declared(Request, "repeat"),
    click.option(
        "--tolerance-max",
        is_flag=False,
        flag_value="",
        hidden=True,
        expose_value=False,
        callback=_refuse_tolerance_max,
    ),
)
@host_value_options
@shared.sensor_options
@shared.pixels_option
@shared.build_options
@shared.section(
    shared.DEVICE,
    click.option(
        "--on",
        "place",
        default="emulator",
        show_default=True,
        metavar="emulator|PORT|host:MODULE",
        help="Where to run: the emulator, a device at a serial port, or a chip "
        "that a host module of its vendor drives.",
    ),
)
@link_options
@shared.section(
    shared.OUTPUT,
    out_option(
        "The frame file (default: NAME.frame.npz in this folder), or a part of it "
        "as .npy .mat .hdr .exr .pfm .tiff .png .gif .mp4."
    ),
    click.option("--png", type=OUT, help="Also write a picture of the frame."),
    click.option(
        "--keep",
        type=KEPT,
        default="",
        help="Also store, comma-separated: light,truth,shutter,codes.",
    ),
    click.option("--timings", type=OUT, help="Write the times in seconds to a JSON file."),
    flag("--verbose", "Print the plan's table: each effect, its error and why it was chosen."),
)
@shared.tone_option
def command(program: Path | None, like: Path | None, **options: Any) -> None:
    """Expose one frame of a scene with a program, and write it as an .npz file.

    With --on PORT, a chip exposes the frame, or a simulated device (`nscc device serve`). With --on
    host:MODULE[@ADDRESS[:PORT]], the next frame is taken that a Python module of the chip's vendor
    receives."""
    keep = parse_keep(options["keep"])
    of_run = run_capture_of(like, options, program)
    if program is None and of_run is not None:
        program = of_run.program
    if program is None:
        raise click.UsageError("name a program, FILE.nsl or FILE.icw, or a run: --like RUN")
    refuse_swapped(program, options["scene"])
    if options["place"] == "emulator":
        refuse_ignored("the emulator has no port (--on PORT)", "baud", "patience")
        _run_on_emulator(program, options, keep, of_run)
    else:
        run_on_device(program, options, keep)


def _run_on_emulator(
    program: Path, options: NamedValues, keep: tuple[str, ...], of_run: RunCapture | None
) -> None:
    """Compile the program (or load a compiled one), expose a scene on the emulator, write the files
    and print a summary.

    `options` are those of the command line, `keep` the arrays to add to the frame file. `of_run` is
    the training run that the program must belong to, if one is named. Raises Rejected if the audit
    finds the plan's error too large, after writing the files."""
    from nscc.container_proof import require_known_shutters
    from nscc.words.readout import converter_of
    from nscc_runtime.frame_file import meta
    from nscc_runtime.host_setting import host_settings
    from nscc_runtime.pieces import simulate_scene
    from nscc_runtime.scenes import laid_lights
    from nscc_runtime.simulate import Listener

    request, out = (
        Request.of(**values_given(Request, options), mark="--"),
        frame_path(program, options),
    )
    listener = Listener(say_done, lambda diagnostic: say([diagnostic]), progress)
    timings = listener.timings
    with timings.measure("compile_s"):
        container, messages = load_program(program, options)
    if "shutter" in keep:
        require_known_shutters(container)
    if of_run is not None:
        of_run.check(container, program)
    settings = host_settings(container, options["params"], options["inputs"])
    request = replace(request, settings=settings)
    sensor = sensor_of(converter_of(container), options)
    with timings.measure("scene_s"):
        scene, messages_so_far = scene_of(options), list(messages)
        laid = laid_lights(
            scene, container.slot_us, container.target, messages_so_far.append, progress
        )
        say(messages_so_far)
    exposed = simulate_scene(container, laid, sensor, request, listener)
    simulated, frame, container = exposed.simulated, exposed.simulated.frame, exposed.container
    about = meta(container, exposed.light, frame, simulated.origin) | exposed.meta_entries
    shown = ExposedFrame(
        container,
        exposed.light,
        frame,
        about,
        title=f"{program.name}  ·  {scene.name.rstrip('/').rsplit('/', 1)[-1]}",
        response=lambda: exposed.response(sensor),
    )
    files = write_frame(out, options, keep, shown, timings, simulated.plan_file)
    if simulated.plan is not None and options["verbose"]:
        from nscc_runtime.planning.plan_file import plan_table

        table = plan_table(simulated.plan, simulated.audit)
        if exposed.pieces > 1:
            table = f"the exposure with the largest error, of {exposed.pieces}:\n{table}"
        say_done(table + "\n")
    elif simulated.plan is not None:
        say_done(f"{simulated.plan.line}; {timings.emulation_s:.2g} s")
        if simulated.audit is not None:
            say_done(str(simulated.audit))
    # The summary gives one set of figures if all repeated frames are equal.
    alike = request.effects.without_effects and not container.keeps_states
    colours = "colours" in exposed.meta_entries
    say_done(summary(container, frame, files, alike=alike, colours=colours))
    if simulated.broken is not None:
        raise simulated.broken


_MEANINGLESS = (*_SIMULATION, "like", "fit", "color", "first", "still")
"""Options that have no meaning for a device, which exposes real light."""
HOST = "host:"
"""Start of a place that names a host module of a vendor instead of a port."""
_SCENE = ("exposure", "transfer", "fps", "crop", "frames_are")
"""Options that describe a scene, which needs to be named."""


def run_on_device(program: Path, options: NamedValues, keep: tuple[str, ...]) -> None:
    """Expose a frame of `program` on the device that `options["place"]` names, write the same files
    as for the emulator, and print a summary.

    The place is a serial port, or `host:MODULE` for a chip that a Python module of its vendor
    drives. `options` are those of the command line, `keep` the arrays to add to the frame file. A
    scene is only recorded in the files."""
    from nscc.words.readout import converter_of
    from nscc_runtime.device.device_chip import exposed
    from nscc_runtime.frame_file import check_adc
    from nscc_runtime.host_setting import host_settings
    from nscc_runtime.response import response_of
    from nscc_runtime.scenes import scene_light
    from nscc_runtime.timings import Timings

    place, scene = options["place"], options["scene"]
    # The options of the simulation do not apply to a device.
    _refuse_simulation(place, scene, keep)
    timings = Timings()
    with timings.measure("compile_s"):
        container, messages = load_program(program, options)
    check_adc(container.target)
    settings = host_settings(container, options["params"], options["inputs"])
    sensor = sensor_of(converter_of(container), options)
    light, messages_so_far = None, list(messages)
    if scene:
        messages_so_far.append(
            Diagnostic(
                "NS0770",
                f"the device exposes the real scene: --scene {scene[:60]} is only recorded",
                severity=Severity.NOTE,
                notes=("it is stored in meta, and in the file with --keep light,truth",),
            )
        )
        with timings.measure("scene_s"):
            named = scene_of(options)
            light = scene_light(
                named, container.slot_us, container.target, messages_so_far.append, progress
            )
    say(messages_so_far)
    out = frame_path(program, options)
    # The place is either a Python host of the chip's maker or a serial port.
    if place.startswith(HOST):
        from nscc_runtime.device.host_module import expose_by_host
        from nscc_runtime.effects import everything

        with timings.measure("expose_s"):
            file = expose_by_host(place, container, sensor, options["patience"])
        frame, meta, effects = file.frame, file.meta, everything()
    else:
        with timings.measure("expose_s"), chip_at(place, options, sensor) as chip:
            repeat = options["repeat"]
            frame, meta = exposed(chip, container, light, repeat, progress, *settings)
            effects = chip.effects
    title = f"{program.name}  ·  on the device"
    shown = ExposedFrame(
        container, light, frame, meta, title, lambda: response_of(container, sensor, effects)
    )
    files = write_frame(out, options, keep, shown, timings)
    say_done(summary(container, frame, files, alike=False))


def _refuse_simulation(place: str, scene: str | None, keep: tuple[str, ...]) -> None:
    """Raise Rejected (NS0770) if the user gave options that have no meaning for the device at
    `place`. `place` is a port or host:MODULE. `scene` and `keep` are the values of these options;
    without a scene, options that describe one are refused, too."""
    of_port = ("baud", "repeat", "scene", "params", "inputs") if place.startswith(HOST) else ()
    refused_options = given_options((*_MEANINGLESS, *of_port, *(() if scene else _SCENE)))
    if not scene:
        refused_options += [f"--keep {name}" for name in keep if name in ("light", "truth")]
    if refused_options:
        listed = ", ".join(refused_options)
        raise rejected(
            "NS0770",
            f"{listed} does not apply to a device: --on {place[:60]}",
            notes=("a device exposes the real scene with its real noise",),
            helps=(f"leave {listed} out, or run on the emulator: leave --on out",),
        )
