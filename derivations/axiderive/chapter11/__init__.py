"""Chapter 11 as a test: each of the equations (11.1)-(11.110) is an executable check.

The right side of every equation stands in its section's module as the chapter
prints it; a check compares it with the left side computed on another route, at
random parameters and in two systems of units.  `runner.run` does all of them,
`runner.table` prints them, `errata.errata` lists what they show to be misprinted.
"""
