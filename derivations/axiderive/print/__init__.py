"""SymPy expressions and words as LaTeX."""
