"""Profiles of one's own: text f(r) -> checked SymPy tree -> `Profile`, never through `eval` or `sympify`."""

from .names import ExpressionError
from .profile import own_profile
from .reading import Expression, read

__all__ = ["Expression", "ExpressionError", "own_profile", "read"]
