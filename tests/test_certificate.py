"""What is proved, what is refused, and the parts of the prover on their own."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from selected import few

from axiderive import notation as nt
from axiderive import profiles
from axiderive.notation import F, R, a, b, n, r, x
from axiderive.physics.normal import derive
from axiderive.proof.algebra.domain import Domain, NotProvedError
from axiderive.proof.algebra.functions import canonical, normal, require_analytic, sign
from axiderive.proof.algebra.identity import at, is_zero, logarithmic
from axiderive.proof.certificate import certify, certify_profile

# an equation whose root is shown to be the place of least pressure
PROVED_ROOT = "concave_power.rz"
ORDERED = Domain((r, b, a), (a, R))


@pytest.mark.parametrize("name", few(profiles.NAMES, ["cone", "truncated_cone", "hyperboloid", "concave_power"]))
def test_every_closed_formula_is_proved(name: str) -> None:
    entries = derive(profiles.load(name))
    certificates = certify_profile(profiles.load(name), entries)
    assert set(certificates) == set(entries)
    for suffix, certificate in certificates.items():
        entry = entries[suffix]
        expected = entry.status == "closed" or entry.key == PROVED_ROOT
        assert certificate.key == entry.key
        assert certificate.proved == expected, f"{entry.text()}\n{certificate.reason}"
        assert certificate.steps if expected else certificate.reason


def test_a_single_certificate_is_that_of_the_whole_profile() -> None:
    profile = profiles.load("rounded_cone")
    entries = derive(profile)
    assert certify(profile, entries, "p") == certify_profile(profile, entries)["p"]


def test_what_rests_on_an_unproved_depth_is_not_proved() -> None:
    profile = profiles.load("cone")
    entries = derive(profile)
    entries["d"] = replace(entries["d"], primitives={})
    assert certify(profile, entries, "F").reason == "rests on cone.d, which is not proved"


def test_nonsense_gives_a_reason_and_no_exception() -> None:
    profile = profiles.load("cone")
    entries = derive(profile)
    for expr in (sp.nan, sp.zoo, sp.I * a, sp.besselj(0, a), sp.Symbol("q"), a ** (a**a), sp.log(-a)):
        case = replace(entries["F"].cases[0], expr=expr)
        certificate = certify(profile, {**entries, "F": replace(entries["F"], cases=(case,))}, "F")
        assert not certificate.proved
        assert certificate.reason


@pytest.mark.parametrize("missing", [0, 1])
def test_a_missing_regime_is_refused(missing: int) -> None:
    profile = profiles.load("rounded_cone")
    entries = derive(profile)
    for suffix in ("d", "F", "p", "w"):
        cases = [case for i, case in enumerate(entries[suffix].cases) if i != missing]
        assert not certify(profile, {**entries, suffix: replace(entries[suffix], cases=tuple(cases))}, suffix).proved


def test_sign_of_a_polynomial_follows_from_the_order_of_lengths() -> None:
    assert sign(a**2 - b**2, ORDERED) == 1
    assert sign(r - b, ORDERED) == -1
    assert sign(2 * b**2 - a**2, ORDERED) == 0
    assert sign(n - 1, Domain((1, n))) == 1


def test_sign_of_a_sum_of_radicals() -> None:
    U, V = sp.sqrt(a**2 - r**2), sp.sqrt(R**2 - r**2)
    assert sign(R + V - a - U, ORDERED) == 1
    assert sign(a - U, ORDERED) == 1
    assert sign(U - b, ORDERED) == 0


def test_two_lower_bounds_without_order_are_refused() -> None:
    with pytest.raises(NotProvedError, match="order of the lower bounds b, r of a"):
        Domain((r, a), (b, a))


@pytest.mark.parametrize(
    ("radical", "plain"),
    [
        (sp.sqrt((a**2 - b**2) / (a + b)), sp.sqrt(a - b)),
        (sp.sqrt(a + R - 2 * sp.sqrt(a * R)), sp.sqrt(R) - sp.sqrt(a)),
        (1 / (a + sp.sqrt(a**2 - r**2)), (a - sp.sqrt(a**2 - r**2)) / r**2),
        ((8 * a**n) ** sp.Rational(1, 3) * a ** (-n / 3), sp.Integer(2)),
        (sp.sinh(sp.asinh(4 * (a / b) ** 3 + 3 * a / b) / 3), a / b),
        (sp.gamma(n + sp.Rational(5, 2)), (n + sp.Rational(3, 2)) * (n + sp.S.Half) * sp.gamma(n + sp.S.Half)),
    ],
)
def test_zero_test_sees_equal_radicals(radical: sp.Expr, plain: sp.Expr) -> None:
    assert is_zero(radical - plain, ORDERED)
    assert not is_zero(radical - plain * (1 + sp.Rational(1, 10**9)), ORDERED)


def test_addition_laws_are_found_by_one_more_derivative() -> None:
    y = (a - b) / (R**2 - a * b) * R
    assert is_zero(sp.atanh(a / R) - sp.atanh(b / R) - sp.atanh(y), ORDERED)
    assert is_zero(sp.acos(b / a) - sp.asin(sp.sqrt(a**2 - b**2) / a), ORDERED)
    assert not is_zero(sp.acos(b / a) - sp.asin(sp.sqrt(a**2 - b**2) / a) - sp.pi / 10**6, ORDERED)


def test_end_values_are_refused_where_a_part_is_infinite() -> None:
    with pytest.raises(NotProvedError, match="finite"):
        at((R - a) * sp.atanh(a / R), a, R)
    with pytest.raises(NotProvedError, match="finite"):
        at((a - b) / (a**2 - b**2), a, b)
    with pytest.raises(NotProvedError, match="finite"):
        at(a ** (n - 1), a, sp.S.Zero)
    assert at(sp.acos(b / a) * sp.sqrt(a**2 - b**2), a, b) == 0


def test_logarithmic_singularities_that_cancel_disappear() -> None:
    """The displacement of the sphere-tipped cone has a removable singularity at a = R."""
    difference = sp.atanh(a / R) - sp.atanh(sp.sqrt(a**2 - b**2) / sp.sqrt(R**2 - b**2))
    with pytest.raises(NotProvedError):
        at(difference, a, R)
    value = at(logarithmic(difference, ORDERED), a, R)
    face = Domain((r, b, R))
    assert is_zero(logarithmic(value - sp.log(R) + sp.log(R**2 - b**2) / 2, face), face)


@pytest.mark.parametrize(
    "expr",
    [sp.sqrt(b - a), 1 / (2 * b - a), sp.acos(a / b), sp.acosh(r / a), sp.log(b - a), sp.atanh(a / r), sp.zeta(a)],
)
def test_poles_and_branch_points_inside_the_region_are_refused(expr: sp.Expr) -> None:
    with pytest.raises(NotProvedError):
        require_analytic(expr, ORDERED)


def test_canonical_form_is_one_text() -> None:
    one = sp.atanh(sp.sqrt((a**2 - b**2) / (R**2 - b**2)))
    other = sp.atanh(sp.sqrt(a - b) * sp.sqrt(a + b) / sp.sqrt(R**2 - b**2))
    assert canonical(one, ORDERED) == canonical(other, ORDERED)
    assert normal(x * (a + b) / (a**2 - b**2), Domain((b, a))) == x / (a - b)


def test_force_of_a_shifted_argument_is_not_the_force() -> None:
    """F(a) with the right derivative but for a profile of another scale: only the depth tells them apart."""
    profile = profiles.load("paraboloid")
    entries = derive(profile)
    case = replace(entries["aF"].cases[0], expr=entries["aF"].cases[0].expr.subs(F, 2 * F))
    assert not certify(profile, {**entries, "aF": replace(entries["aF"], cases=(case,))}, "aF").proved
    assert nt.E_star in entries["aF"].cases[0].expr.free_symbols
