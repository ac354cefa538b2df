"""The commands of nscc: what `nscc --help` lists, without importing any of them."""

from __future__ import annotations

from typing import NamedTuple


class Entry(NamedTuple):
    """A command: its name, the module that holds its `command`, and one line of help."""

    name: str
    module: str
    help: str


COMMANDS = (
    Entry("check", "nscc_cli.check", "Check programs: names, ranges, time, registers."),
    Entry("build", "nscc_cli.build", "Compile a program to a container of words."),
    Entry("run", "nscc_cli.run", "Expose one frame of a scene with a program."),
    Entry("shutters", "nscc_cli.shutters", "Write every pixel's shutter, found by replay."),
    Entry("prove", "nscc_cli.prove", "Replay a container against its own decode table."),
    Entry("view", "nscc_cli.view", "Draw a program's shutters and its map of codes."),
    Entry("asm", "nscc_cli.asm", "Assemble a listing into a container or words."),
    Entry("disasm", "nscc_cli.disasm", "List a container's words as assembly text."),
    Entry("diff", "nscc_cli.diff", "Say what differs between two containers."),
    Entry("explain", "nscc_cli.explain", "Explain the code of a message."),
    Entry("targets", "nscc_cli.targets", "List the chips that nscc knows, and their limits."),
    Entry("effects", "nscc_cli.effects", "List the sensor's effects and its parameters."),
    Entry("calibrate", "nscc_cli.calibrate", "Measure a sensor from flat and dark frames."),
    Entry("device", "nscc_cli.device", "Talk to a chip at a serial port, or stand in for one."),
    Entry("tradeoff", "nscc_cli.tradeoff", "Measure what more time buys."),
    Entry("train", "nscc_cli.train", "Learn shutters together with a decoder."),
    Entry("reconstruct", "nscc_cli.reconstruct", "Make a picture or a clip of a frame."),
    Entry("metrics", "nscc_cli.metrics", "Compare a reconstruction with the truth."),
    Entry("evaluate", "nscc_cli.evaluate", "Score reconstructions under a protocol."),
    Entry("doctor", "nscc_cli.doctor", "Report on this installation."),
)
"""The commands of this version, in the order in which `nscc --help` lists them."""
