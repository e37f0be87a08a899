"""Chapter 11 as a test: each of the equations (11.1)-(11.110) is an executable check.

The right side of every equation stands in its section's module as the chapter
prints it; a check compares it with the left side computed on another route, at
random parameters and in two systems of units.  `equation.run` does all of them,
`equation.table` prints them, `errata.record` lists what they show to be misprinted.
"""
