"""What accuracy costs in time: decoders by milliseconds, shutters by the shortest slot."""
