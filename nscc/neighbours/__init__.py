"""Images and planes of neighbouring pixels: their meaning as exact forms, and their words."""
