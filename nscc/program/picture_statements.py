"""Checked statements of version 3: convolution kernels, images, planes, readouts and reports."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Label, Rejected
from nscc.program.arrays_file import ArraysFile
from nscc.program.constants import constant, constants_scope
from nscc.program.expressions import Meaning
from nscc.program.field_planes import PlaneMaker
from nscc.program.host_values import HostValues, signed_level
from nscc.program.looking import checked_state
from nscc.program.names import Declarations
from nscc.program.picture_expressions import Reader, is_power_of_two, refuse_divisor
from nscc.program.problems import Problems, clipped, counted
from nscc.source import Span
from nscc.syntax import tree
from nscc.words import machine
from nscc.words.counts import count_unit
from nscc.words.pictures import (
    NO_PICTURES,
    Bit,
    Chosen,
    ChosenPlane,
    Condition,
    Inverse,
    Joined,
    KeptImage,
    KeptPlane,
    Picture,
    Pictures,
    PlaneReport,
    RangeState,
    Source,
    Weights,
)

MOST_SIDE = 9
"""Most rows and columns of a convolution kernel."""
MOST_WEIGHT = 1 << 16
"""Largest weight of a convolution kernel, either sign."""
MOST_EVENTS = 4000
"""Most coordinates that the chip's library scans in one call."""
_REPORTS = ("any", "events", "box", "count", "sum")
"""The kinds of reports; the last two are of version 4."""


