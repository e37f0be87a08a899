"""Whether a profile touches in one circle: f >= 0, g' >= 0, and no break at which the slope falls."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mpmath as mp
import numpy as np
import sympy as sp
from sympy.polys.polyerrors import BasePolynomialError

from ..abel.atoms import HyperboloidAtom, SphereAtom
from ..abel.reduce import NotReducibleError, parse
from ..notation import r, theta
from ..physics.general import layers
from ..profiles.profile import Piece, Profile
from .definition import Array, Numeric, lengths
from .names import ExpressionError

DECADES = 3
PER_DECADE = 60
ROUNDING = 1e-9
"""A g' as small as this against its largest value so far is rounding."""


SAMPLED = f"sampled at {2 * DECADES * PER_DECADE + 1} radii over {2 * DECADES} decades and not proved"


@dataclass(frozen=True)
class Validity:
    """What was found: `exact` without numbers, else at these values, up to the radius `compact_to`."""

    exact: bool
    compact_to: float | None
    where: str
    fails: str = ""
    """What fails there, where it is not the sign of g'."""
    ends: float | None = None
    """Radius at which f ends."""

    @property
    def sentence(self) -> str:
        """The finding in one sentence: up to which radius the contact is compact, and whether that is proved."""
        if self.exact and self.ends is not None:
            return (
                f"compact up to where f ends (a = {self.ends:.6g} at {self.where}): all coefficients of f are positive"
            )
        if self.exact:
            return "compact for every contact radius: all coefficients of f are positive"
        if self.ends is not None:
            return f"compact up to a = {self.ends:.6g} at {self.where}, where f ends; {SAMPLED}"
        if self.compact_to is None:
            return f"compact for every contact radius that was tried, at {self.where}; {SAMPLED}"
        fails = self.fails or (
            "g' < 0, the pressure falls below zero at the edge, and the contact is no longer one circle"
        )
        return f"compact up to a = {self.compact_to:.6g} at {self.where}: beyond it {fails}; {SAMPLED}"


def examine(profile: Profile, values: Mapping[sp.Symbol, float], text: str = "") -> Validity:
    """The validity of a profile, exactly where the signs of all coefficients say it, else at these values.

    Raises
    ------
    ExpressionError
        If the indenter does not touch with its apex first, or its slope falls at a break.
    """
    where = drawn(values)
    if any(piece.expr.xreplace(dict(values)).has(sp.zoo, sp.nan, sp.oo, sp.I) for piece in profile.pieces):
        message = f"f is no real number for any r ({where}); put numbers for parameters"
        raise ExpressionError(message, text)
    exact = all(_rises(layer.shape, layer.start) for layer in layers(profile))
    if exact and all(piece.expr.is_polynomial(r) for piece in profile.pieces):
        return Validity(True, None, where)
    numeric = Numeric(profile, values)
    scale, radii = _sampled(numeric)
    if exact:
        return Validity(True, None, where, ends=_end(profile, numeric, radii, np.isfinite(numeric.slope(radii))))
    require_slopes(profile, values, text)
    for b, kink in numeric.kinks():
        if kink < 0.0:
            message = (
                f"the slope of f falls by {-kink:.4g} at the break r = {b:.4g} ({where}): the pressure is -inf there "
                "and the contact has a gap; make the outer part steeper, or round the break"
            )
            raise ExpressionError(message, text)
    if profile.truncated:
        radii = numeric.breaks[0] * np.sqrt(1.0 + (radii / scale) ** 2)
    height, rate = numeric.height(radii), numeric.rate(radii)
    usable = np.isfinite(height) & np.isfinite(rate)
    if not usable[0]:
        message = f"f or its slope is no real number at r = {radii[0]:.3g} ({where}); choose other values"
        raise ExpressionError(message, text)
    if not height[usable].any():
        message = f"f is 0 for every r ({where}); put numbers for parameters"
        raise ExpressionError(message, text)
    last = len(radii) if usable.all() else int(np.argmin(usable))
    height, rate = height[:last], rate[:last]
    largest = np.maximum.accumulate(np.abs(rate))
    wrong = np.flatnonzero((rate < -ROUNDING * largest) | (height < 0.0))
    if not len(wrong):
        return Validity(False, None, where, ends=_end(profile, numeric, radii, usable))
    first = int(wrong[0])
    if first == 0:
        below = "f < 0" if height[0] < 0.0 else "g' < 0"
        message = (
            f"{below} already at r = {radii[0]:.3g} ({where}): the apex is not the lowest point, and the contact is "
            "not compact; a profile rises from f(0) = 0"
        )
        raise ExpressionError(message, text)
    fails = "f < 0, the indenter reaches below its apex" if height[first] < 0.0 and rate[first] >= 0.0 else ""
    return Validity(False, _refined(numeric, radii[first - 1], radii[first]), where, fails)


