"""The flat punch from the point load, (11.1)-(11.15) and (11.32)-(11.47), as a chain of exact steps.

Every step is an identity that algebra, the functional equation of Gamma or the
ratio of two terms of a series decides; nothing is integrated by machine.
Inside, the chord through the point A is mapped onto (0, 1) by
y = (q + v)/(1 + q v), which frees the integral over both directions from the
position of A.  Outside, the ring kernel is summed term by term.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

a, r, s, p0, d, E, H, x = sp.symbols("a r s p_0 d E_star H x", positive=True)
alpha, y, v, q, z = sp.symbols("alpha y v q z", positive=True)
beta, phi, k = sp.symbols("beta phi k", real=True)
m = sp.Symbol("m", integer=True, nonnegative=True)
HALF = sp.Rational(1, 2)


@dataclass(frozen=True)
class Step:
    """left = right, in the words of `claim`; `equations` are those of the chapter it serves."""

    equations: str
    claim: str
    left: sp.Expr
    right: sp.Expr

    def holds(self) -> bool:
        """Whether the difference vanishes identically."""
        return _vanishes(self.left - self.right)


def _vanishes(difference: sp.Expr) -> bool:
    expr = sp.gammasimp(sp.expand_func(sp.expand_trig(difference).rewrite(sp.gamma)))
    expr = sp.powsimp(sp.powdenest(sp.expand_power_base(sp.together(sp.expand(expr)), force=True), force=True))
    numerator = sp.expand(sp.powsimp(sp.expand(sp.fraction(sp.together(expr))[0]), force=True))
    return bool(sp.expand(numerator.subs(sp.sin(phi) ** 2, 1 - sp.cos(phi) ** 2)) == 0)


Rows = tuple[tuple[Any, ...], ...]
"""Steps: number of the equation, claim, left side, right side."""


# fmt: off
def steps() -> tuple[Step, ...]:
    """The whole chain in the order of the chapter."""
    parts = (_inside(), _outside(), _load(), _graded_inside(), _graded_outside(), _graded_load())
    return tuple(Step(*row) for part in parts for row in part)


def _inside() -> Rows:
    reach = sp.sqrt(alpha**2 + beta**2)
    angle = sp.asin((s + beta) / reach)
    radicand = alpha**2 - 2 * beta * s - s**2
    lower = angle.args[0].subs(s, 0)
    in_angle = radicand.subs({alpha: sp.sqrt(a**2 - r**2), beta: r * sp.cos(phi)})
    return (
        ("(11.3)", "law of cosines about A", a**2 - (r + s * sp.cos(phi)) ** 2 - (s * sp.sin(phi)) ** 2, in_angle),
        ("(11.5)", "the square of the derivative of arcsin((s + beta)/sqrt(alpha^2 + beta^2))",
         sp.diff(angle, s) ** 2, 1 / radicand),
        ("(11.5)", "upper end, arcsin(1) = pi/2", angle.args[0].subs(s, reach - beta), sp.S.One),
        ("(11.5)", "lower end, sin/cos = beta/alpha (squared)", lower**2 / (1 - lower**2), (beta / alpha) ** 2),
        ("(11.6)", "beta changes sign over half a turn", r * sp.cos(phi + sp.pi), -r * sp.cos(phi)),
        ("(11.6)", "a full turn of pi/2", p0 * a / (sp.pi * E) * 2 * sp.pi * sp.pi / 2, sp.pi * p0 * a / E),
    )


def _outside() -> Rows:
    reach = sp.sqrt(alpha + beta**2)  # alpha stands for alpha^2, which is negative here
    sine = (s - beta) / reach
    total, depth = p0 * a / (sp.pi * E) * sp.pi * 2 * sp.asin(a / r), sp.pi * p0 * a / E
    return (
        ("(11.7)", "law of cosines about A outside",
         a**2 - (r - s * sp.cos(phi)) ** 2 - (s * sp.sin(phi)) ** 2, a**2 - r**2 + 2 * r * sp.cos(phi) * s - s**2),
        ("(11.9), (11.10)", "the square of the derivative of arcsin((s - beta)/sqrt(alpha^2 + beta^2))",
         sp.diff(sp.asin(sine), s) ** 2, 1 / (alpha + 2 * beta * s - s**2)),
        ("(11.10)", "upper end, arcsin(1)", sine.subs(s, beta + reach), sp.S.One),
        ("(11.10)", "lower end, arcsin(-1)", sine.subs(s, beta - reach), sp.S.NegativeOne),
        ("(11.11)", "the chord shrinks to a point at sin(phi) = a/r",
         (a**2 - r**2 + r**2 * (1 - z**2)).subs(z, a / r), sp.S.Zero),
        ("(11.11)", "pi over an angle of 2 arcsin(a/r)", total, 2 / E * p0 * a * sp.asin(a / r)),
        ("(11.12)", "in terms of the depth", total, 2 / sp.pi * depth * sp.asin(a / r)),
    )


def _load() -> Rows:
    rising = -2 * sp.pi * p0 * a**2 * sp.sqrt(1 - r**2 / a**2)
    force, depth = rising.subs(r, a) - rising.subs(r, 0), sp.pi * p0 * a / E
    return (
        ("(11.13)", "derivative of the force inside r",
         sp.diff(rising, r), p0 / sp.sqrt(1 - r**2 / a**2) * 2 * sp.pi * r),
        ("(11.13)", "between its ends", force, 2 * sp.pi * p0 * a**2),
        ("(11.14)", "force over depth", force / depth, 2 * a * E),
        ("(11.15)", "pressure in terms of the depth (squared)",
         p0**2 / (1 - r**2 / a**2), (E * depth / sp.pi) ** 2 / (a**2 - r**2)),
    )


def _graded_inside() -> Rows:
    """With lengths in units of reach, q = beta/reach: int (y - q)**-k (1 - y**2)**((k-1)/2) dy over (q, 1)."""
    mapped = (q + v) / (1 + q * v)
    constant = p0 * a ** (1 - k) * sp.cos(k * sp.pi / 2) / (sp.pi * H)
    return (
        ("(11.38)", "y - q under the map", mapped - q, v * (1 - q**2) / (1 + q * v)),
        ("(11.38)", "1 - y^2 under the map", 1 - mapped**2, (1 - q**2) * (1 - v**2) / (1 + q * v) ** 2),
        ("(11.38)", "dy/dv under the map", sp.diff(mapped, v), (1 - q**2) / (1 + q * v) ** 2),
        ("(11.38)", "power of 1 + q v that is left", k - 2 * (k - 1) / 2 - 2, sp.S.NegativeOne),
        ("(11.38)", "power of 1 - q^2 that is left", -k + (k - 1) / 2 + 1, (1 - k) / 2),
        ("(11.38)", "both directions: even part of 1/(1 + q v)",
         (1 / (1 + q * v) + 1 / (1 - q * v)) / 2, 1 / (1 - (q * v) ** 2)),
        ("(11.38)", "odd part of 1/(1 + q v)", (1 / (1 + q * v) - 1 / (1 - q * v)) / 2, -q * v / (1 - (q * v) ** 2)),
        ("(11.38)", "even part: the integral over u = v^2 is a Beta function, times 2F1(1, (1-k)/2; 1; q^2)",
         HALF * sp.beta((1 - k) / 2, (1 + k) / 2), sp.pi / (2 * sp.sin(sp.pi * (1 + k) / 2))),
        ("(11.38)", "sin(pi (1 + k)/2) = cos(pi k/2)", sp.sin(sp.pi / 2 + sp.pi * k / 2), sp.cos(sp.pi * k / 2)),
        ("(11.38)", "2F1(1, b; 1; z) is the binomial series of (1 - z)^-b",
         _ratio((1, (1 - k) / 2), (1,)), ((1 - k) / 2 + m) / (1 + m)),
        ("(11.38)", "odd part: the integral over u = v^2 is a Beta function", HALF * sp.beta(1 - k / 2, (1 + k) / 2),
         sp.gamma(1 - k / 2) * sp.gamma((1 + k) / 2) / sp.sqrt(sp.pi)),
        ("(11.38)", "exponent of Euler's transformation of 2F1(1, 1 - k/2; 3/2; q^2)",
         sp.Rational(3, 2) - 1 - (1 - k / 2), -(1 - k) / 2),
        ("(11.39)", "a full turn of the even part",
         constant * 2 * sp.pi * sp.pi / (2 * sp.cos(k * sp.pi / 2)), sp.pi * p0 * a ** (1 - k) / H),
    )


def _ratio(upper: tuple[sp.Expr, ...], lower: tuple[sp.Expr, ...]) -> sp.Expr:
    """Term m + 1 over term m of a hypergeometric series, its power of z left out."""
    return sp.Mul(*(sp.sympify(b) + m for b in upper)) / (sp.Mul(*(sp.sympify(c) + m for c in lower)) * (1 + m))


def _graded_outside() -> Rows:
    """Mean over a ring of radius t: sum of ((e)_m/m!)**2 (t/r)**(2 m), e = (1 + k)/2; then int over t term by term."""
    e = (1 + k) / 2
    coefficient = (sp.gamma(e + m) / (sp.gamma(e) * sp.gamma(1 + m))) ** 2
    ring = sp.beta(m + 1, e) / 2  # of t**(2 m + 1) (1 - t**2)**((k - 1)/2) over (0, 1)
    term = coefficient * ring
    ratio = sp.gammasimp((term.subs(m, m + 1) / term).rewrite(sp.gamma))
    constant = p0 * sp.cos(k * sp.pi / 2) / (sp.pi * H)  # p = p0 a^(1-k) (a^2 - t^2)^((k-1)/2)
    first = constant * 2 * sp.pi * a ** (1 - k) * a ** (1 + k) / r ** (1 + k) / (1 + k)
    depth = sp.pi * p0 * a ** (1 - k) / H
    return (
        ("(11.43)", "ratio of the integrated terms is that of 2F1(e, e; e + 1)", ratio, _ratio((e, e), (e + 1,))),
        ("(11.43)", "first term", term.subs(m, 0), 1 / (1 + k)),
        ("(11.43)", "factor of the series", first,
         2 * sp.cos(k * sp.pi / 2) * p0 * a ** (1 - k) / (H * (1 + k)) * (a / r) ** (k + 1)),
        ("(11.44)", "in terms of the depth", first,
         2 * depth * sp.cos(k * sp.pi / 2) / (sp.pi * (1 + k)) * (a / r) ** (k + 1)),
        ("(11.11)", "for k = 0 the series is that of arcsin(a/r)",
         _ratio((e, e), (e + 1,)).subs(k, 0), (2 * m + 1) ** 2 / (2 * (m + 1) * (2 * m + 3))),
    )


def _graded_load() -> Rows:
    rising = -2 * sp.pi * p0 * a**2 / (1 + k) * x ** ((1 + k) / 2)  # x = 1 - r^2/a^2
    depth, force = sp.pi * p0 * a ** (1 - k) / H, 2 * sp.pi * p0 * a**2 / (1 + k)
    edge = sp.Symbol("edge", positive=True)  # a^2 - r^2
    return (
        ("(11.45)", "derivative of the force inside r by r^2/a^2",
         -sp.diff(rising, x), p0 * x ** ((k - 1) / 2) * sp.pi * a**2),
        ("(11.45)", "at the lower end", -rising.subs(x, 1), force),
        ("(11.46)", "force over depth", force / depth, 2 * H / (1 + k) * a ** (1 + k)),
        ("(11.47)", "pressure in terms of the depth",
         p0 * (edge / a**2) ** ((k - 1) / 2), H * depth / (sp.pi * edge ** ((1 - k) / 2))),
    )
