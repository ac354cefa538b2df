"""What `nscc build --emit` writes of a compiled program: each kind made when it is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from nscc.lower.lowered import Choice
    from nscc.pipeline import Compiled
    from nscc.prove.proof import Proof
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
}
"""The kinds, and how the names of their files end."""


def emitted(kind: str, compiled: Compiled, stem: str) -> dict[str, bytes]:
    """The product of a kind of SUFFIXES by its file's name, STEM and suffix.

    After it come the files that go beside it: the images of a C++ program. ValueError for a program
    of which only a search can tell whether it fits.
    """
    if kind != "cpp":
        return {stem + SUFFIXES[kind]: _text_or_words(kind, compiled)}
    from nscc.emit.cpp import devkit_program

    choice, container, _proof = _complete(compiled)
    made = devkit_program(compiled.tree, choice.best, container, stem)
    return {stem + SUFFIXES[kind]: made.text.encode(), **made.images}


def _complete(compiled: Compiled) -> tuple[Choice, Container, Proof]:
    found = compiled.choice, compiled.container, compiled.proof
    if found[0] is None or found[1] is None or found[2] is None:
        raise ValueError("there are no words to emit")
    return found[0], found[1], found[2]


def _text_or_words(kind: str, compiled: Compiled) -> bytes:
    from nscc.emit.listing import gates_text, schedule_text, text_after
    from nscc.emit.report import report, report_bytes
    from nscc.syntax.printing import print_tree
    from nscc.words.file import to_bytes

    choice, container, proof = _complete(compiled)
    lowered = choice.best
    match kind:
        case "ast":
            return print_tree(compiled.tree, compiled.program.source).encode()
        case "ir":
            return text_after("program", compiled.program).encode()
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
            return report_bytes(report(choice, proof))
        case _:
            return to_bytes(container)
