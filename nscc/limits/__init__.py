"""How large a shutter class may be on a chip: proved, compiled, or unknown."""
