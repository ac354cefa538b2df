"""Improve finished solutions by local changes, which are checked for every shutter by truth
vectors."""

from nscc.logic.improve.balance import balance
from nscc.logic.improve.refine import refine
from nscc.logic.improve.search import improve

__all__ = ["balance", "improve", "refine"]
