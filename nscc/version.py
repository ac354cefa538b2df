"""The version of nscc."""

__version__ = "0.3.0"
