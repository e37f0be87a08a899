"""Fields below the surface: against point loads over the published pressure, exact recurrences and known results."""

from __future__ import annotations

import inspect
from importlib import import_module
from math import gamma, pi, sqrt
from typing import Any

import mpmath as mp
import numpy as np
import pytest
from selected import few
from test_interface import PARAMETERS

from axicontact import subsurface
from axicontact._runtime.subsurface.punches import (
    COSH,
    DISPLACEMENT,
    EXP,
    FRICTION,
    PLAIN,
    SINH,
    STRESS,
    TANH,
    Piece,
    polynomial,
    punch,
    superposed,
)
from axicontact._runtime.subsurface.stresses import frictional_stress, stress_below
from axicontact.normal import cone, paraboloid, rounded_punch
from axicontact.subsurface import SlidingStress, Stress, add, hydrostatic, principal, tresca, von_mises

PROFILES = [name for name in subsurface.__all__ if inspect.ismodule(getattr(subsurface, name))]
FIXED = ("flat_punch", "capped_cylinder", "concave_power", "concave_paraboloid", "concave_quartic")
KINKED = ("truncated_cone", "truncated_paraboloid", "capped_paraboloid")
E_STAR, NU, MU = 1.3, 0.3, 0.4


def contact(name: str) -> tuple[Any, Any, dict[str, Any], float, float]:
    """Modules of the fields and of the normal contact, geometry, what is given, and the radius."""
    geometry, a = PARAMETERS[name], 0.9
    given = 1.3 if name in FIXED else a
    return getattr(subsurface, name), import_module(f"axicontact.normal.{name}"), geometry, given, geometry.get("a", a)


def boussinesq(x: Any, y: Any, z: float) -> tuple[Any, ...]:
    """rr, tt, zz, rz at (x, y) from the point that a unit force presses on, as xx, yy, zz, zx."""
    rr, R = x * x + y * y, np.sqrt(x * x + y * y + z * z)
    along = (1 - 2 * NU) / (R * (R + z)) - 3 * z * rr / R**5
    around = -(1 - 2 * NU) * (1 / (R * (R + z)) - z / R**3)
    cc, ss = x * x / rr, y * y / rr
    found = (along * cc + around * ss, along * ss + around * cc, -3 * z**3 / R**5, -3 * x * z * z / R**5)
    return tuple(own / (2 * np.pi) for own in found)


def cerruti(x: Any, y: Any, z: float) -> tuple[Any, ...]:
    """xx, yy, zz, xy, zx, yz under a unit force along x."""
    R, k = np.sqrt(x * x + y * y + z * z), 1 - 2 * NU
    S = R + z
    xx = -3 * x**3 / R**5 + k * (x / R**3 - 3 * x / (R * S**2) + x**3 / (R**3 * S**2) + 2 * x**3 / (R**2 * S**3))
    yy = -3 * x * y * y / R**5 + k * (
        x / R**3 - x / (R * S**2) + x * y * y / (R**3 * S**2) + 2 * x * y * y / (R**2 * S**3)
    )
    xy = -3 * x * x * y / R**5 + k * (-y / (R * S**2) + x * x * y / (R**3 * S**2) + 2 * x * x * y / (R**2 * S**3))
    found = (xx, yy, -3 * x * z * z / R**5, xy, -3 * x * x * z / R**5, -3 * x * y * z / R**5)
    return tuple(own / (2 * np.pi) for own in found)


def loaded(name: str) -> tuple[Any, Any, Any]:
    """Places and weights over the contact, with the published pressure in the weights."""
    _, normal, geometry, given, a = contact(name)
    ends = [0.0, *(x for x in (geometry.get("b", 0.0), geometry.get("R", 0.0)) if 0.0 < x < a), a]
    if name == "sphere_tipped_cone":
        ends = [0.0, geometry["R"] * np.sin(geometry["theta"]), a]
    nodes, weights = np.polynomial.legendre.leggauss(160)
    turn = (1 + nodes) * np.pi / 2
    places, shares = [], []
    for low, high in zip(ends, ends[1:], strict=False):
        places.append(low + (high - low) * (1 - np.cos(turn)) / 2)
        shares.append((high - low) * np.sin(turn) * weights * np.pi / 4)
    s = np.concatenate(places)
    pressure = normal.pressure(s, given, E_star=E_STAR, **geometry)
    angle = 2 * np.pi * np.arange(240) / 240
    share = np.concatenate(shares) * s * pressure * 2 * np.pi / 240
    return np.outer(s, np.cos(angle)), np.outer(s, np.sin(angle)), share[:, None]


POINTS = ((0.4, 0.35), (1.3, 0.5), (0.9, 1.1))


@pytest.mark.parametrize("name", PROFILES)
def test_stresses_are_those_of_point_loads_over_the_published_pressure(name: str) -> None:
    fields, _, geometry, given, _ = contact(name)
    x, y, share = loaded(name)
    for r, z in POINTS:
        wanted = np.array([np.sum(share * own) for own in boussinesq(r - x, -y, z)])
        found = np.array(fields.stress(r, z, given, E_star=E_STAR, nu=NU, **geometry))
        # what a rule of the test makes of a pressure that is infinite at a kink or steep next to an edge
        loose = 2e-6 if name in KINKED else 1e-9
        assert np.abs(found - wanted).max() < loose * np.abs(wanted).max(), (r, z, found, wanted)


