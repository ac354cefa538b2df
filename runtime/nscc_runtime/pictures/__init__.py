"""Pictures: a function for each kind makes a figure, and `sheet.png_of` makes any of them a PNG."""
