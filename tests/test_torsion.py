"""Torsion against what it was first solved with: Hankel integrals below a punch, Lubkin's angle under a sphere."""

from __future__ import annotations

from dataclasses import replace

import mpmath as mp
import pytest

from axiderive import notation as nt
from axiderive.entry import Entry
from axiderive.oracle.evaluate import case_at, evaluated
from axiderive.physics import torsion
from axiderive.profiles import COMPACT_NAMES, load
from axiderive.proof.certificate import certify

PUNCH, SPHERE = (torsion.derive(load(name)) for name in ("flat_punch", "paraboloid"))
KNOWN = {nt.a: mp.mpf(1), torsion.G: mp.mpf(2), torsion.twist: mp.mpf("0.1")}
SLIPPING = {nt.a: mp.mpf(1), nt.E_star: mp.mpf(3), torsion.G: mp.mpf(2), nt.R: mp.mpf(5), nt.mu: mp.mpf("0.4")}


def value(entry: Entry, known: dict) -> mp.mpf:
    return evaluated(case_at(entry, known).expr, known)


@pytest.mark.parametrize(("r", "z"), [("0.4", "0.7"), ("1.6", "0.9")])
def test_the_punch_is_the_hankel_integral(r: str, z: str) -> None:
    """Reissner and Sagoci: u = 4 beta/pi int (sin k - k cos k)/k^2 exp(-k z) J1(k r) dk; the stresses by Hooke."""
    r, z = mp.mpf(r), mp.mpf(z)
    scale = 4 * KNOWN[torsion.twist] / mp.pi

    def hankel(power: int, order: int) -> mp.mpf:
        return scale * mp.quad(
            lambda k: (mp.sin(k) - k * mp.cos(k)) * k ** (power - 2) * mp.exp(-k * z) * mp.besselj(order, k * r),
            [0, 1, 4, 12, 40, 100],
        )

    at = {**KNOWN, nt.r: r, torsion.z: z}
    shear = KNOWN[torsion.G]
    wanted = {"u": hankel(0, 1), "tz": -shear * hankel(1, 1), "rt": -shear * hankel(1, 2)}
    for suffix, number in wanted.items():
        assert abs(value(PUNCH[suffix], at) / number - 1) < 1e-12, suffix


def test_the_angle_is_that_of_lubkin() -> None:
    """beta = mu p_0/(2 G) (K - E), and it vanishes where nothing slips."""
    at = {**SLIPPING, nt.c: mp.mpf("0.6")}
    peak = 2 * at[nt.E_star] * at[nt.a] / (mp.pi * at[nt.R])
    m = 1 - at[nt.c] ** 2
    lubkin = at[nt.mu] * peak / (2 * at[torsion.G]) * (mp.ellipk(m) - mp.ellipe(m))
    assert abs(value(SPHERE["b"], at) / lubkin - 1) < 1e-13


@pytest.mark.parametrize("c", ["0.3", "0.9"])
def test_the_traction_adds_up_to_the_torque(c: str) -> None:
    """M = 2 pi int tau r^2 dr, on both sides of the edge of stick; at full slip its torque."""
    at = {**SLIPPING, nt.c: mp.mpf(c)}

    def moment(r: mp.mpf) -> mp.mpf:
        return 2 * mp.pi * r**2 * value(SPHERE["tau"], {**at, nt.r: r})

    with mp.workdps(12):
        total = mp.quad(moment, [0, at[nt.c]], maxdegree=4) + mp.quad(moment, [at[nt.c], 1])
    assert abs(value(SPHERE["M"], at) / total - 1) < 1e-6
    tiny = {**SLIPPING, nt.c: mp.mpf("1e-4")}
    assert abs(value(SPHERE["M"], tiny) / value(SPHERE["Ms"], tiny) - 1) < 1e-7


@pytest.mark.parametrize("suffix", ["b", "Ms"])
def test_closed_formulas_are_certified_and_wrong_ones_refused(suffix: str) -> None:
    profile = load("paraboloid")
    assert certify(profile, SPHERE, suffix).proved
    (case,) = SPHERE[suffix].cases
    wrong = replace(SPHERE[suffix], cases=(replace(case, expr=2 * case.expr),))
    assert not certify(profile, {**SPHERE, suffix: wrong}, suffix).proved


def test_profiles_without_entries_say_why() -> None:
    assert all(torsion.refusal(load(name)) for name in COMPACT_NAMES if name != "paraboloid")
    with pytest.raises(ValueError, match="slip angle"):
        torsion.derive(load("cone"))
