"""The printed handbook as page models and templates."""
