"""Decoder for any code: reconstructs clips and stills without training for their code.

`measured` describes the measurement: frames, masks, noise, saturation. `network` is a denoiser that
also receives the measurement. `stages` alternates a step towards the frames with the denoiser.
`decode` applies the stages, and combines several readouts if one of them was always open. `lessons`
are the training examples from which `nscc train` learned the weights."""

from __future__ import annotations
