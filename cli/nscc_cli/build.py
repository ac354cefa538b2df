"""`nscc build`: compile a program to a container of instruction code words."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.files import write_together
from nscc_cli.programs import BuildChoice, build_options, compile_program
from nscc_cli.support import CommonCommand, done, say

if TYPE_CHECKING:
    from nscc.pipeline import Compiled

SUFFIXES = {
    "ast": ".ast",
    "ir": ".ir",
    "gates": ".gates",
    "schedule": ".schedule",
    "asm": ".asm",
    "icw": ".icw",
    "cpp": ".cpp",
    "report": ".report.json",
    "dot": ".dot",
}


@click.command("build", cls=CommonCommand)
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "-o", "out", type=click.Path(path_type=Path), metavar="OUT.icw",
    help="The container to write (default: beside FILE).",
)  # fmt: skip
@click.option(
    "--emit", "kinds", default="", metavar="KINDS",
    help=f"Also write any of {', '.join(SUFFIXES)}, separated by commas; KIND=- prints it.",
)  # fmt: skip
@click.option(
    "--print-after", "after", metavar="PASS", help="Show what a pass of the compiler made."
)
@build_options
def command(
    file: Path,
    out: Path | None,
    kinds: str,
    after: str | None,
    level: int | None,
    codes: str | None,
    lowering: str | None,
    target: str | None,
    cache: bool,
    max_words_per_slot: int | None,
) -> None:
    """Compile FILE, prove the words, and write them."""
    wanted = _kinds(kinds)
    compiled = compile_program(
        file,
        BuildChoice(level, codes, lowering, target, cache, max_words_per_slot),
        price_all="report" in wanted,  # only the report lists the other lowerings
        see=_printer(after),
    )
    say(compiled.diagnostics)
    container = out if out is not None else file.with_suffix(".icw")
    products: dict[Path, bytes] = {}
    printed: list[str] = []
    if out is not None or not wanted:
        wanted.setdefault("icw", False)
    for kind, to_terminal in wanted.items():
        if kind == "cpp":
            data, images = _devkit(compiled, container)
            if to_terminal and images:
                names = ", ".join(path.name for path in images)
                click.echo(f"not written: {names}, without `=-` they are", err=True)
            elif not to_terminal:
                products.update(images)
        else:
            data = _product(kind, compiled)
        if to_terminal:
            printed.append(kind)
            _print(data)
        else:
            path = container if kind == "icw" else container.with_suffix(SUFFIXES[kind])
            products[path] = data
    write_together(products)
    if products:
        click.echo("wrote " + ", ".join(path.as_posix() for path in products), err=True)
        done(_cost(compiled))


def _cost(compiled: Compiled) -> str:
    """What the words cost, in two lines."""
    from nscc.lower.resources import time_text
    from nscc.program.problems import counted

    lowered = compiled.lowered
    assert lowered is not None
    target, schedule = lowered.program.target, lowered.schedule
    launches = lowered.shortest_slot_launches
    launched = counted(launches, "kernel launch", "kernel launches")
    return (
        f"  words  {schedule.words_total} a frame, at most {max(lowered.words_per_boundary)} in a "
        f"slot, {schedule.words_stored} stored of {target.store_words}\n"
        f"  time   shortest legal slot {time_text(lowered.shortest_slot_us)}, "
        f"with {launched} of {time_text(target.launch_us)}"
    )


def _kinds(text: str) -> dict[str, bool]:
    """KIND -> whether it goes to standard output."""
    wanted: dict[str, bool] = {}
    for item in filter(None, (part.strip() for part in text.split(","))):
        kind, _, place = item.partition("=")
        if kind not in SUFFIXES or place not in ("", "-"):
            raise Rejected(
                Diagnostic(
                    "NS0505",
                    f"--emit cannot write '{item}'",
                    notes=("kinds: " + ", ".join(SUFFIXES) + "; KIND=- prints to standard output",),
                ),
                status=2,
            )
        wanted[kind] = place == "-"
    return wanted


def _printer(after: str | None) -> Callable[[str, Any], None] | None:
    """An observer that prints what pass `after` made."""
    if after is None:
        return None
    from nscc.pipeline import PASSES

    names = [each.name for each in PASSES]
    if after not in names:
        raise Rejected(
            Diagnostic(
                "NS0506",
                f"the compiler has no pass '{after}'",
                notes=("passes, in their order: " + ", ".join(names),),
            ),
            status=2,
        )

    def see(name: str, value: Any) -> None:
        if name == after:
            from nscc.emit.listing import text_after

            _print(text_after(name, value).encode())

    return see


def _product(kind: str, compiled: Compiled) -> bytes:
    choice, container, proof = compiled.choice, compiled.container, compiled.proof
    assert choice is not None
    assert container is not None
    assert proof is not None
    from nscc.emit import listing

    lowered = choice.best

    match kind:
        case "ast":
            from nscc.syntax.printing import print_tree

            return print_tree(compiled.tree, compiled.program.source).encode()
        case "ir":
            from nscc.program.printing import print_program

            return print_program(compiled.program).encode()
        case "gates":
            return listing.gates_text(lowered.decoding, lowered.program.target).encode()
        case "schedule":
            return listing.schedule_text(lowered).encode()
        case "dot":
            return listing.dot_text(lowered).encode()
        case "asm":
            from nscc.words.disassembly import disassemble

            return disassemble(container).encode()
        case "report":
            from nscc.emit.report import report, report_bytes

            return report_bytes(report(choice, proof))
        case _:
            from nscc.words.file import to_bytes

            return to_bytes(container)


def _devkit(compiled: Compiled, container: Path) -> tuple[bytes, dict[Path, bytes]]:
    """The C++ program, and the images that go beside it."""
    from nscc.emit.cpp import devkit_program

    assert compiled.lowered is not None
    assert compiled.container is not None
    stem = container.with_suffix("").name
    made = devkit_program(compiled.tree, compiled.lowered, compiled.container, stem)
    images = {container.with_name(name): data for name, data in made.images.items()}
    return made.text.encode(), images


def _print(data: bytes) -> None:
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()
