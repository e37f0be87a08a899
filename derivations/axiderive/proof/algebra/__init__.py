"""The algebra of the certificates: towers of functions, their identities and signs."""
