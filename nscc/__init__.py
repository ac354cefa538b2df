"""nscc compiles per-pixel shutter programs for SCAMP-5 class vision chips.

This package is the compiler: it needs lark, networkx and numpy, and knows nothing of the packages
above it. `nscc.compiler` compiles, `nscc.containers` also reads what was compiled.
"""

from __future__ import annotations

__version__ = "0.1.0"
