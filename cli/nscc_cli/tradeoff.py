"""`nscc tradeoff`: measure error against time on this machine."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from nscc.lower.exposure_plan import LOWERINGS, Lowering
from nscc.pipeline import LEVELS
from nscc.tradeoff.points import STAGES, table_text
from nscc.tradeoff.stopwatch import processor_name
from nscc.tradeoff.synthesis import (
    Count,
    builtin_cases,
    cases_of,
    every_way,
    measure,
    refusals_text,
)
from nscc_cli import options as shared
from nscc_cli.completion import SCENE
from nscc_cli.frames import refuse_swapped, run_capture_of, scene_of
from nscc_cli.options import COUNT, PATH, some_option, tradeoff_options
from nscc_cli.programs import compile_options
from nscc_cli.runtime_options import measured_options
from nscc_cli.support import CommonCommand, NumberRange, Subcommands, progress, say, say_compiling
from nscc_cli.tradeoff_emulator import command as emulator
from nscc_cli.tradeoff_files import kept_rows, output_files, write_files
from nscc_cli.tradeoff_sensor import command as sensor

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
    from nscc_training.tradeoff.bench import JointRequest
    from nscc_training.tradeoff.diagrams import joint_diagram
    from nscc_training.tradeoff.joint import joint_text, measure

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
    with kept_rows(files, {**options, "program": request.program, "run": run}) as rows:
        joint = measure(
            request, rows, lambda diagnostic: say([diagnostic]),
            lambda stages: progress(stages, "measuring"),
        )  # fmt: skip
        click.echo(joint_text(joint))
        device = processor_name()
        diagram = (joint_diagram, joint, request.repeats, device)
        write_files(files, rows, (joint.points, device), png=diagram)
    return 0 if joint.points else 1


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
    from nscc_training.tradeoff.decoder import DecoderStudySettings, cases, measure, not_measured
    from nscc_training.tradeoff.diagrams import TITLES, decoder_diagram

    files = output_files(options)
    named = ("data", "scenes", "size", "repeats", "budget", "seed")
    settings = DecoderStudySettings(*(options[name] for name in named))
    folders = [load_run(path, trust_code=trust_code) for path in dict.fromkeys(runs)]
    todo = cases(folders, settings)
    say_compiling(denoise, "the loop of total variation")
    with kept_rows(files, {**options, "runs": runs}) as rows:
        points, repeats = measure(todo, settings, lambda turns: progress(turns, "decoding"), rows)
        tables = (
            table_text([p for p in points if p.error_unit == unit], ("decoder", "setting", title))
            for unit, title in TITLES.items()
        )
        click.echo("\n\n".join(tables))
        for line in not_measured(folders):
            click.echo(line)
        device = processor_name()
        write_files(files, rows, (points, device), png=(decoder_diagram, points, repeats, device))
    return 0


_WORDS: dict[Count, str] = {"all": "words a frame", "logic": "logic words a frame"}


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
    count: Count, **places: Any,
) -> int:  # fmt: skip
    """Measure the words per frame against compile time, at each level and lowering.

    Compiles FILEs, or else programs of all classes, from text to proof and without the cache. A
    point is dominated if another point of the same program has no more words and no more time.
    Exits with status 1 if no program fits."""
    from nscc_runtime.pictures.precision import synthesis_diagram

    outputs = output_files(places)
    cases = cases_of(files) or builtin_cases()
    ways = list(every_way(cases, lowerings, [int(level) for level in levels]))
    with kept_rows(outputs, {"files": files, "count": count}) as rows:
        measured = measure(ways, repeats, count, lambda turns: progress(turns, "compiling"), rows)
        points, device = measured.points, processor_name()
        click.echo(table_text(points, ("lowering", "level", _WORDS[count])))
        for line in refusals_text(measured.refused):
            click.echo(line)
        if not points:
            rows.remove()
            return 1
        diagram = (synthesis_diagram, points, _WORDS[count], repeats, device)
        write_files(outputs, rows, (points, device), png=diagram)
    return 0


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
    from nscc.tradeoff.images import image_points
    from nscc_runtime.pictures.precision import images_diagram

    outputs = output_files(places)
    points = image_points(file, int(level))
    if not points:
        click.echo(f"no image of '{file.name}' has a kernel", err=True)
        return 1
    click.echo(table_text(points, ("kernel", "program", "noise"), ("us", 1000.0)))
    with kept_rows(outputs, {}) as rows:
        write_files(outputs, rows, (points, "the chip's table"), png=(images_diagram, points))
    return 0
