"""Analysis of a program's syntax tree: the checked program with its decode table.

`nscc.program.analyse.analyse` is the entry point. `nscc.program.pixel_codes.codes_from` reads
other pixel codes for a compiled program. `nscc.emit.listing.program_text` prints a program."""

from __future__ import annotations
