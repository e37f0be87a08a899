"""The emitted functions against the exact results at 80 digits: fixed samples over the bench domain.

Lengths from 1e-9 to 10, ratios down to 1e-6 from both ends, r/a up to 1e6.  The
tolerances are twice the worst error found on 40 points of each profile.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.code.example import NUMERIC
from axiderive.entry import Entry
from axiderive.physics.normal import derive
from axiderive.profiles import COMPACT_NAMES, load

EPS = np.finfo(float).eps
CLOSED = 8 * EPS
RULE = 32 * EPS
POINTS = 6
FORWARD = ("d", "F", "p", "w", "pm")
INTEGRAL = {"sphere_tipped_cone": 1, "wavy_paraboloid": 2, "gaussian": 2}
"""How many points of a pressure or displacement that is itself an integral: the reference takes a second each."""


def close_to_either_end(rng: random.Random) -> float:
    small = 10 ** rng.uniform(-6, 0)
    return small if rng.random() < 0.5 else 1 - small


def sample(name: str, rng: random.Random) -> tuple[dict[str, Any], float]:
    """Parameters and a contact radius."""
    profile = load(name)
    values: dict[str, Any] = {}
    for symbol in profile.parameters:
        key = str(getattr(symbol, "label", symbol))
        values[key] = 10 ** rng.uniform(-9, 1)
        if key == "theta":
            values[key] = rng.uniform(0.02, 1.4)
        if key == "n":
            values[key] = rng.choice((0.5, 1.0, 2.0, 3.7, rng.uniform(0.3, 10)))
    if name == "polynomial":
        values["A"] = (10 ** rng.uniform(-3, 3), 0.0, 10 ** rng.uniform(-3, 3))
    if name == "capped_paraboloid":
        values["R2"] = values["R1"] * close_to_either_end(rng)
    if name == "wavy_paraboloid":
        values["h"] = values["wavelength"] ** 2 / (12.3915 * values["R"]) * rng.random()
        return values, values["wavelength"] * 10 ** rng.uniform(-6, 1)
    ratio = close_to_either_end(rng)
    b = values.get("b", values.get("R", 1.0) * math.sin(values.get("theta", 1.0)))
    if name in ("sphere", "ellipsoid"):
        return values, values["R" if name == "sphere" else "b"] * ratio
    if name == "gaussian":
        return values, values["s"] * 1.5019 * ratio
    if profile.truncated or (profile.breaks and rng.random() < 0.7):
        return values, b / ratio
    return values, b * ratio if profile.breaks or "b" in values else 10 ** rng.uniform(-9, 1)


def exact(entry: Entry, values: dict[str, Any], fields: dict[sp.Symbol, float]) -> mp.mpf:
    known = {symbol: mp.mpf(value) for symbol, value in fields.items()}
    known |= {s: mp.mpf(values[s.name]) for s in entry.profile.parameters if s != nt.coefficients}
    for symbol, expr in entry.profile.abbreviations:
        known[symbol] = numeric(expr, known)
    for case in entry.cases:
        lengths = [numeric(sp.sympify(length), known) for length in case.chain]
        if all(low < high for low, high in zip(lengths, lengths[1:], strict=False)):
            expr = case.expr
            break
    if expr.has(sp.Sum):
        expr = expr.subs(nt.N, len(values["A"])).doit()
        expr = expr.subs({nt.coefficients[j]: sp.Float(mp.mpf(c), 80) for j, c in enumerate(values["A"], 1)})
    for integral in expr.atoms(sp.Integral):
        variable, low, high = integral.limits[0]
        start, end = numeric(sp.sympify(low), known), numeric(high, known)
        symbols = sorted(integral.free_symbols, key=str)
        integrand = sp.lambdify([variable, *symbols], integral.function, NUMERIC)
        panels = [start + (end - start) * part for part in (0, *(mp.mpf(10) ** -k for k in range(9, -1, -1)))]
        with mp.workdps(25):
            total = mp.quad(lambda u: integrand(u, *(known[s] for s in symbols)), panels)  # noqa: B023
        known[sp.Symbol("total")] = mp.re(total)
        expr = expr.subs(integral, sp.Symbol("total"))
    return mp.re(numeric(expr, known))


def numeric(expr: sp.Expr, known: dict[sp.Symbol, mp.mpf]) -> mp.mpf:
    symbols = sorted(expr.free_symbols, key=str)
    return mp.mpmathify(sp.lambdify(symbols, expr, NUMERIC)(*(known[symbol] for symbol in symbols)))


def points(name: str) -> Iterator[tuple[Entry, tuple[float, ...], dict[str, Any], mp.mpf]]:
    rng, entries = random.Random(17), derive(load(name))
    for index in range(POINTS):
        values, a = sample(name, rng)
        inside, outside = a * close_to_either_end(rng), a / close_to_either_end(rng)
        for suffix in FORWARD:
            entry = entries[suffix]
            if entry.status == "integral" and index >= INTEGRAL[name]:
                continue
            fields = {nt.a: a, nt.r: outside if suffix == "w" else inside, nt.E_star: 1.0}
            arguments = tuple(fields[symbol] for symbol in entry.quantity.arguments)
            keywords = values | ({"E_star": 1.0} if nt.E_star in entry.parameters else {})
            with mp.workdps(80):
                yield entry, arguments, keywords, exact(entry, values, fields)


def relative_error(got: float, reference: mp.mpf) -> float:
    return float(abs(mp.mpf(got) - reference) / abs(reference))


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_forward_functions(name: str) -> None:
    module = import_module(f"axicontact.normal.{name}")
    rows = []
    for entry, arguments, keywords, reference in points(name):
        got = getattr(module, entry.quantity.function)(*arguments, **keywords)
        error = relative_error(got, reference)
        if not error <= (RULE if entry.suffix in ("w", "F", "pm") else CLOSED):
            wanted = mp.nstr(reference, 17)
            rows.append(f"{entry.key} {arguments} {keywords}: {got!r}, wanted {wanted}, {error / EPS:.0f} ulp")
    assert not rows, "\n".join(rows)


def test_a_formula_wrong_in_the_tenth_digit_is_noticed() -> None:
    """The tolerances would mean nothing if a factor 1 + 1e-10 passed."""
    for name in ("cone", "rounded_punch", "power_law"):
        module = import_module(f"axicontact.normal.{name}")
        for entry, arguments, keywords, reference in points(name):
            got = getattr(module, entry.quantity.function)(*arguments, **keywords) * (1 + 1e-10)
            assert relative_error(got, reference) > RULE


@pytest.mark.parametrize("n", [0.5, 1.0, 2.0, 3.7, 40.0])
def test_power_law_at_any_exponent(n: float) -> None:
    from axicontact.normal import power_law

    entries = derive(load("power_law"))
    for ratio in (1e-6, 1e-3, 0.3, 0.999, 1 - 1e-6):
        values = {"A": 0.7, "n": n}
        for suffix, r in (("p", ratio), ("w", 1 / ratio)):
            entry = entries[suffix]
            keywords = values | ({"E_star": 1.0} if suffix == "p" else {})
            with mp.workdps(80):
                reference = exact(entry, values, {nt.a: 1.0, nt.r: r, nt.E_star: 1.0})
            got = getattr(power_law, entry.quantity.function)(r, 1.0, **keywords)
            assert relative_error(got, reference) < RULE, (suffix, n, r)
