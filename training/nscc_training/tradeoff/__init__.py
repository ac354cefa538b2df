"""Studies of `nscc tradeoff`: error against time."""

STAGES = ("compile", "lowering", "slots", "effects", "decoder")
"""The stages of the joint tradeoff of one program, in order."""
