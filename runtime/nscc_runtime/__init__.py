"""Runs compiled shutter programs: scenes, the emulated chip, frame files and their pictures."""

from __future__ import annotations
