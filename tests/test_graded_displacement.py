"""The displacement on the graded half-space against its definition in 30 digits, above all next to k = 1.

There it is a small difference of the depth and the profile: as the depth times the share of a flat punch, less the
sag of the profile, it missed 62 units of the last place at 1 - k = 3e-12 and r = 1.00000002 a.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import mpmath as mp
import pytest

UNITS = 4.5
"""Of 2**-52; 3.6 is the most of 40 points of every profile."""
WITH_A_POWER = 5.5
"""The same of a paraboloid and waves, of which the factor of the power loses up to 5."""
SOFTEST = (1.0 - 1e-14, 1.0 - 3e-12)
GRADINGS = (1.0 - 1e-4, 0.36, -0.2)
Numbers = dict[str, Any]
BODIES: dict[str, Numbers] = {
    "truncated_cone": {"theta": 0.36, "b": 0.3},
    "truncated_paraboloid": {"R": 2.0, "b": 0.99},
    "rounded_punch": {"R": 2.0, "b": 0.3},
    "rounded_cone": {"theta": 0.36, "b": 0.02},
    "capped_paraboloid": {"R1": 5.0, "R2": 0.5, "b": 0.3},
    "rounded_curved_punch": {"R1": 5.0, "R2": 0.5, "b": 0.3},
    "sphere_tipped_cone": {"R": 1.0, "theta": 0.36},
    "sphere": {"R": 1.001},
    "hyperboloid": {"theta": 1.1, "b": 1e-3},
    "gaussian": {"h": 0.3, "s": 2.0},
    "wavy_paraboloid": {"R": 2.0, "h": 1e-3, "wavelength": 0.6},
}


def pieces(name: str, p: Numbers) -> tuple[Any, Any, Any]:
    """f, f' and the break."""
    R, b, s, q = (p.get(key) for key in ("R", "b", "s", "wavelength"))
    slope = mp.tan(p["theta"]) if "theta" in p else None
    q = 2 * mp.pi / q if q else None
    match name:
        case "truncated_cone":
            return lambda r: slope * max(r - b, 0), lambda r: slope * (r > b), b
        case "truncated_paraboloid":
            return lambda r: max(r * r - b * b, 0) / (2 * R), lambda r: r / R * (r > b), b
        case "rounded_punch":
            return lambda r: max(r - b, 0) ** 2 / (2 * R), lambda r: max(r - b, 0) / R, b
        case "rounded_cone":
            return lambda r: slope * (r * r / (2 * b) if r < b else r - b / 2), lambda r: slope * min(r / b, 1), b
        case "capped_paraboloid":
            more = 1 / p["R2"] - 1 / p["R1"]
            return (
                lambda r: r * r / (2 * p["R1"]) + more * max(r * r - b * b, 0) / 2,
                lambda r: r / p["R1"] + more * r * (r > b),
                b,
            )
        case "rounded_curved_punch":
            return (
                lambda r: r * r / (2 * p["R1"]) + max(r - b, 0) ** 2 / (2 * p["R2"]),
                lambda r: r / p["R1"] + max(r - b, 0) / p["R2"],
                b,
            )
        case "sphere_tipped_cone":
            b, end = R * mp.sin(p["theta"]), R * mp.cos(p["theta"])
            return (
                lambda r: R - mp.sqrt(R * R - r * r) if r < b else R - end + slope * (r - b),
                lambda r: r / mp.sqrt(R * R - r * r) if r < b else slope,
                b,
            )
        case "sphere":
            return lambda r: R - mp.sqrt(R * R - r * r), lambda r: r / mp.sqrt(R * R - r * r), None
        case "hyperboloid":
            return lambda r: slope * (mp.hypot(r, b) - b), lambda r: slope * r / mp.hypot(r, b), None
        case "gaussian":
            return (
                lambda r: -p["h"] * mp.expm1(-((r / s) ** 2)),
                lambda r: p["h"] * 2 * r / s**2 * mp.exp(-((r / s) ** 2)),
                None,
            )
        case "wavy_paraboloid":
            return (
                lambda r: r * r / (2 * R) + p["h"] * (1 - mp.cos(q * r)),
                lambda r: r / R + p["h"] * q * mp.sin(q * r),
                None,
            )
    message = f"no shape is known for {name}"
    raise ValueError(message)


def exact(name: str, known: Numbers, r: float, k: float) -> Any:
    """For a contact of radius 1, in the variables that make the integrands regular."""
    shape, rate, corner = pieces(name, {key: mp.mpf(value) for key, value in known.items()})
    r, k = mp.mpf(r), mp.mpf(k)
    turn = [0, mp.pi / 2] if corner is None else [0, mp.asin(corner), mp.pi / 2]
    # s = sin(y) up to near the edge; the weight cos(y)**k there is left to x**8
    edge = turn.pop() - turn[-1]
    d = mp.quad(lambda y: rate(mp.sin(y)) * mp.cos(y) ** k, turn) if len(turn) > 1 else 0
    d += mp.quad(
        lambda x: rate(mp.cos(edge * x**8)) * mp.sin(edge * x**8) ** k * 8 * edge * x**7, [0, mp.mpf(1) / 2, 1]
    )
    if r <= 1:
        return d - shape(r)
    root = mp.sqrt((r - 1) * (r + 1))
    places = [mp.asinh(1 / root) * j / 12 for j in range(13)]
    if corner is not None:
        places = sorted([*places, mp.asinh(mp.sqrt(1 - corner**2) / root)])
    first = places[1]
    own = mp.quad(lambda x: _gap(shape, d, root, first * x**8, k) * 8 * first * x**7, [0, mp.mpf(1) / 2, 1])
    own += mp.quad(lambda v: _gap(shape, d, root, v, k), places[1:])
    return 2 / mp.pi * mp.sin(mp.pi / 2 * (1 - k)) * own


def _gap(shape: Any, d: Any, root: Any, v: Any, k: Any) -> Any:
    z = min(root * mp.sinh(v), mp.mpf(1))
    return mp.sinh(v) ** k * (d - shape(mp.sqrt((1 - z) * (1 + z)))) / mp.cosh(v)


@pytest.mark.parametrize("name", BODIES)
def test_displacement_next_to_the_softest_surface(name: str) -> None:
    check(name, SOFTEST, (2e-8,), (1e-9,))


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_displacement_over_gradings(name: str) -> None:
    check(name, GRADINGS, (1e-12, 0.3, 50.0), (0.7,))


def check(name: str, gradings: tuple[float, ...], outside: tuple[float, ...], inside: tuple[float, ...]) -> None:
    module, known = import_module(f"axicontact.graded.normal.{name}"), BODIES[name]
    units = WITH_A_POWER if name == "wavy_paraboloid" else UNITS
    for k in gradings:
        for r in (*(1.0 + more for more in outside), *(1.0 - less for less in inside)):
            with mp.workdps(34):
                wanted = exact(name, known, r, k)
            got = module.displacement(r, 1.0, **known, k=k)
            assert abs(got / wanted - 1) <= units * 2.0**-52, (k, r, float((got / wanted - 1) * 2**52))
