"""Values and half-space of a scene: numbers with units as SI, checked against the domain of their symbol.

A unit of another kind is named as such. The half-space has an effective modulus, given or out of E and nu, or those of
a graded one; what is not said stays free.
"""

from __future__ import annotations

import difflib
import math
import re
from fractions import Fraction
from typing import Any

from .. import notation as nt
from ..profiles.profile import Profile
from . import interface
from .text import SceneText, near

KINDS: dict[str, dict[str, Fraction]] = {
    "length": {"m": Fraction(1), "cm": Fraction(1, 100), "mm": Fraction(1, 1000), "um": Fraction(1, 10**6),
               "nm": Fraction(1, 10**9)},
    "pressure": {"Pa": Fraction(1), "kPa": Fraction(1000), "MPa": Fraction(10**6), "GPa": Fraction(10**9)},
    "force": {"N": Fraction(1), "kN": Fraction(1000), "mN": Fraction(1, 1000), "uN": Fraction(1, 10**6),
              "nN": Fraction(1, 10**9)},
    "energy per area": {"J/m^2": Fraction(1), "mJ/m^2": Fraction(1, 1000), "N/m": Fraction(1),
                        "mN/m": Fraction(1, 1000)},
    "viscosity": {"Pa s": Fraction(1), "kPa s": Fraction(1000), "MPa s": Fraction(10**6), "GPa s": Fraction(10**9)},
    "time": {"s": Fraction(1), "ms": Fraction(1, 1000), "min": Fraction(60), "h": Fraction(3600)},
    "angle": {"rad": Fraction(1), "deg": Fraction(0)},
    "number": {"1": Fraction(1)},
}  # fmt: skip
EXAMPLES = {"length": "mm", "pressure": "MPa", "force": "mN", "energy per area": "mJ/m^2", "angle": "deg",
            "viscosity": "kPa s", "time": "s"}  # fmt: skip
"""The unit that a message writes."""
OTHERS = {"grad": "deg", "degree": "deg", "degrees": "deg", "n/mm^2": "MPa", "n/mm2": "MPa", "micron": "um"}
"""Other words for units, in small letters."""
NOT_HERE = frozenset(["kg", "g"])
"""Near to the name of a unit, and another thing."""
NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*?)\s*")
POWER = re.compile(r"([a-z]+)\^\(?([-+]?\d{1,2}(?:\.\d+)?)\)?")


class UnitError(ValueError):
    """A value that cannot be read as the quantity it stands for."""


def kind_of(record: nt.Notation) -> str:
    """What the values of a parameter are called."""
    return next((kind for kind, units in KINDS.items() if record.unit in units), record.unit)


def value_of(raw: object, kind: str) -> float:
    """The value in SI units.

    Parameters
    ----------
    raw : object
        A number in SI units, or a text with a number and a unit.
    kind : str
        Key of `KINDS`, or a power of a length such as "m^(-3)".
    """
    if isinstance(raw, bool) or not isinstance(raw, (int, float, str)):
        message = f"must be a number or a text with a unit, not {type(raw).__name__}; write {_example(kind)!r}"
        raise UnitError(message)
    value = _with_unit(raw, kind) if isinstance(raw, str) else _plain(raw)
    if not math.isfinite(value):
        message = f"{raw!r} is no finite number; write {_example(kind)!r}"
        raise UnitError(message)
    return value


def _plain(raw: float) -> float:
    try:
        return float(raw)
    except OverflowError:
        return math.inf


def _with_unit(text: str, kind: str) -> float:
    match = NUMBER.fullmatch(text)
    example = f"write {_example(kind)!r}"
    if match is None:
        message = f"{text[:40]!r} is no number with a unit; {example}"
        raise UnitError(message)
    number, unit = Fraction(match[1]), match[2].replace("µ", "u").replace("°", "deg")
    if not unit:
        return _plain(number)  # type: ignore[arg-type]
    factor = _factor(unit, kind, text, example)
    return math.radians(float(number)) if unit == "deg" else _plain(number * factor)  # type: ignore[arg-type]


