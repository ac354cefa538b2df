"""Sweeps over grids of points, on one machine or on many.

`grid` reads grids, `kinds` lists the kinds of points and computes their keys, `store` keeps
results, `work` and `cluster` compute them, `result_table`, `sweep_report` and the pictures show
them, and `run_sweep` runs all of it. Torch and Dask are imported only when a point needs them.
"""
