"""The master integrals against their definitions, by routes that share nothing with `numeric`."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp

from axiderive.abel.masters import (
    C0,
    MASTERS,
    ArctanIntegral,
    CapMoment,
    Dawson,
    Eta,
    Hypergeometric,
    IncompleteBeta,
    Kummer,
    LegendreChi2,
    StruveH,
    StruveL,
    Xi,
    gamma_normalised,
)

DIGITS = 40
STEP = mp.mpf("1e-20")


def c0(b, r, a):
    """t**2 = max(b, r)**2 + y**2."""
    large, small = max(b, r), min(b, r)

    def integrand(y):
        t = mp.sqrt(large**2 + y**2)
        if r >= b:
            return mp.atan(mp.sqrt(t**2 - b**2) / b) / t
        return mp.atan(y / b) * y / (t * mp.sqrt(t**2 - small**2))

    return mp.quad(integrand, mp.linspace(0, mp.sqrt(a**2 - large**2), 5))


def incomplete_beta(z, p, q):
    """u = v**(1/p)."""
    return mp.quad(lambda v: (1 - v ** (1 / p)) ** (q - 1) / p, [0, z**p / 2, z**p])


def struve(nu, z, wave):
    """The integral of Poisson's kind for nu > -1/2, in v = u**(1 + 2 nu)."""
    scale = 2 * (z / 2) ** nu / (mp.sqrt(mp.pi) * mp.gamma(nu + mp.mpf(1) / 2))
    power = 1 + 2 * nu

    def integrand(v):
        u = v ** (1 / power)
        return wave(z * mp.cos(u)) * mp.sincpi(u / mp.pi) ** (2 * nu) / power

    return scale * mp.quad(integrand, mp.linspace(0, (mp.pi / 2) ** power, 5))


def dawson(x):
    return mp.quad(lambda u: mp.exp((u - x) * (u + x)), mp.linspace(0, x, 5))


def hypergeometric(p, q, c, z):
    """Euler's integral, t = v**(1/q)."""
    scale = mp.gamma(c) / (mp.gamma(q) * mp.gamma(c - q))
    return scale * mp.quad(lambda v: (1 - v ** (1 / q)) ** (c - q - 1) * (1 - z * v ** (1 / q)) ** -p / q, [0, 0.5, 1])


def kummer(p, c, z):
    scale = mp.gamma(c) / (mp.gamma(p) * mp.gamma(c - p))
    return scale * mp.quad(lambda v: mp.exp(z * v ** (1 / p)) * (1 - v ** (1 / p)) ** (c - p - 1) / p, [0, 0.5, 1])


def cap_moment(k, b, R, a):
    return mp.quad(lambda s: s / mp.sqrt(R**2 - s**2) * (a**2 - s**2) ** ((k - 1) / 2), mp.linspace(0, b, 7))


def oblate(r, z, t):
    return mp.sqrt(r * r + (z + 1j * t) ** 2)


# master, definition, points
TABLE = [
    (C0, c0, [("0.83", "0.61", "1.37"), ("0.83", "1.04", "1.37"), ("0.83", "0.8300001", "1.37"), ("0.01", "0.9", "1")]),
    (LegendreChi2, lambda x: mp.quad(lambda t: mp.atanh(t) / t, [0, x]), [("0.3",), ("0.97",)]),
    (ArctanIntegral, lambda x: mp.quad(lambda t: mp.atan(t) / t, [0, x / 2, x]), [("0.3",), ("1",), ("7.5",)]),
    (IncompleteBeta, incomplete_beta, [("0.7", "0.5", "-1.155"), ("0.999", "0.685", "0.3"), ("0.2", "3.5", "1")]),
    (StruveH, lambda nu, z: struve(nu, z, mp.sin), [("0", "2.603"), ("-0.3", "11.4"), ("1.185", "0.4")]),
    (StruveL, lambda nu, z: struve(nu, z, mp.sinh), [("0", "1.132"), ("1", "1.132"), ("0", "14.6")]),
    (Dawson, dawson, [("0.4",), ("1.5",), ("6",)]),
    (Hypergeometric, hypergeometric, [("0.5", "1", "1.685", "0.64"), ("0.5", "2", "2.7", "-9")]),
    (Kummer, kummer, [("1", "1.685", "-1.3"), ("2", "2.685", "-30")]),
    (Xi, lambda r, z, t: oblate(r, z, t).real, [("0.7", "0.4", "1.3"), ("2.1", "1e-9", "1.3"), ("0.01", "0.2", "3")]),
    (Eta, lambda r, z, t: oblate(r, z, t).imag, [("0.7", "0.4", "1.3"), ("2.1", "1e-9", "1.3"), ("0.01", "0.2", "3")]),
    (CapMoment, cap_moment, [("0.37", "0.6", "1.7", "1.1"), ("-0.6", "0.6", "0.9", "1.4")]),
]
CASES = [pytest.param(*row[:2], point, id=f"{row[0].__name__}-{'-'.join(point)}") for row in TABLE for point in row[2]]


