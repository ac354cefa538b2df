"""Scenes as protocols expose them, each with the protocol's metrics of a reconstruction."""
