"""The rate of growth of a compact contact in the radius alone, to be measured: modules hold it by its regimes."""

from __future__ import annotations

import sympy as sp

from ..notation import a
from ..stable.opaque import Root
from ..stable.slopes import RATE, ROOT
from .plane.compact import Compact as Strips
from .private import Private
from .regimes import Regimes


def add_rate(compact: Regimes | Strips) -> None:
    """`_rate(a)`: the functions of the rate before and beyond the break, each with its root."""
    known, b = compact.functions.functions, compact.b
    name = "growth" if isinstance(compact, Strips) else "slope"
    tip, beyond = known.get(name), known.get(f"{name}_beyond")
    lines, needs, values = list[str](), set[str](), list[str]()
    if tip is not None:
        length = compact.scale("tip")[1] if isinstance(compact, Regimes) else None
        values.append(_called(compact, tip, length, lines, needs, above=False))
    if beyond is not None and b is not None:
        values.append(_called(compact, beyond, b, lines, needs, above=True))
    if len(values) > 1:
        values, needs = [f"np.where(a < {b}, {', '.join(values)})"], needs | {str(b)}
    if values:
        compact.functions.add(RATE.function, ("a",), [*lines, f"return {values[0]}"], needs)


def _called(
    compact: Regimes | Strips, own: Private, length: sp.Expr | None, lines: list[str], needs: set[str], *, above: bool
) -> str:
    """The call of one regime, its root in the lines."""
    needs |= set(own.needs)
    if ROOT not in own.fields or length is None:
        return own.call("a")
    root = f"root_{'beyond' if above else 'tip'}"
    lines.append(f"{root} = {compact.functions.definition(Root(a, length) if above else Root(length, a))}")
    needs |= {str(symbol) for symbol in length.free_symbols}
    needs |= {str(s) for symbol, d in compact.profile.abbreviations if symbol == length for s in d.free_symbols}
    return own.call("a", root)
