"""Clips and stills from a frame of any code, by weights that no code was trained for.

`measured` is what is known of the light: frames, masks, noise, saturation. `network` is a denoiser
that sees it, `stages` alternates both, `readouts` joins several of which one was always open, and
`lessons` are what `nscc train` made the weights of.
"""

from __future__ import annotations
