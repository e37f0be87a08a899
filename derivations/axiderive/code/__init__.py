"""Views of the entries: Python modules, the handbook, the index."""
