"""The quadrature of the definitions: against known closed forms, over the catalogue, and against wrong formulas."""

from __future__ import annotations

import itertools
from dataclasses import replace

import mpmath as mp
import pytest
import sympy as sp
from selected import few

from axiderive import notation as nt
from axiderive.checks.comparison import Comparison
from axiderive.checks.quadrature import TWICE, check
from axiderive.entry import Entry
from axiderive.oracle import rules
from axiderive.oracle.evaluate import case_at, evaluate
from axiderive.oracle.half_space import HalfSpace
from axiderive.oracle.integrals import GUARD, Homogeneous
from axiderive.oracle.rules import exponential_rule, gauss_rule, integrate, middle
from axiderive.oracle.sampling import NEARLY_ONE, NEARLY_ZERO, points
from axiderive.oracle.shape import number, shape
from axiderive.physics import DEPTH
from axiderive.physics.consequences import CONSEQUENCES
from axiderive.physics.normal import derive
from axiderive.profiles import NAMES, load

DIGITS = 50
# seconds each; the build checks them
SLOW = ("sphere_tipped_cone.p", "concave_power.rz", "concave_power.dmin", "concave_power.Fmin")
AGREEMENT = mp.mpf(10) ** -49
TAN = sp.tan(sp.Rational(2, 5))


@pytest.mark.parametrize(
    ("f", "exact", "singular"),
    [
        (lambda x: 1 / mp.sqrt(x), lambda: mp.mpf(2), (0j,)),
        (mp.log, lambda: mp.mpf(-1), (0j,)),
        (lambda x: mp.log(x) / (1 + x), lambda: -(mp.pi**2) / 12, (0j, -1 + 0j)),
        (lambda x: 1 / (NEAR + x), lambda: mp.log((1 + NEAR) / NEAR), (-1e-9 + 0j,)),
        (lambda x: 1 / (NEAR + x * x), lambda: mp.atan(1 / mp.sqrt(NEAR)) / mp.sqrt(NEAR), (3.16e-5j, -3.16e-5j)),
    ],
    ids=["root", "logarithm", "logarithm and pole", "near pole", "near pair of poles"],
)
def test_rules_deliver_the_digits_they_are_asked_for(f, exact, singular) -> None:
    with mp.workdps(DIGITS + GUARD):
        value = integrate(f, mp.mpf(0), mp.mpf(1), singular, DIGITS)
        assert abs(value / exact() - 1) < AGREEMENT


NEAR = mp.mpf(2) ** -30


def test_rules_integrate_one() -> None:
    """The exponential rule misses the tails beyond its reach, the Gauss rule nothing."""
    with mp.workdps(80):
        assert abs(mp.fsum(w for _, w in gauss_rule(40, mp.mp.prec)) - 1) < mp.mpf(10) ** -78
        assert abs(mp.fsum(w for _, w in exponential_rule(DIGITS, mp.mp.prec)) - 1) < AGREEMENT / 100


@pytest.mark.parametrize("ratio", [sp.Rational(1, 3), NEARLY_ZERO, NEARLY_ONE])
def test_cone_and_truncated_cone_against_the_book(ratio: sp.Expr) -> None:
    """Closed forms typed here, so that neither the engine nor its masters stand on both sides."""
    a = sp.Rational(7, 5)
    values = {nt.theta: sp.Rational(2, 5), nt.a: a, nt.r: a * ratio, nt.b: a * ratio}
    with mp.workdps(DIGITS + GUARD):
        a_, r = number(a), number(a * ratio)
        cone, cut = (Homogeneous(shape(load(name), values), mp.mpf(0), DIGITS) for name in ("cone", "truncated_cone"))
        tan = number(TAN)
        got_and_want = [
            (cone.pressure(a_, r), tan / 2 * mp.acosh(a_ / r)),
            (cut.depth(a_), tan * a_ * mp.acos(r / a_)),
            (
                cut.force(a_),
                tan * a_**2 * (mp.acos(r / a_) + r / a_ * mp.sqrt((a_ - r) * (a_ + r)) / a_),
            ),
        ]
        for got, want in got_and_want:
            assert abs(got / want - 1) < AGREEMENT


@pytest.mark.parametrize("name", few(NAMES, ["cone", "flat_punch"]))
def test_every_entry_agrees_with_its_definition(name: str) -> None:
    """Depth, force, pressure, displacement at the extremes; all else is covered by the build's own run."""
    profile = load(name)
    entries = derive(profile)
    for suffix in entries:
        if f"{name}.{suffix}" in SLOW:
            continue
        evidence = check(Comparison(profile, entries, points=3, seed=1), suffix)
        assert evidence.passed, evidence
        assert evidence.digits >= evidence.required >= (TWICE if suffix in CONSEQUENCES else DIGITS) - 10


def wrong(entry: Entry, change) -> Entry:
    return replace(entry, cases=tuple(replace(case, expr=change(case.expr)) for case in entry.cases))


MUTATIONS = {
    "factor off by 1e-38": lambda expr: expr * (1 + sp.Rational(1, 10**38)),
    "sign": lambda expr: -expr,
    "a for r": lambda expr: expr + (nt.a - nt.r) / 10**12 * nt.E_star / nt.a,
    "branch of the inverse cosine": lambda expr: expr.replace(sp.acos, lambda z: 2 * sp.pi - sp.acos(z)),
    "modulus for parameter": lambda expr: expr.replace(sp.elliptic_e, lambda phi, m: sp.elliptic_e(phi, sp.sqrt(m))),
}


