"""The products of `nscc build --emit`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from nscc.diagnostics.rejection import rejected

if TYPE_CHECKING:
    from nscc.diagnostics.diagnostic import Rejected
    from nscc.lower.lowered import Choice
    from nscc.pipeline import Compiled
    from nscc.prove.proof import Proof
    from nscc.stream.sending import Sending
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
    if compiled.sending is not None:
        return {stem + SUFFIXES[kind]: _of_planes(kind, compiled, compiled.sending)}
    if kind == "planes":
        raise _no_planes(compiled.program.target.name)
    if kind != "cpp":
        return {stem + SUFFIXES[kind]: _text_or_words(kind, compiled)}
    from nscc.emit.cpp import devkit_program

    choice, container, _proof = _complete(compiled)
    devkit = devkit_program(compiled.tree, choice.best, container, stem)
    return {stem + SUFFIXES[kind]: devkit.text.encode(), **devkit.images}


def _of_planes(kind: str, compiled: Compiled, sending: Sending) -> bytes:
    """Return a product of a program for a chip without logic."""
    from nscc.emit.listing import text_after
    from nscc.emit.report import report_bytes
    from nscc.emit.sending_report import planes_bytes, sending_text, stream_report
    from nscc.syntax.printing import print_tree
    from nscc.words.file import to_bytes
    from nscc.words.legality import refuse_planes

    container, proof = compiled.container, compiled.proof
    assert container is not None
    assert proof is not None
    match kind:
        case "ast":
            return print_tree(compiled.tree, compiled.program.source).encode()
        case "ir":
            return text_after("program", compiled.program).encode()
        case "schedule":
            return sending_text(sending).encode()
        case "report":
            return report_bytes(stream_report(sending, proof))
        case "planes":
            return planes_bytes(container)
        case "icw":
            return to_bytes(container)
    refused_option = f"--emit {kind} does not apply to this program"
    refuse_planes(
        container.target,
        refused_option,
        "--emit planes,schedule writes the bit planes and their times",
    )
    raise ValueError(kind)


def _no_planes(chip: str) -> Rejected:
    return rejected(
        "NS0512",
        f"--emit planes does not apply: the pixels of {chip} decode their codes themselves",
        notes=("only a chip whose pixels have no logic receives a bit plane for every slot",),
        helps=(
            "--emit asm lists the words of the program; `nscc targets` shows which chips use "
            "planes",
        ),
        status=1,
    )


def _complete(compiled: Compiled) -> tuple[Choice, Container, Proof]:
    results = compiled.choice, compiled.container, compiled.proof
    if results[0] is None or results[1] is None or results[2] is None:
        raise ValueError("the program has no words to write")
    return results[0], results[1], results[2]


def _text_or_words(kind: str, compiled: Compiled) -> bytes:
    from nscc.emit.listing import gates_text, looking_gates_text, schedule_text, text_after
    from nscc.emit.report import report, report_bytes
    from nscc.looks.passes import LookingLowered
    from nscc.syntax.printing import print_tree
    from nscc.words.file import to_bytes

    choice, container, proof = _complete(compiled)
    lowered = choice.best
    match kind:
        case "ast":
            return print_tree(compiled.tree, compiled.program.source).encode()
        case "ir":
            return text_after("program", compiled.program).encode()
        case "gates" if isinstance(lowered, LookingLowered):
            return looking_gates_text(lowered).encode()
        case "gates":
            return gates_text(lowered.decoding, lowered.program.target).encode()
        case "schedule":
            return schedule_text(lowered).encode()
        case "dot" | "graphml":
            from nscc.emit.looking_network import network_of
            from nscc.emit.network import dot_text, graphml_bytes

            network = network_of(lowered)
            return graphml_bytes(network) if kind == "graphml" else dot_text(network).encode()
        case "asm":
            return text_after("words", container).encode()
        case "report":
            from nscc.emit.picture_report import with_pictures

            return report_bytes(with_pictures(report(choice, proof), container))
        case _:
            return to_bytes(container)