class PictureMaker:
    """Checks the images, planes, readouts and reports of a file, or reports what is wrong.

    `base` is the folder of the files that the program names."""

    def __init__(
        self,
        declared: Declarations,
        constants: Mapping[str, Meaning],
        target: Target,
        base: Path,
        problems: Problems,
    ) -> None:
        """Prepare to check the statements of images and planes.

        `declared` are the statements of the file; `constants` are the meanings of N, rows, cols and
        `let` names; `target` is the chip, whose limits apply. Relative paths of files start at the
        folder `base`. Errors are added to `problems`. An unnamed bucket is called "frame"."""
        self.declared, self.target, self.base, self.problems = declared, target, base, problems
        self.constants = constants_scope(declared, constants)
        self.buckets = [
            rule.name.text if isinstance(rule, tree.Bucket) else "frame" for rule in declared.rules
        ]
        # Only these have a name in the program; the unnamed bucket is `exposure`.
        self.named = [bucket for bucket in self.buckets if bucket != "frame"]

    def make(self) -> Pictures:
        """Return the images, planes, readouts and reports; an unusable result after reporting
        errors, so the caller must ask `problems` first.

        Reports errors in convolution kernels (NS0530), expressions (NS0531 to NS0535), readouts and
        reports (NS0536), assumptions (NS0537) and values of the host (NS0545), and features that
        are not supported yet (NS0539)."""
        if not self._possible():
            return NO_PICTURES
        kernels = [self._kernel(kernel) for kernel in self.declared.kernels.values()]
        known = {kernel.name: kernel for kernel in kernels if kernel is not None}
        planes = PlaneMaker(
            self.declared,
            fields={},
            constants=self.constants,
            target=self.target,
            base=self.base,
            problems=self.problems,
        )
        host = HostValues(self.declared, self.constants, self.target, planes, self.problems)
        reader = Reader(host, known, self.buckets, self._outside())
        known_states = {
            name: checked_state(name, state, self.constants, self.problems, self.declared)
            for name, state in self.declared.states.items()
        }
        for name, state in known_states.items():
            if state is None:
                reader.failed.add(name)
            elif not state.boolean:
                reader.ranges[name] = RangeState(name, state.low, state.high)
        for picture in self.declared.pictures:
            reader.now = name = picture.name.text
            if name in self.declared.repeats:
                # All statements of a `repeat` are read together, at the first of their names.
                reader.repeat(self.declared.repeats[name], name)
                continue
            if isinstance(picture, tree.Plane) and reader.declare_places(name, picture.condition):
                continue
            node = (
                reader.condition(picture.condition)
                if isinstance(picture, tree.Plane)
                else (reader.image(picture.value))
            )
            reader.declare(name, node)
            if node is not None:
                reader.items.append(Picture(name, node))
        states = self._states(reader, known_states)
        kept_images = self._kept_images(reader)
        reads = self._reads(reader)
        read_reports = [self._report(statement, reader) for statement in self.declared.reports]
        reports = tuple(report for report in read_reports if report is not None)
        reports += tuple(reader.floods)
        limits = self._limits()
        # Everything that is computed must reach the host, as an image or in a report.
        if not (reads or reports) and not self.problems.has_errors():
            self.problems.error(
                "NS0536",
                "this program reads out and reports nothing",
                self._place(),
                "computed, but not used",
                helps=(
                    "read it out with the frame: `read NAME`",
                    "or report only whether any bit is 1: `report any PLANE`",
                ),
            )
        pictures = Pictures(
            weights=tuple(known.values()),
            items=tuple(reader.items),
            outside=reader.outside,
            limits_e=limits,
            reads=reads,
            reports=reports,
            states=states,
            inputs=tuple(host.inputs.values()),
            kept_images=kept_images,
            params=tuple(host.params.values()),
            version=max(3, self.declared.version),
            ranges=tuple(reader.ranges.values()),
        )
        return self._with_unit(pictures)

    def _reads(self, reader: Reader) -> tuple[str, ...]:
        """Return the names that are read out, each bit of a state with a range for itself."""
        names = []
        kinds = {**dict.fromkeys(self.named, "bucket"), **reader.kinds}
        for read in self.declared.reads.values():
            if read.text in reader.ranges:
                names += reader.ranges[read.text].bits
            elif read.text in kinds:
                names.append(read.text)
            elif read.text not in (*self.declared.refused, *reader.failed):
                self.problems.unknown("an image, a plane or a bucket", read.text, read.span, kinds)
        return tuple(names)

    def _with_unit(self, pictures: Pictures) -> Pictures:
        """Choose how many steps of IN (the level sent to all pixels) represent one count, and
        return `pictures` with that number.

        Without counts or after an error, return `pictures` as it is. Reports the error NS0540 if
        the largest count does not fit a register."""
        unit = count_unit(pictures, self.target)
        if unit is None or self.problems.has_errors():
            return pictures
        if unit.steps == 0:  # the largest count does not fit, even with the fewest steps
            items = (*self.declared.pictures, *self.declared.nexts.values())
            span = next(item for item in items if item.name.text == unit.name).span
            most = unit.steps_available // unit.least
            self.problems.error(
                "NS0540",
                f"`{unit.name}` counts up to {unit.peak}, and registers hold {most}",
                span,
                "too many weights at once",
                notes=(
                    f"a count takes {counted(unit.least, 'step')} of IN or more, and registers "
                    f"of {self.target.name} hold {unit.steps_available}",
                ),
                helps=("use smaller kernels, or fewer of them in one sum",),
                data={"resource": "counts", "required": float(unit.peak), "available": most},
            )
        return replace(pictures, count_steps=unit.steps)

    def _place(self) -> Span:
        """Return the place of the first image or plane or, without one, of the first report,
        kernel, `assume`, `next`, parameter, input plane or kept image, for errors about the
        program as a whole."""
        declared = self.declared
        kernels, nexts = declared.kernels.values(), declared.nexts.values()
        host = (declared.params, declared.inputs, declared.kept_images)
        host_spans = [each.span for names in host for each in names.values()]
        shown = [*declared.pictures, *declared.reports, *kernels, *declared.assumes, *nexts]
        return [*(each.span for each in shown), *host_spans][0]

    def _possible(self) -> bool:
        """Return whether the chip and the other statements allow images; report why not (NS0538,
        NS0539)."""
        target = self.target
        lacks = None
        if not target.has_logic:
            lacks = "have no processor"
        elif not target.sees_neighbours or "NEWS" not in target.analog_registers:
            lacks = "cannot read values of their neighbours"
        elif target.analog_scratch != "NEWS":
            lacks = f"use NEWS for exposures, because `analog_scratch` is {target.analog_scratch}"
        if lacks is not None:
            self.problems.error(
                "NS0538",
                f"the pixels of {target.name} {lacks}",
                self._place(),
                "needs pixels that compute after the exposure",
                helps=("compile for a chip with such pixels: `target scamp5`",),
            )
            return False
        if self.declared.senses or (self.declared.states and not self.declared.keeps_planes):
            statement = next(iter([*self.declared.senses.values(), *self.declared.states.values()]))
            self.problems.error(
                "NS0539",
                "images and planes are not supported together with senses and states yet",
                statement.span,
                "declared here",
                related=(Label(self._place(), "the images"),),
                helps=(
                    "use fixed shutters, or compute images and planes on the host",
                    "a state that steps on planes needs no sense: `next h = PLANE`",
                ),
            )
            return False
        return True

    def _outside(self) -> int | None:
        """Return the bit (0 or 1) that planes have outside the array (statement `outside`).

        Return None if it is not declared. Other numbers are reported (NS0534), and their lowest bit
        is returned."""
        outside = self.declared.outside
        if outside is None:
            return None
        if outside.bit.value not in (0, 1):
            self.problems.error(
                "NS0534",
                "`outside` must be 0 or 1",
                outside.bit.span,
                f"this is {outside.bit.value}",
                helps=("write `outside 0` or `outside 1`",),
            )
        return outside.bit.value & 1

    # --- kernels

    def _kernel(self, kernel: tree.Kernel | tree.KernelFromFile) -> Weights | None:
        """Return the weights of a declared convolution kernel; None after reporting an error. Among
        these are NS0530 for the shape or the weights, and NS0532 for the divisor."""
        name = kernel.name.text
        if isinstance(kernel, tree.KernelFromFile):
            return self._from_file(kernel)
        rows = []
        for row in kernel.rows:
            values = [constant(v, self.constants, self.problems, "a weight") for v in row.values]
            if None in values:
                return None
            rows.append(tuple(cast(list[int], values)))
        divisor = 1
        if kernel.divisor is not None:
            number = constant(kernel.divisor, self.constants, self.problems, "a divisor")
            if number is None:
                return None
            if not is_power_of_two(number):
                refuse_divisor(self.problems, number, kernel.divisor.span)
                return None
            divisor = number
        return self._weights(name, rows, divisor, kernel.span)

    def _from_file(self, kernel: tree.KernelFromFile) -> Weights | None:
        """Return the weights of a convolution kernel from an .npz file; None after reporting an
        error. The array has the name that the statement gives, or else the kernel's. It is divided
        by 1."""
        try:
            file = ArraysFile(self.base / kernel.path.value, kernel.path.value)
            if kernel.sha256 is not None:
                file.require_sha256(kernel.sha256.value)
            key = (kernel.key or kernel.name).text
            array = file.integers(key, most=MOST_SIDE**2)
        except Rejected as wrong:
            self.problems.adopt(wrong, kernel.path.span)
            return None
        if array.ndim != 2:
            self._bad_kernel(kernel.name.text, f"its array has {array.ndim} axes", kernel.path.span)
            return None
        return self._weights(kernel.name.text, array.tolist(), divisor=1, span=kernel.path.span)

    def _weights(self, name: str, rows: Sequence[Any], divisor: int, span: Span) -> Weights | None:
        """Return the convolution kernel `name` of these rows of integers, the top row first,
        divided by `divisor`, a power of two; None after reporting that it is invalid (NS0530)."""
        fault, helps = _kernel_fault(rows)
        if not fault:
            return Weights(name, tuple(map(tuple, rows)), divisor)
        self._bad_kernel(name, fault, span, helps)
        return None

    def _bad_kernel(self, name: str, fault: str, span: Span, helps: tuple[str, ...] = ()) -> None:
        """Report at `span` that the convolution kernel `name` is not valid (NS0530), because of
        `fault`."""
        self.problems.error(
            "NS0530",
            f"`{clipped(name)}` is not a valid convolution kernel: {fault}",
            span,
            "this kernel",
            helps=helps,
            notes=(
                f"the numbers of rows and columns must be odd and at most {MOST_SIDE}; the "
                "centre is the pixel itself",
            ),
        )

    # --- kept states: they step once a frame, after all images and planes

    def _states(
        self, reader: Reader, known_states: Mapping[str, machine.State | None]
    ) -> tuple[KeptPlane, ...]:
        """Return the states of a program with images or planes, with their next values.

        `reader` reads the next values. Invalid ones are left out and reported: a state that is not
        kept (NS0543), a `next` of an unknown state (NS0214). `known_states` are the checked states
        by name, None for an invalid one."""
        declared = self.declared
        known = {**declared.states, **declared.kept_images}
        for name, step in declared.nexts.items():
            if name not in known and name not in declared.refused:
                self.problems.unknown("a state", name, step.name.span, known)
        states = []
        for name, statement in declared.states.items():
            if not statement.kept:
                self.problems.error(
                    "NS0543",
                    f"`{name}` is not kept, but the program has images or planes",
                    statement.span,
                    "this state",
                    notes=(
                        "images and planes are computed after the last slot, so the new value of "
                        "the state is used in the next frame",
                    ),
                    helps=("write `kept` at its end",),
                )
            elif (state := known_states[name]) is not None:
                of_range = reader.ranges.get(name)
                bits = of_range.bits if of_range else [name]
                start = state.start - state.low if of_range else state.start
                nexts = self._nexts(name, bits, reader)
                states += [
                    KeptPlane(bit, start >> k & 1, node)
                    for k, (bit, node) in enumerate(zip(bits, nexts, strict=bool(nexts)))
                ]
        return tuple(states)

    def _nexts(self, name: str, bits: list[str], reader: Reader) -> list[Condition]:
        """Return the values of the planes `bits` of the state `name` after a frame; [] after
        reporting an error.

        The state keeps its value without a `next` statement, and where the statement's condition is
        0. `reader` reads the expressions."""
        step, state = self.declared.nexts.get(name), reader.ranges.get(name)
        if step is None:
            return [*map(Bit, bits)]
        value, when = step.value, step.condition
        if state is None:
            nodes = [node for node in [reader.condition(value)] if node is not None]
        else:
            if when is not None and reader.reads_range(when):
                # Where the condition is 0, the value may be outside the range.
                value, when = tree.IfElse(value.span, value, when, step.name), None
            nodes = reader.conditions(value, state)
        if when is None or not nodes:
            return nodes
        changes = reader.condition(when)
        if changes is None:
            return []
        pairs = [(node, Bit(bit)) for node, bit in zip(nodes, bits, strict=True)]
        if self.declared.version > 3:  # words of older programs stay as they are
            return [ChosenPlane(changes, node, bit) for node, bit in pairs]
        unchanged = Inverse(changes)
        return [
            Joined("or", Joined("and", changes, node), Joined("and", unchanged, bit))
            for node, bit in pairs
        ]

    def _kept_images(self, reader: Reader) -> tuple[KeptImage, ...]:
        """Return the states that are images, with their start in electrons and their next value.

        `reader` reads the next values. Invalid ones are left out and reported: not kept, or a start
        that a register cannot hold (NS0543)."""
        images = []
        for name, state in self.declared.kept_images.items():
            sign, level = signed_level(state.start) if state.start is not None else (1, None)
            start_e = 0.0
            if isinstance(level, tree.Amount):
                start_e = sign * self.target.level_e(float(level.value), level.unit)
            # A level needs a unit, except 0.
            is_zero = isinstance(level, tree.Int) and level.value == 0  # needs no unit
            invalid = level is not None and not isinstance(level, tree.Amount) and not is_zero
            target = self.target
            if (
                not state.kept
                or invalid
                or not (target.register_min_e <= start_e <= target.register_max_e)
            ):
                self.problems.error(
                    "NS0543",
                    f"`{name}` is not a valid kept image",
                    state.span,
                    "this state",
                    notes=(
                        "a kept image starts with a level that a register can hold, and keeps "
                        "its value from frame to frame",
                    ),
                    helps=(f"write `state {name} : image kept = 4%`",),
                )
                continue
            step = self.declared.nexts.get(name)
            value = Source(name) if step is None else reader.image(step.value)
            if step is not None and step.condition is not None and value is not None:
                when = reader.condition(step.condition)
                value = None if when is None else Chosen(when, value, Source(name))
            if value is not None:
                images.append(KeptImage(name, start_e, value))
        return tuple(images)

    # --- what leaves the chip

    def _report(self, report: tree.Report, reader: Reader) -> PlaneReport | None:
        """Return the checked `report` statement; None after reporting an error.

        `reader` knows the names of images and planes. Among the errors are invalid reports (NS0536)
        and unknown names (NS0214). Only reports of events have a largest number; in others it is 0.
        """
        kind, plane = report.kind.text, report.plane.text
        if kind == "sum" and plane == "exposure" and len(self.buckets) == 1:
            plane = self.buckets[0]
        # The last two kinds are of version 4.
        if kind not in (_REPORTS if self.declared.version > 3 else _REPORTS[:3]):
            self._bad_report(report.kind.span, f"unknown kind of report `{clipped(kind)}`")
            return None
        needed = "image" if kind == "sum" else "plane"
        is_exposure = kind == "sum" and plane in self.buckets
        if reader.kinds.get(plane) != needed and not is_exposure:
            known = [name for name, kind in reader.kinds.items() if kind == needed]
            if needed == "image":
                known += ["exposure"] if len(self.buckets) == 1 else self.buckets
                self.problems.unknown("an image", plane, report.plane.span, known)
            elif reader.kinds.get(plane) == "image":
                text = f"`{plane}` is an image, but `report {kind}` needs a plane"
                self._bad_report(report.plane.span, text)
            elif plane not in reader.failed:
                self.problems.unknown("a plane", plane, report.plane.span, known)
            return None
        most = 0
        if report.count is not None:
            count = constant(report.count, self.constants, self.problems, "the number of events")
            if count is None:
                return None
            most = count
        listed = report.most is not None and report.most.text == "most"
        if (kind == "events") != listed or (listed and not 1 <= most <= MOST_EVENTS):
            message = f"only `report events` has `at most K`, with K from 1 to {MOST_EVENTS}"
            self._bad_report(report.span, message)
            return None
        # The first report of this kind and name must be this statement.
        same_kind = (other for other in self.declared.reports if other.kind.text == kind)
        if report is not next(
            other for other in same_kind if other.plane.text == report.plane.text
        ):
            self.problems.error(
                "NS0536",
                f"`report {kind} {plane}` is given twice",
                report.span,
                "the second",
                helps=("keep one of them",),
            )
            return None
        return PlaneReport(cast(Any, kind), plane, most)

    def _bad_report(self, span: Span, message: str) -> None:
        """Report an invalid `report` statement (NS0536)."""
        helps = (
            "write `report any P`, `report events P at most 1000` or `report box P`",
            "from `nsl 4` on, also `report count P` or `report sum IMAGE`",
        )
        self.problems.error("NS0536", message, span, "this report", helps=helps)

    def _limits(self) -> dict[str, float]:
        """Return the largest exposure of each bucket in electrons, by name.

        It is what PIX (the photodiode) and a register hold, or less if an `assume` statement says
        so. Invalid assumptions and second ones for the same bucket are reported and ignored."""
        target = self.target
        full_e = min(target.full_well_e, target.register_max_e)
        limits = dict.fromkeys(self.buckets, full_e)
        assumed: dict[str | None, tree.Assume] = {}
        for assumption in self.declared.assumes:
            names = [assumption.bucket.text] if assumption.bucket is not None else self.buckets
            if assumption.bucket is not None and assumption.bucket.text not in limits:
                self.problems.unknown(
                    "a bucket", assumption.bucket.text, assumption.bucket.span, self.named
                )
                continue
            # The key None stands for an assumption about all buckets.
            first = assumed.setdefault(names[0] if assumption.bucket else None, assumption)
            if first is not assumption:
                self.problems.error(
                    "NS0537",
                    "`assume` is given twice for the same exposure",
                    assumption.span,
                    "the second",
                    related=(Label(first.span, "the first"),),
                    helps=("keep one of them",),
                )
                continue
            most_e = target.level_e(float(assumption.level.value), assumption.level.unit)
            if assumption.comparison != "<=" or not 0 < most_e <= full_e:
                self.problems.error(
                    "NS0537",
                    "invalid assumption: use `<=`, and a level up to a full well",
                    assumption.span,
                    f"`{assumption.comparison}`, {most_e:g} e",
                    helps=(f"write `assume exposure <= 50%`; a full well is {full_e:g} e",),
                )
                continue
            limits.update(dict.fromkeys(names, most_e))
        return limits


