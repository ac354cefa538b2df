"""Networks that reconstruct the light of a scene from a coded frame.

A decoder is a module with two inputs. `frame` (batch, rows, cols) contains converter codes divided
by the largest code. `shutters` (N, r, c) is a tile that repeats over the frame from its top left
corner (`nscc_training.sensor_model.laid`); for pixels that look it is (batch, 1, rows, cols), the
fraction of the frame for which each pixel was open. A decoder returns light over the frame (batch,
rows, cols) for stills, or per slot (batch, N, rows, cols) for clips. The unit is a full well, for a
slot a full well / N. Inputs and outputs are float32, whatever the network's own precision."""

from __future__ import annotations
