"""Lines that count the lengths and stresses of a search in powers of two near those of the profile.

The radii of a search lie many decades apart and their cubes leave the range of doubles; a change of units by powers
of two loses nothing.
"""

from __future__ import annotations

from collections.abc import Sequence

from ... import notation as nt
from ...letters import name_of
from ...profiles.profile import Profile
from ..code import python

LOADS = {"d": "-unit", "F": "-(stress + 2 * unit)"}
"""The power of two by which a load is multiplied."""


def own_units(profile: Profile, geometry: Sequence[str], modulus: str, field: str = "") -> list[str]:
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
    lines.append("dgamma = np.ldexp(dgamma, -(stress + unit))")
    return [*lines, f"{field} = np.ldexp({field}, {LOADS[field]})"] if field else lines


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
