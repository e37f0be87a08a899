"""The contact that carries the load of an example."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...profiles.profile import Profile
from ...proof.shape import coefficient
from ..values import Numbers, Values
from .cases import Case
from .quantities import DIGITS


def parameters(profile: Profile, case: Case) -> Values:
    """The parameters by symbol; those of a polynomial by their index, A_1 to A_N."""
    if nt.coefficients in profile.parameters:
        found: Values = {coefficient(int(name[2:])): sp.Rational(text) for name, text in case.parameters.items()}
        return found | {nt.N: sp.Integer(len(found))}
    return {nt.describe(name).symbol: sp.Rational(text) for name, text in case.parameters.items()}


def number(value: sp.Rational) -> Any:
    return mp.mpf(int(value.p)) / int(value.q)


def loaded(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Numbers:
    """The contact that carries the load."""
    load = sp.Rational(case.load)
    if profile.contact == "complete":
        if "dF" not in entries:
            return make(profile, entries, values | {nt.P: load}, DIGITS)
        known = values | {nt.F: load}
        return make(profile, entries, known | {nt.d: make(profile, entries, known, DIGITS)("dF")}, DIGITS)
    return make(profile, entries, values | {nt.a: radius_of(profile, entries, values, case, make)}, DIGITS)


def radius_of(
    profile: Profile, entries: Mapping[str, Entry], values: Values, case: Case, make: Callable[..., Numbers]
) -> Any:
    """The contact radius by bisection of its logarithm; the force grows with it."""
    lowest = number(values[profile.breaks[0]]) if profile.truncated else mp.mpf(10) ** -12
    highest = number(values[profile.chain[-1]]) if nt.a in profile.chain else mp.mpf(1)
    with mp.workdps(DIGITS):
        lo, hi = mp.log(lowest * (1 + mp.mpf(10) ** -12)), mp.log(highest * (1 - mp.mpf(10) ** -12))
        for _ in range(60):
            middle = (lo + hi) / 2
            force = make(profile, entries, values | {nt.a: mp.exp(middle)}, DIGITS)("F")
            lo, hi = (middle, hi) if force < case.load else (lo, middle)
        return mp.exp((lo + hi) / 2)


def pull_off(numbers: Numbers, case: Case) -> Any:
    """The least of F_N(a) - sqrt(8 pi E* dgamma a^3) by golden section in the logarithm of the radius."""
    modulus = number(case.material.modulus)

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
