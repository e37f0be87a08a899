"""The calls printed in the handbook, executed as they stand, give the check values printed beside them."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
import sympy as sp
from stored_book import HANDBOOK, PRINTED

from axiderive import notation as nt
from axiderive.emit.spread import pool_of

SPREADS = {name: (HANDBOOK / "profiles" / f"{name}.tex").read_text(encoding="utf-8") for name in PRINTED}
CHECKED = [name for name, text in SPREADS.items() if "]{Check values}" in text]
GIVEN = [name for name in CHECKED if name.startswith("loads.") or name == "plane.eccentric_punch"]
"""What has no profile: a circle or a strip of unit size under a unit load."""
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


def _calls(text: str, values: dict[str, Any], **places: Any) -> dict[str, Any]:
    """What each printed call returns."""
    start, *calls = re.findall(r"\\code\{\\detokenize\{(.*?)\}\}\\par", text)
    names: dict[str, Any] = {"E_star": 1.0, **values, **places}
    exec(start, names)
    return {re.search(r"\.(\w+)\(", call)[1]: eval(call, names) for call in calls}  # type: ignore[index]


def _near(value: Any, given: float = 0.0) -> Any:
    """Close to a printed value; `given` is the relative half digit of a load that is put in as it is printed."""
    return pytest.approx(value, rel=FLOAT64 + given, abs=LAST_DIGIT)


@pytest.mark.parametrize("name", [name for name in CHECKED if name not in GIVEN])
def test_the_printed_calls_give_the_printed_values(name: str) -> None:
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
    found = _calls(text, values, **places)
    size = 2 * values["a"] if plane else np.pi * values["a"] ** 2
    mean = found.get("load", found.get("force", heads[load])) / size
    given = 0.0 if {"load", "force"} & set(found) else LAST_DIGIT / heads[load]
    assert mean == _near(heads[r"\bar p"], given)
    assert found["pressure"] / mean == _near(pressure, given)
    if "depth" in found:
        assert found["depth"] == _near(heads["d"], given)
    if not plane:
        depth = found.get("depth", values.get("d"))
        assert _calls(text, values, r=outside * values["a"])["displacement"] / depth == _near(displacement)


@pytest.mark.parametrize("name", GIVEN)
def test_the_printed_calls_without_a_profile_give_the_printed_values(name: str) -> None:
    text = SPREADS[name]
    (where,) = re.findall(r"\\sect\[(.*?); last digit rounded\]\{Check values\}", text)
    values: dict[str, Any] = {key: float(value) for key, value in re.findall(r"\$(a|p_0|s|P|e)=([\d.]+)\$", where)}
    assert values["a"] == 1.0
    rows = re.findall(r"^\$(-?[\d.]+)\$ & \$([\d.\\,]+)\$ & \$([\d.]+)\$ & \$([\d.\\,]+)\$", text, flags=re.M)
    assert len(rows) == 6
    field, place, unit = ("displacement", "r", 1.0) if "p_0" in values else ("pressure", "x", values.get("P", 0.0) / 2)
    for side in (0, 2):
        places, printed = (np.array([_number(row[i]) for row in rows]) for i in (side, side + 1))
        found = _calls(text, values, **{place: places})
        assert found[field] / unit == _near(printed)
        if "tilt" in found:
            assert found["tilt"] == _near(_number(re.findall(r"\$\\varphi=([\d.\\,]+)\$", text)[0]))


def test_every_kind_of_contact_has_check_values() -> None:
    assert len(GIVEN) == 5
    assert len(CHECKED) > 30
    assert {name.partition(".")[0] for name in CHECKED} >= {"plane", "cone", "flat_punch", "concave_power"}
