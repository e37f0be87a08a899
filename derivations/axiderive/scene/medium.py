"""Values and half-space of a scene.

Values of a scene: read with their units, checked against the domain of their symbol, kept as SI.

The half-space of a scene: an effective modulus, given or out of E and nu; left free if nothing is said.
"""

from __future__ import annotations

import math
from typing import Any

from .. import notation as nt
from ..code.tables import bounds
from ..profiles.profile import Profile
from . import interface
from .text import SceneText, near
from .units import UnitError, kind_of, value_of


def frozen(
    text: SceneText, values: dict[str, float], section: str, key: str, raw: Any, profile: Profile | None = None
) -> None:
    """Read, check and keep one value; `key` names a parameter of the functions."""
    record = interface.record(key, profile)
    try:
        value = value_of(raw, kind_of(record))
    except UnitError as error:
        text.problem(section, key, f"{key} {error}" if str(error).startswith("must") else f"{key}: {error}")
        return
    low, high = _bounds(record)
    if not low < value < high:
        bare = record.unit == "rad" and not isinstance(raw, str) and high < value < 90
        hint = f'degrees need a unit: {key} = "{value:g} deg"' if bare else "change the value"
        given = repr(raw) if isinstance(raw, str) else f"{value:g}"
        text.problem(section, key, f"{key} = {given:.40} is outside {record.domain}; {hint}")
        return
    values[key] = value


def _bounds(record: nt.Notation) -> tuple[float, float]:
    try:
        low, high, _ = bounds(record.domain)
    except (ValueError, TypeError):
        return 0.0 if record.symbol.is_positive else -math.inf, math.inf
    return float(low), float(high)


def inline(text: SceneText, values: dict[str, float], name: str, key: str, value: Any) -> None:
    """A value of an inline table: its line is that of the table."""
    before = len(text.problems)
    frozen(text, values, "physics", key, value)
    line = text.line_of("physics", name)
    for i in range(before, len(text.problems)):
        message = text.problems[i][1].split(": ", 1)[1].split("\n  ")[0]
        text.problems[i] = (line, text.at(line, message))


KINDS = ("homogeneous", "power_law")
KEYS = ("kind", "E_star", "E", "nu", "G_star", "H", "k", "H_x")


def medium_values(text: SceneText) -> dict[str, float]:
    """E_star and G_star, or H and k, as far as they are frozen."""
    table = text.table("medium", KEYS)
    kind = table.get("kind", "homogeneous")
    if kind == "power_law":
        return _graded(text, table)
    if kind != "homogeneous":
        text.problem("medium", "kind", f"unknown medium {str(kind)[:40]!r}{near(str(kind), KINDS)}")
        return {}
    for key in ("k", "H", "H_x"):
        if key in table:
            text.problem(
                "medium", key, f'{key} belongs to a graded half-space; add kind = "power_law", or leave it out'
            )
    values: dict[str, float] = {}
    for key in ("E_star", "E", "nu", "G_star"):
        if key in table:
            _read(text, values, key, table[key])
    if "E_star" in table and ("E" in table or "nu" in table):
        text.problem("medium", "E_star", "give either E_star, or E and nu of a half-space under a rigid indenter")
    elif ("E" in table) != ("nu" in table):
        missing = "nu" if "E" in table else "E"
        text.problem(
            "medium",
            "E" if "E" in table else "nu",
            f"{missing} is missing: E_star = E/(1 - nu^2) needs both; give {missing}, or E_star alone",
        )
    elif "E" in values and "nu" in values:
        nu, E = values.pop("nu"), values.pop("E")
        values["E_star"] = E / ((1.0 - nu) * (1.0 + nu))
        values.setdefault("G_star", 2.0 * E / ((1.0 + nu) * (2.0 - nu)))
    return {key: values[key] for key in ("E_star", "G_star") if key in values}


def _graded(text: SceneText, table: dict[str, Any]) -> dict[str, float]:
    """H, k and H_x of a half-space with the foundation moduli H |x|^k and H_x |x|^k."""
    values: dict[str, float] = {}
    for key in ("E_star", "E", "nu", "G_star"):
        if key in table:
            text.problem("medium", key, f"{key} belongs to a homogeneous half-space; a graded one has H and k")
    for key in ("H", "k", "H_x"):
        if key not in table:
            continue
        try:
            value = value_of(table[key], "number")
        except UnitError as error:
            text.problem("medium", key, f"{key} {error}; H and H_x are in Pa m^(-k), without a unit")
            continue
        low, high, rule = (-1.0, 1.0, "-1 < k < 1") if key == "k" else (0.0, math.inf, f"{key} > 0")
        if low < value < high:
            values[key] = value
        else:
            text.problem("medium", key, f"{key} = {value:g} is outside {rule}; change the value")
    return values


def _read(text: SceneText, values: dict[str, float], key: str, raw: object) -> None:
    try:
        value = value_of(raw, "number" if key == "nu" else "pressure")
    except UnitError as error:
        text.problem("medium", key, f"{key} {error}" if str(error).startswith("must") else f"{key}: {error}")
        return
    if key == "nu" and not -1.0 < value <= 0.5:
        text.problem("medium", key, f"nu = {value:g} is outside -1 < nu <= 0.5; 0.5 is an incompressible half-space")
    elif key != "nu" and value <= 0.0:
        text.problem("medium", key, f"{key} = {value:g} is outside {key} > 0; a modulus is positive")
    else:
        values[key] = value
