"""Stresses and displacements below the surface, under normal load and under friction.

`punches` sums flat punches over the radii of a contact; `stresses` makes stresses of the twelve sums.
"""
