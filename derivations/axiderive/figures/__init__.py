"""Figures as plain data, from the exact entries."""
