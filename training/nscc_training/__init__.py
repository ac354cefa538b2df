"""Learns shutter parameters together with a decoder, under the compiler's own limits.

This version holds only the package's name: encoders, decoders, protocols and the training loop come
with the commands `nscc train`, `nscc reconstruct` and `nscc evaluate`.
"""
