"""The tradeoff of the emulator: errors against the reference and times of frames."""
