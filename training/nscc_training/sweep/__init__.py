"""Sweeps over grids of points, on one machine or on several.

`grid` reads grids. `kinds` lists the kinds of points and computes their keys. `work` and `cluster`
compute points. `result_table` and `sweep_report` present the results. `run_sweep` runs the sweep
and keeps results. Torch and Dask are imported only when a point needs them."""
