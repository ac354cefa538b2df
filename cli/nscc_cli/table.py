"""The names and short descriptions of the commands, available without importing them."""

from __future__ import annotations

GROUPS = {
    "Start": {
        "play": "Try programs in a page of your browser.",
        "demo": "Expose and reconstruct a photo or a clip.",
        "examples": "List the programs that come with nscc, or copy one.",
        "new": "Write a first program, with comments.",
        "explain": "Explain an error code.",
        "doctor": "Report on this installation.",
    },
    "Write programs": {
        "check": "Report errors of programs, and whether they fit the chip.",
        "fmt": "Format programs in the standard style.",
        "lsp": "Start the language server for editors.",
        "design": "Compute a program for a scene.",
        "import-mask": "Write a program for the shutters in a mask file.",
        "import-network": "Write a program for a trained network of bits.",
    },
    "Compile and prove": {
        "build": "Compile a program to a container of words.",
        "view": "Draw a program's shutters and its map of codes.",
        "shutters": "Write the shutter of every pixel.",
        "export-mask": "Write the mask of a program for other tools.",
        "prove": "Prove that a container opens the shutters of its program.",
        "asm": "Assemble text into a container or words.",
        "disasm": "Write a container's words as assembly text.",
        "diff": "Print the differences between two containers.",
    },
    "Expose frames": {
        "run": "Expose one frame of a scene with a program.",
        "device": "Use a chip at a serial port, or simulate one.",
        "import-frame": "Write the frame file of pictures that a chip's host saved.",
        "targets": "List the known chips and their limits.",
        "effects": "List the sensor effects and their parameters.",
        "calibrate": "Measure a sensor from flat and dark frames.",
    },
    "Reconstruct and learn": {
        "reconstruct": "Decode a frame into a picture or a clip.",
        "metrics": "Compare a reconstruction with the ground truth.",
        "train": "Train shutters together with a decoder.",
        "classify": "Name the class of a frame's scene.",
        "evaluate": "Score reconstructions under a protocol.",
    },
    "Compare settings": {
        "tradeoff": "Measure error against computing time.",
        "sweep": "Compute all combinations of settings, in parallel.",
    },
}
"""The help line of each command by task, in the order of `nscc --help`."""
COMMANDS = {name: line for group in GROUPS.values() for name, line in group.items()}
"""The help line of each command.

A command is the function `command` in the module of its name. Commands in `MODULES` are functions
with their own name (with `_` for `-`) in the module that it names."""
MODULES = {
    **dict.fromkeys(("asm", "disasm", "diff", "export-mask", "prove", "shutters"), "containers"),
    **dict.fromkeys(("explain", "examples", "new", "doctor"), "guide"),
    **dict.fromkeys(("import-frame", "import-mask", "import-network"), "imports"),
    "classify": "reconstruct",
    "metrics": "evaluate",
}
SYNONYMS = {
    "compile": "build",
    "draw": "view",
    "plot": "view",
    "show": "view",
    "expose": "run",
    "simulate": "run",
    "verify": "prove",
    "decode": "reconstruct",
    "format": "fmt",
    "help": "--help",
}
"""Names that other tools have for a command, by that name."""