@pytest.mark.parametrize(
    ("name", "suffix", "mutation"),
    [
        *itertools.product(["cone"], ["p"], ["factor off by 1e-38", "sign", "a for r"]),
        *(
            pytest.param("truncated_paraboloid", "p", name, marks=pytest.mark.slow)
            for name in ("factor off by 1e-38", "sign", "a for r")
        ),
        ("truncated_cone", "d", "branch of the inverse cosine"),
        ("truncated_cone", "F", "branch of the inverse cosine"),
        ("truncated_paraboloid", "p", "modulus for parameter"),
        ("sphere", "ad", "factor off by 1e-38"),
    ],
)
def test_a_wrong_formula_fails(name: str, suffix: str, mutation: str) -> None:
    profile = load(name)
    entries = derive(profile)
    if entries[suffix].status == "root":
        change = MUTATIONS[mutation]
        case = entries[suffix].cases[0]
        entries[suffix] = replace(
            entries[suffix], cases=(replace(case, expr=sp.Eq(change(case.expr.lhs), case.expr.rhs)),)
        )
    else:
        entries[suffix] = wrong(entries[suffix], MUTATIONS[mutation])
    evidence = check(Comparison(profile, entries, points=3, seed=1), suffix)
    assert evidence.outcome == "failed"
    assert evidence.worst_point


def test_swapped_regions_fail() -> None:
    """The right formulas in the wrong places: inside for outside of the break."""
    profile = load("rounded_punch")
    entries = derive(profile)
    inside, outside = entries["p"].cases
    swapped = (replace(inside, expr=outside.expr), replace(outside, expr=inside.expr))
    entries["p"] = replace(entries["p"], cases=swapped)
    with pytest.raises(ArithmeticError):
        check(Comparison(profile, entries, points=3, seed=1), "p")


def test_precision_doubling_is_not_fooled() -> None:
    """At t = 1e-107 the value is wrong by 6 % at 30, 60 and 120 digits alike, because 1 - t**2 rounds to 1."""
    n, t = sp.Symbol("n"), nt.r
    expr = sp.hyper((1 - n / 2, 1), (sp.Rational(3, 2),), (1 - t / nt.a) * (1 + t / nt.a))
    values = {n: sp.Rational(1011347697347023, 10**15), t: sp.Rational(10167, 10**111), nt.a: sp.Integer(1)}
    with mp.workdps(600):
        nu, x = number(values[n]), number(values[t])
        want = mp.hyp2f1(1 - nu / 2, 1, mp.mpf(3) / 2, (1 - x) * (1 + x))
    with mp.workdps(60):
        fooled = mp.hyp2f1(1 - nu / 2, 1, mp.mpf(3) / 2, (1 - x) * (1 + x))
    assert abs(fooled / want - 1) > 0.01
    assert abs(evaluate(expr, values, 30) / want - 1) < mp.mpf(10) ** -29


def test_points_keep_their_region_and_start_with_the_extremes() -> None:
    profile = load("truncated_cone")
    entry = derive(profile)["p"]
    for case in entry.cases:
        drawn = points(profile, case.chain, 8, 0, entry.quantity.arguments)
        assert [case_at(entry, point.values) for point in drawn] == [case] * 8
        assert [point.extreme for point in drawn[:5]] == [False, True, True, True, True]
        assert drawn == points(profile, case.chain, 8, 0, entry.quantity.arguments)


def test_a_point_on_a_border_has_no_case() -> None:
    entry = derive(load("cone"))["p"]
    with pytest.raises(LookupError, match="border"):
        case_at(entry, {nt.r: sp.Integer(1), nt.a: sp.Integer(1)})


@pytest.mark.parametrize("name", ["sphere", "gaussian", "wavy_paraboloid", "sphere_tipped_cone", "power_law"])
def test_balls_compute_the_profile_as_mpmath_does(name: str) -> None:
    profile = load(name)
    point = points(profile, derive(profile)["d"].cases[-1].chain, 1, 3)[0]
    with mp.workdps(DIGITS), rules.at_working_precision():
        for piece in shape(profile, point.values).stretches:
            place = piece.lo / 3 + piece.hi * 2 / 3
            got = middle(piece.bend_ball(rules.ball(place)))
            assert abs(got / piece.bend(place) - 1) < mp.mpf(10) ** (3 - DIGITS)


def test_rules_sum_balls_as_numbers() -> None:
    with mp.workdps(DIGITS + GUARD), rules.at_working_precision():
        for lo, hi, singular in ((mp.mpf(0), mp.mpf(1) / 2, (0j, 2 + 0j)), (mp.mpf(1) / 3, mp.mpf(1), (2 + 0j,))):
            numbers = integrate(lambda x: mp.sqrt(x) / mp.sqrt(2 - x), lo, hi, singular, DIGITS)
            balls = integrate(lambda x: x.sqrt() / (2 - x).sqrt(), lo, hi, singular, DIGITS, panel=rules.sum_over_balls)
            assert abs(balls / numbers - 1) < mp.mpf(10) ** (-DIGITS - 20)


def test_a_function_that_balls_lack_is_named() -> None:
    with pytest.raises(ValueError, match="has the function erf"):
        rules.bound(sp.erf(nt.r), nt.r, {})(rules.ball(mp.mpf(1)))


def test_a_value_does_not_depend_on_what_was_evaluated_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """The difference of two near integrals to its last bit: the oracle may not add up by what symbols are called."""
    near = [sp.Integral(DEPTH(nt.t), (nt.t, 0, end)) for end in (nt.a, nt.a + nt.r)]
    point = {nt.a: sp.Rational(5, 2), nt.r: sp.Rational(1, 10**9)}
    found = set()
    for made in (98, 99):
        monkeypatch.setattr(sp.Dummy, "_count", made)
        with mp.workdps(20):
            here = HalfSpace(load("cone"), point, 40, graded=False, known={DEPTH: mp.sin})
            found.add(here.defined(near[1] - near[0]))
    assert len(found) == 1