@pytest.mark.parametrize("name", few(PROFILES, ["cone", "flat_punch", "rounded_punch", "power_law"], pytest.mark.slow))
def test_friction_adds_the_stress_of_point_loads_along_the_surface(name: str) -> None:
    fields, _, geometry, given, _ = contact(name)
    x, y, share = loaded(name)
    for r, z in POINTS:
        phi = 0.7
        px, py = r * np.cos(phi), r * np.sin(phi)
        xx, yy, zz, xy, zx, yz = (MU * np.sum(share * own) for own in cerruti(px - x, py - y, z))
        c, s = np.cos(phi), np.sin(phi)
        rr, tt = xx * c * c + yy * s * s + 2 * xy * s * c, xx * s * s + yy * c * c - 2 * xy * s * c
        wanted = np.array([rr, tt, zz, (yy - xx) * s * c + xy * (c * c - s * s), zx * c + yz * s, yz * c - zx * s])
        found = np.array(fields.sliding_stress(r, phi, z, given, E_star=E_STAR, nu=NU, mu=MU, **geometry))
        loose = 2e-6 if name in KINKED else 1e-9
        assert np.abs(found - wanted).max() < loose * np.abs(wanted).max(), (r, z, found, wanted)


@pytest.mark.parametrize("name", PROFILES)
def test_every_horizontal_plane_carries_the_load(name: str) -> None:
    fields, normal, geometry, given, a = contact(name)
    nodes, weights = np.polynomial.legendre.leggauss(240)
    u = (1 + nodes) / 2
    r, rate = a * u / (1 - u), a / (1 - u) ** 2  # zz falls as r**-5
    for z in (0.3 * a, 2.0 * a):
        zz = fields.stress(r, z, given, E_star=E_STAR, nu=NU, **geometry).zz
        carried = -2 * np.pi * np.sum(zz * r * rate * weights / 2)
        assert carried == pytest.approx(normal.force(given, E_star=E_STAR, **geometry), rel=1e-11)


@pytest.mark.parametrize("name", PROFILES)
def test_displacements_and_stresses_obey_hookes_law(name: str) -> None:
    fields, _, geometry, given, _ = contact(name)
    h = 1e-3
    E = E_STAR * (1 - NU**2)
    first, second = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (1 + NU)

    def u(r: float, z: float) -> Any:
        return np.array(fields.displacement(r, z, given, nu=NU, **geometry))

    def slope(along: tuple[float, float], r: float, z: float) -> Any:
        weights = {-3: -1 / 60, -2: 3 / 20, -1: -3 / 4, 1: 3 / 4, 2: -3 / 20, 3: 1 / 60}
        return sum(w * u(r + k * h * along[0], z + k * h * along[1]) for k, w in weights.items()) / h

    for r, z in POINTS:
        by_r, by_z = slope((1.0, 0.0), r, z), slope((0.0, 1.0), r, z)
        err, ett, ezz = by_r[0], u(r, z)[0] / r, by_z[1]
        volume = first * (err + ett + ezz)
        wanted = np.array([volume + second * e for e in (err, ett, ezz)] + [second / 2 * (by_z[0] + by_r[1])])
        found = np.array(fields.stress(r, z, given, E_star=E_STAR, nu=NU, **geometry))
        assert np.abs(found - wanted).max() < 1e-9 * np.abs(found).max()


@pytest.mark.parametrize("name", PROFILES)
def test_on_the_surface_the_fields_are_those_of_the_normal_contact(name: str) -> None:
    fields, normal, geometry, given, a = contact(name)
    r = a * np.array([0.31, 0.77, 0.99, 1.01, 1.7])
    found = fields.stress(r, 0.0, given, E_star=E_STAR, nu=NU, **geometry)
    pressure = normal.pressure(r, given, E_star=E_STAR, **geometry)
    assert found.zz == pytest.approx(-pressure, rel=1e-12, abs=1e-12 * pressure.max())
    assert found.rz == pytest.approx(np.zeros(5), abs=1e-12)
    sunk = fields.displacement(r, 0.0, given, nu=NU, **geometry)
    assert sunk.z == pytest.approx(normal.displacement(r, given, **geometry), rel=1e-12)
    assert sunk.r == pytest.approx(fields.surface_displacement(r, given, nu=NU, **geometry), rel=1e-14)
    # beside the contact every profile of the same load pulls alike
    force = normal.force(given, E_star=E_STAR, **geometry)
    alike = (1 - 2 * NU) * force / (2 * np.pi * r[3:] ** 2)
    stretched = fields.surface_stress(r, given, E_star=E_STAR, nu=NU, **geometry)
    assert stretched.rr[3:] == pytest.approx(alike, rel=1e-12)
    assert stretched.tt[3:] == pytest.approx(-alike, rel=1e-12)
    # around the axis and away from it: their sum is that of a plane state below a pressure
    assert stretched.rr + stretched.tt == pytest.approx(-(1 + 2 * NU) * pressure, rel=1e-11, abs=1e-11)


