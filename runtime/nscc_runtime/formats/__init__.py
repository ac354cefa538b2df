"""File formats of pictures, clips and frames: a table, and one function per format."""

from __future__ import annotations

from nscc_runtime.formats.content import Content
from nscc_runtime.formats.format_table import FORMATS, Format, check_ending, endings, file_of

__all__ = ["FORMATS", "Content", "Format", "check_ending", "endings", "file_of"]
