"""Compiled simulation of programs whose pixels look at the light: their words as paths through a
frame."""
