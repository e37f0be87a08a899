"""Reduction of Abel integrals to a dozen master integrals."""
