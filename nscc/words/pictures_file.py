"""Storage of images and planes in a container file: header and checks."""

from __future__ import annotations

import json
from base64 import b64decode
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from nscc.words.assembly_text import base64_lines
from nscc.words.pictures import (
    Condition,
    KeptPlane,
    Picture,
    PictureCost,
    Pictures,
    PlaneReport,
    TailLaunch,
    Weights,
    from_plain,
    subexpressions,
    to_plain,
)

if TYPE_CHECKING:
    from nscc.words.container import Container


def header_of(pictures: Pictures) -> dict[str, Any]:
    """Return the header of images and planes as JSON values."""
    counting = {
        "states": [[s.name, int(s.start), to_plain(s.next)] for s in pictures.states],
        "count_steps": pictures.count_steps,
    }  # keys of older files stay the same
    return {name: value for name, value in counting.items() if value} | {
        "kernels": [[k.name, [list(row) for row in k.rows], k.divisor] for k in pictures.weights],
        "items": [[item.name, to_plain(item.node)] for item in pictures.items],
        "outside": pictures.outside,
        "limits_e": dict(pictures.limits_e),
        "reads": list(pictures.reads),
        "reports": [[r.kind, r.plane, r.most] for r in pictures.reports],
        "words": [[list(word) for word in kernel] for kernel in pictures.kernels],
        "launches": [[launch.kernel, launch.level] for launch in pictures.launches],
        "registers": dict(pictures.registers),
        "costs": [[c.name, c.words, c.peak_gain, c.noise_gain] for c in pictures.costs],
    }


def pictures_from(header: Any) -> Pictures:
    """Return the images and planes of a header; raise ValueError for an invalid header."""
    try:
        return Pictures(
            tuple(
                Weights(name, tuple(tuple(map(int, row)) for row in rows), int(divisor))
                for name, rows, divisor in header["kernels"]
            ),
            tuple(Picture(str(name), from_plain(node)) for name, node in header["items"]),
            header["outside"],
            {str(name): float(limit) for name, limit in header["limits_e"].items()},
            tuple(map(str, header["reads"])),
            tuple(
                PlaneReport(kind, str(plane), int(most)) for kind, plane, most in header["reports"]
            ),
            tuple(tuple((a, b, c, d, e) for a, b, c, d, e in kernel) for kernel in header["words"]),
            tuple(TailLaunch(kernel, level) for kernel, level in header["launches"]),
            {str(name): str(register) for name, register in header["registers"].items()},
            tuple(
                PictureCost(str(name), int(words), float(peak), float(noise))
                for name, words, peak, noise in header["costs"]
            ),
            tuple(
                KeptPlane(str(name), bool(start), _condition(step))
                for name, start, step in header.get("states", ())
            ),
            int(header.get("count_steps", 0)),
        )
    except (TypeError, KeyError, AttributeError) as error:
        raise ValueError("the header's pictures are malformed") from error


def _condition(plain: Any) -> Condition:
    node = from_plain(plain)
    if not isinstance(node, Condition):
        raise ValueError("the next value of a state is not a plane")
    return node


def to_text(pictures: Pictures) -> list[str]:
    """Return the `.pictures` lines of assembly text: base64 of the header."""
    data = json.dumps(header_of(pictures), sort_keys=True, separators=(",", ":"))
    return base64_lines(data.encode("ascii"))


def from_text(text: str) -> Pictures | None:
    """Return the images and planes of `.pictures` lines; None if they are invalid."""
    try:
        return pictures_from(json.loads(b64decode(text, validate=True)))
    except (ValueError, RecursionError):
        return None


def faults(container: Container) -> Iterator[str]:
    """Yield the errors of a container's images and planes, each as part of a sentence."""
    pictures = container.pictures
    if pictures is None:
        return
    states = {state.name for state in pictures.states}
    known: set[str] = {*container.buckets, *states}
    weights = {kernel.name for kernel in pictures.weights}
    for expression_name, expression in pictures.expressions.items():
        for node in subexpressions(expression):
            name = getattr(node, "name", None)
            if name is not None and name not in known:
                yield f"`{expression_name[:40]!a}` reads a name that is not computed before it"
                return
            if getattr(node, "kernel", None) not in (None, *weights):
                yield f"`{expression_name[:40]!a}` names a kernel that does not exist"
                return
        known.add(expression_name)
    if pictures.count_steps < 0 or states - pictures.registers.keys():
        yield "its pictures lack the register of a state, or have a negative count step"
    if pictures.outside not in (None, 0, 1) or pictures.limits_e.keys() != {*container.buckets}:
        yield "its pictures are malformed"
    if not known.issuperset(pictures.outputs) or not pictures.outputs:
        yield "its pictures neither read out nor report anything"
    for kernel in pictures.kernels:
        if not all(type(x) is int and 0 <= x < 1 << 32 for word in kernel for x in word):
            yield "a word of its pictures is not five 32-bit integers"
            return
    for launch in pictures.launches:
        level, target = launch.level, container.target
        if launch.kernel not in range(len(pictures.kernels)) or not (
            level is None or (type(level) is int and target.in_low <= level <= target.in_high)
        ):
            yield "a launch of its pictures is malformed"
            return
    registers = {*container.target.analog_registers, *container.target.digital_registers}
    if not registers.issuperset(pictures.registers.values()):
        yield f"its pictures are in registers that {container.target.name} does not have"
