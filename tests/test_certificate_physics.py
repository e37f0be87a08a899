"""Certificates of graded, adhesive, tangential and viscoelastic contact, of prescribed pressures, and k -> 0."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
import sympy as sp
from certificates import CELLS, DERIVE, Entries, expected
from selected import few

from axiderive import notation as nt
from axiderive import profiles
from axiderive.physics import adhesive, loads, normal, tangential, viscoelastic
from axiderive.physics.medium import GRADED, HOMOGENEOUS
from axiderive.profiles.loads import LOADS
from axiderive.profiles.profile import Profile
from axiderive.proof.algebra.domain import NotProvedError
from axiderive.proof.certificate import certify, certify_profile
from axiderive.proof.rules import graded
from axiderive.proof.rules import viscoelastic as laws
from axiderive.proof.rules.compact import Compact
from axiderive.proof.rules.complete import Complete

# every build proves all of them, and .ci/run compares the evidence of one from nothing
PROVED = [pytest.param(*cell, marks=() if cell[1] in ("cone", "flat_punch") else pytest.mark.sweep) for cell in CELLS]


@pytest.mark.parametrize(("kind", "name"), PROVED)
def test_every_closed_formula_is_proved(kind: str, name: str) -> None:
    found = DERIVE[kind](profiles.load(name))
    certificates = certify_profile(profiles.load(name), found)
    assert set(certificates) == set(found)
    for suffix, certificate in certificates.items():
        assert certificate.key == found[suffix].key
        assert certificate.proved == expected(found[suffix], found), f"{found[suffix].text()}\n{certificate.reason}"
        assert certificate.steps if certificate.proved else certificate.reason


@pytest.mark.parametrize("load", LOADS, ids=lambda load: load.name)
def test_displacement_of_a_prescribed_pressure_is_proved(load: Profile) -> None:
    certificate = certify(load, loads.derive(load), "w")
    assert certificate.proved, certificate.reason
    assert len(certificate.steps) == 2


# the limit k -> 0


LIMITS = [
    *((normal.derive, name) for name in profiles.NAMES),
    *((module.derive, name) for module in (adhesive, tangential) for name in profiles.COMPACT_NAMES),
    *((adhesive.detachment, name) for name in ("flat_punch", "concave_power", "concave_quartic")),
]


@pytest.mark.parametrize(
    ("derive", "name"), few(LIMITS, [one for one in LIMITS if one[1] in ("cone", "rounded_punch", "concave_power")])
)
def test_the_homogeneous_half_space_is_the_limit(derive: Callable[..., Entries], name: str) -> None:
    profile = profiles.load(name)
    soft, plain = derive(profile, GRADED), derive(profile)
    below = statements(profile)
    for suffix in soft:
        statuses = {soft[suffix].status, plain[suffix].status}
        if statuses in ({"closed"}, {"root"}):
            assert graded.homogeneous_limit(suffix, soft, plain, below)
        else:
            with pytest.raises(NotProvedError, match="no pair of formulas or equations"):
                graded.homogeneous_limit(suffix, soft, plain, below)


def statements(profile: Profile) -> Compact | Complete:
    found = normal.derive(profile)
    return Compact(profile, found) if profile.contact == "compact" else Complete(profile, found)


@pytest.mark.parametrize("name", ["power_law", "sphere", "truncated_cone", "gaussian"])
def test_another_limit_is_refused(name: str) -> None:
    profile = profiles.load(name)
    soft, plain, below = normal.derive(profile, GRADED), normal.derive(profile), statements(profile)
    for suffix in ("d", "F"):
        (case,) = soft[suffix].cases
        for factor in (2, 1 + nt.k / 2 + sp.Rational(1, 10**9)):
            wrong = replace(soft[suffix], cases=(replace(case, expr=case.expr * factor),))
            with pytest.raises(NotProvedError, match="does not hold"):
                graded.homogeneous_limit(suffix, {**soft, suffix: wrong}, plain, below)


# the laws of viscoelasticity


@pytest.mark.parametrize("law", viscoelastic.LAWS, ids=lambda law: law.name)
def test_laws_are_dual_and_their_ramp_factors_are_integrals(law: viscoelastic.Law) -> None:
    assert laws.duality(law)
    assert laws.ramp(law)


@pytest.mark.parametrize("law", viscoelastic.LAWS, ids=lambda law: law.name)
def test_corrupted_laws_are_refused(law: viscoelastic.Law) -> None:
    for part in ("creep", "relaxation"):
        for wrong in (2 * getattr(law, part), getattr(law, part).subs(nt.time, 2 * nt.time), getattr(law, part) ** 2):
            if wrong == getattr(law, part):  # a constant modulus
                continue
            with pytest.raises(NotProvedError):
                laws.duality(replace(law, **{part: wrong}))
    for wrong in (law.ramp * 2, law.ramp.subs(laws.POWER, laws.POWER + 1), law.ramp + law.impulse + nt.E):
        with pytest.raises(NotProvedError):
            laws.ramp(replace(law, ramp=wrong))


def test_the_normal_contact_below_is_proved_on_its_own_half_space() -> None:
    """A graded entry is compared with the graded normal contact, never with the homogeneous one."""
    profile = profiles.load("cone")
    assert GRADED.k != HOMOGENEOUS.k
    soft, plain = adhesive.derive(profile, GRADED), adhesive.derive(profile)
    mixed = {**soft, "F": replace(soft["F"], cases=plain["F"].cases)}
    assert not certify(profile, mixed, "F").proved
