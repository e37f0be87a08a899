"""A scene's module, put together from the generated ones."""
