"""Evaluation under protocols, with all metadata of a result."""
