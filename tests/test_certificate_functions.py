"""What the proofs of graded contact add: bounded symbols, families of special functions, stated integrals."""

from __future__ import annotations

import mpmath as mp
import pytest
import sympy as sp
from certificates import entries
from selected import few

from axiderive import notation as nt
from axiderive.abel.masters import CapMoment, Hypergeometric, IncompleteBeta, Kummer, StruveH, StruveL
from axiderive.proof.algebra import special
from axiderive.proof.algebra.domain import Domain, NotProvedError
from axiderive.proof.algebra.functions import require_analytic, sign
from axiderive.proof.algebra.identity import at, is_zero
from axiderive.proof.algebra.tower import spelled
from axiderive.proof.rules import graded
from axiderive.proof.statement import require_integral

KAPPA = graded.KAPPA
BOUNDED = Domain((nt.r, nt.a), *graded.BOUNDS)


def test_the_exponent_of_grading_is_between_its_bounds() -> None:
    assert sign(2 - KAPPA, BOUNDED) == 1
    assert sign(KAPPA**2 - 2 * KAPPA, BOUNDED) == -1
    assert sign(KAPPA - 1, BOUNDED) == 0
    assert sign(3 - 2 * KAPPA, BOUNDED) == 0
    assert sign(nt.a - nt.r * (KAPPA - 1), BOUNDED) == 1
    assert sign(sp.cos(sp.pi * (KAPPA - 1) / 2), BOUNDED) == 1
    assert sign(sp.cos(sp.pi * KAPPA / 2), BOUNDED) == 0
    assert sign(1 - sp.exp(-nt.a), BOUNDED) == 1
    assert sign(1 - sp.exp(nt.a), BOUNDED) == 0


def test_end_values_ask_for_the_sign_of_the_exponent() -> None:
    """k is positive in notation but may be -1/2: a**k must not vanish at a = 0."""
    assert at(nt.a ** (2 - KAPPA), nt.a, sp.S.Zero, BOUNDED) == 0
    for exponent in (KAPPA - 1, 1 - KAPPA):
        with pytest.raises(NotProvedError, match="finite"):
            at(nt.a**exponent, nt.a, sp.S.Zero, BOUNDED)
    assert all(not graded.in_kappa(case.expr).has(nt.k) for case in entries("graded", "cone")["p"].cases)


def test_fractional_exponents_have_one_spelling() -> None:
    n, k = nt.n, KAPPA
    assert spelled(2 * k / (k + 2) + 4 / (k + 2)) == 2
    assert spelled(n / (n + k)) - spelled(-k / (n + k)) == 1
    assert is_zero((nt.a**n * nt.r**k) ** (1 / (n + k)) * nt.a ** (k / (n + k)) - nt.a * nt.r ** (k / (n + k)), BOUNDED)


Z, HALF = sp.Symbol("z", positive=True), sp.S.Half
UNIT = Domain((Z, 1))
FAMILIES = [
    *(Hypergeometric(HALF + i, j, sp.Rational(17, 10) + m, z) for i in (0, 1) for j in (1, 2, 3) for m in (0, 1, 2)
      for z in (Z, -Z)),
    *(Kummer(i, sp.Rational(8, 5) + m, -Z) for i in (1, 2, 3) for m in (-1, 0, 1, 2)),
    *(Kummer(i, sp.Rational(3, 2) + m, -Z) for i in (1, 2) for m in (0, 1)),
    *(head(sp.Rational(m, 2) - sp.Rational(1, 5), Z) for head in (StruveH, StruveL) for m in (-4, -3, -1, 3, 5)),
    CapMoment(0, Z, nt.R, nt.a),
]  # fmt: skip


@pytest.mark.parametrize("function", few(FAMILIES, FAMILIES[::3], pytest.mark.slow), ids=str)
def test_contiguity_relations_keep_the_value(function: sp.Expr) -> None:
    """36 digits of 40: relations are subtractions of neighbours."""
    domain = Domain((Z, 1), (Z, nt.R), (Z, nt.a))
    other = special.respelled(function.func, list(function.args), lambda expr: sign(expr, domain))
    other = function if other is None else other
    values = {Z: sp.Rational(3, 7), nt.R: sp.Integer(2), nt.a: sp.Integer(3)}
    with mp.workdps(40):
        one, two = (sp.N(expr.subs(values), 40) for expr in (function, other))
    assert abs(one - two) < 1e-36 * abs(one)


