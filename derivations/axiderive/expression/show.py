"""What `axicontact derive` prints: f, g, F, p and w with their status, and what was checked."""

from __future__ import annotations

import re
import textwrap
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sp

from .. import notation as nt
from .answer import DIGITS, Answer, answered
from .errors import ExpressionError
from .profile import OwnProfile, own_profile

if TYPE_CHECKING:
    from ..scene.compose import Result

WIDTH = 110
SHOWN = ("d", "F", "p", "w")


def shown(text: str, k: str = "0", *, write: bool = False) -> tuple[list[str], Result | None]:
    """The lines, and the files of a module with all functions if they are wanted."""
    own = own_profile(text)
    exponent = exponent_of(k)
    with nt.extended(own.notation):
        answer = answered(own, k=exponent)
        lines = _head(own) + [line for suffix in SHOWN for line in _entry(answer, suffix)] + _tail(answer)
    if not write and all(answer.entries[suffix].status == "closed" for suffix in SHOWN):
        return lines, None  # else the rules of the module give the values, and their error is measured
    from ..scene import interface
    from ..scene.compose import composed
    from ..scene.request import Request
    from ..scene.sources import graded_refusal

    physics, values = ("normal", {}) if exponent == 0 else ("graded", {"k": float(exponent)})
    if exponent != 0 and (reason := graded_refusal(answer.profile)):
        return [*lines, *([f"written   nothing: {reason}"] if write else [])], None
    names = list(interface.functions(physics))
    if answer.bounded:
        names = [name for name in names if name not in interface.INVERSES]
        reason = "how far the contact is compact depends on the values; freeze them in a scene"
        lines += [f"left out  {', '.join(sorted(interface.INVERSES))}: {reason}"] if write else []
    request = Request(
        "Contact of a profile of one's own",
        f"{own.profile.name}.py",
        None,
        own,
        physics,
        names,
        values,
        formats=("python", "json"),
    )
    result = composed(request, answer)
    return [*lines, *(line for line in result.lines if line not in lines)], result if write else None


def exponent_of(text: str) -> sp.Rational:
    """The exponent of grading, a fraction between -1 and 1."""
    match = re.fullmatch(r"\s*([-+]?(?:\d{1,6}\.?\d{0,6}|\.\d{1,6}))\s*(?:/\s*(\d{1,6}))?\s*", text)
    below = int(match[2] or 1) if match else 0
    value = Fraction(match[1]) / below if match and below else Fraction(1)
    if not -1 < value < 1:
        message = f"k = {text[:40]!r} is outside -1 < k < 1; give the exponent of grading as a fraction, as 1/3"
        raise ExpressionError(message)
    return sp.Rational(value.numerator, value.denominator)


def _head(own: OwnProfile) -> list[str]:
    lines = [f"f(r) = {own.expression.text}"]
    lines += [f"          {record.name} [{record.unit}], {record.domain}" for record in own.notation]
    if not own.homogeneous:
        lines.append("          numbers in f carry units: all lengths in the same unit")
    return lines


def _entry(answer: Answer, suffix: str) -> list[str]:
    entry = answer.entries[suffix]
    if answer.k != 0:
        entry = replace(entry, cases=tuple(replace(c, expr=c.expr.subs(nt.k, answer.k)) for c in entry.cases))
    lines = ["", f"{entry.quantity.label}: {answer.status(suffix)}"]
    for pairs, expr in entry.regions():
        where = " and ".join(f"{sp.sstr(low)} < {sp.sstr(high)}" for low, high in pairs)
        text = f"{entry.quantity.symbol} = {sp.sstr(expr)}" + (f"   for {where}" if where else "")
        lines += textwrap.wrap(
            text, WIDTH, initial_indent="  ", subsequent_indent="    ", break_long_words=False, break_on_hyphens=False
        )
    return lines


def _tail(answer: Answer) -> list[str]:
    examined = "" if answer.k == 0 or answer.validity.exact else " (on the homogeneous half-space, k = 0)"
    lines = ["", f"contact   {answer.validity.sentence}{examined}"]
    if answer.comparisons:
        count = len(answer.comparisons)
        lines.append(
            f"checked   {count} values against the defining integrals, {DIGITS} digits, worst {answer.worst:.1e}"
        )
    if answer.told:
        lines.append(f"form      {answer.told}")
    return lines
