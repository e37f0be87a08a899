"""Formulas as graphs, and what is compiled of them at the first call."""
