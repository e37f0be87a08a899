"""Programs over single numbers as C99."""
