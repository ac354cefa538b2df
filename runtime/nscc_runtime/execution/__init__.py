"""Expose frames of programs with fixed shutters under a given set of effects.

A frame is computed by weighted sums over slots, by the words of single pixels, or by the reference.
`nscc_runtime.planning` decides which effects are simulated and imports this package."""
