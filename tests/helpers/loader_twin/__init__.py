"""The loader in Python: what the firmware's core must answer, byte for byte."""
