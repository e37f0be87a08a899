"""What is printed is what was checked: the LaTeX of every row, evaluated without SymPy and compared with its entry."""
