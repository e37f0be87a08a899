"""Where a contact stops being compact, and where complete contact of a concave face begins."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp

from axiderive import profiles
from axiderive.abel.masters import MASTERS
from axiderive.notation import E_star, H, R, a, d, h, k, n, r, r_zero, s, wavelength
from axiderive.physics.medium import GRADED
from axiderive.physics.normal import derive
from axiderive.profiles.compact import GAUSSIAN_LIMIT, WAVY_LIMIT

OWN = {master.__name__: master.numeric for master in MASTERS}


def compiled(expr, *arguments):
    return sp.lambdify(arguments, expr, [OWN, "mpmath"])


def slope_of_depth(name):
    (case,) = derive(profiles.load(name))["d"].cases
    return sp.diff(case.expr, a)


def test_gaussian_depth_is_largest_just_above_the_limit():
    """g' vanishes at the maximum of z D(z); the rule may not allow more than that, and should not allow less."""
    slope = compiled(slope_of_depth("gaussian").subs({h: 1, s: 1}), a)
    with mp.workdps(40):
        largest = mp.findroot(slope, (1.4, 1.6), solver="anderson")
        limit = mp.mpmathify(GAUSSIAN_LIMIT)
        assert 0 < largest - limit < mp.mpf("1e-16")
        assert all(slope(limit * i / 64) > 0 for i in range(1, 65))


def test_wavy_paraboloid_stays_compact_at_the_limit():
    """g' >= 0 for every a at the stated wavelength**2/(h R), and g' < 0 somewhere just below it."""
    slope = compiled(slope_of_depth("wavy_paraboloid").subs({R: 1, h: 1}), a, wavelength)
    with mp.workdps(40):
        wave = mp.sqrt(mp.mpmathify(WAVY_LIMIT))

        def bend(x):
            return mp.diff(lambda y: slope(y, wave) / y, x)

        first = mp.findroot(bend, (0.55 * wave, 0.7 * wave), solver="anderson")
        assert 0 <= slope(first, wave) < mp.mpf("1e-15")
        assert slope(first, wave * (1 - mp.mpf("1e-15"))) < 0
    # later waves are shallower against the growing 2 a/R
    with mp.workdps(15):
        assert all(slope(wave * mp.mpf(i) / 32, wave) > 0 for i in range(1, 320) if abs(wave * i / 32 - first) > 0.02)


def test_limit_of_the_wavy_paraboloid_by_struve_functions():
    """pi**3 times the depth of the lowest minimum of (H_0(z) + z (2/pi - H_1(z)))/z."""

    def curve(z):
        return (mp.struveh(0, z) + z * (2 / mp.pi - mp.struveh(1, z))) / z

    with mp.workdps(40):
        z = mp.findroot(lambda x: mp.diff(curve, x), 3.96)
        excess = mp.mpmathify(WAVY_LIMIT) + mp.pi**3 * curve(z)
        assert 0 < excess < mp.mpf("1e-15")
    assert min(curve(mp.mpf(i) / 8) for i in range(1, 400) if abs(i / 8 - z) > 1) > curve(z)


GRADED_LIMITS = {"gaussian": ("1.2286", "1.50198", "1.8788"), "wavy_paraboloid": ("15.5992", "12.3914", "10.1777")}


@pytest.mark.parametrize("name", GRADED_LIMITS)
def test_the_note_says_how_the_limit_depends_on_the_grading(name):
    """The largest radius of the bump and the least wavelength**2/(h R), from g' on the graded half-space."""
    (case,) = derive(profiles.load(name), GRADED)["d"].cases
    slope = sp.diff(case.expr, a)
    for exponent, printed in zip((-0.5, 0.0, 0.5), GRADED_LIMITS[name], strict=True):
        assert printed in profiles.load(name).note
        if name == "gaussian":
            rate = compiled(slope.subs({h: 1, s: 1, k: exponent}), a)
            limit = mp.findroot(rate, (1.1, 2.2), solver="anderson")
        else:
            # g' = A a/R - h B(q a) q: what the flat paraboloid and the waves of unit height bring in
            flat = compiled(slope.subs({h: 0, R: 1, wavelength: 1, k: exponent}), a)
            waves = compiled(slope.subs({h: 1, k: exponent}).subs(R, sp.oo), a, wavelength)
            limit = max(-waves(mp.mpf(i) / 2000, 1) / flat(mp.mpf(i) / 2000) for i in range(1100, 1400))
        assert abs(limit - mp.mpf(printed)) < mp.mpf("1e-4"), limit


