"""Runs compiled shutter programs: scenes, the emulated chip, devices, frame files and pictures.

It executes words, and imports of nscc what words and targets are, never what compiles. `capture`
goes from arrays to arrays, `simulate` is what `nscc run` does. Most of it needs `nscc[run]`.
"""

from __future__ import annotations