@pytest.mark.parametrize("depth", [0.0, 1e-300, 1e-140, 1e-40])
@pytest.mark.parametrize("name", PROFILES)
def test_special_places_next_to_the_surface_are_like_their_neighbours(name: str, depth: float) -> None:
    """The tip, the break, the edge and the radius of a sphere; but for stresses that have no bound there."""
    fields, _, geometry, given, a = contact(name)
    lengths = [x for x in (geometry.get("b"), geometry.get("R")) if x]
    r = np.array([0.0, a, *lengths])
    beside = r + 1e-9
    here, there = (fields.displacement(x, z, given, nu=NU, **geometry) for x, z in ((r, depth), (beside, 0.0)))
    assert np.array(here) == pytest.approx(np.array(there), abs=1e-4)
    # no pressure has a bound at a tip, a kink or the edge of a face
    bounded = slice(int(name in ("cone", "polynomial")), 1 if name in FIXED else 2 if name in KINKED else None)
    material = {"E_star": E_STAR, "nu": NU, **geometry}
    here, there = (np.array(fields.stress(x[bounded], z, given, **material)) for x, z in ((r, depth), (beside, 0.0)))
    assert here == pytest.approx(there, abs=1e-3)


@pytest.mark.parametrize("name", ["cone", "truncated_cone", "truncated_paraboloid", "capped_paraboloid"])
def test_below_a_tip_and_a_kink_the_stress_grows_like_the_logarithm_of_the_depth(name: str) -> None:
    fields, _, geometry, a, _ = contact(name)
    z = np.array([1e-25, 1e-65, 1e-105, 1e-145])
    found = fields.stress(geometry.get("b", 0.0), z, a, E_star=E_STAR, nu=NU, **geometry).zz
    assert np.diff(found) == pytest.approx(np.diff(found)[0], rel=1e-12)
    assert np.diff(found)[0] < -1.0


@pytest.mark.parametrize(("name", "end"), [("sphere", "R"), ("ellipsoid", "b")])
def test_the_radius_of_a_sphere_is_a_place_like_any_other(name: str, end: str) -> None:
    fields, _, geometry, a, _ = contact(name)
    r = geometry[end] * np.array([1.0 - 1e-6, 1.0, 1.0 + 1e-6])
    low, here, high = np.array(fields.stress(r, 0.0, a, E_star=E_STAR, nu=NU, **geometry))[:2].T
    assert here == pytest.approx(0.5 * (low + high), rel=1e-10)


def test_next_to_an_edge_any_unit_of_length_will_do() -> None:
    """The square of such a depth is nothing in the smaller unit."""
    small, large = (
        subsurface.flat_punch.stress(unit, 1e-100 * unit, unit, a=unit, E_star=E_STAR, nu=NU) for unit in (1e-100, 1.0)
    )
    assert small == pytest.approx(large, rel=1e-12)


def test_no_points_have_no_stresses() -> None:
    found = subsurface.sphere.stress([], 0.1, 0.9, R=1.5, E_star=E_STAR, nu=NU)
    assert [own.shape for own in found] == [(0,)] * 4


def test_no_load_has_no_place_of_the_greatest_stress() -> None:
    found = subsurface.truncated_cone.greatest_shear(0.5, theta=0.4, b=0.5, E_star=E_STAR, nu=NU)
    assert found == pytest.approx((0.0, np.nan, np.nan), nan_ok=True)


@pytest.mark.parametrize("name", [name for name in PROFILES if name not in FIXED])
def test_a_stick_zone_takes_the_friction_of_its_own_contact_away(name: str) -> None:
    fields, _, geometry, a, _ = contact(name)
    given = {"E_star": E_STAR, "nu": NU, "mu": MU, **geometry}
    inner = 0.95 * a
    whole, stuck = (np.array(fields.sliding_stress(0.5, 0.3, 0.4, x, **given)) for x in (a, inner))
    assert fields.partial_slip_stress(0.5, 0.3, 0.4, a, inner, **given) == pytest.approx(whole - stuck, rel=1e-13)
    with pytest.raises(ValueError, match="c <= a is violated; .*exchange a and c"):
        fields.partial_slip_stress(0.5, 0.3, 0.4, a, 1.1 * a, **given)


@pytest.mark.parametrize("depth", [0.0, 1e-300])
@pytest.mark.parametrize("name", [name for name in PROFILES if name not in FIXED])
def test_the_traction_of_a_stick_zone_is_finite_over_the_tip_and_the_break(name: str, depth: float) -> None:
    fields, _, geometry, a, _ = contact(name)
    tangential = import_module(f"axicontact.tangential.{name}")
    c, b = 0.95 * a, 0.4 if name == "ellipsoid" else geometry.get("b", 0.4)
    given = {"E_star": E_STAR, "mu": MU, **geometry}
    # next to the tip and the break pressures of both radii still have their digits
    r, beside = (np.array([0.0, b, 0.7 * a, 0.99 * a]) + shift for shift in (0.0, np.array([1e-6, 1e-6, 0.0, 0.0])))
    found = fields.partial_slip_stress(r, 0.3, depth, a, c, nu=NU, **given)
    traction = tangential.traction(beside, a, c, **given)
    assert found.rz == pytest.approx(-traction * np.cos(0.3), rel=1e-5)
    assert found.tz == pytest.approx(traction * np.sin(0.3), rel=1e-5)


