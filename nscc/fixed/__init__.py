"""Programs whose shutters depend on the code of a pixel only."""
