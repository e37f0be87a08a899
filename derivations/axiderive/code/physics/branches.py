"""Pull-off and stable branches where the load is no power of the radius.

Pull-off and stable branches of the other profiles: between refined changes of sign of the growth.

Lines that count the lengths and stresses of a search in powers of two near those of the profile.

The radii of a search lie many decades apart and their cubes leave the range of doubles; a change of units by powers
of two loses nothing.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import sympy as sp

from ... import notation as nt
from ...letters import name_of
from ...notation import wavelength
from ...profiles.profile import Profile
from ..function import Function
from ..text import python
from ..writer import Writer

LOADS = {"d": "-unit", "F": "-(stress + 2 * unit)", "dgamma": "-(stress + unit)"}
"""The power of two by which a load, or a work of separation, is multiplied."""


def own_units(profile: Profile, geometry: Sequence[str], modulus: str, *given: str) -> list[str]:
    """The lines before a search; none where a parameter is neither a length nor a pure number."""
    kinds = {name_of(symbol): _unit(symbol) for symbol in profile.parameters}
    anchor = _anchor(profile, kinds)
    if not anchor or set(kinds.values()) - {"m", "1", "rad"}:
        return []
    lengths = [name for name in geometry if kinds.get(name) == "m"]
    lines = [f"unit = exponent_of({anchor})"]
    if modulus == "H":
        lines.append("stress, H = stress_at(unit, H, k)")
    else:
        lines += [f"stress = exponent_of({modulus})", f"{modulus} = np.ldexp({modulus}, -stress)"]
    lines += [f"{name} = np.ldexp({name}, -unit)" for name in lengths]
    return [*lines, *(f"{name} = np.ldexp({name}, {LOADS[name]})" for name in given)]


def returned(radius: str, lines: Sequence[str]) -> list[str]:
    """The return of a radius that was found after these lines."""
    return [f"radius = {radius}", "return np.ldexp(radius, unit)"] if lines else [f"return {radius}"]


def _unit(symbol: object) -> str:
    name = name_of(symbol)
    return nt.describe(name).unit if nt.known(name) else ""


def _anchor(profile: Profile, kinds: dict[str, str]) -> str:
    """The length at which the grid of radii is hung up, else any."""
    if profile.breaks:
        return python(dict(profile.abbreviations).get(profile.breaks[0], profile.breaks[0]))
    if profile.chain:
        return python(profile.chain[-1])
    lengths = [name for name, unit in kinds.items() if unit == "m"]
    own = [name for name in ("wavelength", "s", "b") if name in lengths]
    return (own or lengths or [""])[0]


PULLED = {"depth": "hess_retraction", "force": "pull"}


def branch_functions(module: Writer) -> list[Function]:
    """The private functions of pull-off and of the stable radii."""
    geometry = module.geometry
    needs = [*geometry, "E_star", "dgamma"]
    profile = module.profile
    reach = "(np.sqrt(4.5 * np.pi * dgamma / E_star) * 2.0 * R) ** (2.0 / 3.0)"
    grid = radii(profile, reach)
    steepness = f"np.sqrt(a) * _rate({', '.join(['a', *geometry])})"
    level = "least_steepness(control, E_star, dgamma)"
    own, samples, found = search(profile, geometry, needs, grid, steepness, level)
    units = own_units(module.profile, geometry, "E_star", "dgamma")
    return [
        Function("_rate", ["a"], geometry, _rate(module), "Derivative g'(a) of the depth without adhesion."),
        Function("_samples", [], own, samples, SAMPLED, returns="Samples", decorator="Kept"),
        Function("_branches", [], [*needs, "control"], found, returns="Branches"),
        Function("_pull_off_radius", [], [*needs, "control"], pull_off(units, needs)),
        *(_inverse(module, quantity, field, needs) for quantity, field in (("depth", "d"), ("force", "F"))),
    ]


SAMPLED = "The steepness at radii that separate the minima of the load."


def search(
    profile: Profile,
    geometry: Sequence[str],
    needs: Sequence[str],
    grid: str,
    steepness: str,
    level: str,
    name: str = "_samples",
) -> tuple[list[str], list[str], list[str]]:
    """Arguments and lines of the samples, which but for waves depend on the geometry alone; lines of `_branches`."""
    own = [one for one in needs if one in geometry or re.search(rf"\b{one}\b", grid)]
    end = "a[-1]" if profile.largest is not None or (profile.chain and not profile.breaks) else "np.inf"
    found = f"return branches(lambda a: {steepness}, {name}({', '.join(own)}), {level})"
    return own, [f"a = {grid}", f"return Samples(a, {steepness}, {end}, {{}})"], [found]


def pull_off(units: Sequence[str], needs: Sequence[str]) -> list[str]:
    """The lines of the private function of the radius at pull-off."""
    given = ", ".join(needs)
    return [
        *units,
        f"found = _branches({given}, control)",
        'load = _force if control == "force" else _depth',
        *returned(f"lowest(found, lambda a: load(a, {given}))", units),
    ]


def _inverse(module: Writer, quantity: str, field: str, needs: list[str]) -> Function:
    passed, arguments = ", ".join(needs), ", ".join(["a", *needs])
    units, unknown = own_units(module.profile, module.geometry, "E_star", "dgamma", field), unknowns(module.profile)
    rate = f"_rate({', '.join(['a', *module.geometry])})"
    curves = [
        f"lambda a: _{quantity}({arguments})",
        f'lambda a: growth({rate}, a, "{quantity}", E_star, dgamma)',
        f"lambda a: {PULLED[quantity]}(a, E_star, dgamma)",
    ]
    lines = [
        *units,
        f'found = _branches({passed}, control="{quantity}")',
        *returned(f"stable_radius({field}, found, {', '.join(curves)}, {unknown})", units),
    ]
    return Function(f"_radius_from_{quantity}", [field], needs, lines)


def unknowns(profile: Profile, grading: str = "", *, steep: bool = False) -> str:
    """The unknowns below and beyond a break, and a break inside the domain, as the last arguments of a call.

    On a graded half-space the depth of a `steep` profile leaves the break as a power of its root.
    """
    inner = "radius_itself()"
    if profile.largest is not None:
        inner = "on_the_bump(s)"
    elif profile.chain:
        inner = f"up_to({', '.join(filter(None, [python(profile.chain[-1]), grading]))})"
    if not profile.breaks:
        return inner
    end = python(dict(profile.abbreviations).get(profile.breaks[0], profile.breaks[0]))
    outer = f"beyond_edge({end}{f', 1.0 + {grading}' if steep else ''})"
    return f"{inner}, {outer}" if profile.truncated else f"{inner}, {outer}, corner={end}"


def _rate(module: Writer) -> list[str]:
    functions, profile = module.normal, module.profile
    known = functions.get("_slope_at")
    if known is not None and known[1:2] != ["root"]:
        return [f"return {module.call('_slope_at', 'a')}"]
    if "_slope_beyond" in functions:
        b = profile.breaks[0]
        lines = [f"{symbol} = {python(own)}" for symbol, own in profile.abbreviations if symbol == b and not known]
        plain = f"np.sqrt(np.maximum(a - {b}, 0.0) * (a + {b}))"
        lines.append(f"root = {root_beyond(profile) if profile.abbreviations else plain}")
        rate = module.call("_slope_at" if known else "_slope_beyond", "a", "root")
        if known is None and "_slope" in functions:
            rate = f"np.where(a < {b}, {module.call('_slope', 'a')}, {rate})"
        return [*lines, f"return {rate}"]
    if functions["_slope"][1:2] == ["root"]:
        end = profile.chain[-1]
        root = f"np.sqrt(np.maximum({end} - a, 0.0) * ({end} + a))"
        return [f"root = {root}", f"return {module.call('_slope', 'a', 'root')}"]
    return [f"return {module.call('_slope', 'a')}"]


def root_beyond(profile: Profile) -> str:
    """Text of sqrt(a**2 - b**2) beyond a break, which b as a rounded product of others would spoil next to it."""
    b = profile.breaks[0]
    whole = dict(profile.abbreviations).get(b)
    if whole is None:
        return f"difference_root(a, {b})"
    (sine,) = whole.atoms(sp.sin)
    return f"sine_root(a, {python(whole / sine)}, {python(sine.args[0])})"


def radii(profile: Profile, reach: str, *, graded: bool = False) -> str:
    """The grid that separates the minima of the load; over waves up to `reach`."""
    if profile.largest is not None:
        return f"radii_to({'gaussian_reach(s, k)' if graded else python(profile.largest)})"
    if profile.breaks:
        own = dict(profile.abbreviations)
        end = python(own.get(profile.breaks[0], profile.breaks[0]))
        return f"radii_{'beyond' if profile.truncated else 'around'}({end})"
    if profile.chain:
        return f"radii_below({python(profile.chain[-1])})"
    return f"radii_of_waves(wavelength, {reach})" if wavelength in profile.parameters else "decades()"
