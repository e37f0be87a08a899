"""Exact certificates: derivative identity, end value and sign of every radicand."""