def _factor(unit: str, kind: str, text: str, example: str) -> Fraction:
    own = KINDS.get(kind, {})
    if unit in own:
        return own[unit]
    power = POWER.fullmatch(unit)
    wanted = POWER.fullmatch(kind)
    if power and wanted and power[1] in KINDS["length"] and float(power[2]) == float(wanted[2]):
        scale = KINDS["length"][power[1]]
        return scale ** int(power[2]) if "." not in power[2] else Fraction(float(scale) ** float(power[2]))
    other = next((name for name, units in KINDS.items() if unit in units), None)
    if other is not None:
        message = f"must be {_article(kind)}, but {text[:40]!r} is {_article(other)}; {example}"
        raise UnitError(message)
    if re.match(r",\d", unit):
        message = f"{text[:40]!r} has a comma, and decimals have a point; write '{text.replace(',', '.')[:40].strip()}'"
        raise UnitError(message)
    known = {name.lower(): name for name in own} | {wrong: right for wrong, right in OTHERS.items() if right in own}
    near = difflib.get_close_matches(unit.lower(), known, n=1, cutoff=0.4) if unit not in NOT_HERE else []
    hint = f"did you mean {known[near[0]]!r}?" if near else example
    message = f"unit {unit[:20]!r} in {text[:40]!r} is unknown; {hint}"
    raise UnitError(message)


def _article(kind: str) -> str:
    return f"{'an' if kind[0] in 'ae' else 'a'} {kind}" if kind in KINDS else f"in {kind}"


def _example(kind: str) -> str:
    return "0.3" if kind == "number" else f"5 {EXAMPLES.get(kind, kind)}"


def given(text: SceneText, section: str, key: str, raw: object, kind: str, name: str, after: str = "") -> float | None:
    """The value in SI units; None where it cannot be read, which is a problem of the text at this key."""
    try:
        return value_of(raw, kind)
    except UnitError as error:
        colon = "" if after or str(error).startswith("must") else ":"
        text.problem(section, key, f"{name}{colon} {error}{after}")
        return None


def frozen(
    text: SceneText, values: dict[str, float], section: str, key: str, raw: Any, profile: Profile | None = None,
    *, inside: str = "", kind: str = "", after: str = "",
) -> None:  # fmt: skip
    """Read, check and keep one value; `key` names a parameter of the functions or a constant of the half-space.

    A table `inside` the section has all its values on its line.
    """
    record = interface.record(key, profile)
    value = given(text, section, inside or key, raw, kind or kind_of(record), key, after)
    if value is None:
        return
    low, high, closed = interface.interval(record)
    if not (float(low) < value < float(high) or (closed == "high" and value == float(high))):
        bare = record.unit == "rad" and not isinstance(raw, str) and float(high) < value < 90
        hint = f'degrees need a unit: {key} = "{value:g} deg"' if bare else "change the value"
        shown = repr(raw) if isinstance(raw, str) else f"{value:g}"
        text.problem(section, inside or key, f"{key} = {shown:.40} is outside {record.domain}; {hint}")
        return
    values[key] = value


MEDIA = {"homogeneous": ("E_star", "E", "nu", "G_star"), "power_law": ("H", "k", "H_x")}
"""The constants of a half-space."""
KEYS = ("kind", *(key for keys in MEDIA.values() for key in keys))
READ = {"homogeneous": ("", ""), "power_law": ("number", "; H and H_x are in Pa m^(-k), without a unit")}
"""How a constant is read: those of a graded half-space have no unit that is not a power of its own."""
FOREIGN = {
    "homogeneous": 'belongs to a graded half-space; add kind = "power_law", or leave it out',
    "power_law": "belongs to a homogeneous half-space; a graded one has H and k",
}


def medium_values(text: SceneText) -> dict[str, float]:
    """E_star and G_star, or H, k and H_x of the foundation moduli H |x|^k and H_x |x|^k, as far as they are frozen."""
    table = text.table("medium", KEYS)
    kind = table.get("kind", "homogeneous")
    if not isinstance(kind, str) or kind not in MEDIA:
        text.problem("medium", "kind", f"unknown medium {str(kind)[:40]!r}{near(str(kind), MEDIA)}")
        return {}
    values: dict[str, float] = {}
    for key in (key for key in KEYS[1:] if key in table):
        if key not in MEDIA[kind]:
            text.problem("medium", key, f"{key} {FOREIGN[kind]}")
        else:
            frozen(text, values, "medium", key, table[key], kind=READ[kind][0], after=READ[kind][1])
    if "E_star" in table and ("E" in table or "nu" in table):
        text.problem("medium", "E_star", "give either E_star, or E and nu of a half-space under a rigid indenter")
    elif ("E" in table) != ("nu" in table):
        there, missing = ("E", "nu") if "E" in table else ("nu", "E")
        message = f"{missing} is missing: E_star = E/(1 - nu^2) needs both; give {missing}, or E_star alone"
        text.problem("medium", there, message)
    elif "E" in values and "nu" in values:
        nu, E = values["nu"], values["E"]
        values["E_star"] = E / ((1.0 - nu) * (1.0 + nu))
        values.setdefault("G_star", 2.0 * E / ((1.0 + nu) * (2.0 - nu)))
    return {key: value for key, value in values.items() if key != "E"}
