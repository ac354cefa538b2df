"""`nscc train`: train shutters and a decoder, and write a run folder."""

from __future__ import annotations

from pathlib import Path

import click

from nscc_cli.options import OUT, PATH
from nscc_cli.support import OutPath, common_command, progress, say_done


def _print_schema(context: click.Context, _option: click.Parameter, value: bool) -> None:
    """Print a configuration of defaults, in which comments explain each key, and end the command.
    Without the option (`value` False), do nothing."""
    if value and not context.resilient_parsing:
        from nscc_training.settings import RunSettings, config_toml

        click.echo(config_toml(RunSettings(), remarks=True), nl=False)
        context.exit()


@common_command("train")
@click.argument("config", metavar="CONFIG.toml|FOLDER", type=PATH)
@click.option("--out", required=True, metavar="RUN", type=OUT, help="The run folder.")
@click.option(
    "--set", "changes", multiple=True, metavar="K=V", help="Change a setting: train.steps=100."
)
@click.option(
    "--resume",
    type=OutPath(str),
    default="auto",
    show_default=True,
    metavar="auto|never|PATH",  # checkpoints replace each other
    help="Resume from RUN's checkpoint, start again, or resume from another checkpoint.",
)
@click.option(
    "--schema",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_schema,
    help="Print a complete configuration with every default, and exit.",
)
def command(config: Path, out: Path, changes: tuple[str, ...], resume: str) -> None:
    """Train shutters together with a decoder, within the limits of the chip.

    A FOLDER of pictures or clips is learned from with settings for its kind: linear pictures are
    stills, films and photographs become clips. --set changes them; RUN/config.resolved.toml
    contains all of them. Every fifth file is kept for validation.

    The configuration is checked, and its shutters are compiled, before the first step. The same
    command resumes an interrupted run."""
    from nscc_training.settings import load_config

    if config.is_dir():
        from nscc_training.own_folder import folder_settings

        settings = folder_settings(config, changes, say_done)
    else:
        settings = load_config(config, changes)
    from nscc_training.loop.train import train

    train(settings, out, resume=resume, track=progress, report=say_done)
