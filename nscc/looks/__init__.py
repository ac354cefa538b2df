"""Lowering of programs with senses: from the state machine to words."""
