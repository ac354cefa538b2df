"""The largest size of each shutter class on a chip, and sizes that are impossible or unknown."""
