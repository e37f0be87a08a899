"""Worked examples: real materials, a real load, and the key of the formula behind every number."""
