"""The products of `nscc build --emit`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from nscc.diagnostics.rejection import rejected

if TYPE_CHECKING:
    from nscc.pipeline import Compiled
    from nscc.words.container import Container

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
    "graphml": ".graphml",
    "planes": ".planes.npz",
}
"""The file name ending of each kind of product."""


def emitted(kind: str, compiled: Compiled, stem: str) -> dict[str, bytes]:
    """Return the product of a kind in SUFFIXES, by its file name (STEM and suffix).

    Further files follow it: the images of a C++ program. Raises Rejected if the program's chip does
    not have such products (NS0510 for words and gates, NS0512 for planes). Raises ValueError if it
    is unknown whether the program fits."""
    name, target = stem + SUFFIXES[kind], compiled.program.target
    if kind == "planes" and not target.streamed:
        raise rejected(
            "NS0512",
            f"--emit planes does not apply: the pixels of {target.name} decode their codes "
            "themselves",
            notes=("only a chip whose pixels have no logic receives a bit plane for every slot",),
            helps=(
                "--emit asm lists the words of the program; `nscc targets` shows which chips use "
                "planes",
            ),
            status=1,
        )
    if compiled.container is None:
        raise ValueError("the program has no words to write")
    if kind != "cpp" or target.streamed:
        return {name: _data(kind, compiled, compiled.container)}
    from nscc.emit.cpp.program import devkit_program

    lowered = compiled.lowered
    assert lowered is not None
    devkit = devkit_program(compiled.tree, lowered, compiled.container, stem)
    return {name: devkit.text.encode(), **devkit.images}


def _data(kind: str, compiled: Compiled, container: Container) -> bytes:
    from nscc.emit.listing import (
        gates_text,
        looking_gates_text,
        print_tree,
        schedule_text,
        text_after,
    )
    from nscc.emit.report import report_bytes
    from nscc.emit.sending_report import planes_bytes, sending_text
    from nscc.looks.passes import LookingLowered
    from nscc.words.file import to_bytes
    from nscc.words.legality import refuse_planes

    if kind == "icw":
        return to_bytes(container)
    if kind == "report":
        return report_bytes(report_of(compiled))
    if kind == "planes":
        return planes_bytes(container)
    if kind == "ast":
        return print_tree(compiled.tree, compiled.program.source).encode()
    if kind == "ir":
        return text_after("program", compiled.program).encode()
    if kind == "schedule" and compiled.sending is not None:
        return sending_text(compiled.sending).encode()
    refuse_planes(
        container.target,
        f"--emit {kind} does not apply to this program",
        "--emit planes,schedule writes the bit planes and their times",
    )
    lowered = compiled.lowered
    assert lowered is not None
    if kind == "asm":
        return text_after("words", container).encode()
    if kind == "schedule":
        return schedule_text(lowered).encode()
    if kind == "gates":
        if isinstance(lowered, LookingLowered):
            return looking_gates_text(lowered).encode()
        return gates_text(lowered.decoding, lowered.program).encode()
    from nscc.emit.network import dot_text, graphml_bytes, network_of

    network = network_of(lowered)
    return graphml_bytes(network) if kind == "graphml" else dot_text(network).encode()


def report_of(compiled: Compiled) -> dict[str, Any]:
    """Return the contents of `--emit report`."""
    from nscc.emit.picture_report import with_pictures
    from nscc.emit.report import report
    from nscc.emit.sending_report import stream_report

    choice, container, proof = compiled.choice, compiled.container, compiled.proof
    assert container is not None
    assert proof is not None
    if compiled.sending is not None:
        return stream_report(compiled.sending, proof)
    assert choice is not None
    return with_pictures(report(choice, proof), container)
