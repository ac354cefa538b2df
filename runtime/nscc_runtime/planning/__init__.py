"""Planning: choose the sensor effects that a run simulates, by measuring on a sample of pixels.

`nscc_runtime.planning.make` describes the steps."""
