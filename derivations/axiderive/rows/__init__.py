"""Entries as printed rows: label, range, formula, key."""