def test_a_sphere_capped_at_the_edge_is_a_sphere() -> None:
    """The moment with b = a; its own quadrature divides by a - b."""
    k, b, R = sp.Rational(1, 5), sp.Rational(3, 7), sp.Integer(2)
    value = sp.N(special.respelled(CapMoment, [k, b, R, b], lambda expr: 1), 40)
    with mp.workdps(40):
        # s = b cos(x)
        kernel = lambda s, width: s * width**k / mp.sqrt(R**2 - s**2)  # noqa: E731
        wanted = mp.quad(lambda x: kernel(b * mp.cos(x), b * mp.sin(x)), [0, mp.pi / 2])
        assert abs(mp.mpf(str(value)) - wanted) < mp.mpf(10) ** -36


def refused(expr: sp.Expr, domain: Domain) -> bool:
    try:
        return not is_zero(expr, domain)
    except NotProvedError:
        return True


def test_neighbours_are_one_function() -> None:
    """A relation that holds is seen, one that does not is not: members of a family are one generator."""
    c = KAPPA + sp.Rational(3, 2)
    first, next_ = (Hypergeometric(HALF, 1, c + i, Z) for i in (0, 1))
    domain = Domain((Z, 1), *graded.BOUNDS)
    assert is_zero((1 - Z) * c * first - c + (c - HALF) * Z * next_, domain)
    assert refused((1 - Z) * c * first - c + (c + HALF) * Z * next_, domain)
    order = KAPPA / 2
    three = [StruveH(order + i, Z) for i in (-1, 0, 1)]
    source = (Z / 2) ** order / (sp.sqrt(sp.pi) * sp.gamma(order + sp.Rational(3, 2)))
    assert is_zero(three[0] + three[2] - 2 * order / Z * three[1] - source, domain)
    assert refused(three[0] - three[2] - 2 * order / Z * three[1] - source, domain)


@pytest.mark.parametrize(("p", "q"), list(special.ELEMENTARY))
def test_special_values_by_derivative_and_end(p: sp.Expr, q: sp.Expr) -> None:
    wanted = special.ELEMENTARY[p, q](Z)
    assert is_zero(IncompleteBeta(Z, p, q) - wanted, UNIT)
    assert not is_zero(IncompleteBeta(Z, p, q) - wanted * sp.Rational(101, 100), UNIT)


@pytest.mark.parametrize(
    "function",
    [
        Hypergeometric(sp.Rational(1, 3), sp.Rational(3, 4), sp.Rational(9, 5), Z),
        Hypergeometric(HALF, 1, sp.Rational(8, 5), -Z),
        StruveH(sp.Rational(1, 4), 3 * Z),
        StruveL(sp.Rational(1, 4), 3 * Z),
        sp.elliptic_e(Z),
        sp.elliptic_k(Z),
    ],
    ids=str,
)
def test_stated_integrals_are_the_functions(function: sp.Expr) -> None:
    t = sp.Symbol("t", positive=True)
    found = special.integrand(function, t)
    assert found is not None
    kernel, margins = found
    assert all(margin.subs(Z, sp.Rational(2, 5)) > 0 for margin in margins)
    with mp.workdps(30):
        kernel = kernel.subs(Z, sp.Rational(2, 5))
        lower, upper = (sp.lambdify(t, f, "mpmath") for f in (kernel, kernel.subs(t, sp.sqrt(1 - t**2))))
        total = mp.quad(lower, [0, mp.mpf(1) / 2])
        # 1 - t^2 = x^2 next to the upper end
        total += mp.quad(lambda x: upper(x) * x / mp.sqrt(1 - x**2), [0, mp.sqrt(3) / 2])
        wanted = sp.N(function.subs(Z, sp.Rational(2, 5)), 30)
        assert abs(total - mp.mpf(str(wanted))) < mp.mpf(10) ** -12 * total


def test_integrals_that_do_not_exist_or_differ_are_refused() -> None:
    t = nt.t
    domain = Domain((t, 1), (Z, 1))
    kernel = sp.sqrt(1 - Z * t**2) / sp.sqrt(1 - t**2)
    assert require_integral(3 * sp.elliptic_e(Z), 3 * kernel, t, domain)
    for expr in (sp.elliptic_k(Z), 2 * sp.elliptic_e(Z), sp.elliptic_e(Z) + Z, sp.elliptic_e(Z) ** 2):
        with pytest.raises(NotProvedError):
            require_integral(expr, kernel, t, domain)
    with pytest.raises(NotProvedError, match="not shown to exist"):
        require_integral(Hypergeometric(HALF, 2, 2, Z), kernel, t, domain)


@pytest.mark.parametrize(
    "expr",
    [Hypergeometric(HALF, 1, 2, 1 + nt.a), Kummer(1, -nt.a, nt.r), CapMoment(nt.k, nt.a, nt.R, nt.r), sp.elliptic_k(2)],
)
def test_functions_outside_their_range_are_refused(expr: sp.Expr) -> None:
    with pytest.raises(NotProvedError):
        require_analytic(expr, BOUNDED)
