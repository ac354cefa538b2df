"""Programs whose pixels look at the light, compiled: their words as ways through a frame."""
