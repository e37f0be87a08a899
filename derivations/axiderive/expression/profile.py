"""An expression as a `Profile`: ascending pieces, what the parameters mean, numbers to draw it with."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..notation import r
from ..profiles.profile import Piece, Profile, Rule, Sketch
from .dimensions import records
from .errors import ExpressionError
from .reading import Expression, read

NAME, TITLE = "own_profile", "Profile of one's own"
ANGLE = 0.35


@dataclass(frozen=True)
class OwnProfile:
    """A profile with the notation of its parameters, which holds while it is worked on."""

    expression: Expression
    profile: Profile
    notation: tuple[nt.Notation, ...]
    homogeneous: bool
    """Whether the parameters have dimensions that make f a length."""

    @property
    def smooth(self) -> bool:
        return not self.profile.breaks


def own_profile(text: str, *, name: str = NAME, title: str = TITLE) -> OwnProfile:
    """The profile an expression stands for.

    Raises
    ------
    ExpressionError
        If the text is no expression, or f(0) is not 0.
    """
    expression = read(text)
    pieces = tuple(
        Piece(upper, _tidied(expression.between(passed))) for passed, upper in enumerate((*expression.breaks, None))
    )
    _require_apex(expression, pieces[0].expr)
    own, homogeneous = records(expression.tree, expression.parameters)
    profile = Profile(
        name=name,
        title=title,
        subtitle=f"f(r) = {expression.text}",
        contact="compact",
        parameters=expression.parameters,
        pieces=pieces,
        validity="small slopes",
        sources=(),
        sketch=_sketch(expression),
        rules=tuple(
            Rule(low, high, True, "the breaks ascend in the order in which the expression names them; exchange them")
            for low, high in zip(expression.breaks, expression.breaks[1:], strict=False)
        ),
    )
    return OwnProfile(expression, profile, tuple(own), homogeneous)


def _tidied(expr: sp.Expr) -> sp.Expr:
    """Multiplied out unless it is shorter as it stands."""
    expr = expr.replace(_squared_wave, _wave)
    expanded = sp.expand(expr)
    return min((expanded, expr), key=lambda e: (sp.count_ops(e), sp.sstr(e)))


def _squared_wave(expr: sp.Expr) -> bool:
    return bool(expr.is_Pow and expr.exp == 2 and isinstance(expr.base, sp.sin | sp.cos))


def _wave(square: sp.Expr) -> sp.Expr:
    """sin(x)**2 and cos(x)**2 as one wave."""
    sign = 1 if isinstance(square.base, sp.cos) else -1
    return (1 + sign * sp.cos(2 * square.base.args[0])) / 2


def _require_apex(expression: Expression, tip: sp.Expr) -> None:
    height = tip.subs(r, 0)
    if height == 0 or sp.expand(height) == 0 or _vanishes(height):
        return
    shown = sp.sstr(height)[:60]
    if height.has(sp.nan, sp.zoo, sp.oo):
        message = (
            "f has no value at r = 0, where a profile starts with f(0) = 0: powers of r below 0, log(r) and quotients "
            "by r have no place at the apex"
        )
    elif any(power.base == 0 for power in height.atoms(sp.Pow)):
        message = (
            f"f(0) = {shown} is 0 for some values only; write a power of r with an exponent above 0 for all, as r**n"
        )
    else:
        message = f"f(0) = {shown}, but a profile starts at its apex with f(0) = 0; "
        message += "write Max(0, r - b) for what begins at r = b" if height.free_symbols else "subtract that value"
    raise ExpressionError(message, expression.text, 0, len(expression.text))


def _vanishes(height: sp.Expr) -> bool:
    if height.has(sp.nan, sp.zoo, sp.oo):
        return False
    at = {symbol: sp.Rational(10 + 3 * i, 7) for i, symbol in enumerate(sorted(height.free_symbols, key=str))}
    return bool(abs(height.subs(at).evalf(30)) < sp.Float("1e-25"))


def _sketch(expression: Expression) -> Sketch:
    """Lengths of 1, breaks at 1, 1.4, ..., and a contact beyond the last of them."""
    values, at = [], 1.0
    for symbol in expression.parameters:
        if symbol in expression.breaks:
            values.append((symbol, round(1.0 + 0.4 * expression.breaks.index(symbol), 3)))
        elif symbol.name == "theta":
            values.append((symbol, ANGLE))
        else:
            values.append((symbol, 1.0))
    if expression.breaks:
        at = round(1.4 + 0.4 * (len(expression.breaks) - 1), 3)
    return Sketch(tuple(values), a=at)
