"""Simulation of the words that follow the last slot: images and planes from neighbouring pixels."""
