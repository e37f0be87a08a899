"""What contacts on the power-law graded half-space need."""
