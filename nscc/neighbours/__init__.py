"""Compile images and planes, which read neighbouring pixels, from expressions into words."""
