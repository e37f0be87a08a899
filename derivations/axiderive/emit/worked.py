"""A worked example for every profile: real materials, a real load, and the function behind every number."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from ..proof.shape import coefficient
from .values import Numbers, Values


@dataclass(frozen=True)
class Material:
    """Two bodies as the example names them: effective modulus in Pa, work of separation in J/m^2 or none."""

    words: str
    modulus: sp.Rational
    separation: float = 0.0


def plane_strain(young: float, poisson: str, bodies: int = 1) -> sp.Rational:
    return sp.Rational(young) / (bodies * (1 - sp.Rational(poisson) ** 2))


STEEL = Material(r"steel on steel, $E=210$\,GPa, $\nu=0.3$", plane_strain(210e9, "0.3", 2))
GLASS = Material(r"diamond on glass, $E=70$\,GPa, $\nu=0.22$ (diamond rigid)", plane_strain(70e9, "0.22"))
SILICONE = Material(
    r"rigid on silicone rubber, $E=2$\,MPa, $\nu=0.5$, $\Delta\gamma=50$\,mJ/m$^2$", plane_strain(2e6, "0.5"), 0.05
)


@dataclass(frozen=True)
class Case:
    """Material, load in N (plane contact: N/m), and the parameters in SI units."""

    material: Material
    load: float
    parameters: Mapping[str, str]


CASES = {
    "cone": Case(SILICONE, 0.05, {"theta": "0.14"}),
    "paraboloid": Case(SILICONE, 0.02, {"R": "5e-3"}),
    "quartic": Case(STEEL, 50.0, {"A": "2e6"}),
    "sextic": Case(STEEL, 50.0, {"A": "4e12"}),
    "power_law": Case(STEEL, 50.0, {"n": "3", "A": "1e4"}),
    "polynomial": Case(STEEL, 100.0, {"A_1": "0.01", "A_2": "20", "A_3": "2e4"}),
    "sphere": Case(SILICONE, 0.5, {"R": "5e-3"}),
    "ellipsoid": Case(SILICONE, 0.5, {"h": "4e-3", "b": "5e-3"}),
    "hyperboloid": Case(GLASS, 0.002, {"theta": "0.35", "b": "1e-6"}),
    "truncated_cone": Case(STEEL, 500.0, {"theta": "0.05", "b": "5e-4"}),
    "truncated_paraboloid": Case(STEEL, 500.0, {"R": "20e-3", "b": "5e-4"}),
    "rounded_cone": Case(GLASS, 0.002, {"theta": "0.35", "b": "1e-6"}),
    "capped_paraboloid": Case(STEEL, 200.0, {"R1": "50e-3", "R2": "20e-3", "b": "3e-4"}),
    "rounded_punch": Case(STEEL, 20e3, {"R": "2e-3", "b": "5e-3"}),
    "rounded_curved_punch": Case(STEEL, 20e3, {"R1": "1", "R2": "2e-3", "b": "5e-3"}),
    "wavy_paraboloid": Case(SILICONE, 0.02, {"R": "5e-3", "h": "1e-7", "wavelength": "2e-4"}),
    "gaussian": Case(SILICONE, 0.02, {"h": "2e-4", "s": "1e-3"}),
    "sphere_tipped_cone": Case(GLASS, 0.002, {"R": "2e-6", "theta": "0.35"}),
    "flat_punch": Case(STEEL, 1e3, {"a": "2e-3"}),
    "capped_cylinder": Case(STEEL, 5e3, {"a": "2e-3", "R": "0.5"}),
    "concave_power": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6", "n": "3"}),
    "concave_paraboloid": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6"}),
    "concave_quartic": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6"}),
    "plane.wedge": Case(STEEL, 1e5, {"theta": "0.01"}),
    "plane.parabola": Case(STEEL, 1e5, {"R": "20e-3"}),
    "plane.quartic": Case(STEEL, 1e5, {"A": "5e6"}),
    "plane.sextic": Case(STEEL, 1e5, {"A": "2e13"}),
    "plane.power_law": Case(STEEL, 1e5, {"A": "1e4", "n": "3"}),
    "plane.truncated_wedge": Case(STEEL, 5e5, {"theta": "0.02", "b": "5e-4"}),
    "plane.rounded_wedge": Case(STEEL, 1e5, {"theta": "0.01", "b": "5e-5"}),
    "plane.rounded_punch": Case(STEEL, 1e6, {"R": "2e-3", "b": "5e-3"}),
    "plane.concave_power": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6", "n": "3"}),
    "plane.concave_parabola": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6"}),
    "plane.concave_quartic": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6"}),
    "plane.flat_punch": Case(STEEL, 1e5, {"a": "1e-3"}),
}
PREFIXES = {-12: "p", -9: "n", -6: r"\textmu{}", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
DIGITS = 20


def worked(profile_id: str, profile: Profile, entries: Mapping[str, Entry], make: Callable[..., Numbers]) -> Any:
    """Heading, numbers with the key of their formula, and the lines of Python that give them; None without a case."""
    case = CASES.get(profile_id)
    if case is None:
        return None
    values = _parameters(profile, case)
    values[nt.E_star] = case.material.modulus
    for symbol, expr in profile.abbreviations:
        values.setdefault(symbol, expr.xreplace(values))
    numbers = _loaded(profile, entries, values, case, make)
    radius = numbers["a"]
    mean, half = numbers.mean_pressure, numbers("p", radius / 2)
    plane = numbers.place("p") == nt.x
    shown = [
        ("a", radius, "m", ("aP" if plane else "aF") if numbers.compact else ""),
        *([] if plane else [("d", numbers.depth, "m", "d" if "d" in entries else "dF")]),
        (r"\bar p", mean, "Pa", "pm" if "pm" in entries else ""),
        ("p(a/2)", half, "Pa", "p"),
    ]
    if not plane:
        shown.append(("w(2a)", numbers("w", 2 * radius), "m", "w"))
    if case.material.separation and numbers.compact and not profile.breaks:
        shown.append(("F_{\\mathrm c}", _pull_off(numbers, case), "N", "adh.Fc"))
    given = [
        rf"${_latex(name)}={given_text(name, text, _degree(name, profile, case))}$"
        for name, text in case.parameters.items()
    ]
    name, unit = ("P", "N/m") if plane else (r"F_{\mathrm N}", "N")
    load = f"${name}={quantity_text(mp.mpf(case.load), unit)}$"
    modulus = rf"$E^{{*}}={quantity_text(_number(case.material.modulus), 'Pa')}$"
    return {
        "words": "; ".join([case.material.words, modulus, *given, load]),
        "numbers": [(name, quantity_text(value, unit), key) for name, value, unit, key in shown],
    }


def _parameters(profile: Profile, case: Case) -> Values:
    """The parameters by symbol; those of a polynomial by their index, A_1 to A_N."""
    if nt.coefficients in profile.parameters:
        found: Values = {coefficient(int(name[2:])): sp.Rational(text) for name, text in case.parameters.items()}
        return found | {nt.N: sp.Integer(len(found))}
    return {nt.describe(name).symbol: sp.Rational(text) for name, text in case.parameters.items()}


def _latex(name: str) -> str:
    return nt.describe(name).latex if nt.known(name) else name


def _number(value: sp.Rational) -> Any:
    return mp.mpf(int(value.p)) / int(value.q)


def _loaded(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Numbers:
    """The contact that carries the load."""
    load = sp.Rational(case.load)
    if profile.contact == "complete":
        if "dF" not in entries:
            return make(profile, entries, values | {nt.P: load}, DIGITS)
        known = values | {nt.F: load}
        return make(profile, entries, known | {nt.d: make(profile, entries, known, DIGITS)("dF")}, DIGITS)
    return make(profile, entries, values | {nt.a: _radius(profile, entries, values, case, make)}, DIGITS)


def _radius(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Any:
    """The contact radius by bisection of its logarithm; the force grows with it."""
    lowest = _number(values[profile.breaks[0]]) if profile.truncated else mp.mpf(10) ** -12
    highest = _number(values[profile.chain[-1]]) if nt.a in profile.chain else mp.mpf(1)
    with mp.workdps(DIGITS):
        lo, hi = mp.log(lowest * (1 + mp.mpf(10) ** -12)), mp.log(highest * (1 - mp.mpf(10) ** -12))
        for _ in range(60):
            middle = (lo + hi) / 2
            force = make(profile, entries, values | {nt.a: mp.exp(middle)}, DIGITS)("F")
            lo, hi = (middle, hi) if force < case.load else (lo, middle)
        return mp.exp((lo + hi) / 2)


def _pull_off(numbers: Numbers, case: Case) -> Any:
    """The least of F_N(a) - sqrt(8 pi E* dgamma a^3) by golden section in the logarithm of the radius."""
    modulus = _number(case.material.modulus)

    def force(logarithm: Any) -> Any:
        radius = mp.exp(logarithm)
        return numbers.at(a=radius)("F") - mp.sqrt(8 * mp.pi * modulus * case.material.separation * radius**3)

    with mp.workdps(DIGITS):
        lo, hi = mp.log(numbers["a"]) - 14, mp.log(numbers["a"])
        ratio = (mp.sqrt(5) - 1) / 2
        for _ in range(60):
            left, right = hi - ratio * (hi - lo), lo + ratio * (hi - lo)
            lo, hi = (lo, right) if force(left) < force(right) else (left, hi)
        return force((lo + hi) / 2)


def given_text(name: str, text: str, degree: int = 0) -> str:
    """A given value with its unit; that of an amplitude A of r**degree is a power of the metre."""
    notation = nt.describe(name) if nt.known(name) else None
    if notation and notation.unit in ("m", "Pa", "N", "N/m"):
        return quantity_text(mp.mpf(text), notation.unit)
    mantissa, _, power = text.partition("e")
    digits = (rf"{mantissa}\times" if mantissa != "1" else "") + f"10^{{{int(power)}}}" if power else mantissa
    return digits + (rf"\,\text{{m}}^{{{1 - degree}}}" if degree > 1 else "")


def _degree(name: str, profile: Profile, case: Case) -> int:
    """The power of r that belongs to an amplitude."""
    if name.startswith("A_"):
        return int(name[2:])
    if name != "A":
        return 0
    shape = profile.pieces[0].expr
    return (
        int(case.parameters["n"])
        if "n" in case.parameters
        else int(sp.degree(shape, nt.x if shape.has(nt.x) else nt.r))
    )


def quantity_text(value: Any, unit: str) -> str:
    """Four significant digits with a prefix of the unit."""
    if value == 0:
        return rf"0\,\text{{{unit}}}"
    with mp.workdps(DIGITS):
        power = int(mp.floor(mp.log10(abs(value)) / 3 + mp.mpf(10) ** -9)) * 3
        power = max(min(power, 9), -12)
        text = mp.nstr(value / mp.mpf(10) ** power, 4, strip_zeros=False, min_fixed=-5, max_fixed=7)
    return rf"{text.rstrip('.')}\,\text{{{PREFIXES[power]}{unit}}}"
