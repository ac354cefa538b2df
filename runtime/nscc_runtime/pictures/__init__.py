"""Pictures: each kind has a function that makes a figure, and `sheet.png_of` renders it."""
