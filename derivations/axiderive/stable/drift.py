"""What counts as drift between two measurements of the same functions, and what the libraries of a machine explain."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

Record = dict[str, Any]
UNITS, FACTOR = 1.0, 3.0
"""How far a worst error may move: NumPy's functions differ by a unit between processors, and roots amplify that.

With AVX-512 off it moved from 2.1 to 6.4 units at most, in a force at given depth.
"""
MANY = 1e3
"""Units above which a sum has cancelled: only the number of lost digits is compared."""
NOTHING = 2.0**52
"""Units at which a printed formula has lost all digits; what it gives there is noise, as is the last one it keeps."""
STATED = ("form", "nodes", "sample")


def settled(kept: Mapping[str, Record], found: Mapping[str, Record]) -> dict[str, Record]:
    """The kept row of every function whose errors have not drifted, so that a record does not depend on the machine."""
    return {suffix: row if drift(kept, {suffix: row}) else kept[suffix] for suffix, row in found.items()}


def drift(kept: Mapping[str, Record], found: Mapping[str, Record]) -> list[tuple[str, str]]:
    """What no difference between machines explains, as suffix and sentence; only functions in `found` are compared.

    The same form, nodes and points are wanted, the same number of lost values, and a worst error that is at most
    one unit more than three times the smaller of both; of the printed formula, half or twice the digits that were lost.
    """
    lines = []
    for suffix, row in found.items():
        if suffix in kept:
            lines += [(suffix, line) for line in _row(kept[suffix], row)]
        else:
            lines.append((suffix, "there is no record of them; run axicontact build"))
    return lines


def _row(kept: Record, found: Record) -> list[str]:
    stated = [(name, kept.get(name), found.get(name)) for name in STATED]
    lines = [f"{name} was {before}, is {now}" for name, before, now in stated if before != now]
    for domain, new in found.items():
        if domain not in STATED:
            lines += [f"{domain}: {line}" for line in _errors(kept.get(domain, {}), new)]
    return lines


def _errors(old: Record, new: Record) -> list[str]:
    lines = [
        f"{name} was {old.get(name)}, is {new[name]}" for name in ("points", "lost") if old.get(name) != new.get(name)
    ]
    before, now = _worst(old), _worst(new)
    noise = min(before, now) > MANY and not _other_digits(before, now)
    if max(before, now) > UNITS + FACTOR * min(before, now) and not noise:
        lines.append(f"the worst error was {before}, is {now} units")
    if ("naive" in old) != ("naive" in new):
        lines.append(f"the printed formula was {'' if 'naive' in old else 'not '}measured")
    elif "naive" in new:
        before, now = _worst(old["naive"]), _worst(new["naive"])
        if _other_digits(before, now):
            lines.append(f"the worst error of the printed formula was {before}, is {now} units")
    return lines


def _other_digits(*errors: float) -> bool:
    """Whether one of two errors has lost more than twice the digits of the other."""
    low, high = sorted(math.log2(1.0 + min(error, NOTHING)) for error in errors)
    return high > UNITS + 2.0 * low


def _worst(errors: Record) -> float:
    """Infinite where every value was lost, nought where there was no point."""
    return float(errors.get("worst_ulp", math.inf if errors.get("points") else 0.0))