@pytest.mark.parametrize(
    ("name", "rate"),
    [
        ("cone", lambda t, theta: np.pi / 2 * np.tan(theta)),
        ("power_law", lambda t, A, n: sqrt(pi) * A * n * t ** (n - 1) * gamma(n / 2 + 1) / gamma(n / 2 + 0.5)),
        ("sphere", lambda t, R: np.arctanh(t / R) + t * R / (R * R - t * t)),
        ("truncated_cone", lambda t, theta, b: np.tan(theta) * (np.arccos(b / t) + b / np.sqrt(t * t - b * b))),
    ],
)  # fmt: skip
def test_a_ring_of_slip_that_is_narrow_keeps_its_digits(name: str, rate: Any) -> None:
    """It is that of one flat punch."""
    fields, _, geometry, a, _ = contact(name)
    c, middle = a * (1 - 1e-8), a * (1 - 5e-9)
    r, z = a * np.array([[0.1, 0.5, 1.0, 1.0, 1.4, 6.0], [0.7, 1e-3, 0.02, 0.2, 0.01, 3.0]])
    found = fields.partial_slip_stress(r, 0.3, z, a, c, E_star=E_STAR, nu=NU, mu=MU, **geometry)
    one = np.array(FRICTION.of(punch(r, z, np.full(6, middle), (a - r) - (a - c) / 2)))
    wanted = np.array(frictional_stress(one, 0.3, NU, MU * E_STAR / np.pi)) * rate(middle, **geometry) * (a - c)
    assert np.max(np.abs(np.array(found) - wanted) / np.abs(wanted).max(axis=0)) < 1e-11


def of_stresses(S: list[Any], D: list[Any], r: Any, z: Any) -> list[Any]:
    """The numbers STRESS and FRICTION from S_0 ... S_3 and D_0 ... D_3."""
    less, slope = (S[0] - z * S[1] / r, z * S[2] / r) if r else (S[0] - (D[0] + D[2]) / 2, (D[1] + D[3]) / 4)
    return [S[0], (S[0] + S[2]) / 2, S[0] + D[0], less, D[1], S[1], (S[1] + S[3]) / 2, slope, D[1], D[2], less]


def found_at(r: Any, z: Any, piece: Piece) -> Any:
    """The same as the rule finds them, as rows."""
    return np.concatenate([superposed(own, r, z, [piece]) for own in (STRESS, FRICTION)])


def exact(r: float, z: float, growth: list[int]) -> tuple[list[Any], list[Any], list[Any]]:
    """S_0 ... S_3, D_0 ... D_3 and the numbers DISPLACEMENT for a = 1 and g' = sum growth[j] t**j.

    By recurrences for int t**j (r/q)**m/rho dt.
    """
    r, z, i = mp.mpf(r), mp.mpf(z), mp.mpc(0, 1)
    rho, start = mp.sqrt(z + i * (1 - r)) * mp.sqrt(z + i * (1 + r)), mp.hypot(r, z)
    one, nought, top = r / (rho + z + i), r / (z + start), len(growth) + 4
    table = [[-i * mp.log((rho + z + i) / (z + start))] + [i / m * (one**m - nought**m) for m in range(1, top + 1)]]
    for j in range(1, len(growth) + 1):
        first = (2 * j - 1) * i * z * table[-1][0] - (rho - (start if j == 1 else 0))
        first += (j - 1) * start**2 * table[j - 2][0] if j > 1 else 0
        row = [first / j]
        row += [-i * (r / 2 * (table[-1][m - 1] - table[-1][m + 1]) - z * table[-1][m]) for m in range(1, top + 1 - j)]
        table.append(row)
    S = [-sum(x * table[j][m] for j, x in enumerate(growth)).imag for m in range(4)]
    D = []
    for m in range(4):
        bent = sum(j * x * table[j - 1][m] for j, x in enumerate(growth) if j) - sum(growth) * one**m / rho
        D.append(z * (mp.re(bent) + growth[0] * nought**m / start))
    depth = mp.fsum(mp.mpf(x) / (j + 1) for j, x in enumerate(growth))
    W = depth * table[0][0].real - sum(mp.mpf(x) / (j + 1) * table[j + 1][0] for j, x in enumerate(growth)).real
    return S, D, [S[0], S[1], r * (S[0] + S[2]) / 2, W]


def places(count: int) -> list[tuple[float, float]]:
    """Points near and far, next to the edge, the axis and the surface."""
    dice = np.random.default_rng(3)
    near, edge = 10.0 ** dice.uniform(-12, -1, count), 10.0 ** dice.uniform(-2, 2, count)
    found = [(1 + s * x, x * y) for s, x, y in zip(dice.choice([-1, 1], count), near, edge, strict=True)]
    found += [tuple(10.0 ** dice.uniform(-8, 4, 2)) for _ in range(count)]
    found += [tuple(dice.uniform(0, 2.5, 2)) for _ in range(count)]
    found += [(float(x), 0.0) for x in dice.uniform(0.01, 2.5, count)]
    return [*found, (0.0, 0.4), (0.0, 1e-9), (0.7, 1e-31), (0.7, 1e-25), (1e-20, 1e-12)]


