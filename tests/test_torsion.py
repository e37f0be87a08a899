"""Torsion against what it was first solved with: Hankel integrals below a punch, Lubkin's angle under a sphere."""

from __future__ import annotations

from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from false_entries import below, record

from axicontact.torsion import flat_punch, paraboloid
from axiderive import notation as nt
from axiderive.entry import Entry
from axiderive.oracle.evaluate import case_at, evaluated
from axiderive.physics import torsion
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, load
from axiderive.proof.certificate import certify
from axiderive.verifier.problem import Problem

PUNCH, SPHERE = (torsion.derive(load(name)) for name in ("flat_punch", "paraboloid"))
KNOWN = {nt.a: mp.mpf(1), torsion.G: mp.mpf(2), torsion.twist: mp.mpf("0.1")}
SLIPPING = {nt.a: mp.mpf(1), nt.E_star: mp.mpf(3), torsion.G: mp.mpf(2), nt.R: mp.mpf(5), nt.mu: mp.mpf("0.4")}
GIVEN = {"R": 5.0, "E_star": 3.0, "mu": 0.4}
"""The same of the module; the angle takes G besides."""


def value(entry: Entry, known: dict) -> mp.mpf:
    return evaluated(case_at(entry, known).expr, known)


def below_the_face(suffix: str, r: object, z: object) -> mp.mpf:
    return value(PUNCH[suffix], {**KNOWN, nt.r: mp.mpf(r), nt.z: mp.mpf(z)})


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

    shear = KNOWN[torsion.G]
    wanted = {"ut": hankel(0, 1), "tz": -shear * hankel(1, 1), "rt": -shear * hankel(1, 2)}
    for suffix, number in wanted.items():
        assert abs(below_the_face(suffix, r, z) / number - 1) < 1e-12, suffix


@pytest.mark.parametrize(("r", "z"), [("0.4", "0.7"), ("1.6", "0.05")])
def test_rings_below_the_punch_are_in_equilibrium(r: str, z: str) -> None:
    """d rt/dr + d tz/dz + 2 rt/r = 0, where no stress is stated by an integral."""
    with mp.workdps(40):
        r, z = mp.mpf(r), mp.mpf(z)
        along = mp.diff(lambda x: below_the_face("rt", x, z), r)
        down = mp.diff(lambda y: below_the_face("tz", r, y), z)
        assert abs((along + down) / below_the_face("rt", r, z) * r / 2 + 1) < 1e-15


def test_every_plane_below_the_punch_carries_its_torque() -> None:
    """M = -2 pi int tz r^2 dr at a depth; beyond a large radius r rings carry 3 z/(2 r) of it."""
    z, cut = mp.mpf("0.8"), [0, 1, 4, 20, 200, 10**4, 10**8]
    with mp.workdps(40):
        total = mp.quad(lambda r: -2 * mp.pi * r**2 * below_the_face("tz", r, z), cut)
        assert abs(total / value(PUNCH["M"], KNOWN) - 1) < 2 * z / cut[-1]


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


def test_full_slip_is_the_moment_of_the_pressure() -> None:
    """M = 2 pi mu int p r^2 dr under p = 2 E*/(pi R) sqrt(a^2 - r^2)."""
    unit = 2 * SLIPPING[nt.E_star] / (mp.pi * SLIPPING[nt.R])
    total = mp.quad(lambda r: 2 * mp.pi * SLIPPING[nt.mu] * unit * mp.sqrt(1 - r * r) * r * r, [0, 1])
    assert abs(value(SPHERE["Ms"], SLIPPING) / total - 1) < 1e-13


def test_a_ring_that_just_slips_turns_the_disc_like_a_punch() -> None:
    """As c -> a the angle is beta = pi mu p_0/(8 G) (1 - c^2/a^2) and the torque that of a punch without slip."""
    at = {**SLIPPING, nt.c: 1 - mp.mpf("1e-7")}
    angle, torque = value(SPHERE["b"], at), value(SPHERE["M"], at)
    peak = 2 * at[nt.E_star] / (mp.pi * at[nt.R])
    assert abs(angle / (mp.pi * at[nt.mu] * peak / (4 * at[torsion.G]) * mp.mpf("1e-7") / 1) - 1) < 1e-6
    assert abs(torque / (mp.mpf(16) / 3 * at[torsion.G] * angle) - 1) < 1e-6


CLOSED = [*(("paraboloid", s) for s in ("b", "Ms")), *(("flat_punch", s) for s in ("M", "ut", "tz", "rt"))]


@pytest.mark.parametrize(("name", "suffix"), CLOSED)
def test_closed_formulas_are_proved_twice_and_wrong_ones_by_none(name: str, suffix: str) -> None:
    profile, entries = load(name), SPHERE if name == "paraboloid" else PUNCH
    plain, key = Problem(below(f"{name}.tor")), f"{name}.tor"
    assert certify(profile, entries, suffix).proved
    assert Problem(record(key, entries), plain).prove(suffix) == ""
    (case,) = entries[suffix].cases
    # a factor, a length put in for another, and one more term
    other = {nt.a: nt.R} if name == "paraboloid" else {nt.a: 2 * nt.a}
    for expr in (2 * case.expr, case.expr.subs(other, simultaneous=True), case.expr + sp.Rational(1, 10**9) * nt.a):
        wrong = {**entries, suffix: replace(entries[suffix], cases=(replace(case, expr=expr),))}
        assert not certify(profile, wrong, suffix).proved
        assert Problem(record(key, wrong), plain).prove(suffix)


