"""Evaluation of runs and baselines under protocols."""
