"""`--shutter CLASS[:START]`: other codes for baselines that take any."""

from __future__ import annotations

from nscc.diagnostics.rejection import rejected
from nscc_training.code_choices import STARTS
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.protocols import Protocol

_CLASSES = {
    "hdr-v1": ("b",),
    "video-v1": ("c", "d", "e"),
    "deblur-v1": ("b", "c", "d", "e"),
}
_TILE = (8, 8)


def codes_named(text: str, protocol: Protocol, takers: tuple[str, ...], name: str) -> tuple[
    ShutterSpec, str
]:  # fmt: skip
    """The class on its tile, and its start, of `CLASS[:START]`; a class alone starts at random.

    NS0840 where `name` is none of `takers`, or the text none of the protocol's classes and starts.
    """
    kind, _, start = text.partition(":")
    start = start or "random"
    known = _CLASSES[protocol.name]
    reason, note = "", ""
    if name not in takers:
        reason = f"{name} has codes of its own"
        note = f"under {protocol.name} these take others: {', '.join(takers)}"
    elif kind not in known or start not in STARTS:
        reason = f"'{text[:40]}' names no codes of protocol {protocol.name}"
        note = f"its classes are {', '.join(known)}; starts are {', '.join(STARTS)}"
    if reason:
        raise rejected("NS0840", reason, notes=(note,), helps=(f"such as {known[0]}:quad",))
    slots = int(protocol["slots" if protocol.name == "hdr-v1" else "frames"])
    length = max(1, slots // 4) if kind == "c" else None
    spec = ShutterSpec(kind, slots, _TILE, length=length)
    try:
        make_encoder(spec, start)
    except ValueError as error:
        raise rejected("NS0840", f"'{text}' names no codes: {error}") from error
    return spec, start
