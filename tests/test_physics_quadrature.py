"""Graded, adhesive, tangential, viscoelastic contact and prescribed pressures against their definitions; units.

Each check must also fail: an entry with a changed factor, exponent or sign is not passed.
"""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from functools import lru_cache

import mpmath as mp
import pytest
import sympy as sp
from selected import drawn, few

from axiderive import notation as nt
from axiderive import profiles
from axiderive.checks import quadrature, units
from axiderive.checks.checks import check_problem
from axiderive.checks.comparison import Comparison
from axiderive.checks.viscoelastic import material
from axiderive.entry import Case, Entry
from axiderive.physics import systems
from axiderive.profiles.profile import Profile
from axiderive.proof import certificate

SYSTEMS = {
    "graded": systems.BY_NAME["graded.normal"],
    "adhesive": systems.BY_NAME["adhesive"],
    "graded adhesive": systems.BY_NAME["graded.adhesive"],
    "tangential": systems.BY_NAME["tangential"],
    "graded tangential": systems.BY_NAME["graded.tangential"],
    "viscoelastic": systems.BY_NAME["viscoelastic"],
    "load": systems.BY_NAME["loads"],
}
LOAD = systems.PRESSURES.names


@lru_cache(maxsize=32)
def derived(physics: str, name: str) -> tuple[Profile, dict[str, Entry]]:
    system = SYSTEMS[physics]
    profile = system.pool.load(name)
    return profile, system.derive(profile)


def check(physics: str, name: str, suffix: str, changed: Entry | None = None, **options: int):
    profile, entries = derived(physics, name)
    entries = entries if changed is None else {**entries, suffix: changed}
    return quadrature.check(Comparison(profile, entries, SYSTEMS[physics].physics, **options), suffix)


QUICK = [
    ("graded", "paraboloid", "d F w k pm ad aF Fd dF p"),
    ("graded", "truncated_cone", "d F aF"),
    ("graded", "capped_cylinder", "F w dF"),
    ("graded", "power_law", "d F w Fd"),
    ("adhesive", "cone", "Dl d F p w ad aF ac Fc dc am Fm dm"),
    ("adhesive", "truncated_paraboloid", "d F w ad aF ac Fc am dm"),
    ("graded adhesive", "paraboloid", "Dl d F w ad aF ac Fc dc am Fm dm"),
    ("graded adhesive", "sphere", "d F ac Fc am dm"),
    ("tangential", "paraboloid", "F tau u c us"),
    ("tangential", "truncated_cone", "F u c us"),
    ("graded tangential", "cone", "F u c us"),
    ("viscoelastic", "cone", "ramp_mx step_kv load_sls load_pc"),
    ("viscoelastic", "sphere", "step_mx load_kv step_pc"),
    ("viscoelastic", "flat_punch", "ramp_mx ramp_kv ramp_sls ramp_pc"),
    *(("load", name, "w") for name in LOAD),
]


DEFINED = [(physics, name, suffix) for physics, name, some in QUICK for suffix in some.split()]
"""The build has compared all of them, and `test_catalogue` asks for its checks by digest."""


@pytest.mark.parametrize(("physics", "name", "suffix"), drawn(DEFINED, 12))
def test_entry_is_its_definition(physics, name, suffix):
    evidence = check(physics, name, suffix, points=2)
    assert evidence.passed, evidence
    assert evidence.count >= 1
    json.dumps(asdict(evidence))


MUTANTS = [
    ("graded", "paraboloid", "d", lambda x: x.subs(nt.k, nt.k + sp.Rational(1, 10**30))),
    ("graded", "paraboloid", "F", lambda x: x * (1 + sp.Rational(1, 10**35))),
    ("graded", "paraboloid", "w", lambda x: x * sp.cos(nt.k / 10**18)),
    ("graded", "paraboloid", "p", lambda x: x * (1 + sp.Rational(1, 10**20))),
    ("graded", "paraboloid", "aF", lambda x: x * (1 + sp.Rational(1, 10**35))),
    ("adhesive", "truncated_cone", "d", lambda x: x.subs(nt.dgamma, nt.dgamma * 2)),
    ("adhesive", "cone", "p", lambda x: x.subs(nt.dgamma, nt.dgamma * (1 + sp.Rational(1, 10**30)))),
    ("adhesive", "truncated_cone", "ac", lambda x: sp.Eq(x.lhs, x.rhs * (1 + sp.Rational(1, 10**30)))),
    ("adhesive", "cone", "am", lambda x: x * 3),
    ("graded adhesive", "paraboloid", "Fc", lambda x: x * (3 - nt.k) / (3 + nt.k)),
    ("tangential", "paraboloid", "tau", lambda x: x * (1 + sp.Rational(1, 10**30))),
    ("tangential", "truncated_cone", "c", lambda x: sp.Eq(x.lhs * (1 + sp.Rational(1, 10**30)), x.rhs)),
    ("graded tangential", "cone", "u", lambda x: x.subs(nt.H_x, nt.H)),
    ("viscoelastic", "cone", "ramp_mx", lambda x: x * (1 + sp.Rational(1, 10**15))),
    ("viscoelastic", "cone", "load_pc", lambda x: x.subs(nt.alpha, nt.alpha / 2)),
    ("viscoelastic", "sphere", "step_mx", lambda x: sp.Eq(x.lhs * (1 + sp.Rational(1, 10**20)), x.rhs)),
    ("load", "power", "w", lambda x: x.subs(nt.sigma, nt.sigma + sp.Rational(1, 10**30))),
]


