"""Contradictions between the registers or taps of a target, whose single values are valid."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import Any

from nscc.diagnostics.suggest import meant
from nscc.operations import ANALOG_WRITE, DIGITAL_WRITE
from nscc.toml.toml_text import shown

_MOST_TOLD = 10
_MOST_TAPS = 16


def contradictions(registers: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield the contradictions between the keys of [registers] as (key, message, help).

    `registers` maps the keys that could be read to their values. The help is "" if there is none.
    """
    for key, known in (("analog", tuple(ANALOG_WRITE)), ("digital", tuple(DIGITAL_WRITE))):
        for message, help_text in islice(_listed(registers.get(key, ()), known), _MOST_TOLD):
            yield key, f"registers.{key} lists {message}", help_text
    analog, digital = registers.get("analog"), registers.get("digital")
    scratch, mask, masked = map(registers.get, ("analog_scratch", "mask", "masked"))
    if analog is not None and "analog_scratch" in registers and scratch not in analog:
        message = f"analog_scratch is {shown(scratch)}, not in registers.analog"
        yield "analog_scratch", message, ""
    if (mask is None) != (masked is None):
        key_given, absent = ("mask", "masked") if masked is None else ("masked", "mask")
        message = f"registers.{key_given} is given and registers.{absent} is not: "
        message += "give both or neither"
        yield key_given, message, ""
    elif mask is not None and mask == masked:
        yield "masked", f"registers.mask and registers.masked are both {shown(mask)}", ""
    for key, name in (("mask", mask), ("masked", masked)):
        if name is not None and digital is not None and name not in digital:
            yield key, f"registers.{key} is {shown(name)}, not in registers.digital", ""


def tap_contradictions(stream: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield the contradictions between the keys of [stream], for a chip with taps, like
    `contradictions`."""
    taps, drain, gains = map(stream.get, ("taps", "drain", "tap_gain"))
    if taps is not None and len(set(taps)) < len(taps):
        yield "taps", "stream.taps has a name twice", ""
    elif taps is not None and not 1 <= len(taps) <= _MOST_TAPS:
        message = f"stream.taps lists {len(taps)} taps, but 1 to {_MOST_TAPS} are allowed"
        yield "taps", message, ""
    elif taps is not None and len(taps) == 1 and not drain:
        message = "stream.taps has one tap and no drain, so all light goes to that tap"
        yield "taps", message, "give `drain = true`, or a second tap"
    if taps is not None and gains and len(gains) != len(taps):
        message = f"stream.tap_gain has {len(gains)} gains, but there are {len(taps)} taps"
        yield "tap_gain", message, "give one for each tap, in their order"


def _listed(names: Sequence[str], known: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the errors in a list of registers as (message, help); `known` are the existing
    registers."""
    for index, name in enumerate(names):
        if name in names[:index]:
            yield f"{shown(name)} twice", ""
        elif name not in known:
            known_text = ", ".join(known) if len(known) < 10 else f"{known[0]} to {known[-1]}"
            yield (
                f"{shown(name)}, which an instruction word cannot address",
                meant(name, known, f"instruction words address {known_text}")[0],
            )
