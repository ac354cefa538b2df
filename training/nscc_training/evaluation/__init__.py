"""Numbers under a protocol, with everything that says what they mean."""
