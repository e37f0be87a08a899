"""An expression as a `Profile`: ascending pieces, what the parameters mean, numbers to draw it with.

Their dimensions are those that make f(r) a length, by linear algebra on its tree.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from .. import notation as nt
from ..notation import r
from ..profiles.profile import Piece, Profile, Rule, Sketch
from .names import ExpressionError, latex
from .reading import Expression, read, step

SHARED = frozenset(["theta", "R", "R1", "R2", "b", "n", "h", "s", "wavelength"])
"""Letters that keep the unit, the domain and the meaning of the notation where these fit."""


class _InconsistentError(Exception):
    """No dimensions of the parameters make every sum homogeneous: bare numbers carry units."""


def records(tree: sp.Expr, parameters: Sequence[sp.Symbol]) -> tuple[list[nt.Notation], bool]:
    """The notation of the parameters, and whether their dimensions are known."""
    # b is the radius of a break only where it is one
    shared = [p for p in parameters if p.name in SHARED and (p.name != "b" or tree.has(step(p)))]
    given = {p: nt.describe(p).dimension.length for p in shared}
    for known in (given, {}):
        try:
            lengths = _lengths(tree, parameters, known)
        except _InconsistentError:
            continue
        return [_record(p, lengths[p], keep=p in known) for p in parameters], True
    return [_record(p, None, keep=False) for p in parameters], False


def _record(symbol: sp.Symbol, length: sp.Expr | None, *, keep: bool) -> nt.Notation:
    if keep:
        return nt.describe(symbol)
    unit = {None: "SI", 0: "1", 1: "m"}.get(length, f"m^({sp.sstr(length)})" if length is not None else "")
    dimension = nt.NUMBER if length is None else nt.Dimension(length, sp.S.Zero)
    name = symbol.name
    return nt.Notation(symbol, latex(name), dimension, unit, f"{name} > 0", "parameter of the profile")


def _lengths(
    tree: sp.Expr, parameters: Sequence[sp.Symbol], known: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """Exponents of length, those left open set to 0."""
    unknown = {p: sp.Dummy(p.name) for p in parameters if p not in known}
    powers = {**known, **unknown, nt.r: sp.S.One}
    equations: list[sp.Expr] = []
    equations.append(_power(tree, powers, equations) - 1)
    open_ = list(unknown.values())
    conditions = [sp.expand(e) for e in equations if sp.expand(e) != 0]
    if not open_:
        if conditions:
            raise _InconsistentError
        return dict(known)
    try:
        solutions = sp.linsolve(conditions, open_) if conditions else sp.FiniteSet(tuple(open_))
    except (ValueError, sp.polys.polyerrors.PolynomialError) as error:  # a product of two unknown dimensions
        raise _InconsistentError from error
    if not solutions:
        raise _InconsistentError
    (values,) = solutions
    free = dict.fromkeys(open_, sp.S.Zero)
    return {**known, **{p: sp.sympify(v).xreplace(free) for p, v in zip(unknown, values, strict=True)}}


def _power(expr: sp.Expr, powers: Mapping[sp.Symbol, sp.Expr], equations: list[sp.Expr]) -> sp.Expr:
    """The exponent of length of an expression; what must vanish is added to the equations."""
    if expr.is_Symbol:
        return powers.get(expr, sp.S.Zero)  # a step is a number
    if expr.is_Add:
        first, *rest = (_power(arg, powers, equations) for arg in expr.args)
        equations.extend(first - other for other in rest)
        return first
    if expr.is_Mul:
        return sp.Add(*(_power(arg, powers, equations) for arg in expr.args))
    if expr.is_Pow:
        equations.append(_power(expr.exp, powers, equations))
        return sp.expand(_power(expr.base, powers, equations) * expr.exp)
    for arg in expr.args:
        equations.append(_power(arg, powers, equations))
    return sp.S.Zero


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


def own_profile(text: str) -> OwnProfile:
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
        name=NAME,
        title=TITLE,
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
    """Lengths of 1, exponents of no special case, breaks at 1, 1.4, ..., and a contact beyond the last of them."""
    values = []
    exponents = {symbol for power in expression.tree.atoms(sp.Pow) for symbol in power.exp.free_symbols}
    for symbol in expression.parameters:
        if symbol in expression.breaks:
            number = round(1.0 + 0.4 * expression.breaks.index(symbol), 3)
        else:
            number = ANGLE if symbol.name == "theta" else 1.5 if symbol in exponents else 1.0
        values.append((symbol, number))
    return Sketch(tuple(values), a=round(1.0 + 0.4 * len(expression.breaks), 3))
