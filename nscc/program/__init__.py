"""From the tree of a shutter program to a checked program with its decode table.

The way in is `nscc.program.analyse.analyse`; `nscc.program.pixels.codes_from_file` lays a file of
codes on a program that is compiled already; `nscc.program.printing.print_program` shows the result.
"""

from __future__ import annotations
