"""Planning: which effects of the sensor a run simulates, chosen by measuring on a sample of pixels.

`nscc_runtime.planning.make` has the five steps.
"""
