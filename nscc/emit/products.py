"""The products of `nscc build --emit`."""

from __future__ import annotations

from nscc.diagnostics.diagnostic import rejected
from nscc.pipeline import KINDS, Compiled, ProgramKind

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
    """Return the product of a kind in SUFFIXES as {file name: content}; file names begin with
    `stem`.

    A C++ program has its images as further files. Raises Rejected if the program's chip does not
    have such products (NS0510 for words and gates, NS0512 for planes), or if C++ cannot be written.
    Raises ValueError if it is unknown whether the program fits."""
    if compiled.container is None:
        raise ValueError("the program has no words to write")
    from nscc.emit.listing import print_tree, program_text
    from nscc.emit.report import report_bytes
    from nscc.words.file import to_bytes

    program_kind = KINDS.of(compiled.program)
    match kind:
        case "icw":
            data = to_bytes(compiled.container)
        case "report":
            data = report_bytes(program_kind.report(compiled))
        case "ast":
            data = print_tree(compiled.tree, compiled.program.source).encode()
        case "ir":
            data = program_text(compiled.program).encode()
        case _:
            return program_kind.product(kind, compiled, stem)
    return {stem + SUFFIXES[kind]: data}


def word_product(
    product: str, compiled: Compiled, stem: str, kind: ProgramKind
) -> dict[str, bytes]:
    """Return a product of a program with words as {file name: content}; file names begin with
    `stem`.

    `product` is a key of SUFFIXES that `emitted` leaves to the kind of the program, which is
    `kind`. Raises Rejected as `emitted` does, and for C++ as `devkit_program` does."""
    from nscc.emit.listing import schedule_text

    lowered, container = compiled.lowered, compiled.built
    assert lowered is not None
    match product:
        case "planes":
            raise rejected(
                "NS0512",
                f"--emit planes does not apply: the pixels of {container.target.name} decode their "
                "codes themselves",
                notes=(
                    "only a chip whose pixels have no logic receives a bit plane for every slot",
                ),
                helps=(
                    "--emit asm lists the words of the program; `nscc targets` shows which chips "
                    "use planes",
                ),
                status=1,
            )
        case "cpp":
            from nscc.emit.cpp.program import devkit_program

            devkit = devkit_program(compiled.tree, lowered, container, stem)
            return {stem + SUFFIXES[product]: devkit.text.encode(), **devkit.images}
        case "asm":
            data = kind.words_text(container).encode()
        case "schedule":
            data = schedule_text(lowered).encode()
        case "gates":
            data = kind.gates_text(lowered).encode()
        case _:
            from nscc.emit.network import dot_text, graphml_bytes

            network = kind.network(lowered)
            data = graphml_bytes(network) if product == "graphml" else dot_text(network).encode()
    return {stem + SUFFIXES[product]: data}
