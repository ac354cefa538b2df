"""`nscc check`: parse, check, fit; writes nothing."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from nscc.diagnostics.diagnostic import Diagnostic, Rejected
from nscc.lower.ledger import ledger
from nscc.lower.resources import time_text
from nscc.program.problems import counted
from nscc_cli.programs import BuildChoice, build_options, compile_program
from nscc_cli.support import CommonCommand, say

if TYPE_CHECKING:
    from nscc.pipeline import Compiled


@click.command("check", cls=CommonCommand)
@click.argument(
    "files", nargs=-1, required=True, metavar="FILE...", type=click.Path(path_type=Path)
)
@build_options
def command(
    files: tuple[Path, ...],
    level: int | None,
    codes: str | None,
    lowering: str | None,
    target: str | None,
    cache: bool,
    max_words_per_slot: int | None,
) -> None:
    """Check programs: what they are, whether they fit the chip, and that their words are right.

    Lowers at -O1, unless -O says otherwise, and proves that. Where only a search can tell whether
    a program fits, a note says that `nscc build` decides.
    """
    choice = BuildChoice(
        1 if level is None else level, codes, lowering, target, cache, max_words_per_slot
    )
    wrong: list[Diagnostic] = []
    status = 0
    for path in files:
        try:
            compiled = compile_program(path, choice, unproved_is_error=False)
            say(compiled.diagnostics)
        except Rejected as rejected:
            wrong.extend(rejected.diagnostics)
            status = max(status, rejected.status)
        else:
            click.echo(summary(path.as_posix(), compiled))
    if wrong:
        raise Rejected(wrong, status)


def summary(name: str, compiled: Compiled) -> str:
    """What `nscc check` prints of a program that passes."""
    program, lowered, proof = compiled.program, compiled.lowered, compiled.proof
    table = program.table
    lines = [f"class      {program.class_name}: {program.class_reason}"]
    lines.append(
        f"codes      {len(table.codes)} {'in use' if program.mode == 'fixed' else 'legal'}, "
        f"{counted(len(table.shutters), 'shutter')}, {counted(len(program.frame.slot_us), 'slot')}"
    )
    if lowered is None or proof is None:
        return "\n  ".join([f"{name}: passes, unless its words do not fit", *lines])
    schedule = lowered.schedule
    digital = ledger(schedule.allocation.holders)
    shortest = min(program.frame.slot_us)
    lines += [
        f"lowering   {lowered.plan.lowering}; encoding: {lowered.solution.encoding}",
        f"digital    {digital or 'no register needed'}",
        f"analog     {ledger(lowered.plan.registers)}",
        f"words      {schedule.words_stored} stored of {program.target.store_words}, "
        f"{schedule.words_total} a frame",
        f"time       shortest slot {time_text(shortest)}, longest instructions "
        f"{time_text(lowered.shortest_slot_us)}",
        f"proved     {counted(proof.codes, 'code')} x {counted(proof.slots, 'slot')}, "
        f"{counted(proof.frames, 'frame')}",
    ]
    return "\n  ".join([f"{name}: fits {program.target.name}", *lines])
