"""The check values printed in the handbook are what the functions of the package give."""

from __future__ import annotations

import math
import re
from importlib import import_module
from typing import Any

import numpy as np
import pytest
import sympy as sp
from stored_book import HANDBOOK, PRINTED, stored

from axiderive import notation as nt
from axiderive.book.page import BREAKS
from axiderive.book.spread import problems_of
from axiderive.letters import name_of
from axiderive.physics.systems import pool_of

SPREADS = {name: (HANDBOOK / "profiles" / f"{name}.tex").read_text(encoding="utf-8") for name in PRINTED}
CHECKED = [name for name, text in SPREADS.items() if "]{Check values}" in text]
GIVEN = [name for name in CHECKED if name.startswith("loads.") or name == "plane.eccentric_punch"]
"""What has no profile: a circle or a strip of unit size under a unit load."""
BROKEN = [name for name in CHECKED if name not in GIVEN and pool_of(name).load(name.rpartition(".")[2]).breaks]
NAMES = {nt.describe(symbol).latex: symbol.name for symbol in (nt.a, nt.d)}
LAST_DIGIT = 0.6e-12
"""A printed value is rounded to nearest in its twelfth decimal."""
FLOAT64 = 2e-13
"""What the functions may lose of a value of the size of one, and of the larger ones in proportion."""


def _number(text: str) -> float:
    return float(text.replace(r"\,", ""))


def _values(name: str, text: str) -> dict[str, Any]:
    """The parameters at which the check values hold, by their names in Python."""
    parameters = [s for s in pool_of(name).load(name.rpartition(".")[2]).parameters if isinstance(s, sp.Symbol)]
    names = NAMES | {nt.describe(symbol).latex: symbol.name for symbol in parameters}
    (where,) = re.findall(r"\\sect\[(.*?); last digit rounded\]\{Check values\}", text)
    found: dict[str, Any] = {}
    for latex, value in re.findall(r"\$([^$=]+)=([-\d.]+)[^$]*\$", where):
        if latex.startswith("A_"):
            found.setdefault("A", []).append(float(value))
        elif latex in names:
            found[names[latex]] = float(value)
    return found


def _calls(name: str, values: dict[str, Any], **places: Any) -> dict[str, Any]:
    """What each function of the first module of an entry returns whose arguments have values."""
    problem = problems_of(name)[0]
    module = import_module(problem.module.removesuffix(".py").replace("/", "."))
    known = {"E_star": 1.0, **values, **places}
    found = {}
    for entry in (entry for suffix, entry in stored(name).items() if suffix in ("d", "F", "P", "p", "w", "phi")):
        fields = [name_of(symbol) for symbol in entry.quantity.arguments]
        keywords = [name_of(symbol) for symbol in entry.parameters if name_of(symbol) not in fields]
        if {*fields, *keywords} <= set(known):
            function = getattr(module, entry.quantity.function)
            found[entry.quantity.function] = function(*(known[f] for f in fields), **{k: known[k] for k in keywords})
    return found


def _near(value: Any, given: float = 0.0) -> Any:
    """Close to a printed value; `given` is the relative half digit of a load that is put in as it is printed."""
    return pytest.approx(value, rel=FLOAT64 + given, abs=LAST_DIGIT)


@pytest.mark.parametrize("name", BROKEN)
def test_the_values_over_the_place_of_a_break_are_those_of_the_functions(name: str) -> None:
    text = SPREADS[name]
    values = _values(name, text)
    rows = re.findall(r"^\$([\d.]+)\$" + r" & \$([-\d.\\,]+)\$" * 4 + r"\\\\$", text, flags=re.M)
    assert [row[0] for row in rows] == list(BREAKS)
    profile, a = pool_of(name).load(name.rpartition(".")[2]), values["a"]
    plane = name.startswith("plane.")
    for row in rows:
        b = _number(row[0]) * a
        given = values | ({"R": b / math.sin(values["theta"])} if profile.abbreviations else {"b": b})
        place = {"x" if plane else "r": a / 2}
        found = _calls(name, given, **place, L=2.7 * a)
        size = 2 * a if plane else math.pi * a * a
        load = found["load" if plane else "force"]
        depth = found["depth"]
        sunk = depth - _calls(name, given, L=2 * a)["depth"] if plane else _calls(name, given, r=2 * a)["displacement"]
        assert [depth, load, found["pressure"] * size / load, sunk / depth] == [_near(_number(tex)) for tex in row[1:]]


