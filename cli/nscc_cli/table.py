"""The commands of nscc: what `nscc --help` lists, without importing any of them."""

from __future__ import annotations

COMMANDS = {
    "demo": "Show what a coded exposure makes of a photo or a clip.",
    "examples": "List the programs that come with nscc, or copy one.",
    "new": "Begin a program: one with a remark on every statement.",
    "design": "Write a program that is made for a scene.",
    "import-mask": "Write a program that opens an own mask's shutters.",
    "import-network": "Write a program of a trained network of bits.",
    "check": "Check programs: names, ranges, time, registers.",
    "build": "Compile a program to a container of words.",
    "run": "Expose one frame of a scene with a program.",
    "shutters": "Write every pixel's shutter, found by replay.",
    "prove": "Replay a container against its own decode table.",
    "fmt": "Write programs in the one style of the language.",
    "lsp": "Serve editors: messages, fixes, names, costs.",
    "view": "Draw a program's shutters and its map of codes.",
    "asm": "Assemble a listing into a container or words.",
    "disasm": "List a container's words as assembly text.",
    "diff": "Say what differs between two containers.",
    "explain": "Explain the code of a message.",
    "targets": "List the chips that nscc knows, and their limits.",
    "effects": "List the sensor's effects and its parameters.",
    "calibrate": "Measure a sensor from flat and dark frames.",
    "device": "Talk to a chip at a serial port, or stand in for one.",
    "tradeoff": "Measure what more time buys.",
    "sweep": "Compute every point of a grid, on many processors.",
    "train": "Learn shutters together with a decoder.",
    "reconstruct": "Make a picture or a clip of a frame.",
    "metrics": "Compare a reconstruction with the truth.",
    "evaluate": "Score reconstructions under a protocol.",
    "doctor": "Report on this installation.",
}
"""A line of help by the name of the command, in the help's order. A command is `command` in the
module of its name (with `_` for `-`), or has its own name in that of `MODULES`."""
MODULES = {
    **dict.fromkeys(("asm", "disasm", "diff", "prove", "shutters"), "containers"),
    **dict.fromkeys(("explain", "examples", "new", "doctor"), "guide"),
}
