"""Scenes of evaluation protocols, exposed and scored as the protocols define."""
