"""The functions of a normal contact as a row names them, g, F_N, p and w, from the entries themselves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from ... import notation as nt
from ...contact.systems import BY_NAME, Problem, problem
from ...entry import Entry
from ...proof.evaluate import at_precision, case_at
from .compare import value_of
from .printed import Values, name_in_print

Entries = Mapping[str, Entry]
Stored = Callable[[str], Entries]
"""The entries of a problem by its key."""


def base_of(key: str, stored: Stored) -> Entries:
    """The entries of the normal contact on the same medium."""
    own = problem(key)
    if not own.system.rests_on:
        return stored(key)
    graded = own.system.name.startswith("graded")
    return stored(Problem(BY_NAME["graded.normal" if graded else "normal"], own.name).key)


def functions(base: Entries, values: Values) -> dict[str, Any]:
    """g, g', F_N, p and w at the parameters of a point, f too; a field at the radius a unless another is given."""

    def at(suffix: str, derived: bool, **moved: Any) -> Any:
        point = {**values, **{getattr(nt, name): value for name, value in moved.items()}}
        expr = case_at(base[suffix], point).expr
        expr = sp.diff(expr, nt.a) if derived else expr
        return value_of(expr, point) if expr.has(sp.Integral) else at_precision(expr, point)

    def field(suffix: str) -> Callable[..., Any]:
        def value(place: Any, radius: Any = None) -> Any:
            radius = values[nt.a] if radius is None else radius
            if suffix == "p" and place > radius:
                return 0
            return at(suffix, False, a=radius, r=place)

        return value

    def shape(place: Any) -> Any:
        piece = next(p for p in profile.pieces if p.upper is None or place < at_precision(p.upper, values))
        return at_precision(piece.expr, {**values, nt.r: place})

    profile = next(iter(base.values())).profile
    breaks = [at_precision(b, values) for b in profile.breaks]
    return {
        "f()": shape,
        "g()": lambda radius: at("d", False, a=radius),
        "g'()": lambda radius: at("d", True, a=radius),
        "F_N()": lambda radius: at("F", False, a=radius),
        "p()": field("p"),
        "w()": field("w"),
        "cuts": {"t": breaks, name_in_print(nt.r): breaks},
    }
