"""Measured tradeoffs of error against time, and their tables."""
