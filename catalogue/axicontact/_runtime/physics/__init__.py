"""What the contacts beyond the normal one on an elastic half-space need."""
