"""What begins at the tip or at a break, as text: its functions, how far a rule goes, and g' in closed form."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
import sympy as sp

from ..abel.order import Order
from ..abel.reduce import NotReducibleError, parse
from ..contact.general import Layer, beyond, excess
from ..notation import a, r
from ..profiles.profile import Piece
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.signs import facts_of
from ..stable.slopes import slope_form
from .code import python

LEAST_POWER = sp.Rational(1, 12)
"""The least exponent a profile may have; a parameter may be as small."""


def reach(layers: Iterable[Layer], start: sp.Expr) -> str:
    """How far a rule goes towards a start where f is a power below 1 of the distance, as its last argument."""
    least = least_power(layers, start)
    return "" if least >= 1 else f", {_far(least):.1f}"


def least_power(layers: Iterable[Layer], start: sp.Expr) -> sp.Expr:
    """The least power of the distance from a start in what begins there, 1 if all are larger."""
    shapes = (beyond(layer.shape, start) for layer in layers if layer.start == start)
    powers = [power for shape in shapes for power in _powers(shape)]
    if any(not power.is_number for power in powers):
        return LEAST_POWER
    return min((power for power in powers if power > 0), default=sp.S.One)


def _powers(expr: sp.Expr) -> Iterator[sp.Expr]:
    """Powers of the distance that an expression has, those behind a root of what vanishes at the start too."""
    for power in expr.atoms(sp.Pow):
        place = next((symbol for symbol in (r, excess) if power.base.has(symbol)), None)
        if power.base == place:
            yield power.exp
        elif place is not None and not power.exp.is_Integer and sp.expand(power.base.subs(place, 0)) == 0:
            yield power.exp * _order(power.base, place)


def _order(base: sp.Expr, place: sp.Symbol) -> sp.Expr:
    """The least power of a base that vanishes."""
    if base.is_polynomial(place):
        return sp.Integer(min(power for (power,) in sp.Poly(base, place).monoms()))
    return min((power for power in (sp.S.One, *_powers(base)) if power.is_positive), default=sp.S.One)


def _far(power: sp.Expr) -> float:
    """The t with power*(t + t**3/75) = 46, where the integral of a power has lost its last digit."""
    wanted = 46.0 / float(power)
    return float(max(root.real for root in np.roots([1.0 / 75.0, 0.0, 1.0, -wanted]) if abs(root.imag) < 1e-9))


def text(expr: sp.Expr) -> str:
    form = evaluation_form(expr, facts_of(()))
    return python(expr) if form.cancels or form.steps else python(form.value)


def radius_text(start: sp.Expr) -> str:
    return "0.0" if start == 0 else str(start)


def closed(layer: Layer) -> EvaluationForm | None:
    """g' of a layer by the engine, if it is a polynomial and its form does not cancel."""
    b = layer.start
    if not layer.shape.is_polynomial(r):
        return None
    pieces = (Piece(None, layer.shape),) if b == 0 else (Piece(b, sp.S.Zero), Piece(None, layer.shape))
    chain = (a,) if b == 0 else (b, a)
    try:
        depth = parse(pieces).depth(Order(chain)).expr()
        form = slope_form(depth, facts_of(chain))
    except (NotReducibleError, ValueError, AssertionError):
        return None
    rooted = {str(name) for name, _ in form.steps}
    allowed = set() if b == 0 else {"root"}
    plain = {name for name in rooted if name.startswith("root")} <= allowed
    return form if plain and not form.cancels else None
