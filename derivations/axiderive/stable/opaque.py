"""Functions with a fixed meaning that SymPy leaves alone: what the printed code calls."""

from __future__ import annotations

from typing import Any

import sympy as sp


class Named(sp.Symbol):
    """An intermediate of the code; a difference of two of them is not exact."""


def named(label: str) -> Named:
    """A positive symbol for an intermediate of the code."""
    return Named(label, positive=True)


def _function(name: str, count: int, meaning: str) -> Any:
    """The class of the calls of a function of so many arguments."""
    return type(name, (sp.Function,), {"nargs": count, "__doc__": meaning, "__module__": __name__})


Root = _function("Root", 2, "sqrt(x**2 - y**2), computed as sqrt((x - y)*(x + y)).")
SineRoot = _function("SineRoot", 3, "sqrt(x**2 - (R sin(theta))**2), of (x, R, theta).")
Arctan2 = _function("Arctan2", 2, "atan(y/x).")
Arcosh = _function(
    "Arcosh", 3, "acosh(x/y) of (x, y, sqrt(x**2 - y**2)), computed as log1p((x - y + root)/y): nothing cancels."
)
Log1p = _function("Log1p", 1, "ln(1 + x).")
Expm1 = _function("Expm1", 1, "exp(x) - 1.")
ArctanGap = _function("ArctanGap", 1, "x - atan(x).")
RootGap = _function("RootGap", 2, "ArctanGap(sqrt(x**2 - y**2)/y), of (x, y).")
TanhGap = _function("TanhGap", 2, "y - x of an angle and its hyperbolic tangent, (y, x).")
GammaRatio = _function("GammaRatio", 1, "Gamma(x + 1/2)/Gamma(x).")
DepthOverHeight = _function(
    "DepthOverHeight", 1, "sqrt(pi) Gamma(j/2 + 1)/Gamma(j/2 + 1/2) of a whole j: the depth of r**j over a**j."
)
ArcStrips = _function("ArcStrips", 3, "int_r^a atanh(t/R)/sqrt(t^2 - r^2) dt, of (r, a, R).")
PowerPressure = _function("PowerPressure", 3, "int_r^a t**(n-1)/sqrt(t^2 - r^2) dt / a**(n-1), of (r, a, n).")
PowerDisplacement = _function("PowerDisplacement", 3, "int_0^a n t**(n-1) asin(t/r) dt / a**n, of (r, a, n).")
PowerPunches = _function("PowerPunches", 3, "int_0^a t**n/sqrt(r^2 - t^2) dt / a**n, of (r, a, n).")
PowerStrips = _function("PowerStrips", 3, "int_0^a n t**(n-1)/sqrt(x^2 - t^2) dt / a**n, of (x, a, n).")
