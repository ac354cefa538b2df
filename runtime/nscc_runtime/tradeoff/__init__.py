"""What the emulator's time buys: errors against the reference beside times of frames."""