@pytest.mark.parametrize(
    ("name", "ring", "depth", "force"),
    [
        ("concave_paraboloid", 0, 2 * h, sp.Rational(16, 3) * E_star * a * h),
        ("concave_quartic", a / 2, sp.Rational(4, 3) * h, sp.Rational(56, 15) * E_star * a * h),
    ],
)
def test_least_depth_and_force_of_complete_contact(name, ring, depth, force):
    """For n = 4 the pressure vanishes first on the ring r = a/2, not at the centre."""
    entries = derive(profiles.load(name))
    found = [entries[suffix].cases[0].expr for suffix in ("rz", "dmin", "Fmin")]
    assert [sp.expand(x - y) for x, y in zip(found, (ring, depth, force), strict=True)] == [0, 0, 0]


@pytest.mark.parametrize(("exponent", "ring", "name"), [(2, 0, "concave_paraboloid"), (4, a / 2, "concave_quartic")])
def test_general_exponent_agrees_with_the_special_faces(exponent, ring, name):
    general, special = derive(profiles.load("concave_power")), derive(profiles.load(name))
    for suffix in ("dmin", "Fmin"):
        at_exponent = general[suffix].cases[0].expr.subs({n: exponent, r_zero: ring})
        assert sp.expand(sp.expand_func(at_exponent) - special[suffix].cases[0].expr) == 0
    for suffix, place in (("F", 0), ("p", sp.Rational(3, 10)), ("w", sp.Rational(17, 10))):
        values = {a: 1, h: 1, d: 3, E_star: 1, r: place}
        exact = special[suffix].cases[0].expr.subs(values)
        assert abs((general[suffix].cases[0].expr.subs({n: exponent}).subs(values) - exact).evalf(30)) < sp.Float(
            "1e-28"
        )


def general_ring(exponent):
    """r_0/a from the equation of the general face, with a = 1."""
    above = next(case for case in derive(profiles.load("concave_power"))["rz"].cases if case.chain[-1] == n)
    scale = r_zero ** (exponent - 1) * (exponent * (1 - r_zero**2) - 1)  # no pole, and finite at the centre
    gap = compiled((above.expr.lhs - above.expr.rhs).subs({a: 1, n: exponent}) * scale, r_zero)
    return mp.findroot(gap, (0.1, mp.sqrt(1 - 1 / mp.mpf(float(exponent))) - 0.001), solver="anderson")


@pytest.mark.parametrize("exponent", [sp.Rational(5, 2), sp.Integer(3), sp.Integer(4), sp.Integer(9)])
def test_pressure_at_the_least_depth_touches_zero_on_the_ring_only(exponent):
    entries = derive(profiles.load("concave_power"))
    with mp.workdps(40):
        ring = general_ring(exponent)
        if exponent == 4:
            assert abs(ring - mp.mpf(1) / 2) < mp.mpf("1e-35")
        fixed = {a: 1, h: 1, E_star: 1, n: exponent}
        depth = compiled(entries["dmin"].cases[0].expr.subs(fixed), r_zero)(ring)
        pressure = compiled(entries["p"].cases[0].expr.subs(fixed), r, d)
        assert abs(pressure(ring, depth)) < mp.mpf("1e-35")
        assert all(pressure(mp.mpf(i) / 40, depth) > 0 for i in range(1, 40) if abs(mp.mpf(i) / 40 - ring) > 0.001)
        force = compiled(entries["F"].cases[0].expr.subs(fixed), d)(depth)
        assert abs(compiled(entries["Fmin"].cases[0].expr.subs(fixed), r_zero)(ring) / force - 1) < mp.mpf("1e-35")


def test_graded_quartic_face_has_its_ring_at_a_fraction_of_the_grading():
    """r_0**2/a**2 = (1 - k)/4, and k = 0 is the homogeneous half-space."""
    graded, plain = (derive(profiles.load("concave_quartic"), *medium) for medium in ((GRADED,), ()))
    assert sp.expand(graded["rz"].cases[0].expr ** 2 - a**2 * (1 - k) / 4) == 0
    for suffix in ("dmin", "Fmin"):
        limit = graded[suffix].cases[0].expr.subs({k: 0, H: E_star})
        assert sp.expand(limit - plain[suffix].cases[0].expr) == 0
