"""Networks from a coded frame to the light of the scene.

A decoder is a module called with `frame` (batch, rows, cols), codes over the top code, and
`shutters` (N, r, c), a tile that repeats over the frame from its top left corner
(`nscc_training.sensor_model.laid`); of pixels that look (batch, 1, rows, cols), the part of the
frame that each pixel was open. It returns light over the whole frame, (batch, rows, cols), for
stills, or light slot by slot, (batch, N, rows, cols), for clips; 1 is a full well, for a slot a
full well / N. Both are float32, whatever the network calculates in.
"""

from __future__ import annotations
