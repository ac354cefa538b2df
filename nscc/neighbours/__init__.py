"""Images and planes of neighbouring pixels: from expressions to words."""