def test_no_master_is_left_out():
    assert {row[0] for row in TABLE} == set(MASTERS)


@pytest.mark.parametrize(("master", "definition", "point"), CASES)
def test_value_is_the_defining_integral(master, definition, point):
    with mp.workdps(DIGITS + 15):
        exact = definition(*map(mp.mpf, point))
        assert abs(master.numeric(*map(mp.mpf, point)) / exact - 1) < mp.mpf(10) ** -DIGITS
        symbolic = master(*map(sp.Rational, point)).evalf(DIGITS)
        assert abs(mp.mpmathify(symbolic) / exact - 1) < mp.mpf(10) ** (1 - DIGITS)


@pytest.mark.parametrize(("master", "definition", "point"), CASES)
def test_derivative_is_that_of_the_definition(master, definition, point):
    """The last argument is differentiated, but of IncompleteBeta the first."""
    index = 0 if master is IncompleteBeta else len(point) - 1
    arguments = list(map(sp.Rational, point))
    place = sp.Symbol("place", positive=True)
    slope = sp.diff(master(*arguments[:index], place, *arguments[index + 1 :]), place).subs(place, arguments[index])
    with mp.workdps(DIGITS + 15):
        numbers = list(map(mp.mpf, point))
        moved = [[*numbers[:index], numbers[index] + step, *numbers[index + 1 :]] for step in (-STEP, STEP)]
        exact = (definition(*moved[1]) - definition(*moved[0])) / (2 * STEP)
        assert abs(mp.mpmathify(slope.evalf(DIGITS)) / exact - 1) < mp.mpf("1e-25")


def test_other_derivatives_stay_unevaluated():
    b, r, a = sp.symbols("b r a", positive=True)
    assert sp.diff(C0(b, r, a), r).has(sp.Derivative)
    assert sp.diff(IncompleteBeta(b, r, a), a).has(sp.Derivative)


def test_values_where_the_range_of_integration_is_empty_or_the_kernel_elementary():
    b, r, a, p, q = sp.symbols("b r a p q", positive=True)
    assert C0(b, r, b) == C0(b, a, a) == 0
    assert C0(0, r, a) == sp.pi / 2 * sp.acosh(a / r)
    assert LegendreChi2(0) == ArctanIntegral(0) == Dawson(0) == 0
    assert IncompleteBeta(0, p, q) == 0
    assert StruveH(0, 0) == StruveL(1, 0) == 0
    assert StruveH(-1, 0) != 0  # 2/pi


def test_c0_where_the_radius_meets_the_break():
    with mp.workdps(DIGITS):
        b, a, step = mp.mpf("0.83"), mp.mpf("1.37"), mp.mpf("1e-12")
        below, at, above = (C0.numeric(b, b + x, a) for x in (-step, mp.mpf(0), step))
        # continuous like x log(x): 16 steps are measured
        assert abs(below - at) < 30 * step
        assert abs(above - at) < 30 * step
        assert abs(at / c0(b, b, a) - 1) < mp.mpf("1e-38")


@pytest.mark.parametrize("shift", [-2, -1, 0, 1, 2, 3])
def test_gamma_is_shifted_into_the_first_unit_interval(shift):
    n = sp.Symbol("n", positive=True)
    argument = n / 2 + sp.Rational(1, 2) + shift
    shifted = gamma_normalised(argument)
    assert shifted.atoms(sp.gamma) == {sp.gamma(n / 2 + sp.Rational(1, 2))}
    point = {n: sp.Rational(37, 10)}
    assert abs(shifted.subs(point).evalf(30) / sp.gamma(argument.subs(point)).evalf(30) - 1) < sp.Float("1e-28")
