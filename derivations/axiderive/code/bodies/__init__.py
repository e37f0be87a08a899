"""Bodies of the generated functions, by kind of contact."""
