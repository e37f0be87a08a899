"""Emitted modules of the plane problem against the exact entries and the defining integrals."""

from __future__ import annotations

import math
import random
import sys
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from plane_modules import ACCURACY, CONCAVE, SMOOTH, entries, written
from stored_book import evidence, stored

from axiderive import notation as nt
from axiderive.code.plane import module
from axiderive.entry import Case, Entry
from axiderive.oracle.plane import GUARD, defined
from axiderive.profiles import plane
from axiderive.stable.measure import samples, ulps
from axiderive.stable.measure import value as measured
from axiderive.stable.reference import DOMAINS, Domain, condition, floats

Values = dict[sp.Symbol, float]
UNITS = 5.0
"""Of the last place, over 1 + the condition where there are more; 4.0 is measured (least load of a concave power)."""


def ratio(draw: random.Random) -> float:
    """Between 0 and 1, down to 1e-6 of either end."""
    share = float(10 ** draw.uniform(-6, 0))
    return share if draw.random() < 0.5 else 1 - share


def state(name: str, draw: random.Random) -> Values:
    """Lengths of 1e-9 to 10 m; x inside the contact, L outside, the break on either side of the edge and near x."""
    profile, a = plane.load(name), 10 ** draw.uniform(-9, 1)
    values = {
        nt.a: a, nt.E_star: 10 ** draw.uniform(3, 11), nt.theta: 10 ** draw.uniform(-4, -0.2),
        nt.R: 10 ** draw.uniform(-6, 2), nt.A: 10 ** draw.uniform(-3, 3), nt.h: a * 10 ** draw.uniform(-5, -1),
        nt.n: 10 ** draw.uniform(-1, 1.2) if profile.contact == "compact" else 1 + 10 ** draw.uniform(-2, 1.2),
        nt.x: a * ratio(draw), nt.L: a / ratio(draw),
    }  # fmt: skip
    if profile.breaks:
        share = ratio(draw)
        values[nt.b] = a * share if profile.truncated or draw.random() < 0.6 else a / share
        if values[nt.b] < a and draw.random() < 0.3:
            near = values[nt.b] * (1 + draw.choice((-1, 1)) * 10 ** draw.uniform(-6, -1))
            values[nt.x] = min(near, a * (1 - 1e-7))
    return values


def exact_numbers(values: Values) -> dict[sp.Symbol, sp.Expr]:
    return {symbol: sp.Rational(value) for symbol, value in values.items()}


def called(module: ModuleType, entry: Entry, values: Values) -> float:
    fields = [values[symbol] for symbol in entry.quantity.arguments]
    parameters = {str(symbol): values[symbol] for symbol in entry.parameters}
    return float(getattr(module, entry.quantity.function)(*fields, **parameters))


def ready(module: ModuleType, name: str, values: Values, suffix: str, draw: random.Random) -> Values:
    """The state for one function: x outside for the slope, a load of complete contact."""
    values = dict(values)
    if suffix == "s":
        values[nt.x] = values[nt.a] / ratio(draw)
    if name in plane.COMPLETE_NAMES:
        least = called(module, entries(name)["Pmin"], values) if name in CONCAVE else 1.0
        values[nt.P] = least * (1 + 10 ** draw.uniform(-3, 3))
    return values


def worst(module: ModuleType, name: str, suffix: str, count: int) -> tuple[float, str]:
    """The largest error over both domains, and where: in units of the last place, of many over 1 + the condition."""
    own, found = dict(entries(name)), (0.0, "")
    function = getattr(module, own[suffix].quantity.function)
    for domain in DOMAINS:
        points = list(samples(own, suffix, domain, count))
        assert points
        for point in points:
            error = ulps(measured(function, point), point.exact)
            if UNITS < error < math.inf:
                error /= 1.0 + condition(own, suffix, point.values)
            found = max(found, (error, f"{domain.name}: {point.arguments} {point.keywords}"))
    return found


