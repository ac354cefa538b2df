"""The names and short descriptions of the commands, available without importing them."""

from __future__ import annotations

COMMANDS = {
    "demo": "Expose and reconstruct a photo or a clip.",
    "examples": "List the programs that come with nscc, or copy one.",
    "new": "Write a first program, with comments.",
    "design": "Compute a program for a scene.",
    "import-mask": "Write a program for the shutters in a mask file.",
    "import-network": "Write a program for a trained network of bits.",
    "check": "Report errors of programs, and whether they fit the chip.",
    "build": "Compile a program to a container of words.",
    "run": "Expose one frame of a scene with a program.",
    "shutters": "Write the shutter of every pixel.",
    "prove": "Prove that a container opens the shutters of its program.",
    "fmt": "Format programs in the standard style.",
    "lsp": "Start the language server for editors.",
    "view": "Draw a program's shutters and its map of codes.",
    "asm": "Assemble text into a container or words.",
    "disasm": "Write a container's words as assembly text.",
    "diff": "Print the differences between two containers.",
    "explain": "Explain an error code.",
    "targets": "List the known chips and their limits.",
    "effects": "List the sensor effects and their parameters.",
    "calibrate": "Measure a sensor from flat and dark frames.",
    "device": "Use a chip at a serial port, or simulate one.",
    "tradeoff": "Measure error against computing time.",
    "sweep": "Compute all combinations of settings, in parallel.",
    "train": "Train shutters together with a decoder.",
    "reconstruct": "Decode a frame into a picture or a clip.",
    "classify": "Name the class of a frame's scene.",
    "metrics": "Compare a reconstruction with the ground truth.",
    "evaluate": "Score reconstructions under a protocol.",
    "doctor": "Report on this installation.",
}
"""The help line of each command, in the order of `nscc --help`.

A command is the function `command` in the module of its name. Commands in `MODULES` are functions
with their own name (with `_` for `-`) in the module that it names."""
MODULES = {
    **dict.fromkeys(("asm", "disasm", "diff", "prove", "shutters"), "containers"),
    **dict.fromkeys(("explain", "examples", "new", "doctor"), "guide"),
    **dict.fromkeys(("import-mask", "import-network"), "imports"),
    "classify": "reconstruct",
    "metrics": "evaluate",
}