@pytest.mark.parametrize("growth", [[1], [0, 1], [0, 0, 0, 1], [1, 2, 0, 3], [0, 0, 0, 0, 0, 1]])
def test_the_rule_keeps_its_digits_everywhere(growth: list[int]) -> None:
    points = places(40)
    r, z = np.array(points).T
    # by the closed forms, and by the rule alone
    slopes = polynomial, lambda t, *rates: polynomial(t, *rates)
    pieces = [Piece(PLAIN, 0.0, 1.0, slope, tuple(map(float, growth))) for slope in slopes]
    if sum(x > 0 for x in growth) == 1:
        j = len(growth) - 1.0
        pieces.append(Piece(EXP, 0.0, 1.0, lambda t: t**j, (), 1.0, 2.0 / (j + 1.0), j + 1.0))
    with mp.workdps(90):
        wanted = [exact(*point, growth) for point in points]
        for piece in pieces:
            found, moved = found_at(r, z, piece), superposed(DISPLACEMENT, r, z, [piece])
            for i, (S, D, sunk) in enumerate(wanted):
                size, row = max(map(abs, (*S, *D))), of_stresses(S, D, *map(mp.mpf, points[i]))
                error = max(abs(mp.mpf(float(x)) - w) for x, w in zip(found[:, i], row, strict=True)) / size
                assert error < 6e-14, (points[i], mp.nstr(error, 3))
                # beside the contact S_0 and D_0 leave z**3 of each other; depths below 1e-30 are the surface
                lost = abs(mp.mpf(float(found[2, i])) - row[2])
                assert lost <= 1e-12 * abs(row[2]) or points[i][1] < 1e-30, points[i]
                for x, w, least in zip(moved[:, i], sunk, (size, size, 0, 0), strict=True):
                    assert abs(mp.mpf(float(x)) - w) <= 6e-14 * max(w, least), points[i]


def test_a_flat_punch_keeps_the_digits_of_each_number() -> None:
    points = [(r, z) for r, z in places(60) if z > 0.0 and r > 0.0]
    r, z = np.array(points).T
    own = punch(r, z, np.ones(r.size), 1.0 - r)
    found, moved = np.array([*STRESS.of(own), *FRICTION.of(own)]), np.array(DISPLACEMENT.of(own))
    with mp.workdps(90):
        for i, (x, y) in enumerate(points):
            near, depth = mp.mpf(x), mp.mpf(y)
            rho = mp.sqrt(depth + 1j * (1 - near)) * mp.sqrt(depth + 1j * (1 + near))
            q, zeta = rho + depth + mp.mpc(0, 1), depth + mp.mpc(0, 1)
            S = [-((near / q) ** m / rho).imag for m in range(4)]
            D = [-depth * ((zeta + m * rho) * (near / q) ** m / rho**3).imag for m in range(4)]
            row = of_stresses(S, D, near, depth)
            # sums of terms of one sign
            for one in (0, 1, 2, 3, 5, 6):
                assert abs(mp.mpf(float(found[one, i])) / row[one] - 1) < 4e-15, (x, y, one)
            for one, wanted in enumerate((S[0], S[1], near * (S[0] + S[2]) / 2, mp.arg(q))):
                assert abs(mp.mpf(float(moved[one, i])) / wanted - 1) < 4e-15, (x, y, one)
            size = max(map(abs, (*S, *D)))
            assert max(abs(mp.mpf(float(f)) - w) for f, w in zip(found[:, i], row, strict=True)) < 3e-15 * size


VARIABLES = {
    "truncated cone": (COSH, lambda b: (b, 1.0), lambda t, root, b: np.arctan(root / b) + b / root,
                       lambda v, b: mp.atan(mp.sinh(v)) + 1 / mp.sinh(v), lambda v, b: (b * mp.cosh(v), b * mp.sinh(v)),
                       mp.acosh, (0.6, 0.999, 1e-4)),
    "sphere": (TANH, lambda b: (0.0, 1.0), lambda t, root, b: np.arcsinh(t / root) + b * t / root**2,
               lambda v, b: v + mp.sinh(v) * mp.cosh(v), lambda v, b: (b * mp.tanh(v), b / mp.cosh(v) ** 2),
               mp.atanh, (1.5, 1.001, 1 + 1e-9)),
    "hyperboloid": (SINH, lambda b: (0.0, 1.0), lambda t, b: np.arctan(t / b) + b * t / (t * t + b * b),
                    lambda v, b: mp.atan(mp.sinh(v)) + mp.sinh(v) / mp.cosh(v) ** 2,
                    lambda v, b: (b * mp.sinh(v), b * mp.cosh(v)), mp.asinh, (2.0, 0.1, 1e-5)),
}  # fmt: skip


def wanted_rate(name: str, v: Any, b: Any, m: int, bent: bool, r: Any, z: Any) -> Any:
    """The integrand of S_m, or of D_m if `bent`, in the variable of the slope."""
    _, _, _, rate, radius, _, _ = VARIABLES[name]
    if not v:
        return 0
    t, pace = radius(v, b)
    zeta = z + mp.mpc(0, 1) * t
    rho = mp.sqrt(z + mp.mpc(0, 1) * (t - r)) * mp.sqrt(z + mp.mpc(0, 1) * (t + r))
    own = (r / (rho + zeta)) ** m / rho
    return -(z * (zeta + m * rho) * own / rho**2 if bent else own).imag * rate(v, b) * pace