@pytest.mark.parametrize("name", SMOOTH)
def test_accuracy_against_the_exact_entries(name: str) -> None:
    """What the build has measured at thirty points of either domain; `test_catalogue` asks whether of these modules."""
    key = f"plane.{name}"
    recorded = evidence(key)["evaluation"]
    # the place of zero pressure of a power is an equation in x and n, measured below
    assert recorded.keys() == stored(key).keys() - ({"xz"} if name == "concave_power" else set())
    for suffix, row in recorded.items():
        for found in (row[domain.name] for domain in DOMAINS):
            assert found["points"] and not found["lost"]
            assert min(found["worst_ulp"], found.get("over_condition", math.inf)) <= UNITS, (key, suffix, found)


@pytest.mark.slow
@pytest.mark.parametrize("name", SMOOTH)
def test_accuracy_at_more_points(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    for suffix in entries(name):
        # the place of zero pressure of a power is searched in many digits for every value
        error, where = worst(plane_module(name), name, suffix, 80 if name == "concave_power" else 400)
        assert error <= UNITS, (suffix, where)


@pytest.mark.parametrize("name", [name for name in SMOOTH if name != "flat_punch"])
def test_accuracy_against_the_defining_integrals(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    """Not through the closed forms: a wrong entry would not pass, whatever the emission does."""
    module, draw, profile = plane_module(name), random.Random(7), plane.load(name)
    suffixes = [suffix for suffix in ("P", "p", "s", "d") if suffix in entries(name)]
    with mp.workdps(20 + GUARD):
        for suffix in suffixes:
            # the substitution of the quadrature is for whole powers: near t = 0 it is slow for small ones
            values = ready(module, name, state(name, draw) | {nt.n: 2.75}, suffix, draw)
            if name in CONCAVE:  # away from the zero of the pressure
                values[nt.P] += called(module, entries(name)["Pmin"], values)
            values[nt.x] = values[nt.a] * (1.75 if suffix == "s" else 0.375)
            values[nt.L] = values[nt.a] * 2.25
            value = defined(profile, suffix, exact_numbers(values), 20)
            found = called(module, entries(name)[suffix], values)
            assert abs(found - value) < 2 * ACCURACY * abs(value), (suffix, values)


@pytest.mark.parametrize("n", [1.01, 1.5, 2.0, 2.3, 4.0, 12.0])
def test_least_load_of_a_concave_power(n: float, plane_module: Callable[[str], ModuleType]) -> None:
    """At the least load the pressure is zero at the place that is named, and positive elsewhere."""
    module, given = plane_module("concave_power"), {"a": 0.75, "h": 0.01, "n": n}
    place = module.zero_distance(**given)
    least = module.minimum_load(**given, E_star=3.0)
    scale = least / given["a"]
    assert abs(module.pressure(place, least, **given, E_star=3.0)) < 1e-14 * scale / min(n - 1, 1)
    around = module.pressure(np.linspace(0.0, 0.7499, 900), least, **given, E_star=3.0)
    assert (around > -1e-14 * scale / min(n - 1, 1)).all()
    assert (place == 0.0) == (n <= 2.0)


def test_special_powers_are_those_of_the_law(plane_module: Callable[[str], ModuleType]) -> None:
    law, quartic = plane_module("concave_power"), plane_module("concave_quartic")
    given = {"a": 0.75, "h": 0.01, "E_star": 3.0}
    assert law.minimum_load(**given, n=4.0) == pytest.approx(quartic.minimum_load(**given), rel=ACCURACY, abs=0.0)
    assert law.zero_distance(a=0.75, h=0.01, n=4.0) == pytest.approx(
        quartic.zero_distance(a=0.75, h=0.01), rel=1e-14, abs=0.0
    )


ECCENTRICITIES = (0.0, 0.2, 0.375, 0.375 * (1 - 1e-7), 0.375 * (1 + 1e-7), 0.5, 0.7, 0.75 * (1 - 1e-6))


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_pressure_of_the_eccentric_punch_carries_load_and_moment(
    e: float, sign: float, plane_module: Callable[[str], ModuleType]
) -> None:
    """Gauss rules for the weight of either pressure, with nodes in the contact that the width names."""
    module, a, P, e = plane_module("eccentric_punch"), 0.75, 2.5, sign * e
    width = module.contact_width(a=a, e=e)
    side = math.copysign(1.0, e)
    angle = (np.arange(400) + 0.5) * np.pi / 400
    x = side * (a - width / 2 * (1 - np.cos(angle)))
    pressure = module.pressure(x, P, a=a, e=e)
    weight = np.pi / 400 * width / 2 * np.sin(angle)
    assert np.sum(pressure * weight) == pytest.approx(P, rel=1e-8)
    assert np.sum(pressure * weight * x) == pytest.approx(P * e, rel=1e-8, abs=1e-12)
    lifted = -side * (a - (2 * a - width) / 2)
    assert module.pressure(lifted, P, a=a, e=e) == 0.0 or width == 2 * a


@pytest.mark.parametrize("domain", DOMAINS, ids=lambda domain: domain.name)
def test_accuracy_of_the_eccentric_punch(domain: Domain, plane_module: Callable[[str], ModuleType]) -> None:
    """A load on either side, next to the middle, to lift-off and to overturning, and places next to either end."""
    module, own = plane_module("eccentric_punch"), entries("eccentric_punch")
    for suffix, entry in own.items():
        points = list(samples(own, suffix, domain, 120))
        assert len(points) > 100
        for point in points:
            error = ulps(measured(getattr(module, entry.quantity.function), point), point.exact)
            assert error <= UNITS, (suffix, point.arguments, point.keywords)


def test_points_of_an_eccentric_load() -> None:
    """Both signs of load and place, and every end: the middle, lift-off, overturning, the edges, the lifted end."""
    for domain, small, close in ((DOMAINS[0], 1e-5, 1e-5), (DOMAINS[1], 1e-100, 1e-14)):
        points = list(floats(entries("eccentric_punch")["p"], domain, 700))
        shares = [abs(point[nt.e] / point[nt.a]) for point in points]
        assert min(shares) < small
        assert min(1.0 - share for share in shares) < close
        for side in (-1.0, 1.0):
            assert 0.0 < min(side * (share - 0.5) for share in shares if side * (share - 0.5) > 0.0) < close
            places = [side * point[nt.x] / point[nt.a] for point in points if side * point[nt.e] > 0.0]
            assert min(1.0 - place for place in places) < 10 * close
            assert min(1.0 + place for place in places) < 10 * close
            apart = [point for point in points if side * point[nt.e] > point[nt.a] / 2]
            reached = [reach for reach in map(from_lifted_end, apart) if reach > 0]
            assert min(reached) < 100 * close


def from_lifted_end(point: Values) -> Fraction:
    """Over the half-width."""
    x, a, e = (Fraction(float(point[symbol])) for symbol in (nt.x, nt.a, nt.e))
    return ((x if e > 0 else -x) + 3 * a - 4 * abs(e)) / a


def mutant(entry: Entry, change: Callable[[sp.Expr], sp.Expr]) -> Entry:
    return replace(entry, cases=tuple(Case(case.chain, change(case.expr)) for case in entry.cases))


@pytest.mark.parametrize(
    ("name", "suffix", "change"),
    [
        ("quartic", "s", lambda expr: expr.subs(sp.sqrt(nt.x**2 - nt.a**2), nt.x)),
        ("rounded_punch", "P", lambda expr: expr.subs(sp.acos(nt.b / nt.a), sp.asin(nt.b / nt.a))),
        ("truncated_wedge", "p", lambda expr: expr.replace(sp.atanh, sp.asinh)),
    ],
)
def test_a_wrong_formula_is_seen(
    name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The comparison is made with the entries of the engine, the module from a corrupted one."""
    wrong = entries(name) | {suffix: mutant(entries(name)[suffix], change)}
    written(tmp_path, "mutated_plane", {f"axicontact/plane/{name}.py": module(wrong).source()})
    (tmp_path / "mutated_plane" / "plane" / "__init__.py").write_text("")
    monkeypatch.syspath_prepend(str(tmp_path))
    for found in [found for found in sys.modules if found.startswith("mutated_plane")]:
        monkeypatch.delitem(sys.modules, found)
    assert worst(import_module(f"mutated_plane.plane.{name}"), name, suffix, 10)[0] > 1e3 * UNITS
