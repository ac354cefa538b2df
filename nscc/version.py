"""The version of nscc."""

__version__ = "0.1.0"