@pytest.mark.slow
@pytest.mark.parametrize("name", VARIABLES)
def test_slopes_with_singular_points_keep_their_digits(name: str) -> None:
    variable, ends, slope, _, _, inverse, lengths = VARIABLES[name]
    for b in lengths:
        low, high = ends(b)
        piece = Piece(variable, low, high, slope, (b,), b, 2.0)
        for r, z in ((0.3, 0.2), (1.3, 0.02), (0.999, 1e-3)):
            found = found_at(np.array([r]), np.array([z]), piece)[:, 0]
            with mp.workdps(30):
                B, x, y = mp.mpf(b), mp.mpf(r), mp.mpf(z)
                start, end = inverse(mp.mpf(low) / B), inverse(mp.mpf(high) / B)
                star = inverse(mp.mpc(x, y) / B)
                steps = [star.real + k * abs(star.imag) * 4**j for j in range(8) for k in (-1, 1)]
                cuts = sorted({start, end, *(s for s in [star.real, *steps] if start < s < end)})

                wanted = [
                    mp.quad(lambda v, own=(B, m, bent, x, y): wanted_rate(name, v, *own), cuts)
                    for bent in (False, True) for m in range(4)
                ]  # fmt: skip
                row = of_stresses(wanted[:4], wanted[4:], x, y)
                error = max(abs(mp.mpf(float(f)) - w) for f, w in zip(found, row, strict=True))
                assert error < 3e-14 * max(map(abs, wanted)), (b, r, z)


def power_rate(n: float, v: Any, r: Any, z: Any, m: int) -> Any:
    """The integrand of S_m of the slope t**(n - 1) in log(t)."""
    t, i = mp.exp(v), mp.mpc(0, 1)
    rho = mp.sqrt(z + i * (t - r)) * mp.sqrt(z + i * (t + r))
    return -((r / (rho + z + i * t)) ** m / rho).imag * mp.exp(n * v)


@pytest.mark.parametrize("n", [0.3, pytest.param(0.5, marks=pytest.mark.slow), 1.3,
                               pytest.param(40.0, marks=pytest.mark.slow)])  # fmt: skip
def test_slopes_that_are_any_power_keep_their_digits(n: float) -> None:
    piece = Piece(EXP, 0.0, 1.0, lambda t: t ** (n - 1.0), (), 1.0, 2.0 / max(n, 1.0), n)
    for r, z in ((0.3, 0.2), (1e-3, 2e-3), (0.99, 0.01)):
        own = (np.array([r]), np.array([z]), [piece])
        found = [*superposed(DISPLACEMENT, *own)[:2, 0], superposed(STRESS, *own)[1, 0]]
        found += [superposed(FRICTION, *own)[1, 0]]
        with mp.workdps(25):
            x, y = mp.mpf(r), mp.mpf(z)
            star = mp.log(mp.mpc(x, y))
            steps = [star.real + k * star.imag * 4**j for j in range(4) for k in (-1, 1)]
            cuts = sorted({mp.mpf(0), *(s for s in (star.real, star.real - 8, *steps) if s < 0), mp.mpf(-60) / n})

            wanted = [mp.quad(lambda v, own=(x, y, m): power_rate(n, v, *own), cuts) for m in range(4)]
            wanted = [*wanted[:2], (wanted[0] + wanted[2]) / 2, (wanted[1] + wanted[3]) / 2]
            error = max(abs(mp.mpf(float(f)) - w) for f, w in zip(found, wanted, strict=True))
            assert error < 2e-14 * max(map(abs, wanted)), (r, z)


def test_the_axis_of_hertz() -> None:
    p_0 = paraboloid.pressure(0.0, 1.0, R=2.0, E_star=E_STAR)
    z = np.geomspace(1e-6, 1e6, 25)
    found = subsurface.paraboloid.stress(0.0, z, 1.0, R=2.0, E_star=E_STAR, nu=NU)
    assert found.zz == pytest.approx(-p_0 / (1 + z * z), rel=1e-14)
    with mp.workdps(60):
        wanted = [float(-(1 + mp.mpf(NU)) * (1 - x * mp.atan(1 / x)) + 1 / (2 * (1 + x * x))) for x in map(mp.mpf, z)]
    assert found.rr == pytest.approx(p_0 * np.array(wanted), rel=1e-12)
    assert found.tt == pytest.approx(found.rr, rel=1e-14)


def test_the_greatest_shear_of_hertz_and_of_a_quartic() -> None:
    p_0 = paraboloid.pressure(0.0, 1.0, R=2.0, E_star=E_STAR)
    value, r, z = subsurface.paraboloid.greatest_shear(1.0, R=2.0, E_star=E_STAR, nu=0.3)
    assert value == pytest.approx(0.31002050 * p_0, rel=1e-7)
    assert (r, z) == pytest.approx((0.0, 0.4808645), abs=1e-6)
    value, r, z = subsurface.quartic.greatest_von_mises(1.0, A=0.2, E_star=E_STAR, nu=0.3)
    assert (r, z) == pytest.approx((0.743, 0.324), abs=2e-3)
    grid = np.meshgrid(np.linspace(0, 1.3, 131), np.linspace(0.005, 1.3, 130))
    assert value >= von_mises(subsurface.quartic.stress(*grid, 1.0, A=0.2, E_star=E_STAR, nu=0.3)).max()


def test_a_rounded_punch_yields_below_its_rounding_and_not_on_its_axis() -> None:
    E_star, given = 210e9 / (2 * (1 - 0.3**2)), {"R": 2e-3, "b": 5e-3}
    a = rounded_punch.radius_from_force(20e3, E_star=E_star, **given)
    value, r, z = subsurface.rounded_punch.greatest_von_mises(a, E_star=E_star, nu=0.3, **given)
    assert (value, r / given["b"], z) == pytest.approx((734.7e6, 1.0077, 31.4e-6), rel=1e-3)
    axis = subsurface.rounded_punch.stress(0.0, np.linspace(1e-4, 2e-2, 400), a, E_star=E_star, nu=0.3, **given)
    assert von_mises(axis).max() == pytest.approx(107e6, rel=5e-3)


