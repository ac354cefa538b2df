"""Checks that the words of a container are valid on its target; all users of words go through them.

A container file may contain any five integers as a word. `decoded` converts words to operations and
refuses a word without operation (NS0701), half-words without their partner (NS0703) and words that
the container's target does not support (NS0708)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType

from nscc.chips.target import Target
from nscc.diagnostics.diagnostic import Diagnostic, Rejected, rejected
from nscc.operations import NEIGHBOURS, STEERING, Op, Phase, Word, WordEffect
from nscc.words.container import Container, kept_starts
from nscc.words.encoding import matching, no_operation

_MOST_SHOWN = 10
"""Most illegal words reported for a container."""
_SAME_STEP = 1e-9
"""The difference in steps of IN up to which levels are the same."""
_MOST_VALUE = 1 << 31
"""Parameters are sent as signed integers of 32 bits."""


def refuse_planes(target: Target, refusal: str, help_text: str) -> None:
    """Raise Rejected (NS0510, status 1) for a chip without logic, which runs no words; else do
    nothing.

    `refusal` is the first half of the message, `help_text` says what to do instead."""
    if not target.has_logic:
        raise rejected(
            "NS0510",
            f"{refusal}: the pixels of {target.name} have no logic and run no words",
            notes=("such a chip receives one bit per pixel and slot",),
            helps=(help_text,),
            status=1,
        )


def refuse_pictures(container: Container, refusal: str, note: str, help_text: str) -> None:
    """Raise Rejected (NS0542, status 1) for a program with images or planes; else do nothing.

    `refusal` is the message, `note` the reason, `help_text` what to do instead."""
    if container.pictures.outputs:
        raise rejected("NS0542", refusal, notes=(note,), helps=(help_text,), status=1)


def loader_fault(container: Container) -> str | None:
    """Return, as a clause, what a program needs that neither a device's loader nor a devkit program
    can do; the first such thing.

    These are starts of kept images that are not whole steps of IN or beyond its range, and
    parameters beyond 32 bits. Return None if there is nothing. IN is the level sent to all pixels.
    """
    pictures, target = container.pictures, container.target
    for image in pictures.kept_images:
        steps = image.start_e / target.electrons_per_step
        if abs(steps - round(steps)) > _SAME_STEP:
            return (
                f"`{image.name}` starts with {image.start_e:g} e, which is not a whole number of "
                f"steps of IN; the nearest is {round(steps) * target.electrons_per_step!r} e"
            )
    if any(not target.in_low <= level <= target.in_high for level in kept_starts(container)):
        return "an image that it keeps starts with a level that IN does not have"
    if any(not -_MOST_VALUE < end < _MOST_VALUE for each in pictures.params for end in each.ends):
        return f"a parameter has values of {_MOST_VALUE} or more"
    return None


def decoded(container: Container) -> tuple[tuple[Op, ...], ...]:
    """Return the operations of every kernel (list of words), in order, as words of the exposure.

    Raises Rejected with the errors of the first ten invalid words: NS0701 (no operation), NS0703
    (half of a pair) and NS0708 (not on this chip, or not during the exposure)."""
    kernels = ((kernel.name, kernel.words) for kernel in container.kernels)
    return _decoded(kernels, container.target, target_fault)


def picture_kernels(container: Container) -> tuple[tuple[Op, ...], ...]:
    """Return the operations of every kernel (list of words) of images and planes, in order; ()
    without images and planes.

    These words may reach neighbours. Raises Rejected (NS0701, NS0703, NS0708) with the errors of
    the first ten invalid words."""
    kernels = container.pictures.kernels
    named = ((f"{number} of the images", words) for number, words in enumerate(kernels))
    return _decoded(named, container.target, picture_fault)


def picture_words(
    container: Container, params: Mapping[str, int] = MappingProxyType({})
) -> list[tuple[Op, int | None]]:
    """Return the words of images and planes as a frame executes them, as pairs (word, value of IN
    in steps).

    The value of IN (the level sent to all pixels) is None if it is not set. `params` has values of
    parameters by name, by default their starts. Raises Rejected (NS0701, NS0703, NS0708) with the
    errors of the first ten invalid words."""
    kernels = picture_kernels(container)
    launches = container.pictures.executed(params)
    return [(op, launch.level) for launch in launches for op in kernels[launch.kernel]]


def _decoded(
    kernels: Iterable[tuple[str, Sequence[Word]]],
    target: Target,
    fault_of: Callable[[Op, Target], str | None],
) -> tuple[tuple[Op, ...], ...]:
    """Return the operations of named kernels: pairs (name, list of words).

    `fault_of` tells why the target does not support an operation, None if it does. Raises Rejected
    with the errors of the first `_MOST_SHOWN` invalid words."""
    diagnostics: list[Diagnostic] = []
    operations: list[tuple[Op, ...]] = []
    faults: dict[Op, str | None] = {}
    for name, words in kernels:
        ops: list[Op] = []
        for index, word in enumerate(words):
            place = f"word {index} of kernel '{name}'"
            operation = matching(word, target.words)
            if operation is None:
                diagnostics.append(no_operation(word, place))
            else:
                if operation not in faults:
                    faults[operation] = fault_of(operation, target)
                fault = faults[operation]
                if fault is not None:
                    diagnostics.append(
                        Diagnostic(
                            "NS0708",
                            f"{place}: {target.name} cannot run `{operation}`: {fault}",
                            helps=(f"`nscc targets {target.name}` lists what the chip has",),
                            data={"target": target.name},
                        )
                    )
                ops.append(operation)
            if len(diagnostics) >= _MOST_SHOWN:
                raise Rejected(diagnostics)
        # Pairs can be checked only if every word has an operation.
        if len(ops) == len(words):
            diagnostics.extend(split_pairs(name, ops))
        operations.append(tuple(ops))
    if diagnostics:
        raise Rejected(diagnostics[:_MOST_SHOWN])
    return tuple(operations)


def target_fault(operation: Op, target: Target) -> str | None:
    """Return why `target` does not support this word during the exposure, as a clause; None if it
    does.

    Words that reach neighbours only run after the exposure. `picture_fault` checks everything else.
    """
    if _reaches_by_bits(operation) or NEIGHBOURS.keys() & {
        *operation.destinations,
        *operation.sources,
    }:
        return "only the words of images and planes reach neighbours, after the last slot"
    return picture_fault(operation, target)


def picture_fault(operation: Op, target: Target) -> str | None:
    """Return why `target` does not support this word after the exposure, as a clause; None if it
    does.

    The reasons are unknown registers, neighbours that the chip does not reach, too many sources,
    and a WHERE that reads FLAG (the bit that lets a pixel act)."""
    known = (
        *target.analog_registers,
        *target.digital_registers,
        "PIX",
        "IN",
        "FLAG",
        "SELECT",
        *(NEIGHBOURS if "NEWS" in target.analog_registers else ()),
    )
    for register in operation.destinations + operation.sources:
        if register not in known:
            return f"{target.name} has no register {register}"
    count, row = len(operation.sources), operation.operation
    if (fault := _neighbour_fault(operation, target)) is not None:
        return fault
    # Chips may limit the sources of WHERE and of OR and NOR differently.
    if row.effect is WordEffect.FLAG_DIGITAL:
        kind, limit = "a WHERE", target.where_sources
    else:
        kind, limit = (
            "an OR or NOR",
            target.or_sources if row.effect is WordEffect.DIGITAL else None,
        )
    if limit is not None and count > limit:
        most = f"{kind} word of {target.name} reads at most {limit} sources"
        return f"{most}, but this word reads {count}"
    reads_flag = row.effect is WordEffect.FLAG_DIGITAL and "FLAG" in operation.sources
    if reads_flag and not target.where_reads_flag:
        return f"WHERE writes FLAG, and on {target.name} it cannot also read it"
    return None


def _reaches_by_bits(operation: Op) -> bool:
    """Return whether a word reads bits of neighbours (DNEWS), or propagates bits to them (PROP)."""
    seen = operation.operation.effect is WordEffect.DIGITAL_NEIGHBOURS
    return seen or operation.name.startswith("PROP")


def _neighbour_fault(operation: Op, target: Target) -> str | None:
    """Return why `target` does not support a word that reaches neighbours, as a clause.

    Return None if it does, and for any other word. The reasons are missing registers or
    connections, too many sources, and a division."""
    row = operation.operation
    digital = _reaches_by_bits(operation)
    written = NEIGHBOURS.keys() & operation.destinations
    if not (digital or written or NEIGHBOURS.keys() & operation.sources):
        return None
    if not target.sees_neighbours:
        return f"the pixels of {target.name} do not see their neighbours"
    if operation.name.startswith("PROP"):
        registers = {*operation.destinations, *operation.sources}
        if not target.propagation_pixels:
            return f"{target.name} does not propagate bits: `propagation_pixels` is 0"
        if not registers <= {target.masked_register} or target.mask_register is None:
            return f"{target.name} propagates the bits of its masked register only"
    if digital:
        missing = [name for name in STEERING if name not in target.digital_registers]
        return f"{target.name} has no register {missing[0]}" if missing else None
    most = target.directed_sources
    if len(operation.sources) > most:
        return f"a word of {target.name} that reaches a neighbour reads at most {most} sources"
    if row.divisor > 1 and not target.directed_halving:
        return f"a word of {target.name} that reads a neighbour does not divide"
    return None


def pair_kind(first: Op, second: Op) -> str | None:
    """Return the instruction that two words form: OR, NOR, REFRESH or PROP; None if they form none.

    The first word reads, the second writes."""
    kind, _, half = first.name.partition(".")
    return kind if half == "read" and second.name == f"{kind}.write" else None


def split_pairs(kernel_name: str, ops: Sequence[Op]) -> list[Diagnostic]:
    """Return an error (NS0703) for each word that is half of a pair without the other half beside
    it; [] if there is none.

    `ops` are the operations of the kernel (list of words) that messages call `kernel_name`."""
    diagnostics = []
    for index, operation in enumerate(ops):
        before, phase = ops[index - 1] if index else None, operation.operation.phase
        following = ops[index + 1] if index + 1 < len(ops) else None
        position = ""
        if phase is Phase.READ and not (following and pair_kind(operation, following)):
            position = f"is followed by `{following}`" if following else "ends the kernel"
        elif phase is Phase.WRITE and not (before and pair_kind(before, operation)):
            position = f"comes after `{before}`" if before else "begins the kernel"
        if position:
            kind = operation.name.partition(".")[0]
            diagnostics.append(
                Diagnostic(
                    "NS0703",
                    f"word {index} of kernel '{kernel_name}' is one half of a pair, and the other "
                    f"half is missing: `{operation}` {position}",
                    notes=(
                        "the first word of a pair leaves its result on the pixel's bus, and any "
                        "word between the halves loses it",
                    ),
                    helps=(f"keep `{kind}.read` and `{kind}.write` together in one kernel",),
                    data={"kernel": kernel_name, "word": index},
                )
            )
    return diagnostics
