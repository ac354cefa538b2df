"""Pictures: each kind has a function that returns a figure, and `sheet.png_of` renders it."""
