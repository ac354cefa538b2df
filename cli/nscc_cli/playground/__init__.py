"""A page to try nscc: the answers to its requests, and its files."""

from pathlib import Path

PAGE = Path(__file__).with_name("page")
"""The folder with the files of the page; its `config.json` is that of `nscc play`."""
