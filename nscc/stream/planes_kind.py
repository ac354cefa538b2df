"""The kind of programs for chips without logic, which receive a bit plane for every slot."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar

from nscc.arrays import Bools
from nscc.diagnostics.diagnostic import rejected
from nscc.emit.products import SUFFIXES
from nscc.emit.summary import share_text
from nscc.mappings import JsonObject
from nscc.operations import Op
from nscc.pipeline import Compiled, Found, Job, Pass, ProgramKind
from nscc.program.problems import counted
from nscc.prove.proof import Proof
from nscc.stream import sending_report as texts
from nscc.stream.checks import check_loadings, check_route
from nscc.stream.passes import check_times, container_of, plan_of, with_planes
from nscc.stream.planes_proof import prove_planes
from nscc.words.container import Container
from nscc.words.legality import refuse_planes


class BitPlanes(ProgramKind):
    """What the compiler does for a chip without logic: bit planes instead of words."""

    passes: ClassVar[tuple[Pass, ...]] = (
        Pass("plan", plan_of, check_route, texts.sending_text),
        Pass("schedule", check_times, check_loadings, texts.sending_text),
    )
    subject = "planes"
    one_lowering_for = "a chip without logic"

    def assemble(self, layout: Any, job: Job) -> tuple[Container, Found]:
        """Return the container (a compiled program) of a layout of bit planes; it causes no
        diagnostics."""
        return container_of(layout), ()

    def prove(self, container: Container, kernels: Sequence[Sequence[Op]]) -> Proof:
        """Prove that the bit planes open the shutters of the program. `kernels` are not used: there
        are no words."""
        return prove_planes(container)

    def replayed(self, container: Container, name: str) -> Bools:
        """Return the shutters that the bit planes open, bool (shutters, buckets, slots).

        Raises Rejected (NS0442) if they differ from the decode table. `name` is the file's name,
        for the message."""
        failure = prove_planes(container).failure
        if failure is not None:
            raise rejected(
                "NS0442",
                f"the planes of {name} do not match its decode table: {failure.reason}",
                helps=("build the program again",),
                status=1,
            )
        return container.table.shutters

    def with_planes(self, container: Container) -> Container:
        """Return a container (a compiled program) with the bit planes of its pixel codes; see
        `nscc.stream.passes.with_planes`."""
        return with_planes(container)

    def product(self, product: str, compiled: Compiled, stem: str) -> dict[str, bytes]:
        """Return the output files of `--emit product` as {file name: content}; `stem` is the name
        without its ending.

        The products are "planes" (bit planes with their times, .npz) and "schedule" (a text).
        Raises Rejected for products of words, which a chip without logic does not have, and for
        planes (NS0511) if the pixels have no codes."""
        container, name = compiled.built, stem + SUFFIXES[product]
        if product == "planes":
            return {name: texts.planes_bytes(container)}
        if product == "schedule":
            return {name: texts.sending_text(compiled.layout).encode()}
        refuse_planes(
            container.target,
            f"--emit {product} does not apply to this program",
            "--emit planes,schedule writes the bit planes and their times",
        )
        raise ValueError(f"unknown product {product}")

    def words_text(self, container: Container) -> str:
        """Return the bit planes as text."""
        return texts.planes_text(container)

    def report(self, compiled: Compiled) -> JsonObject:
        """Return the build report (`--emit report`) as JSON values."""
        assert compiled.proof is not None
        return texts.stream_report(compiled.layout, compiled.proof)

    def rows(self, compiled: Compiled) -> list[tuple[str, str]]:
        """Return the rows (label, text) of the summary that `nscc check` prints; [] without a
        proof."""
        return texts.stream_rows(compiled.layout, compiled.proof) if compiled.proof else []

    def cost_text(self, compiled: Compiled) -> str:
        """Return the cost of a layout as text."""
        return texts.cost_text(compiled.layout)

    def size_text(self, container: Container) -> str:
        """Return the number of bit planes as text."""
        return counted(container.slots, "plane")

    def readout_us(self, container: Container) -> float:
        """Return the duration of a readout of all taps, in microseconds."""
        return container.target.readout_us  # all taps at once

    def frame_text(self, compiled: Compiled) -> str:
        """Return the start of a sentence on the planes of a frame, which the caller completes."""
        target = compiled.program.target
        planes = counted(len(compiled.program.frame.slot_us), "plane")
        return f"{planes} of {target.rows} x {target.cols} bits a frame. Loading them"

    def slot_text(self, compiled: Compiled, slot: int) -> str:
        """Return a sentence on the plane of a slot and its load time; `slot` is the number of the
        slot, from 0."""
        program = compiled.program
        took = share_text(program.target.plane_load_us, program.frame.slot_us[slot])
        return f"one bit plane, loaded in {took}."
