"""The tradeoff of the emulator: errors relative to the reference, and times of frames."""
