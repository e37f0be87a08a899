"""What stands, in expressions, for functions of the run time that look at their data: rules, searches, gammas.

Each takes the graph and the arguments of the function itself.  A sum over the coefficients of a polynomial is one over
a term that stands for all; Python's own functions for sums know it too.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from .expressions import EXPRESSIONS, STEPS
from .graph import Graph, Lengths, Node, Traced, needed

GRIDS = ("decades", "radii_below", "radii_to", "radii_beyond", "radii_around", "radii_of_waves")
"""Grids of radii that separate the least loads of a contact, as many for any lengths."""
ONE: Lengths = ((math.inf, 64),)
WAVES: Lengths = ()
"""How many nodes an interval has of any length, and over any number of waves."""
SLACK = 1e-6
"""The least slope of a curve of which none is known."""


class _Term(Traced):
    """The coefficient of a term that is left out where it is zero."""

    def __bool__(self) -> bool:
        return True


def _pair(graph: Graph) -> tuple[Node, Node]:
    """The number and the coefficient that stand for all."""
    return graph.variable("j"), graph.variable("A_j")


def _stands(items: list[Any]) -> bool:
    """Whether this is the term that stands for all."""
    one = items[0] if len(items) == 1 else None
    return isinstance(one, Traced) and not {*_pair(one.graph)}.isdisjoint(needed(one.node))


def _enumerate(given: Any, start: int = 0) -> Any:
    if isinstance(given, Traced):
        graph = given.graph
        graph.coefficients = given.node
        number, coefficient = _pair(graph)
        return [(Traced(graph, number), _Term(graph, coefficient))]
    items = list(given)
    return [(Traced(items[0].graph, _pair(items[0].graph)[0]), items[0])] if _stands(items) else enumerate(items, start)


def _over_terms(kind: str, term: Traced) -> Traced:
    graph, zero = term.graph, term.graph.number(0.0)
    number, coefficient = _pair(graph)
    nothing = zero if kind == "total" else graph.number(math.inf)
    own = graph.choice(graph.operation("greater", coefficient, zero), term.node, nothing)
    return Traced(graph, graph.other(kind, (graph.coefficients or zero, number, coefficient, own)))


def _sum(given: Any) -> Any:
    items = list(given)
    return _over_terms("total", items[0]) if _stands(items) else sum(items)


def _reduce(function: Any, given: Any) -> Any:
    items = list(given)
    return _over_terms("least", items[0]) if _stands(items) else functools.reduce(function, items)


def _len(given: Any) -> Any:
    return Traced(given.graph, given.graph.other("count", [given.node])) if isinstance(given, Traced) else len(given)


def _traced(graph: Graph, x: Any) -> Traced:
    return Traced(graph, graph.of(x))


def _calling(name: str, home: str = STEPS, kind: str = "call") -> Callable[..., Traced]:
    """What calls a function of the run time."""
    return lambda graph, *given: Traced(graph, graph.other(kind, [graph.of(x) for x in given], (home, name)))


def _strip(graph: Graph, integrand: Any, stop: Any, width: Any = 1.0, waves: Any = ()) -> Traced:
    return _traced(graph, stop).integral(integrand, width, WAVES if waves else ONE)


def _panels(graph: Graph, integrand: Any, stop: Any, width: Any, count: int) -> Traced:
    return _traced(graph, stop).integral(integrand, width, WAVES)


def _weighted(graph: Graph, smooth: Any, stop: Any, power: Any, count: int = 0, above: Any = None) -> Traced:
    return _traced(graph, stop).weighted(smooth, 1.0 + power if above is None else above)


def _gamma(graph: Graph, x: Any) -> Traced:
    """For 1 < x < 2."""
    return _calling("rising")(graph, 1.0, x - 1.0)


def _gamma_quotient(graph: Graph, x: Any, y: Any) -> Traced:
    return _calling("rising")(graph, y, x - y)


def _over_waves(graph: Graph, value: Traced, waves: Traced, power: int) -> Traced:
    struve = [_calling(f"struve_h{order}", f"{EXPRESSIONS}._runtime.special") for order in (0, 1)]
    plain = np.sqrt(value) if power == 1 else np.cbrt(1.5 * value)
    raised = 1.0 + 2.0 / np.pi * waves / (1.0 + plain * plain)

    def curve(z: Traced) -> tuple[Traced, Traced]:
        zero, one = (own(graph, z) for own in struve)
        slope = 2.0 * z + waves * (zero + z * (2.0 / np.pi - one))
        if power == 1:
            y = z * z + waves * z * zero
            return y, z * slope / y
        y = 2.0 / 3.0 * z * (z * z) + waves * (z * z * zero - z * one)
        return y, z * z * slope / y

    start = plain / (np.sqrt(raised) if power == 1 else np.cbrt(raised))
    return start.root(curve, value, np.inf, (SLACK, np.inf))


def _waves(graph: Graph, a: Traced, q: Traced, k: Traced, of: Callable[..., Traced], factor: Any) -> Traced:
    """A panel of some waves with the weight, then plain ones, whatever the phase."""
    phase = q * a
    first = np.minimum(np.pi / 2.0, 8.0 / np.maximum(phase, 1e-300))

    def over(y: Traced) -> Traced:
        return of(phase * np.cos(y), np.cos(y))

    def over_angle(y: Traced) -> Any:
        return np.where(y > 0.0, np.sin(y) / np.where(y > 0.0, y, 1.0), 1.0)

    near = _weighted(graph, lambda y: over(y) * over_angle(y) ** k, first, k)
    rest = _panels(graph, lambda y: over(first + y) * np.sin(first + y) ** k, np.pi / 2.0 - first, first, 64)
    return first * first**k * near + rest


def _bell(graph: Graph, a: Traced, s: Traced, k: Traced, of: Callable[[Traced], Traced]) -> Traced:
    square = (a / s) ** 2
    return _weighted(graph, lambda x: of((1.0 - x) * (1.0 + x) * square), _traced(graph, 1.0), k)


def _gaussian_reach(graph: Graph, s: Traced, k: Traced) -> Traced:
    """The rate vanishes where the mean of the fall is one, with the weight of the depth."""

    def curve(t: Traced) -> tuple[Traced, Traced]:
        one = _traced(graph, 1.0)
        depth = _bell(graph, t, one, k, lambda fall: np.exp(-fall))
        first = _bell(graph, t, one, k, lambda fall: fall * np.exp(-fall))
        second = _bell(graph, t, one, k, lambda fall: fall * fall * np.exp(-fall))
        return first / depth, 2.0 * (1.0 + first / depth - second / first)

    return s * _traced(graph, 1.5).root(curve, 1.0, np.inf, (SLACK, np.inf))


def _across(graph: Graph, curve: Any, value: Traced, b: Any, tip: Any, end: Any = None, powers: Any = None) -> Traced:
    """In x = a/b up to the break and 1 + sqrt(a**2/b**2 - 1) beyond: no slope is infinite there but for k < 0."""
    b = _traced(graph, b)
    base = curve(b, b * 0.0)[0]

    def radius(x: Traced) -> tuple[Any, Any, Any]:
        t = np.where(x < 1.0, 0.0, x - 1.0)
        stretched = np.sqrt(1.0 + t * t)
        return b * np.where(x < 1.0, x, stretched), b * t, np.where(x < 1.0, 1.0, x * t / (1.0 + t * t))

    def own(x: Traced) -> tuple[Traced, Traced]:
        a, root, share = radius(x)
        y, rate = curve(a, root)
        return y, rate / y * share

    start = (value / base) ** (1.0 / tip)
    return radius(start.root(own, value, np.inf, (SLACK, np.inf)))[0]


def _radius_across(
    graph: Graph, load: Any, rate: Any, value: Traced, b: Any, needs: Any, tip: Any, least: Any = None, end: Any = None
) -> Traced:
    return _across(graph, lambda a, root: (load(a, root, *needs), a * rate(a, root, *needs)), value, b, tip)


def _stable_radius(
    graph: Graph, value: Traced, found: Any, load: Any, slope_of: Any, *unknowns: Any, **corner: Any
) -> Traced:
    a = Traced(graph, graph.variable())
    given = value.node, found.radii.node, a.node, load(a).node, slope_of(a).node
    return Traced(graph, graph.other("stable", given))


def _radii(kind: str) -> Callable[..., Traced]:
    """Those of a grid, for a length of one or of their own."""
    return lambda graph, length=1.0, *others: Traced(graph, graph.other("radii", (), kind)) * length


STANDING: dict[tuple[str, str], Any] = {
    **{("physics.branches", kind): _radii(kind) for kind in GRIDS},
    ("physics.branches", "branches"): lambda graph, steepness, sampled, level: sampled,
    ("physics.stable", "stable_radius"): _stable_radius,
    ("integrals", "integral_in_strip"): _strip,
    ("integrals", "integral_by_panels"): _panels,
    ("functions", "gamma"): _gamma,
    ("functions", "gamma_quotient"): _gamma_quotient,
    ("functions", "depth_over_height"): _calling("depth_over_height", "_runtime.functions", "plain"),
    ("shapes.waves", "inverse_over_waves"): _over_waves,
    ("shapes.across", "inverse_across"): _across,
    ("physics.relaxation", "fading"): _calling("fading"),
    ("physics.retraction", "fraction"): _calling("fraction"),
    ("physics.branches", "exponent_of"): lambda graph, x: 0,
    ("physics.branches", "stress_at"): lambda graph, unit, H, k: (0, H),
    ("physics.unknowns", "root_of"): lambda graph, x, first, last: (x, 1.0),
    ("physics.unknowns", "power_of"): lambda graph, t, first, last: t,
    ("graded.rules", "weighted"): _weighted,
    ("graded.growth", "_gamma"): _gamma,
    ("graded.growth", "_rising"): _calling("rising"),
    ("graded.growth", "_bell"): _bell,
    ("graded.inverse", "gaussian_reach"): _gaussian_reach,
    ("graded.inverse", "radius_across"): _radius_across,
    ("graded.displacement", "_to_axis"): lambda graph, q: _traced(graph, np.pi / 3.0),
    ("graded.waves", "_waves"): _waves,
}
"""By the module of the run time and the name; lengths and stresses keep their units."""
BUILTINS = {"enumerate": _enumerate, "sum": _sum, "reduce": _reduce, "len": _len}
