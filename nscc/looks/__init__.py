"""Lowering programs whose pixels look at the light: from the machine to words in time."""
