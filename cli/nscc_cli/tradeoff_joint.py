"""`nscc tradeoff PROGRAM`: find the setting of each stage that reaches a given error."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from nscc.pipeline import LEVELS
from nscc.tradeoff.points import STAGES, csv_text
from nscc.tradeoff.stopwatch import processor_name
from nscc_cli import options as shared
from nscc_cli.completion import SCENE
from nscc_cli.frames import refuse_swapped, run_capture_of, scene_of
from nscc_cli.options import PATH, SEED, some_option
from nscc_cli.programs import compile_options
from nscc_cli.support import CommonCommand, progress, say
from nscc_cli.tradeoff_files import kept_rows, output_files, write_files

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
@click.option("--seed", type=SEED, default=0, help="Seed of the frames' noise.")
@click.option("--device-seed", type=SEED, default=0, help="Seed of fixed patterns.")
@shared.pixels_option
@shared.scene_options
@shared.sensor_options
@shared.build_options
@shared.trust_code_option
@shared.tradeoff_options
def command(program: Path, **options: Any) -> int:
    """Find the fastest settings for a given error, for one program on one scene.

    For each stage (compile level, lowering, number and length of slots, effects and tolerance,
    decoder), prints the fastest setting within --target-error, with its time and error. If no
    setting reaches this error, prints the fastest of the most accurate ones. Errors are
    percentages of the mean signal and times are seconds, so that one diagram shows all stages. A
    RUN, or hdr and clip, defines program, exposure, sensor and decoder. With -o, --csv or --png,
    finished measurements are kept, and the same command continues after an interruption. Exits
    with status 1 if nothing could be measured."""
    from nscc_training.tradeoff.bench import JointRequest
    from nscc_training.tradeoff.joint import joint_text, measure

    files = output_files(options)
    refuse_swapped(program, options["scene"])
    run = _run_of(program)
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
            request,
            rows,
            lambda diagnostic: say([diagnostic]),
            lambda stages: progress(stages, "measuring"),
        )
        click.echo(joint_text(joint))
        device = processor_name()

        def png() -> bytes:
            from nscc_runtime.pictures.sheet import png_of
            from nscc_training.tradeoff.diagrams import joint_diagram

            return png_of(joint_diagram, joint, request.repeats, device)

        makers = {"csv": lambda: csv_text(joint.points, device).encode(), "png": png}
        write_files(files, makers, rows)
    return 0 if joint.points else 1


def _run_of(program: Path) -> Path | None:
    """Return the run that PROGRAM names, or None if it is a program file."""
    if program.suffix.lower() in (".nsl", ".icw"):
        return None
    return program