def drawn(values: Mapping[sp.Symbol, float]) -> str:
    """The values of the parameters in words."""
    return ", ".join(f"{s.name} = {float(v):g}" for s, v in values.items()) or "these numbers"


def require_slopes(profile: Profile, values: Mapping[sp.Symbol, float], text: str) -> None:
    """A finite slope on the outer side of every break."""
    for layer in layers(profile):
        if not sp.sympify(layer.kink.xreplace(dict(values))).is_finite:
            power = next((p for p in sorted(layer.shape.atoms(sp.Pow), key=str) if _broken(p, layer.start)), None)
            message = (
                f"f has a power {sp.sstr(power or layer.shape)[:60]} beyond the break r = {layer.start}, where broken "
                f"and free exponents are not derived; write powers of r - {layer.start} with whole numbers of 1 or more"
            )
            raise ExpressionError(message, text)


def _broken(power: sp.Pow, start: sp.Expr) -> bool:
    """Whether it is a power of r - start that is no whole one."""
    return sp.expand(power.base.subs(r, start)) == 0 and not (power.exp.is_Integer and power.exp > 0)


def _sampled(numeric: Numeric) -> tuple[float, Array]:
    """A length of the profile, and radii around it."""
    scale = max([*numeric.breaks, *(float(numeric.values[p]) for p in lengths(numeric.values))], default=1.0)
    return scale, scale * 10.0 ** np.linspace(-DECADES, DECADES, 2 * DECADES * PER_DECADE + 1)


def _end(profile: Profile, numeric: Numeric, radii: Array, usable: Array) -> float | None:
    """The radius at which f ends, from where its numbers are usable."""
    last = int(np.argmin(usable))
    if usable.all() or _overflows(profile, numeric.values, float(radii[last])):
        return None
    return _refined(numeric, radii[last - 1], radii[last])


def _overflows(profile: Profile, values: Mapping[sp.Symbol, float], radius: float) -> bool:
    """Whether f is a real number there all the same, only out of the range of doubles."""
    function = sp.lambdify(r, profile.pieces[-1].expr.xreplace(dict(values)), "mpmath")
    try:
        return isinstance(function(mp.mpf(1.001 * radius)), mp.mpf)
    except (ZeroDivisionError, ValueError, OverflowError):
        return False


def _refined(numeric: Numeric, low: float, high: float) -> float:
    for _ in range(60):
        middle = (low + high) / 2.0
        at = np.array([middle])
        good = bool((numeric.rate(at) >= 0.0).all() and (numeric.height(at) >= 0.0).all())
        low, high = (middle, high) if good else (low, middle)
    return float(low)


def _rises(shape: sp.Expr, start: sp.Expr) -> bool:
    """A polynomial with positive coefficients in r - start: f' and (r f')' are positive for every value."""
    inclined = sp.Dummy(positive=True)
    moved = sp.expand(shape.subs(r, r + start)).subs(sp.tan(theta), inclined)
    if not moved.is_polynomial(r):
        return start == 0 and (_power_law(moved) or _round(shape))
    return all(c.is_positive for c in sp.Poly(moved, r).coeffs())


def _round(shape: sp.Expr) -> bool:
    """A sphere, an ellipsoid or a hyperboloid: f' and r f'' are positive."""
    try:
        (atom,) = parse((Piece(None, shape),)).atoms
    except (NotReducibleError, ValueError, AssertionError, BasePolynomialError):
        return False
    return isinstance(atom, (SphereAtom, HyperboloidAtom)) and bool(atom.c.is_positive)


def _power_law(expr: sp.Expr) -> bool:
    """A sum of c r**n with positive c and n."""
    for term in sp.Add.make_args(expr):
        factor, power = term.as_independent(r, as_Add=False)
        base, exponent = power.as_base_exp()
        if not (factor.is_positive and base == r and exponent.is_positive):
            return False
    return True
