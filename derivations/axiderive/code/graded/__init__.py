"""The power-law graded half-space: shapes of the run time in the place of formulas."""
