"""Measurements of accuracy against time: decoders, shutters, and single programs."""
