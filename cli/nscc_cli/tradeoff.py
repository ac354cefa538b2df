"""`nscc tradeoff`: measure error against time on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, rejected
from nscc.mappings import NamedValues
from nscc.options import Options
from nscc_cli import options as shared
from nscc_cli.frames import refuse_swapped, run_capture_of, scene_of, sensor_of
from nscc_cli.options import PATH, declared, out_option, settings_from, tradeoff_options
from nscc_cli.programs import compile_options, load_program
from nscc_cli.runtime_options import measured_options, scene_option
from nscc_cli.support import Subcommands, progress, say, say_compiling
from nscc_cli.tradeoff_files import output_files, run_study
from nscc_training.command_settings import (
    DecoderStudySettings,
    EmulatorStudySettings,
    JointRequest,
    SensorStudySettings,
    SynthesisStudySettings,
)

if TYPE_CHECKING:
    from nscc.words.container import Container
    from nscc_training.tradeoff.emulator import NamedLight

_SHUTTERS = ("classes", "slots", "stop_slots", "looks", "readouts", "codes", "lowerings")
"""Fields of SensorStudySettings that name shutters and programs, in the order of the help."""


class _Tradeoffs(Subcommands):
    """The subcommands of `nscc tradeoff`; other names are programs or runs."""

    unknown = "{group} '{name}': there is no such command, file or run"

    others = ("or name a program (FILE.nsl, FILE.icw) or a run: RUN, hdr, clip",)

    def accepts(self, name: str) -> bool:
        """Return whether `name` is that of a program, of any existing path or of a run that comes
        with nscc."""
        from nscc_training.run_files import shipped_runs

        path = Path(name)
        return (
            path.suffix.lower() in (".nsl", ".icw") or path.exists() or str(path) in shipped_runs()
        )


@click.group("tradeoff", cls=_Tradeoffs)
def command() -> None:
    """Measure what more computing time improves: a table, a CSV file, a diagram.

    `nscc tradeoff PROGRAM|RUN --scene S --target-error 1%` is short for `nscc tradeoff of PROGRAM
    ..`. It finds the setting of every stage for that error."""


@command.command("of")
@click.argument("program", metavar="FILE.nsl|FILE.icw|RUN", type=PATH)
@scene_option
@declared(JointRequest, "target_error", "stages", "levels", "repeats", show=True)
@measured_options
@declared(JointRequest, "trust_code")
@shared.tradeoff_options
def joint(program: Path, **options: Any) -> int:
    """Find the fastest settings for a given error, for one program on one scene.

    For each stage (compile level, lowering, number and length of slots, effects and tolerance,
    decoder), prints the fastest setting within --target-error, with its time and error. If no
    setting reaches this error, prints the fastest of the most accurate ones. Errors are
    percentages of the mean signal and times are seconds, so that one diagram shows all stages. A
    RUN, or hdr and clip, defines program, exposure, sensor and decoder. With -o, --csv or --png,
    finished measurements are kept, and the same command continues after an interruption. Exits
    with status 1 if nothing could be measured."""
    from nscc_training.tradeoff.joint import joint_study

    files = output_files(options)
    refuse_swapped(program, options["scene"])
    run = None if program.suffix.lower() in (".nsl", ".icw") else program
    captured = run_capture_of(run, options) if options["scene"] else None
    scene = scene_of(options)
    request = settings_from(
        JointRequest,
        options,
        program=program if captured is None else captured.program,
        scene=scene,
        options=compile_options(options),
        changes=options["sensor_set"],
        run=run,
        **{name: options[name] for name in ("pixels", "sensor", "seed", "device_seed")},
    )
    study = joint_study(request, lambda message: say([message]))
    known = {**options, "program": request.program, "run": run}
    return 0 if run_study(study, files, known).points else 1


@command.command("emulator")
@click.argument("program", required=False, metavar="[FILE.nsl|FILE.icw]", type=PATH)
@shared.scenes_option("A scene as in nscc run; may be repeated (default: three built-in scenes).")
@declared(EmulatorStudySettings, show=True)
@measured_options
@shared.section(
    shared.OUTPUT,
    out_option("Write OUT.csv, OUT.png, OUT_calibration.png and OUT_budget.png.", "OUT"),
)
@shared.csv_options
def emulator(program: Path | None, **options: Any) -> int:
    """Measure the error against the reference and the simulation time of one frame.

    Compares the reference; light summed in float32 without effects; Poisson numbers drawn slot by
    slot in numpy; plans for several tolerances, with and without planning time. A second diagram
    shows the measured error against the requested tolerance, a third each effect's contribution
    and which effects are left out. Exits with status 1 if a plan exceeded its tolerance."""
    from nscc.words.readout import converter_of
    from nscc_runtime.execution.program import analysed
    from nscc_training.tradeoff.emulator_study import EmulatorBenches

    files = output_files(options, "calibration", "budget")
    container, messages = _container(program, options)
    sensor = sensor_of(converter_of(container), options)
    seeds = {name: options[name] for name in ("seed", "device_seed")}
    settings = settings_from(EmulatorStudySettings, options, **seeds)
    scenes = _scenes(container, options, messages)
    _refuse(container)
    benches = EmulatorBenches.of(analysed(container, sensor), scenes, settings)
    digests = [scene.light.sha256() for scene in scenes]
    measured = run_study(benches.study(), files, {**options, "program": program}, *digests)
    return 0 if benches.keep_promises(measured) else 1


def _refuse(container: Container) -> None:
    """Raise Rejected if the study does not support a program: chips without plans (NS0750), and
    pixels that look at their light (NS0828)."""
    from nscc_runtime.run_kinds import KINDS, refuse_planless

    refuse_planless(container, "nscc tradeoff emulator")
    if not KINDS.of(container).open_times_known:
        raise rejected(
            "NS0828",
            "nscc tradeoff emulator uses sums over slots, which are undefined for pixels "
            "that look at the light",
            helps=("`nscc tradeoff FILE.nsl --scene S` supports such programs",),
        )


def _container(path: Path | None, options: NamedValues) -> tuple[Container, tuple[Diagnostic, ...]]:
    """Return the program at `path`, compiled or loaded with the `options` of the command, and
    messages. None compiles a built-in program of 16 slots."""
    if path is not None:
        return load_program(path, options)
    from nscc.compiler import compile_source
    from nscc.containers import with_pixels
    from nscc.source import Source
    from nscc_training.tradeoff.emulator import PROGRAM

    path = Path("default.nsl")
    compiled = compile_source(Source(path.name, PROGRAM), Path(), compile_options(options))
    return with_pixels(compiled.built, path, options["pixels"]), ()


def _scenes(
    container: Container, options: NamedValues, messages: tuple[Diagnostic, ...]
) -> list[NamedLight]:
    """Return the light of each scene that `options` name (none: the built-in ones), with a short
    name that is unique: the file's name without its ending, or all paths in full if two of these
    are equal. Print `messages` of the program, and those of the scenes."""
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


@command.command("sensor")
@declared(SensorStudySettings, *_SHUTTERS, show=True)
@shared.chip_option
@declared(Options, level=1)
@declared(SensorStudySettings, "slot_us", "effects", "data", "count", "seed", show=True)
@shared.tradeoff_options
def sensor(**options: Any) -> int:
    """Measure PSNR against the shortest possible slot of each shutter class, on one chip.

    Compiles every class with every number of slots, for known and for arbitrary codes, in each
    lowering; the number of words determines the shortest slot. The emulated chip captures the
    scenes. Clips are decoded by GAP-TV and stills by merging neighbours; nothing is trained. For
    pixels that look (looks-K of hdr-v1, and looks designed for the scenes) the light is exposure
    divided by open time, and the words and slot length of further looks are measured. Clips are
    also captured with several readouts of one exposure and compared with a burst of the same
    number of ordinary frames. Settings that do not fit the chip are marked in the table. Exits
    with status 1 if nothing fits."""
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.tradeoff.sensor import sensor_study

    files = output_files(options)
    chip = {name: options[name] for name in ("target", "level")}
    study = sensor_study(settings_from(SensorStudySettings, options, **chip))
    say_compiling(denoise, "the loop of total variation")
    measured = run_study(study, files, options)
    return 0 if any(point.case != "readouts" for point in measured.points) else 1


@command.command("decoder")
@click.option(
    "--run",
    "runs",
    multiple=True,
    type=PATH,
    metavar="RUN",
    help="A run folder of nscc train; may be repeated.",
)
@declared(DecoderStudySettings, show=True)
@declared(JointRequest, "trust_code")
@shared.tradeoff_options
def decoder(runs: tuple[Path, ...], trust_code: bool, **options: Any) -> int:
    """Measure PSNR and SSIM against decoding time per scene, in milliseconds.

    Decoders without training are measured at several numbers of iterations: GAP-TV, ADMM-TV and a
    dictionary; for stills merging neighbours and sparse coding. Networks come from run folders, in
    f32 and bf16, FC-net with 4, 2 and 1 blocks a pixel. All decode captures with the same code:
    that of the runs (runs with another code are compared separately), else random bits, and 2 x 2
    stops for stills."""
    from nscc_training.baselines.tv_loop import denoise
    from nscc_training.run_folder import load_run
    from nscc_training.tradeoff.decoder import decoder_study

    files = output_files(options)
    folders = [load_run(path, trust_code=trust_code) for path in dict.fromkeys(runs)]
    study = decoder_study(folders, settings_from(DecoderStudySettings, options))
    say_compiling(denoise, "the loop of total variation")
    run_study(study, files, {**options, "runs": runs})
    return 0


@command.command("synthesis")
@click.argument("files", nargs=-1, metavar="[FILE.nsl]...", type=PATH)
@tradeoff_options
@declared(SynthesisStudySettings, show=True)
def synthesis(files: tuple[Path, ...], **options: Any) -> int:
    """Measure the words per frame against compile time, at each level and lowering.

    Compiles FILEs, or else programs of all classes, from text to proof and without the cache. A
    point is dominated if another point of the same program has no more words and no more time.
    Exits with status 1 if no program fits."""
    from nscc_training.tradeoff.synthesis import builtin_programs, programs_of, synthesis_study

    outputs = output_files(options)
    programs = programs_of(files) or builtin_programs()
    study = synthesis_study(programs, settings_from(SynthesisStudySettings, options))
    known = {"files": files, "count": options["count"]}
    return 0 if run_study(study, outputs, known).points else 1


@command.command("images")
@click.argument("file", metavar="FILE.nsl", type=PATH)
@declared(Options, "level", show=True)
@tradeoff_options
def images(file: Path, level: int, **places: Any) -> int:
    """Compare programs of words for the kernels of a program's images: noise against time.

    Noise is the standard deviation of the error that a kernel's words add, relative to one word.
    Among programs that fit the registers' range, the compiler takes the one with the fewest words.
    Exits with status 1 if no image has a kernel."""
    from nscc_training.tradeoff.synthesis import images_study

    outputs = output_files(places)
    study = images_study(file, level)
    if not study.points:
        click.echo(f"no image of '{file.name}' has a kernel", err=True)
        return 1
    run_study(study, outputs, {"file": file, "level": level})
    return 0
