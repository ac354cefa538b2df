"""`nscc tradeoff emulator`: measure simulation error against time, and check tolerances."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic
from nscc.diagnostics.rejection import rejected
from nscc_cli import options as shared
from nscc_cli.completion import SCENE
from nscc_cli.frames import scene_of, sensor_of
from nscc_cli.options import OUT, PATH
from nscc_cli.programs import compile_options, load_program
from nscc_cli.runtime_options import measured_options
from nscc_cli.support import CommonCommand, progress, say
from nscc_cli.tradeoff_files import output_files, run_study
from nscc_runtime.run_kinds import KINDS

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_training.tradeoff.emulator import NamedLight


@click.command("emulator", cls=CommonCommand)
@click.argument("program", required=False, metavar="[FILE.nsl|FILE.icw]", type=PATH)
@shared.section(shared.SCENE, click.option(
    "--scene", "scenes", type=SCENE, multiple=True, metavar="SCENE",
    help="A scene as in nscc run; may be repeated (default: three built-in scenes).",
))  # fmt: skip
@click.option("--tolerances", metavar="T,..", default="0.5e,1e,2e,5e,10e,20e,50e",
              show_default=True,
              help="Tolerances to plan for: electrons (5e), codes (0.1lsb), or a part of each "
              "scene's mean signal (1%).")  # fmt: skip
@click.option("--budget", metavar="T", default="5e", show_default=True,
              help="The tolerance whose plans are shown effect by effect.")  # fmt: skip
@click.option("--frames", type=click.IntRange(2, 1000), default=2, show_default=True,
              help="Number of frames for measuring errors; more if they have few "
                   "pixels.")  # fmt: skip
@shared.repeats_option(5)
@measured_options
@shared.section(shared.OUTPUT, click.option(
    "-o", "out", type=OUT, metavar="OUT",
    help="Write OUT.csv, OUT.png, OUT_calibration.png and OUT_budget.png.",
))  # fmt: skip
@shared.csv_options
def command(program: Path | None, **options: Any) -> int:
    """Measure the error against the reference and the simulation time of one frame.

    Compares the reference; light summed in float32 without effects; Poisson numbers drawn slot by
    slot in numpy; plans for several tolerances, with and without planning time. A second diagram
    shows the measured error against the requested tolerance, a third each effect's contribution
    and which effects are left out. Exits with status 1 if a plan exceeded its tolerance."""
    from nscc.words.readout import converter_of
    from nscc_runtime.execution.program import analysed
    from nscc_training.tradeoff.emulator import StudySettings
    from nscc_training.tradeoff.emulator_study import EmulatorBenches

    files = output_files(options, "calibration", "budget")
    container, messages = _container(program, options)
    sensor = sensor_of(converter_of(container), options)
    repeats = options["repeats"]
    settings = StudySettings(
        tuple(options["tolerances"].split(",")), options["budget"], options["frames"], repeats,
        options["seed"], options["device_seed"],
    )  # fmt: skip
    scenes = _scenes(container, options, messages)
    _refuse(container)
    benches = EmulatorBenches.of(analysed(container, sensor), scenes, settings)
    digests = [scene.light.sha256() for scene in scenes]
    measured = run_study(benches.study(), files, {**options, "program": program}, *digests)
    return 0 if benches.keep_promises(measured) else 1


def _refuse(container: Container) -> None:
    """Raise NS0750 for a program without plans, and NS0828 for pixels that look."""
    from nscc_runtime.planless import refuse_planless

    refuse_planless(container, "nscc tradeoff emulator")
    if not KINDS.of(container).open_times_known:
        raise rejected(
            "NS0828",
            "nscc tradeoff emulator uses sums over slots, which are undefined for pixels "
            "that look at the light",
            helps=("`nscc tradeoff FILE.nsl --scene S` supports such programs",),
        )


def _container(
    path: Path | None, options: dict[str, Any]
) -> tuple[Container, tuple[Diagnostic, ...]]:
    """Compile or load the program; without a path compile a built-in program of 16 slots."""
    if path is not None:
        return load_program(path, options)
    from nscc.compiler import compile_source
    from nscc.containers import with_pixels
    from nscc.source import Source
    from nscc_training.tradeoff.emulator import PROGRAM

    path = Path("default.nsl")
    container = compile_source(
        Source(path.name, PROGRAM), Path(), compile_options(options)
    ).container
    assert container is not None  # programs that do not fit are rejected
    return with_pixels(container, path, options["pixels"]), ()


def _scenes(
    container: Container, options: dict[str, Any], messages: tuple[Diagnostic, ...]
) -> list[NamedLight]:
    """Return the light of each scene, with the shortest unique name."""
    from nscc_runtime.scenes import scene_light
    from nscc_training.tradeoff.emulator import SCENES, NamedLight

    specs = list(dict.fromkeys(options["scenes"] or SCENES))
    names = [spec if spec.startswith("builtin:") else Path(spec).stem for spec in specs]
    if len(set(names)) < len(names):
        names = specs
    say(messages)
    scenes = []
    for name, spec in zip(names, specs, strict=True):
        scene_messages: list[Diagnostic] = []
        scene = scene_of({**options, "scene": spec})
        light = scene_light(
            scene, container.slot_us, container.target, scene_messages.append, progress
        )
        say(scene_messages)
        scenes.append(NamedLight(name, light))
    return scenes
