"""Learned shutters and decoders: encoders, decoders, baselines, losses, metrics, protocols.

This version holds the package's name and version only; `nscc train`, `nscc reconstruct` and
`nscc evaluate` say that they are not in it. The package will need torch (`pip install
nscc[train]`) and import nscc and nscc_runtime, never the other way round.
"""

from __future__ import annotations

from nscc import __version__

__all__ = ["__version__"]
