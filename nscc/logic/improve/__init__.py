"""Improvement of complete solutions by local changes, checked for all shutters by truth vectors."""

from nscc.logic.improve.balance import balance
from nscc.logic.improve.refine import refine
from nscc.logic.improve.search import improve

__all__ = ["balance", "improve", "refine"]
