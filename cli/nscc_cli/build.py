"""`nscc build`: compile a program to a container of instruction words."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import Any

import click

from nscc.containers import SUFFIX
from nscc.diagnostics.diagnostic import rejected
from nscc.emit.products import SUFFIXES, emitted
from nscc.files import refuse_inputs, write_together
from nscc.pipeline import KINDS, PASSES, Observer, Pass
from nscc.words.legality import refuse_planes
from nscc_cli.completion import PASS, PRODUCTS
from nscc_cli.options import PATH, build_options, out_option
from nscc_cli.programs import compile_program
from nscc_cli.support import common_command, say, say_done


@common_command("build")
@click.argument("file", type=PATH)
@out_option("The container (default: FILE with .icw; with --emit, none).", "OUT.icw")
@click.option(
    "--emit",
    "kinds",
    type=PRODUCTS,
    default="",
    metavar="KINDS",
    help=f"Write these files next to OUT or FILE, separated by commas: "
    f"{', '.join(SUFFIXES)}. KIND=- prints one. The container is written only "
    "with icw or -o.",
)
@click.option(
    "--print-after", "after", type=PASS, metavar="PASS", help="Print the result of a compiler pass."
)
@build_options
def command(file: Path, out: Path | None, kinds: str, after: str | None, **options: Any) -> None:
    """Compile FILE, prove the words, and write the container or the products that --emit names."""
    places_by_kind = _kinds(kinds)
    compiled = compile_program(
        file,
        options,
        price_all="report" in places_by_kind,  # only the report lists the other lowerings
        see=_printer(after),
    )
    # A chip that is sent bit planes has no gates to print.
    if after == "gates":
        refused_option = "--print-after gates does not apply to this program"
        refuse_planes(compiled.program.target, refused_option, "its other passes can be printed")
    if out is not None:
        _check_container_name(out)
    say(compiled.diagnostics)
    container = out if out is not None else file.with_suffix(".icw")
    products: dict[Path, bytes] = {}
    # Without `--emit`, or with `-o` beside it, the container is written too.
    if out is not None or not places_by_kind:
        places_by_kind.setdefault("icw", False)
    for kind, to_terminal in places_by_kind.items():
        # A product may have further files beside it, such as the pictures that C++ code loads.
        (name, data), *beside = emitted(kind, compiled, container.stem).items()
        if not to_terminal:
            products.update(
                (container.with_name(beside_name), image) for beside_name, image in beside
            )
            products[container if kind == "icw" else container.with_name(name)] = data
            continue
        if beside:
            names = ", ".join(beside_name for beside_name, _ in beside)
            click.echo(f"not written: {names}; without `=-` they are written, too", err=True)
        _print(data)
    write_together(products)
    if products:
        click.echo("wrote " + ", ".join(path.as_posix() for path in products), err=True)
        say_done(KINDS.of(compiled.program).cost_text(compiled))


def _check_container_name(out: Path) -> None:
    """Raise Rejected if the container `out` would replace an input (NS0785), or if its ending names
    another kind of file (NS0786). Names that end in .icw or have no ending are accepted."""
    if out.suffix.lower() in (SUFFIX, ""):
        return
    refuse_inputs(out)
    ending = out.suffix.lower()
    kind = next((kind for kind, suffix in SUFFIXES.items() if suffix.endswith(ending)), None)
    named = shlex.quote(out.with_suffix(SUFFIX).as_posix())
    helps: tuple[str, ...] = (f"name it {named}",)
    if kind is not None:
        helps = (f"`--emit {kind} -o {named}` writes this product beside it", *helps)
    raise rejected(
        "NS0786",
        f"a container cannot be written as '{out.name}': the ending '{out.suffix[:20]}' is not "
        "supported here",
        notes=(f"it ends in {SUFFIX}",),
        helps=helps,
    )


def _kinds(text: str) -> dict[str, bool]:
    """Return the products that the value of `--emit` names, such as `asm,report=-`, in its order,
    with True for those that are printed (`KIND=-`) instead of written.

    Raises Rejected (NS0505) for an unknown kind."""
    places_by_kind: dict[str, bool] = {}
    for item in filter(None, (item_text.strip() for item_text in text.split(","))):
        kind, _, place = item.partition("=")
        if kind not in SUFFIXES or place not in ("", "-"):
            raise rejected(
                "NS0505",
                f"unknown kind '{item}' for --emit",
                notes=("kinds: " + ", ".join(SUFFIXES) + "; KIND=- prints to standard output",),
            )
        places_by_kind[kind] = place == "-"
    return places_by_kind


def _printer(after: str | None) -> Observer | None:
    """Return a function of a pass and its value that the compiler calls after each pass, and that
    prints the result of the pass named `after`; None prints nothing.

    Raises Rejected (NS0506) if there is no such pass."""
    if after is None:
        return None
    if after not in PASSES:
        raise rejected(
            "NS0506",
            f"unknown compiler pass '{after}'",
            notes=("passes in their order: " + ", ".join(PASSES),),
        )

    def see(compiler_pass: Pass, value: Any) -> None:
        """Print the result `value` of a pass, if the user chose to see this pass."""
        if compiler_pass.name == after:
            _print(compiler_pass.text(value).encode())

    return see


def _print(data: bytes) -> None:
    """Write bytes to standard output at once, without conversion."""
    sys.stdout.buffer.write(data)
    sys.stdout.buffer.flush()
