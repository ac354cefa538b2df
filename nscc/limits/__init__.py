"""The largest size of each shutter class on a chip: compiled, impossible, or unknown."""
