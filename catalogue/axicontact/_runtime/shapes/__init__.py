"""What some shapes of indenter need: powers of any exponent, arcs, hollows, breaks, waves."""
