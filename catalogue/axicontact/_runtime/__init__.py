"""What the modules of the catalogue compute with: hand-written NumPy, the same files in the engine and in the package.

An import of a module brings along what its functions need of this folder; the rest comes with the first call.

interface
    What every function begins with: the checks of its arguments, and the way into its formula.
bare
    Arguments that carry a unit or a mask, which are refused.
functions, special
    Functions that NumPy lacks or that lose digits when written out; those with fitted kernels are apart.
integrals, rules
    Gauss-Legendre rules for intervals of any length, and the substitutions that make the integrals over the growth of
    a contact regular.
inverse
    Roots of increasing curves, for radii of a depth or a force.
steps
    Sums and roots in a fixed number of steps, for expressions over other array libraries.
nodes, kernels, intervals, symbols
    Numbers that the engine writes: nodes, fitted kernels, domains and units of the parameters.
shapes
    What some indenters need: powers of any exponent, arcs, the ring of zero pressure under a hollow, breaks, waves.
physics
    Adhesion, slip, viscoelasticity, prescribed pressures and strips.
graded
    The half-space whose modulus grows as a power of depth.
subsurface
    Stresses and displacements below the surface, under normal load and friction.
plain
    What the formulas for plain numbers are written with, beside `math`.
arrays
    Broadcasting and blocks; numbers without a range where doubles end.
"""
