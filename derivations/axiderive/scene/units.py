"""Numbers with units: SI out of what a scene writes; a unit of another kind is named as such."""

from __future__ import annotations

import difflib
import math
import re
from fractions import Fraction

from .. import notation as nt

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
    if record.unit == "rad":
        return "angle"
    known = {nt.LENGTH: "length", nt.STRESS: "pressure", nt.FORCE: "force", nt.NUMBER: "number"}
    if record.unit in ("s", "Pa s"):
        return "time" if record.unit == "s" else "viscosity"
    if record.name == "dgamma":
        return "energy per area"
    return known.get(record.dimension, record.unit)


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
    units = {
        "length": "mm",
        "pressure": "MPa",
        "force": "mN",
        "energy per area": "mJ/m^2",
        "angle": "deg",
        "viscosity": "kPa s",
        "time": "s",
    }
    return f"5 {units[kind]}" if kind in units else "0.3" if kind == "number" else f"5 {kind}"
