"""Functions with a fixed meaning that SymPy leaves alone: what the printed code calls."""

from __future__ import annotations

import sympy as sp


class Named(sp.Symbol):
    """An intermediate of the code; a difference of two of them is not exact."""


def named(label: str) -> Named:
    """A positive symbol for an intermediate of the code."""
    return Named(label, positive=True)


class Root(sp.Function):
    """sqrt(x**2 - y**2), computed as sqrt((x - y)*(x + y))."""

    nargs = 2


class SineRoot(sp.Function):
    """sqrt(x**2 - (R sin(theta))**2), of (x, R, theta)."""

    nargs = 3


class Arctan2(sp.Function):
    """atan(y/x)."""

    nargs = 2


class Arcosh(sp.Function):
    """acosh(x/y) of (x, y, sqrt(x**2 - y**2)), computed as log1p((x - y + root)/y): nothing cancels."""

    nargs = 3


class Log1p(sp.Function):
    """ln(1 + x)."""

    nargs = 1


class Expm1(sp.Function):
    """exp(x) - 1."""

    nargs = 1


class ArctanGap(sp.Function):
    """x - atan(x)."""

    nargs = 1


class RootGap(sp.Function):
    """ArctanGap(sqrt(x**2 - y**2)/y), of (x, y)."""

    nargs = 2


class TanhGap(sp.Function):
    """y - x of an angle and its hyperbolic tangent, (y, x)."""

    nargs = 2


class GammaRatio(sp.Function):
    """Gamma(x + 1/2)/Gamma(x)."""

    nargs = 1


class DepthOverHeight(sp.Function):
    """sqrt(pi) Gamma(j/2 + 1)/Gamma(j/2 + 1/2) of a whole j: the depth of r**j over a**j."""

    nargs = 1


class ArcStrips(sp.Function):
    """int_r^a atanh(t/R)/sqrt(t^2 - r^2) dt, of (r, a, R)."""

    nargs = 3


class PowerPressure(sp.Function):
    """int_r^a t**(n-1)/sqrt(t^2 - r^2) dt / a**(n-1), of (r, a, n)."""

    nargs = 3


class PowerDisplacement(sp.Function):
    """int_0^a n t**(n-1) asin(t/r) dt / a**n, of (r, a, n)."""

    nargs = 3


class PowerPunches(sp.Function):
    """int_0^a t**n/sqrt(r^2 - t^2) dt / a**n, of (r, a, n)."""

    nargs = 3


class PowerStrips(sp.Function):
    """int_0^a n t**(n-1)/sqrt(x^2 - t^2) dt / a**n, of (x, a, n)."""

    nargs = 3
