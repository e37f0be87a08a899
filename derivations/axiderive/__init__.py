"""Derivation engine of axicontact: from an indenter profile f(r) to proved contact formulas."""

__version__ = "0.1.0"