def _kernel_fault(rows: Sequence[Any]) -> tuple[str, tuple[str, ...]]:
    """Return what is wrong with a convolution kernel, as the end of a sentence, and the texts of
    helps; "" and () if it is valid. Of several faults, the first is returned: lengths of rows,
    sides, only zeros, too large weights.

    `rows` are lists of integer weights, the top row first. A kernel has a centre, so both sides are
    odd."""
    widths = {len(row) for row in rows}
    add_zeros = ("add zeros: `[[0, 1, 1], ..]` instead of two columns `[[1, 1], ..]`",)
    if len(widths) > 1:
        return "its rows have different lengths", add_zeros
    height, width = len(rows), max(widths, default=0)
    if height % 2 == 0 or width % 2 == 0 or max(height, width) > MOST_SIDE:
        shape = f"it has {counted(height, 'row')} and {counted(width, 'column')}"
        smaller = "apply two smaller kernels one after the other: `k(j(exposure))`"
        # Zeros make an even side odd, which must not make it too large.
        return shape, add_zeros if max(height, width) < MOST_SIDE else (smaller,)
    flat = [weight for row in rows for weight in row]
    if not any(flat):
        return "all its weights are 0", ()
    if max(map(abs, flat)) > MOST_WEIGHT:
        return f"a weight is larger than {MOST_WEIGHT}", ()
    return "", ()
