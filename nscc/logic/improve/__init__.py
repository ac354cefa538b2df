"""Fewer words for a finished solution: what its gates compute is known for every shutter."""

from nscc.logic.improve.balance import balance
from nscc.logic.improve.refine import refine
from nscc.logic.improve.search import improve

__all__ = ["balance", "improve", "refine"]
