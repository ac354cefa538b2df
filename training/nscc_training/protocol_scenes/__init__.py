"""Scenes exposed as protocols say, with the protocols' metrics."""