def test_profiles_without_entries_say_why() -> None:
    silent = [name for name in (*COMPACT_NAMES, *COMPLETE_NAMES) if name not in ("paraboloid", "flat_punch")]
    assert all(torsion.refusal(load(name)) for name in silent)
    with pytest.raises(ValueError, match="a paraboloid has one"):
        torsion.derive(load("cone"))


RATIOS = ("1e-240", "1e-12", "1e-5", "0.01", "0.3", "0.7", "0.99", "0.99999", "0.999999999999")


@pytest.mark.parametrize("ratio", RATIOS)
@pytest.mark.parametrize("scale", [1e-60, 1.0, 1e60])
def test_the_module_keeps_its_digits_at_all_sizes_of_the_stick_zone(ratio: str, scale: float) -> None:
    """Everything scales with powers of a; the exact numbers are those of c as the module gets it."""
    a, c = scale, scale * float(ratio)
    with mp.workdps(40):
        share = mp.mpf(c) / mp.mpf(a)
        at = {**SLIPPING, nt.c: share, nt.mu: mp.mpf(GIVEN["mu"])}
        # a zone of stick this small takes nothing of the torque, and of the integral all digits
        torque = value(SPHERE["M" if share > mp.mpf("1e-6") else "Ms"], at)
    with mp.workdps(640):
        angle = value(SPHERE["b"], at)
    assert abs(paraboloid.slip_angle(a, c, G=2.0, **GIVEN) / scale / angle - 1) < 1e-14
    assert abs(paraboloid.torque(a, c, **GIVEN) / scale / scale / scale / scale / torque - 1) < 1e-13


@pytest.mark.parametrize("place", [1e-200, 1e-3, 0.2, 0.5, 0.5999999, 0.61, 0.9999999])
def test_the_traction_of_the_module_keeps_its_digits(place: float) -> None:
    with mp.workdps(30):
        at = {**SLIPPING, nt.c: mp.mpf(0.6), nt.mu: mp.mpf(GIVEN["mu"]), nt.r: mp.mpf(place)}
        wanted = value(SPHERE["tau"], at)
    assert abs(paraboloid.traction(place, 1.0, 0.6, **GIVEN) / wanted - 1) < 1e-13


def test_the_edges_of_what_the_module_is_given() -> None:
    """Nothing slips for c = a; for c = 0 all does: the torque is that of full slip, the angle without bound."""
    assert paraboloid.slip_angle(2.0, 2.0, G=1.0, **GIVEN) == paraboloid.torque(2.0, 2.0, **GIVEN) == 0.0
    assert paraboloid.torque(2.0, 0.0, **GIVEN) == pytest.approx(paraboloid.full_slip_torque(2.0, **GIVEN), rel=1e-14)
    assert paraboloid.slip_angle(2.0, 0.0, G=1.0, **GIVEN) == np.inf
    assert paraboloid.traction(3.0, 2.0, 1.0, **GIVEN) == 0.0
    with pytest.raises(ValueError, match="c <= a"):
        paraboloid.torque(1.0, 2.0, **GIVEN)


@pytest.mark.parametrize(("r", "z"), [(0.4, 0.7), (1e-8, 1e-8), (0.999999, 1e-9), (1.5, 0.0), (3.0, 1e5), (1e7, 1e3)])
@pytest.mark.parametrize("scale", [1e-60, 1.0, 1e80])
def test_the_field_of_the_module_keeps_its_digits(r: float, z: float, scale: float) -> None:
    with mp.workdps(80):
        exact = {s: below_the_face(s, mp.mpf(r * scale) / scale, mp.mpf(z * scale) / scale) for s in ("ut", "tz", "rt")}
    moved = flat_punch.displacement(r * scale, z * scale, a=scale, beta=0.1)
    stress = flat_punch.stress(r * scale, z * scale, a=scale, beta=0.1, G=2.0)
    for got, suffix in ((moved / scale, "ut"), (stress.tz, "tz"), (stress.rt, "rt")):
        assert abs(got - exact[suffix]) <= 2e-14 * abs(exact[suffix])


def test_on_the_surface_the_disc_turns_and_its_edge_is_singular() -> None:
    assert flat_punch.displacement(0.5, 0.0, a=1.0, beta=0.1) == pytest.approx(0.05, rel=1e-15)
    assert flat_punch.stress(0.5, 0.0, a=1.0, beta=0.1, G=2.0).rt == 0.0
    assert flat_punch.stress(1.5, 0.0, a=1.0, beta=0.1, G=2.0).tz == 0.0
    assert np.all(np.isnan(flat_punch.displacement([-1.0, 1.0], [1.0, -1.0], a=1.0, beta=0.1)))