@pytest.mark.parametrize(("physics", "name", "suffix", "mutate"), MUTANTS, ids=["-".join(row[:3]) for row in MUTANTS])
def test_changed_formula_fails(physics, name, suffix, mutate):
    entry = derived(physics, name)[1][suffix]
    changed = replace(entry, cases=tuple(Case(case.chain, mutate(case.expr)) for case in entry.cases))
    evidence = check(physics, name, suffix, changed, points=2)
    assert not evidence.passed


def test_creep_and_relaxation_belong_together():
    values = {
        nt.E: sp.Rational(7, 5), nt.eta: sp.Rational(3, 2), nt.relaxation: sp.Rational(2, 3),
        nt.E_inf: sp.Rational(4, 5), nt.E_1: sp.Rational(9, 4), nt.alpha: sp.Rational(2, 5), nt.t_0: sp.Rational(5, 3),
    }  # fmt: skip
    with mp.workdps(80):
        for law in ("mx", "kv", "sls", "pc"):
            for time in ("0.3", "2.1"):
                assert abs(material(law, values).convolution(mp.mpf(time), 45) - 1) < mp.mpf(10) ** -40
        wrong = replace(material("sls", values), initial=material("mx", values).initial)
        assert abs(wrong.convolution(mp.mpf(1), 45) - 1) > mp.mpf("1e-3")


UNITS_OF = ("paraboloid", "truncated_cone", "power")
EVERYWHERE = [
    (physics, name)
    for physics in SYSTEMS
    for name in (LOAD if physics == "load" else profiles.NAMES)
    if physics in ("load", "graded", "viscoelastic") or name in profiles.COMPACT_NAMES
]


@pytest.mark.parametrize(
    ("physics", "name"),
    few(EVERYWHERE, [row for row in EVERYWHERE if row[1] in UNITS_OF]),
)
def test_units(physics, name):
    profile, entries = derived(physics, name)
    assert all(evidence.passed for evidence in units.check_profile(profile, entries).values())
    suffix, entry = next(iter(entries.items()))
    wrong = replace(entry, cases=tuple(Case(case.chain, with_a_length_more(case.expr)) for case in entry.cases))
    assert not units.check(profile, {suffix: wrong}, suffix).passed


def with_a_length_more(expr: sp.Expr) -> sp.Expr:
    return sp.Eq(expr.lhs * nt.a, expr.rhs) if isinstance(expr, sp.Eq) else expr * nt.a


def test_units_of_a_limit_of_integration():
    """On the graded half-space the regularised variable is a power of a length, the same at both limits."""
    profile, entries = derived("graded", "truncated_cone")
    entry = entries["p"]
    wrong = replace(
        entry,
        cases=tuple(Case(case.chain, case.expr.replace(sp.Integral, _longer_lower_limit)) for case in entry.cases),
    )
    assert units.check(profile, entries, "p").passed
    assert not units.check(profile, {"p": wrong}, "p").passed


def _longer_lower_limit(function: sp.Expr, limits: sp.Tuple) -> sp.Expr:
    variable, lower, upper = limits
    return sp.Integral(function, (variable, lower or nt.b**2, upper**2))


# every check of a problem, as the build calls them

SAMPLE = (
    "cone.adh", "cone.tan", "cone.fgm", "paraboloid.fgm.adh", "cone.fgm.tan", "concave_paraboloid.fgm",
    "cone.vis", "plane.parabola", "plane.eccentric_punch", "loads.power",
)  # fmt: skip
EVIDENCE = {"digits": 50, "points": 2, "seed": 5}


def all_evidence(key: str) -> None:
    """Every entry has a certificate or the reason why not, a comparison that passed, and none that failed."""
    problem = systems.problem(key)
    entries = problem.derive()
    certificates = certificate.certify_profile(problem.profile, entries)
    checks = check_problem(problem, entries, **EVIDENCE)
    assert [check for check in checks if check.outcome == "failed"] == []
    for suffix, entry in entries.items():
        own = [check for check in checks if check.key == entry.key]
        assert certificates[suffix].steps if certificates[suffix].proved else certificates[suffix].reason
        assert any(check.passed and check.worst for check in own), f"{entry.key} was not compared with anything"


@pytest.mark.parametrize("key", few(SAMPLE, ["plane.parabola", "loads.power"]))
def test_evidence_of_a_problem(key):
    all_evidence(key)


@pytest.mark.sweep
@pytest.mark.parametrize("key", [problem.key for problem in systems.problems()])
def test_evidence_of_every_problem(key):
    all_evidence(key)


CORRUPTED = (
    ("cone.adh", "am"), ("cone.tan", "us"), ("cone.fgm", "k"), ("cone.fgm.adh", "Dl"), ("cone.fgm.tan", "u"),
    ("cone.vis", "step_sls"), ("plane.wedge", "s"), ("plane.eccentric_punch", "phi"),
    ("plane.eccentric_punch", "cw"), ("loads.uniform", "w"),
)  # fmt: skip


@pytest.mark.parametrize(
    ("key", "suffix"),
    few(
        CORRUPTED,
        [("cone.vis", "step_sls"), ("plane.wedge", "s"), ("loads.uniform", "w")],
        pytest.mark.slow,
    ),
)
def test_a_corrupted_formula_fails_the_problem(key, suffix):
    problem = systems.problem(key)
    entries = problem.derive()
    entry = entries[suffix]
    wrong = tuple(Case(case.chain, case.expr * (1 + sp.Rational(1, 10**25))) for case in entry.cases)
    checks = check_problem(problem, {**entries, suffix: replace(entry, cases=wrong)}, **EVIDENCE)
    assert entry.key in {check.key for check in checks if check.outcome == "failed"}