def test_the_edge_of_a_sliding_sphere() -> None:
    p_0 = paraboloid.pressure(0.0, 1.0, R=2.0, E_star=E_STAR)
    found = subsurface.paraboloid.sliding_stress(1.0, np.pi, 0.0, 1.0, R=2.0, E_star=E_STAR, nu=NU, mu=MU)
    assert found.rr == pytest.approx(np.pi * (4 + NU) / 8 * MU * p_0, rel=1e-13)
    pressed = subsurface.paraboloid.surface_stress(1.0, 1.0, R=2.0, E_star=E_STAR, nu=NU)
    assert pressed.rr == pytest.approx((1 - 2 * NU) * p_0 / 3, rel=1e-13)


def test_far_away_every_contact_is_a_point_load() -> None:
    for name in ("cone", "flat_punch", "rounded_cone", "wavy_paraboloid"):
        fields, normal, geometry, given, a = contact(name)
        force = normal.force(given, E_star=E_STAR, **geometry)
        for r, z in ((3e7, 1e7), (1e7, 4e7)):
            wanted = np.array(boussinesq(r * a, 0.0, z * a)) * force
            assert fields.stress(r * a, z * a, given, E_star=E_STAR, nu=NU, **geometry) == pytest.approx(
                wanted, rel=1e-12
            )


def test_a_given_depth_moves_the_edge_as_a_flat_punch() -> None:
    given, point = {"R": 2.0, "E_star": E_STAR, "nu": NU}, (0.6, 0.3, 1.0)
    short = paraboloid.depth(1.0, R=2.0) - 0.05
    found = np.array(subsurface.paraboloid.stress(*point, d=short, **given))
    lifted = np.array(subsurface.flat_punch.stress(0.6, 0.3, 0.05, a=1.0, E_star=E_STAR, nu=NU))
    assert found == pytest.approx(np.array(subsurface.paraboloid.stress(*point, **given)) - lifted, rel=1e-13)


def test_measures_of_a_stress() -> None:
    stress = subsurface.cone.stress(0.5, 0.3, 1.0, theta=0.2, E_star=E_STAR, nu=NU)
    sliding = subsurface.cone.sliding_stress(0.5, 0.9, 0.3, 1.0, theta=0.2, E_star=E_STAR, nu=NU, mu=MU)
    both = add(stress, sliding)
    assert isinstance(both, SlidingStress)
    rr, tt, zz, rt, rz, tz = both
    tensor = np.array([[rr, rt, rz], [rt, tt, tz], [rz, tz, zz]])
    values = np.linalg.eigvalsh(tensor)[::-1]
    assert principal(both) == pytest.approx(values, rel=1e-13)
    assert tresca(both) == pytest.approx(values[0] - values[2], rel=1e-13)
    assert hydrostatic(both) == pytest.approx(values.mean(), rel=1e-13)
    apart = tensor - np.eye(3) * values.mean()
    assert von_mises(both) == pytest.approx(np.sqrt(1.5 * np.sum(apart**2)), rel=1e-13)
    assert von_mises(Stress(*(np.full((2, 3), x) for x in stress))).shape == (2, 3)


def test_where_the_pressure_is_infinite_the_result_says_so() -> None:
    given = {"E_star": E_STAR, "nu": NU}
    assert subsurface.cone.stress(0.0, 0.0, 1.0, theta=0.2, **given).zz == -np.inf
    assert subsurface.flat_punch.stress(1.0, 0.0, 0.1, a=1.0, **given).zz == -np.inf
    assert subsurface.truncated_cone.stress(0.5, 0.0, 1.0, theta=0.2, b=0.5, **given).zz == -np.inf
    assert subsurface.rounded_punch.stress(0.5, 0.0, 1.0, R=1.0, b=0.5, **given).zz == pytest.approx(
        -rounded_punch.pressure(0.5, 1.0, R=1.0, b=0.5, E_star=E_STAR), rel=1e-12
    )
    assert subsurface.cone.greatest_von_mises(1.0, theta=0.2, **given) == (np.inf, 0.0, 0.0)
    assert subsurface.flat_punch.greatest_shear(0.1, a=1.0, **given) == (np.inf, 1.0, 0.0)
    # an incompressible half-space is under the same pressure in all directions at the tip
    assert np.isfinite(subsurface.cone.greatest_von_mises(1.0, theta=0.2, E_star=E_STAR, nu=0.5).value)


@pytest.mark.parametrize("n", [0.7, 1.5, 2.0])
def test_at_the_tip_of_a_power_law(n: float) -> None:
    given = {"A": 0.2, "n": n, "E_star": E_STAR, "nu": NU}
    found = np.array(subsurface.power_law.stress(np.array([0.0, 1e-14]), 0.0, 1.0, **given))
    if n <= 1.0:
        assert (found[:3, 0] == -np.inf).all()
    else:
        assert found[:, 0] == pytest.approx(found[:, 1], rel=1e-6, abs=1e-14)


