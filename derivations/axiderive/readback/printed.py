"""The printed rows of a problem as functions: g, F_N, p and w as a reader of the book would evaluate them.

What stands on the left of a row is the quantity whose value is compared, at the place it is compared at.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.shape import coefficient, number, numeric_symbols
from ..physics.systems import of
from ..rows.row import Region, Row, kappa_row, row
from .grammar import read
from .meaning import Environment, Node, environment

Values = dict[Any, Any]
Function = Callable[..., Any]


class Printed:
    """The rows of a problem, and of the normal contact on the same medium that its rules refer to."""

    def __init__(self, entries: Mapping[str, Entry], base: Mapping[str, Entry]) -> None:
        self.entries, self.base = entries, base
        self.profile = next(iter(base.values())).profile
        self.kappa = _kappa(tuple(base.values()))

    def environment(self, values: Values) -> dict[str, Any]:
        """Every name that a row may use: symbols, kappa, and the functions of other rows."""
        env: dict[str, Any] = named(values) | self.kappa
        tip = number(values[self.profile.breaks[0]]) if self.profile.truncated else None
        env |= {
            "g()": self._of_radius("d", env, tip),
            "F_N()": self._of_radius("F", env, tip),
            "P()": self._of_radius("P", env, tip),
            "p()": self._field("p", env),
            "w()": self._field("w", env),
            "cuts": self._cuts(values),
        }
        env["g'()"] = lambda radius: mp.diff(env["g()"], radius)
        if "Dl" in self.entries:
            env |= {
                "d_adh()": self._of_radius("d", env, tip, self.entries),
                "F_adh()": self._of_radius("F", env, tip, self.entries),
                "Delta ell": Node(lambda known: self.at("Dl", known, self.entries)),
            }
        return env

    def at(self, suffix: str, env: Environment, entries: Mapping[str, Entry] | None = None) -> Any:
        """A printed row of the normal contact, or of other entries, where its names have these values."""
        one = row((self.base if entries is None else entries)[suffix])
        region = holding(one, env) if one.kind == "formula" else one.regions[0]
        statements = read(region.tex)
        return statements[0].members[-1](environment(statements[1:], env))

    def _of_radius(
        self, suffix: str, env: Environment, tip: Any, entries: Mapping[str, Entry] | None = None
    ) -> Function:
        """A quantity at another radius; a contact within the flat tip carries nothing while it is not pressed in."""

        def value(radius: Any) -> Any:
            if tip is not None and radius <= tip:
                return mp.mpf(0)
            return self.at(suffix, {**env, "a": radius}, entries)

        return value

    def _field(self, suffix: str, env: Environment) -> Function:
        def value(place: Any, radius: Any = None) -> Any:
            radius = env["a"] if radius is None else radius
            if suffix == "p" and place > radius:
                return mp.mpf(0)
            return self.at(suffix, {**env, "a": radius, "r": place})

        return value

    def _cuts(self, values: Values) -> dict[str, list[Any]]:
        """Where the integrals of the rules cross a break of the profile."""
        if nt.r not in values or nt.k not in values or not self.profile.breaks:
            return {}
        radius, power = number(values[nt.r]), (1 + number(values[nt.k])) / 2
        breaks = [number(values[b]) for b in self.profile.breaks]
        return {
            "u": [(b * b - radius * radius) ** power for b in breaks if b > radius],
            "psi": [mp.asin(b / radius) for b in breaks if b < radius],
        }


@lru_cache(maxsize=256)
def _kappa(entries: tuple[Entry, ...]) -> dict[str, Any]:
    text = kappa_row(entries)
    return environment(read(text), {}) if text else {}


def holding(one: Row, env: Environment) -> Region:
    """The one region whose printed range contains the point."""
    found = [region for region in one.regions if holds(region.condition, env)]
    if len(found) != 1:
        message = f"{one.key}: {len(found)} printed ranges hold at one point: {[region.condition for region in found]}"
        raise LookupError(message)
    return found[0]


def holds(condition: str, env: Environment) -> bool:
    """Whether a printed range, chains of < and <= separated by commas, contains the point."""
    for chain in filter(None, condition.split(r",\; ")):
        if re.search(r">|\\ge(?![a-z])", chain):
            chain = "<".join(reversed(re.split(r">|\\ge(?![a-z])", chain)))
        members = [read(part)[0].members[0](env) for part in re.split(r"<|\\le(?![a-z])", chain)]
        if any(lo >= hi for lo, hi in zip(members, members[1:], strict=False)):
            return False
    return True


def named(values: Values) -> dict[str, Any]:
    """The values under the names their symbols have in print."""
    env: dict[str, Any] = {name_in_print(s): number(values[s]) for s in numeric_symbols(values) if nt.known(s.name)}
    if nt.N in values:
        env["A_j"] = [number(values[coefficient(i)]) for i in range(1, int(values[nt.N]) + 1)]
    if nt.a_c in values:
        env |= {"a_c": number(values[nt.a_c]), "a_m": number(values[nt.a_c])}
    return env


def name_in_print(symbol: sp.Symbol) -> str:
    """The name under which the reader finds a symbol, read from its LaTeX."""
    return read(nt.describe(symbol).latex)[0].members[0].name


NORMAL = {
    "d": "d", "F": "F_N", "p": "p(r)", "w": "w(r)", "k": "dF_N/dd", "pm": "bar p", "ad": "a", "aF": "a", "Fd": "F_N",
    "dF": "d", "rz": "r_0", "dmin": "d_min", "Fmin": "F_min", "rp": "r_max", "pp": "p_max",
}  # fmt: skip
ADHESIVE = {
    "Dl": "Delta ell", "d": "d_adh(a)", "F": "F_adh(a)", "p": "p_adh(r)", "w": "w_adh(r)", "ad": "a", "aF": "a",
    "ac": "a_c", "Fc": "F_c", "dc": "d_c", "am": "a_m", "Fm": "F_m", "dm": "d_m",
}  # fmt: skip
TANGENTIAL = {"F": "F_x", "tau": "tau(r)", "u": "u", "c": "c", "us": "u_s"}
PLANE = {
    "P": "P", "p": "p(x)", "s": "dw/dx", "d": "d", "aP": "a", "xz": "x_0", "Pmin": "P_min", "phi": "varphi",
    "cw": "ell",
}  # fmt: skip
LOADS = {"w": "w(r)"}
VISCOELASTIC = {"step": "F_N(t)", "load": "a", "ramp": "F_N(t)"}
NAMES = {
    "normal": NORMAL, "adhesive": ADHESIVE, "tangential": TANGENTIAL, "plane": PLANE, "loads": LOADS,
    "viscoelastic": VISCOELASTIC,
}  # fmt: skip


def name_of(entry: Entry) -> str:
    """The quantity of an entry as the grammar reads its name, with its argument in brackets: p(r)."""
    table = NAMES.get(of(entry).physics.name)
    return table[entry.suffix.partition("_")[0]] if table else name_in_print(entry.quantity.symbol)


def bound(name: str, value: Any, env: Mapping[str, Any]) -> dict[str, Any]:
    """The names of a point with one of them, or a function at one argument, bound to a value."""
    function, _, argument = name.partition("(")
    if not argument:
        return {**env, name: value}
    return {**env, f"{function}()": _at(name, value, env[argument.rstrip(")")])}


def _at(name: str, value: Any, place: Any) -> Callable[[Any], Any]:
    """A function that is known at one place only."""

    def known(argument: Any) -> Any:
        if argument != place:
            message = f"the row states {name}, and not its value at {argument}"
            raise LookupError(message)
        return value

    return known
