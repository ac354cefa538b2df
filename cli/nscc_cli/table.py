"""The commands of nscc: what `nscc --help` lists, without importing any of them."""

from __future__ import annotations

from typing import NamedTuple


class Entry(NamedTuple):
    """A command: its name, that of the module here whose `command` it is, and one line of help."""

    name: str
    help: str


COMMANDS = (
    Entry("check", "Check programs: names, ranges, time, registers."),
    Entry("build", "Compile a program to a container of words."),
    Entry("run", "Expose one frame of a scene with a program."),
    Entry("shutters", "Write every pixel's shutter, found by replay."),
    Entry("prove", "Replay a container against its own decode table."),
    Entry("view", "Draw a program's shutters and its map of codes."),
    Entry("asm", "Assemble a listing into a container or words."),
    Entry("disasm", "List a container's words as assembly text."),
    Entry("diff", "Say what differs between two containers."),
    Entry("explain", "Explain the code of a message."),
    Entry("targets", "List the chips that nscc knows, and their limits."),
    Entry("effects", "List the sensor's effects and its parameters."),
    Entry("calibrate", "Measure a sensor from flat and dark frames."),
    Entry("device", "Talk to a chip at a serial port, or stand in for one."),
    Entry("tradeoff", "Measure what more time buys."),
    Entry("train", "Learn shutters together with a decoder."),
    Entry("reconstruct", "Make a picture or a clip of a frame."),
    Entry("metrics", "Compare a reconstruction with the truth."),
    Entry("evaluate", "Score reconstructions under a protocol."),
    Entry("doctor", "Report on this installation."),
)
"""The commands of this version, in the order in which `nscc --help` lists them."""