@pytest.mark.parametrize("name", [name for name in CHECKED if name not in GIVEN and name not in BROKEN])
def test_the_functions_give_the_printed_values(name: str) -> None:
    text = SPREADS[name]
    values = _values(name, text)
    heads = {key: _number(value) for key, value in re.findall(r"\$(d|P|F_\{\\mathrm N\}|\\bar p)=([\d.\\,]+)\$", text)}
    rows = re.findall(r"^\$([\d.]+)\$ & \$([-\d.\\,]+)\$ & \$([\d.]+)\$ & \$([-\d.\\,]+)\$", text, flags=re.M)
    assert len(rows) == 6
    inside, pressure, outside, displacement = (np.array([_number(row[i]) for row in rows]) for i in range(4))
    plane = name.startswith("plane.")
    place, load = ("x", "P") if plane else ("r", r"F_{\mathrm N}")
    values = {"P": heads.get("P")} | values if plane else values
    places = {place: inside * values["a"], "L": 2.7 * values["a"]}
    found = _calls(name, values, **places)
    size = 2 * values["a"] if plane else np.pi * values["a"] ** 2
    mean = found.get("load", found.get("force", heads[load])) / size
    given = 0.0 if {"load", "force"} & set(found) else LAST_DIGIT / heads[load]
    assert mean == _near(heads[r"\bar p"], given)
    assert found["pressure"] / mean == _near(pressure, given)
    if "depth" in found:
        assert found["depth"] == _near(heads["d"], given)
    if not plane:
        depth = found.get("depth", values.get("d"))
        assert _calls(name, values, r=outside * values["a"])["displacement"] / depth == _near(displacement)
    else:
        sunk = found["depth"] - _calls(name, values, L=outside * values["a"])["depth"]
        assert sunk / found["depth"] == _near(displacement, given)


@pytest.mark.parametrize("name", GIVEN)
def test_the_functions_without_a_profile_give_the_printed_values(name: str) -> None:
    text = SPREADS[name]
    (where,) = re.findall(r"\\sect\[(.*?); last digit rounded\]\{Check values\}", text)
    values: dict[str, Any] = {key: float(value) for key, value in re.findall(r"\$(a|p_0|s|P|e)=([\d.]+)\$", where)}
    assert values["a"] == 1.0
    rows = re.findall(r"^\$(-?[\d.]+)\$ & \$([\d.\\,]+)\$ & \$([\d.]+)\$ & \$([\d.\\,]+)\$", text, flags=re.M)
    assert len(rows) == 6
    field, place, unit = ("displacement", "r", 1.0) if "p_0" in values else ("pressure", "x", values.get("P", 0.0) / 2)
    for side in (0, 2):
        places, printed = (np.array([_number(row[i]) for row in rows]) for i in (side, side + 1))
        found = _calls(name, values, **{place: places})
        assert found[field] / unit == _near(printed)
        if "p_0" in values:
            force = math.pi / (1 + _exponent(name, values))
            assert force == _near(_number(re.findall(r"\$F_\{\\mathrm N\}=([\d.\\,]+)\$", text)[0]))
        if "tilt" in found:
            assert found["tilt"] == _near(_number(re.findall(r"\$\\varphi=([\d.\\,]+)\$", text)[0]))


def _exponent(name: str, values: dict[str, Any]) -> float:
    """That of the pressure over 1 - r^2/a^2."""
    exponent = pool_of(name).load(name.rpartition(".")[2]).exponent
    return float(sp.sympify(exponent).subs(nt.sigma, values.get("s", 0.0)))


def test_every_kind_of_contact_has_check_values() -> None:
    assert len(GIVEN) == 5
    assert len(CHECKED) > 30
    assert {name.partition(".")[0] for name in CHECKED} >= {"plane", "cone", "flat_punch", "concave_power"}
