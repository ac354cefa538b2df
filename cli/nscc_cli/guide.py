"""`nscc explain`, `examples`, `new` and `doctor`: help for beginners and for problems."""

from __future__ import annotations

import shlex
from itertools import chain
from pathlib import Path

import click

from nscc.diagnostics.explain import index, page
from nscc_cli.completion import EXAMPLE, MESSAGE
from nscc_cli.options import OUT
from nscc_cli.support import common_command, say_done


@common_command("explain")
@click.argument("code", required=False, type=MESSAGE)
def explain(code: str | None) -> None:
    """Explain CODE (NS0412, 412, or its name); without one, list all codes."""
    click.echo(index() if code is None else page(code), nl=False)


@common_command("examples")
@click.argument("names", type=EXAMPLE, metavar="[NAME..]", nargs=-1)
@click.option(
    "-o",
    "folder",
    type=OUT,
    metavar="DIR",
    default=Path(),
    help="The folder for the copies (default: this folder).",
)
def examples(names: tuple[str, ...], folder: Path) -> None:
    """List the programs that come with nscc, or copy the named ones."""
    from nscc.examples import about, contents, example, examples
    from nscc.files import write_new

    if names:
        files = dict(contents(example(name)) for name in names)
        write_new({folder / name: data for name, data in files.items()})
        say_done("\n".join(f"wrote {(folder / name).as_posix()}" for name in files))
        return
    known = examples()
    width = max(map(len, known))
    for name, path in known.items():
        click.echo(f"{name:<{width}}  {about(path)}")
    say_done("\n`nscc examples NAME` copies one, `nscc check` and `nscc run` take it from there")


@common_command("new")
@click.argument("name", type=OUT, metavar="NAME")
def new(name: Path) -> None:
    """Write NAME.nsl, a program that runs and has a comment on every statement."""
    from nscc.examples import START
    from nscc.files import write_new

    if name.name in ("", "..", ".nsl"):
        raise click.BadParameter(f"invalid file name '{name}'", param_hint="NAME")
    path = name if name.suffix == ".nsl" else name.with_name(name.name + ".nsl")
    write_new({path: START.encode()})
    command_text = shlex.join(["nscc", "check", path.as_posix()])
    say_done(f"wrote {path.as_posix()}: `{command_text}` describes it")


@common_command("doctor")
def doctor() -> int:
    """Report versions, extras, the cache, compiled loops and serial ports.

    Exits with status 3 if something that nscc needs is missing or broken."""
    from nscc import installation
    from nscc_runtime import installation as runtime

    status = 0
    for state, text in chain(installation.findings(), runtime.findings()):
        click.echo(f"{state:8}{text}")
        status = 3 if state == installation.WRONG else status
    return status
