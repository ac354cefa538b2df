"""Reports and driver files of programs for chips without logic."""

from __future__ import annotations

import hashlib
import json
from io import BytesIO

import numpy as np

from nscc.diagnostics.diagnostic import rejected
from nscc.emit.report import subject
from nscc.lower.resources import time_text
from nscc.mappings import JsonObject
from nscc.program.problems import counted
from nscc.prove.proof import Proof
from nscc.stream.passes import Sending
from nscc.words.container import Container
from nscc.words.stream import DRAIN, schedule

PLANES_FORMAT = "nscc-planes-1"


def stream_rows(sending: Sending, proof: Proof) -> list[tuple[str, str]]:
    """Return the rows (label, text) that `nscc check` prints after class and codes, for a chip
    without logic: light, planes, time and proof."""
    program, target = sending.program, sending.program.target
    slots = len(program.frame.slot_us)
    taps = target.taps[: len(program.buckets)]
    destinations = [f"{b.name} in {tap}" for b, tap in zip(program.buckets, taps, strict=True)]
    # Destinations of light that no bucket collects.
    unread = sorted({int(n) for n in sending.route.zeros} - {*range(len(program.buckets))})
    for number in unread:
        tap = "the drain" if number == DRAIN else f"{target.taps[number]}, which is not read"
        destinations.append(f"the rest to {tap}")
    pixels = f"{counted(proof.pixels, 'pixel')} x " if proof.pixels else ""
    pixels_note = "" if proof.pixels else ", no pixels yet"
    return [
        ("light", "; ".join(destinations)),
        (
            "planes",
            f"{slots} of {target.rows} x {target.cols} bits, {rate_text(sending.bits_per_us)} "
            "while one loads",
        ),
        (
            "time",
            f"shortest slot {time_text(min(program.frame.slot_us))}, loading a plane "
            f"{time_text(sending.shortest_slot_us)}"
            + (" meanwhile" if target.pipelined else " of its slot, light led away"),
        ),
        ("proved", f"{pixels}{counted(proof.slots, 'slot')}{pixels_note}"),
    ]


def cost_text(sending: Sending) -> str:
    """Return two lines of text: number and size of the bit planes of a frame with their data rate,
    and the shortest possible slot."""
    return (
        f"  planes {len(sending.loadings)} a frame, {sending.bits_a_frame} bits, "
        f"{rate_text(sending.bits_per_us)} while one loads\n"
        f"  time   shortest legal slot {time_text(sending.shortest_slot_us)}"
    )


def rate_text(bits_per_us: float) -> str:
    """Return a data rate, given in bits per microsecond, as text with four digits, in kbit/s,
    Mbit/s or Gbit/s."""
    if bits_per_us >= 1e3:
        return f"{bits_per_us / 1e3:.4g} Gbit/s"
    return f"{bits_per_us:.4g} Mbit/s" if bits_per_us >= 1 else f"{bits_per_us * 1e3:.4g} kbit/s"


def sending_text(sending: Sending) -> str:
    """Return a text with a heading and a line for each slot.

    A line tells when the slot's plane is sent and takes effect, and where bits 1 and 0 send the
    light."""
    target, way = sending.program.target, sending.route
    lines = [
        f"{len(way.ones)} planes of {target.rows} x {target.cols} bits, "
        f"{sending.bits_a_frame} bits a frame, {time_text(sending.shortest_slot_us)} each"
    ]
    named = {DRAIN: "drain", **dict(enumerate(target.taps))}
    for slot, loading in enumerate(sending.loadings):
        ones, zeros = named[int(way.ones[slot])], named[int(way.zeros[slot])]
        lines.append(
            f"slot {slot:>4}: sent at {loading.load_us:g} us, acts at {loading.acts_us:g} us: "
            f"1 {ones}, 0 {zeros}"
        )
    return "\n".join(lines) + "\n"


def stream_report(sending: Sending, proof: Proof) -> JsonObject:
    """Return the build report (`--emit report`) of a chip without logic as JSON values.

    It has the planes and their load time where other reports have words; times are in microseconds.
    """
    program, target = sending.program, sending.program.target
    names = [bucket.name for bucket in program.buckets]
    return {
        **subject(program),
        "taps": dict(zip(names, target.taps[: len(names)], strict=True)),
        "lowering": "stream",
        "planes": {
            "rows": target.rows,
            "cols": target.cols,
            "bits_a_frame": sending.bits_a_frame,
            "bits_per_us": sending.bits_per_us,
            "load_us": target.plane_load_us,
            "pipelined": target.pipelined,
        },
        "shortest_slot_us": round(sending.shortest_slot_us, 6),
        "frame_us": round(sending.frame_us, 6),
        "proof": {
            "codes": proof.codes,
            "slots": proof.slots,
            "frames": proof.frames,
            "pixels": proof.pixels,
            "holds": proof.holds,
        },
        "target": target.name,
        "source_sha256": hashlib.sha256(program.source.text.encode()).hexdigest(),
    }


def planes_bytes(container: Container) -> bytes:
    """Return the bit planes and their times for the chip's driver, as the bytes of an .npz file.

    docs/targets.md lists its keys. Raises Rejected (NS0511) if the pixels have no codes, because
    codes determine the planes."""
    sent, target = container.stream, container.target
    if sent is None:
        raise rejected(
            "NS0511",
            "cannot compute the planes: the pixels have no codes",
            helps=(
                'add a `pixels` statement, or read the codes from a file: `pixels from "C.npz"`',
            ),
            status=1,
        )
    loadings = [*schedule(target, container.slot_us)]
    meta = {
        "format": PLANES_FORMAT,
        "target": target.name,
        "rows": target.rows,
        "cols": target.cols,
        "taps": list(target.taps),
        "buckets": list(container.buckets),
        "row_load_us": target.row_load_us,
        "pipelined": target.pipelined,
    }
    out = BytesIO()
    np.savez(
        out,
        meta=np.array(json.dumps(meta)),
        planes=sent.planes,
        ones=sent.ones,
        zeros=sent.zeros,
        load_us=np.array([loading.load_us for loading in loadings]),
        acts_us=np.array([loading.acts_us for loading in loadings]),
        slot_us=np.array(container.slot_us),
    )
    return out.getvalue()


def planes_text(container: Container) -> str:
    """Return a description of a container's bit planes, for `--print-after words`."""
    planes = "no planes yet" if container.stream is None else f"{container.slots} planes"
    lines = [
        f"Container({len(container.table.codes)} codes, {container.slots} slots, {planes}, for "
        f"{container.target.name})"
    ]
    for readout in container.readouts:
        lines.append(f"{readout.bucket} is read from {readout.register}, gain {readout.gain:g}")
    return "".join(f"{line}\n" for line in lines)
