"""Compilation for chips without logic: routes of light to taps, bit planes, and their schedule."""
