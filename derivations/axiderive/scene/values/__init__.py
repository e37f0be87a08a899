"""Numbers a scene's module is checked with."""
