"""Arb balls of results and definitions: they overlap for the catalogue, and do not for a wrong formula."""

from __future__ import annotations

from dataclasses import replace

import mpmath as mp
import pytest
import sympy as sp
from flint import acb, ctx
from selected import few

from axiderive import notation as nt
from axiderive.abel import masters
from axiderive.checks.comparison import Comparison
from axiderive.checks.enclosure import ENCLOSED, check, check_profile
from axiderive.oracle.balls import FUNCTIONS, Ball, NotAvailableError, enclose, integral, shrinking
from axiderive.physics.normal import derive
from axiderive.profiles import NAMES, load

MISSING = {
    "sphere_tipped_cone": {"p"},
    "wavy_paraboloid": {"p", "w"},
    "gaussian": {"p", "w"},
    "flat_punch": {"p"},
    "capped_cylinder": {"p"},
    "concave_power": {"p"},
    "concave_paraboloid": {"p"},
    "concave_quartic": {"p"},
}


@pytest.mark.parametrize("name", few(NAMES, ["cone", "rounded_punch", "concave_power"]))
def test_result_and_definition_overlap(name: str) -> None:
    """To 40 digits, or a reason is given: which entries have none is part of the claim."""
    profile = load(name)
    evidence = {
        one.key.partition(".")[2]: one for one in check_profile(Comparison(profile, derive(profile), digits=40, seed=1))
    }
    assert set(evidence) <= set(ENCLOSED)
    for suffix, one in evidence.items():
        assert one.outcome == ("not available" if suffix in MISSING.get(name, ()) else "passed"), one
        assert one.reason if one.outcome == "not available" else one.digits >= 40


@pytest.mark.parametrize(("name", "suffix"), [("cone", "w"), ("rounded_punch", "p"), ("sphere", "F")])
def test_a_formula_wrong_in_its_38th_digit_fails(name: str, suffix: str) -> None:
    profile = load(name)
    entries = derive(profile)
    entry = entries[suffix]
    factor = 1 + sp.Rational(1, 10**38)
    entries[suffix] = replace(entry, cases=tuple(replace(c, expr=c.expr * factor) for c in entry.cases))
    evidence = check(Comparison(profile, entries, digits=40), suffix)
    assert evidence.outcome == "failed"
    assert evidence.worst == "1.0e-38"


MASTERS = [
    masters.C0(sp.Rational(1, 3), sp.Rational(1, 7), 1),
    masters.C0(sp.Rational(1, 3), sp.Rational(5, 7), 1),
    masters.LegendreChi2(sp.Rational(3, 4)),
    masters.ArctanIntegral(sp.Rational(13, 4)),
    masters.IncompleteBeta(sp.Rational(3, 4), sp.Rational(1, 2), sp.Rational(-7, 5)),
    masters.StruveH(0, sp.Rational(7, 2)),
    masters.StruveH(1, sp.Rational(7, 2)),
    masters.StruveL(1, sp.Rational(7, 2)),
    masters.Dawson(sp.Rational(7, 2)),
    sp.elliptic_f(sp.Rational(9, 10), sp.Rational(3, 10)),
    sp.elliptic_e(sp.Rational(9, 10), sp.Rational(3, 10)),
]


@pytest.mark.parametrize("expr", MASTERS, ids=str)
def test_masters_agree_with_mpmath(expr: sp.Expr) -> None:
    ball = enclose(expr, {}, 40)
    with mp.workdps(50):
        assert abs(mp.mpf(ball.mid().str(50, radius=False)) / mp.mpf(str(expr.evalf(50))) - 1) < mp.mpf(10) ** -40


def test_a_branch_cut_inside_a_box_is_noticed() -> None:
    """acos(x) across its branch point x = 1 must give no finite ball instead of a wrong one."""
    ctx.prec = 128
    crossing = integral(lambda x, analytic: FUNCTIONS[sp.acos](Ball({}, bool(analytic)), x), acb(0.5), acb(1.5))
    assert not crossing.is_finite() or crossing.rel_accuracy_bits() < 64


def test_what_arb_lacks_says_so() -> None:
    with pytest.raises(NotAvailableError, match="zeta"):
        enclose(sp.zeta(nt.a), {nt.a: sp.Rational(5, 2)}, 30)


def test_a_zero_has_no_relative_enclosure() -> None:
    with pytest.raises(NotAvailableError, match="zero"):
        shrinking(lambda: acb(2).sqrt() ** 2 - 2, 30)
