"""`nscc tradeoff`: measure error against time on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from nscc.lower.exposure_plan import LOWERINGS, Lowering
from nscc.pipeline import LEVELS
from nscc_cli import options as shared
from nscc_cli.completion import SCENE
from nscc_cli.frames import refuse_swapped, run_capture_of, scene_of
from nscc_cli.options import COUNT, PATH, some_option, tradeoff_options
from nscc_cli.programs import compile_options
from nscc_cli.runtime_options import measured_options
from nscc_cli.support import CommonCommand, NumberRange, Subcommands, say, say_compiling
from nscc_cli.tradeoff_emulator import command as emulator
from nscc_cli.tradeoff_files import output_files, run_study
from nscc_cli.tradeoff_sensor import command as sensor
from nscc_training.tradeoff import STAGES

_LEVELS = [str(level) for level in LEVELS]


@click.command("of", cls=CommonCommand)
@click.argument("program", metavar="FILE.nsl|FILE.icw|RUN", type=PATH)
@shared.section(shared.SCENE, click.option("--scene", type=SCENE, help="As in nscc run."))
@click.option("--target-error", metavar="1%|5e|0.1lsb|1noise", default="1%", show_default=True,
              help="The largest error that you accept: in percent of the scene's mean signal, in "
              "electrons, in converter codes, or relative to the frame's own noise.")  # fmt: skip
@some_option("--stages", STAGES, "NAME,..", "Stages to measure.")
@some_option("--levels", _LEVELS, "0,1,..", "Levels of -O to compare.", default="0,1,2")
@shared.repeats_option(3)
@measured_options
@shared.trust_code_option
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
    from nscc_training.tradeoff.joint_bench import JointRequest

    files = output_files(options)
    refuse_swapped(program, options["scene"])
    run = None if program.suffix.lower() in (".nsl", ".icw") else program
    captured = run_capture_of(run, options) if options["scene"] else None
    scene = scene_of(options)
    named = ("pixels", "sensor", "seed", "device_seed", "repeats", "trust_code")
    request = JointRequest(
        program if captured is None else captured.program, scene, options["target_error"],
        options["stages"], compile_options(options), tuple(map(int, options["levels"])),
        changes=options["sensor_set"], run=run, **{name: options[name] for name in named},
    )  # fmt: skip
    study = joint_study(request, lambda message: say([message]))
    known = {**options, "program": request.program, "run": run}
    return 0 if run_study(study, files, known).points else 1


@click.command("decoder", cls=CommonCommand)
@click.option("--run", "runs", multiple=True, type=PATH, metavar="RUN",
              help="A run folder of nscc train; may be repeated.")  # fmt: skip
@shared.made_scenes_option
@click.option("--scenes", type=COUNT, default=2, show_default=True,
              help="Number of scenes of each kind.")  # fmt: skip
@click.option("--size", type=click.IntRange(32, 512), default=128, show_default=True,
              help="Rows and columns of a scene.")  # fmt: skip
@shared.repeats_option(3)
@click.option("--budget", type=NumberRange(0, 1e6), default=40.0, show_default=True,
              metavar="S", help="Seconds after which no repeat starts; everything is measured at "
              "least once.")  # fmt: skip
@shared.made_seed_option
@shared.trust_code_option
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
    from nscc_training.tradeoff.decoder import DecoderStudySettings, decoder_study

    files = output_files(options)
    scenes = DecoderStudySettings(*(options[n] for n in ("data", "scenes", "size", "seed")))
    folders = [load_run(path, trust_code=trust_code) for path in dict.fromkeys(runs)]
    study = decoder_study(folders, scenes, options["repeats"], options["budget"])
    say_compiling(denoise, "the loop of total variation")
    run_study(study, files, {**options, "runs": runs})
    return 0


class _Tradeoffs(Subcommands):
    """The subcommands of `nscc tradeoff`; other names are programs or runs."""

    unknown = "{group} '{name}': there is no such command, file or run"

    def or_else(self) -> Sequence[str]:
        from nscc_training.run_files import shipped_runs

        return (
            f"or name a program (FILE.nsl, FILE.icw) or a run: RUN, {', '.join(shipped_runs())}",
        )

    def accepts(self, name: str) -> bool:
        """Return whether the name is that of a program or a run."""
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


for subcommand in (joint, emulator, sensor, decoder):
    command.add_command(subcommand)


@command.command("synthesis", cls=CommonCommand)
@click.argument("files", nargs=-1, metavar="[FILE.nsl]...", type=PATH)
@tradeoff_options
@some_option("--levels", _LEVELS, "0,1,..", "Levels of -O.")
@some_option("--lowerings", LOWERINGS, "NAME,..", "Lowerings.")
@click.option("--repeats", type=COUNT, default=3, show_default=True,
              help="How often each setting is compiled; the median is used.")  # fmt: skip
@click.option("--count", type=click.Choice(["all", "logic"]), default="all", show_default=True,
              help="All words of a frame, or only those that decode codes.")  # fmt: skip
def synthesis(
    files: tuple[Path, ...], levels: tuple[str, ...], lowerings: tuple[Lowering, ...], repeats: int,
    count: Any, **places: Any,
) -> int:  # fmt: skip
    """Measure the words per frame against compile time, at each level and lowering.

    Compiles FILEs, or else programs of all classes, from text to proof and without the cache. A
    point is dominated if another point of the same program has no more words and no more time.
    Exits with status 1 if no program fits."""
    from nscc_training.tradeoff.synthesis import builtin_programs, programs_of, synthesis_study

    outputs = output_files(places)
    programs = programs_of(files) or builtin_programs()
    study = synthesis_study(programs, lowerings, map(int, levels), count, repeats)
    return 0 if run_study(study, outputs, {"files": files, "count": count}).points else 1


@command.command("images", cls=CommonCommand)
@click.argument("file", metavar="FILE.nsl", type=PATH)
@click.option("-O", "level", type=click.Choice(_LEVELS), default="2", show_default=True,
              help="Level of optimisation of the search.")  # fmt: skip
@tradeoff_options
def images(file: Path, level: str, **places: Any) -> int:
    """Compare programs of words for the kernels of a program's images: noise against time.

    Noise is the standard deviation of the error that a kernel's words add, relative to one word.
    Among programs that fit the registers' range, the compiler takes the one with the fewest words.
    Exits with status 1 if no image has a kernel."""
    from nscc_training.tradeoff.images import images_study

    outputs = output_files(places)
    study = images_study(file, int(level))
    if not study.points:
        click.echo(f"no image of '{file.name}' has a kernel", err=True)
        return 1
    run_study(study, outputs, {"file": file, "level": level})
    return 0
