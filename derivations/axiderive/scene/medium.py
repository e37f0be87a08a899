"""The half-space of a scene: an effective modulus, given or out of E and nu; left free if nothing is said."""

from __future__ import annotations

import math
from typing import Any

from .text import SceneText, near
from .units import UnitError, value_of

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