def test_what_is_outside_is_nan_or_refused() -> None:
    given = {"R": 2.0, "E_star": E_STAR, "nu": NU}
    for point in ((-0.1, 0.2, 1.0), (0.1, -1e-300, 1.0), (0.1, 0.2, -1.0), (np.nan, 0.2, 1.0), (0.1, np.nan, 1.0)):
        assert np.isnan(subsurface.paraboloid.stress(*point, **given)).all()
    assert subsurface.paraboloid.stress(0.1, np.inf, 1.0, **given) == (0.0,) * 4
    assert subsurface.paraboloid.stress(0.1, 0.2, 0.0, **given) == (0.0,) * 4
    assert np.isnan(subsurface.sphere.stress(0.1, 0.2, 3.0, **given)).all()
    with pytest.raises(ValueError, match="-1 < nu <= 1/2"):
        subsurface.paraboloid.stress(0.1, 0.2, 1.0, **{**given, "nu": 0.51})
    with pytest.raises(TypeError, match="r must be a real number"):
        subsurface.paraboloid.stress("0.1", 0.2, 1.0, **given)
    with pytest.raises(ValueError, match="below b"):
        subsurface.truncated_cone.stress(0.1, 0.2, 0.4, theta=0.2, b=0.5, E_star=E_STAR, nu=NU)


def test_arguments_broadcast_and_numbers_give_numbers() -> None:
    r, z, R = np.linspace(0.1, 2.0, 5)[:, None], np.linspace(0.0, 1.0, 4), np.array([1.0, 2.0])[:, None, None]
    found = subsurface.paraboloid.stress(r, z, 0.8, R=R, E_star=E_STAR, nu=NU)
    assert found.rr.shape == (2, 5, 4)
    one = subsurface.paraboloid.stress(float(r[3, 0]), float(z[2]), 0.8, R=2.0, E_star=E_STAR, nu=NU)
    assert all(type(x) is float for x in one)
    assert [x[1, 3, 2] for x in found] == pytest.approx(one, rel=1e-14)
    several = subsurface.paraboloid.greatest_shear(np.array([0.5, 1.0]), R=2.0, E_star=E_STAR, nu=NU)
    assert several.z[1] == pytest.approx(2 * several.z[0], rel=1e-6)
    assert type(subsurface.cone.surface_displacement(0.4, 1.0, theta=0.2, nu=NU)) is float
    assert cone.displacement(2.0, 1.0, theta=0.2) == pytest.approx(
        subsurface.cone.displacement(2.0, 0.0, 1.0, theta=0.2, nu=NU).z, rel=1e-13
    )


@pytest.mark.parametrize("name", PROFILES)
def test_every_function_refuses_what_is_outside(name: str) -> None:
    fields, _, geometry, given, a = contact(name)
    known: dict[str, Any] = {"r": 0.4, "phi": 0.3, "z": 0.2, "a": given, "d": given, "c": 0.95 * a}
    material = {"E_star": E_STAR, "nu": NU, "mu": MU}
    for asked, function in inspect.getmembers(fields, inspect.isfunction):
        if asked.startswith("_") or function.__module__ != fields.__name__:
            continue
        signature = inspect.signature(function).parameters.values()
        first = [one.name for one in signature if one.kind is one.POSITIONAL_OR_KEYWORD]
        rest = {one.name: material[one.name] for one in signature if one.name in material} | geometry
        for outside in (-1.0, 0.5000001, np.nan):
            with pytest.raises(ValueError, match="-1 < nu <= 1/2"):
                function(*(known[one] for one in first), **{**rest, "nu": outside})
        # an incompressible half-space, and one next to the other end of the range; a search takes longer
        for inside in () if asked.startswith("greatest") else (0.5, -0.999):
            assert np.isfinite(function(*(known[one] for one in first), **{**rest, "nu": inside})).all()
        for field in {"r", "z"} & set(first):
            assert np.isnan(function(*({**known, field: -1e-300}[one] for one in first), **rest)).all(), (asked, field)
        if "z" in first:
            # neither above the surface nor with the axis in the way does one point spoil the others
            many = np.array([0.2, -0.2, np.nan])
            found = np.array(function(*({**known, "z": many}[one] for one in first), **rest))
            assert np.isnan(found[:, 1:]).all(), asked
            assert np.isfinite(found[:, 0]).all(), asked
        if "stress" in asked:
            assert "infinite" in str(function.__doc__), asked


def test_waves_keep_their_digits_next_to_the_edge() -> None:
    """Beside panels of a fourth of the length, where the slope of steep waves nearly vanishes within the contact."""
    dice, R, wavelength = np.random.default_rng(2), 2.0, 1.0
    a = 10.0 ** dice.uniform(-0.5, 0.0, 1000)
    away, turn = a * 10.0 ** dice.uniform(-6.0, -0.5, a.size), dice.uniform(0.0, np.pi, a.size)
    r, z = np.abs(a + away * np.cos(turn)), away * np.sin(turn)
    given = {"R": R, "h": 0.0718 * wavelength**2 / R, "wavelength": wavelength}

    def finer(*fields: Any, **geometry: Any) -> Any:
        radius, edge, (piece,) = subsurface.wavy_paraboloid._shape(*fields, **geometry)
        return radius, edge, (piece._replace(longest=piece.longest / 4),)

    own, wanted = (
        np.array(stress_below(shape, r, z, a, E_STAR, NU, **given))
        for shape in (subsurface.wavy_paraboloid._shape, finer)
    )
    assert (np.abs(own - wanted).max(axis=0) / np.abs(wanted).max(axis=0)).max() < 3e-14
