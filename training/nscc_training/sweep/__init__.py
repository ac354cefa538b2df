"""Grids of points: what to compute in which combinations, on one machine or on many.

`grid` reads what is asked for, `kinds` says what a point can be, `keys` by what a result is known,
`store` keeps results, `work` and `cluster` compute them, `table`, `report` and the pictures tell
them, and `run` is the whole of it. Nothing here needs torch, nor Dask, before a point does.
"""
