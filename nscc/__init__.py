"""nscc compiles per-pixel shutter programs for SCAMP-5 class vision chips."""

from __future__ import annotations

__version__ = "0.1.0"
