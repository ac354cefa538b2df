"""Execution of programs with fixed shutters: a frame under a given set of effects, by weighted sums
over slots, by the words of single pixels, or by the reference.

Nothing here decides which effects are simulated: `nscc_runtime.planning` does, and imports this.
"""
