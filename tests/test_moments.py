"""The moments of the Abel kernels against their definitions."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp
from selected import few

from axiderive.abel import moments
from axiderive.abel.form import Form
from axiderive.abel.masters import MASTERS
from axiderive.notation import a, b, k, r

DIGITS = 30
POINT = {a: mp.mpf("1.37"), b: mp.mpf("0.83"), r: mp.mpf("0.61")}
OUTSIDE = POINT | {r: mp.mpf("1.83")}
RING = POINT | {r: mp.mpf("1.04")}
GRADINGS = ["0", "1/3", "-3/5"]
POWERS = ["0", "1", "2", "5", "-1/2", "1/2", "131/100"]


def number(expr: sp.Expr, values: dict[sp.Symbol, mp.mpf]) -> mp.mpf:
    own = {master.__name__: master.numeric for master in MASTERS}
    return mp.mpmathify(sp.lambdify(list(values), expr, [own, "mpmath"])(*values.values()))


def quad(integrand, start, end):
    return mp.quad(integrand, mp.linspace(start, end, 3))


def agree(form: Form, values: dict[sp.Symbol, mp.mpf], exact: mp.mpf) -> None:
    assert abs(number(form.expr(), values) / exact - 1) < mp.mpf(10) ** -DIGITS


def real(text: str) -> mp.mpf:
    return mp.mpf(sp.Rational(text).p) / sp.Rational(text).q


@pytest.mark.parametrize("grading", few(GRADINGS, ["0", "-3/5"], pytest.mark.slow))
@pytest.mark.parametrize("power", POWERS)
@pytest.mark.parametrize("lower", [sp.S.Zero, b], ids=["tip", "break"])
def test_depth_moment(power, lower, grading):
    """int_lo^a x**s (a^2 - x^2)**((k-1)/2) dx, in x**(1+s) below the middle and (a^2 - x^2)**((1+k)/2) above."""
    with mp.workdps(50):
        q, p, top, lo = (1 + real(grading)) / 2, real(power), POINT[a], POINT[b] if lower != 0 else mp.mpf(0)
        middle = (lo + top) / 2
        below = quad(lambda y: (top**2 - y ** (2 / (1 + p))) ** (q - 1) / (1 + p), lo ** (1 + p), middle ** (1 + p))
        above = quad(
            lambda v: mp.sqrt(top**2 - v ** (1 / q)) ** (p - 1) / (2 * q), mp.mpf(0), (top**2 - middle**2) ** q
        )
        agree(moments.depth_moment(sp.Rational(power), lower, sp.Rational(grading)), POINT, below + above)


@pytest.mark.parametrize("grading", few(GRADINGS, ["0", "-3/5"], pytest.mark.slow))
@pytest.mark.parametrize("power", POWERS)
def test_pressure_moment(power, grading):
    """int_r^a t**s (t^2 - r^2)**((k-1)/2) dt in v = (t^2 - r^2)**((1+k)/2)."""
    with mp.workdps(50):
        q, p, top, low = (1 + real(grading)) / 2, real(power), POINT[a], POINT[r]
        exact = quad(lambda v: mp.sqrt(low**2 + v ** (1 / q)) ** (p - 1) / (2 * q), mp.mpf(0), (top**2 - low**2) ** q)
        agree(moments.pressure_moment(sp.Rational(power), sp.Rational(grading)), POINT, exact)


@pytest.mark.parametrize("name", ["depth_moment", "pressure_moment"])
@pytest.mark.parametrize("grading", GRADINGS[1:])
def test_symbolic_grading_is_the_same_moment(name, grading):
    moment, power = getattr(moments, name), sp.Rational(131, 100)
    arguments = (power, b) if name == "depth_moment" else (power,)
    with mp.workdps(50):
        exact = number(moment(*arguments, sp.Rational(grading)).expr(), POINT)
        agree(moment(*arguments, k), POINT | {k: real(grading)}, exact)


@pytest.mark.parametrize("place", [POINT, RING], ids=["r < b", "b < r"])
@pytest.mark.parametrize("order", [0, 2, 4, 6])
def test_elliptic_and_arccos_moments(order, place):
    """int t**n / sqrt((t^2 - b^2)(t^2 - r^2)) dt and int t**n acos(b/t) / sqrt(t^2 - r^2) dt in t^2 = max^2 + y^2."""
    with mp.workdps(50):
        large, small = max(place[b], place[r]), min(place[b], place[r])
        end, inside = mp.sqrt(place[a] ** 2 - large**2), place[r] < place[b]

        def other(t):
            return mp.sqrt(t**2 - small**2)

        def arc(y):
            t = mp.sqrt(large**2 + y**2)
            if inside:
                return t ** (order - 1) * y * mp.atan(y / place[b]) / other(t)
            return t ** (order - 1) * mp.atan(other(t) / place[b])

        def elliptic(y):
            t = mp.sqrt(large**2 + y**2)
            return t ** (order - 1) / other(t)

        agree(moments.elliptic_moment(order, b, inside), place, quad(elliptic, mp.mpf(0), end))
        agree(moments.arccos_moment(order, b, inside), place, quad(arc, mp.mpf(0), end))


@pytest.mark.parametrize("lower", [sp.S.Zero, b], ids=["tip", "break"])
@pytest.mark.parametrize("order", range(6))
def test_outside_moment(order, lower):
    """sqrt(r^2 - a^2) int s**n / ((r^2 - s^2) sqrt(a^2 - s^2)) ds in s = a sin(u)."""
    with mp.workdps(50):
        top, place = OUTSIDE[a], OUTSIDE[r]
        start = mp.asin(OUTSIDE[b] / top) if lower != 0 else mp.mpf(0)
        integral = quad(lambda u: (top * mp.sin(u)) ** order / (place**2 - (top * mp.sin(u)) ** 2), start, mp.pi / 2)
        agree(moments.outside_moment(order, lower), OUTSIDE, mp.sqrt(place**2 - top**2) * integral)


@pytest.mark.parametrize("grading", GRADINGS)
def test_outside_kernel(grading):
    """int_0^a t**k (r^2 - t^2)**(-(1+k)/2) dt in y = t**(1+k)."""
    with mp.workdps(50):
        q, place = 1 + real(grading), OUTSIDE[r]
        exact = quad(lambda y: (place**2 - y ** (2 / q)) ** (-q / 2) / q, mp.mpf(0), OUTSIDE[a] ** q)
        agree(moments.outside_kernel(sp.Rational(grading)), OUTSIDE, exact)
