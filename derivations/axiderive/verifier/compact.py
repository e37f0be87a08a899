"""Compact contact: depth by antiderivatives, fields by their growth with the radius, inverses by substitution."""

from __future__ import annotations

from typing import Any

from .field import Element
from .limits import Limit
from .problem import PUNCH, Case, Chain, Problem, Rule
from .reading import Tree, UnknownError, put, symbols, tree


def depth(problem: Problem, suffix: str) -> None:
    """The sum of the increments of antiderivatives of f'(x) a**(1 - k) (a**2 - x**2)**((k - 1)/2)."""
    for case in problem.places("d", problem.orders()):
        abel(problem, case, "d", "a**(1 - k)*slope*(a**2 - x**2)**((k - 1)/2)")


WAVE = (
    "wavelength",
    "2*pi*h/wavelength*sin(2*pi*x/wavelength)",
    "a**(1 - k)*pi**(3/2)*h/wavelength*gamma((1 + k)/2)*(a*wavelength/pi)**(k/2)*StruveH(k/2, 2*pi*a/wavelength)",
)
"""Slope of a wave h (1 - cos(2 pi x/wavelength)) and its depth, by Poisson's integral of the Struve function."""


def abel(problem: Problem, case: Case, suffix: str, kernel: str) -> None:
    """Shows a case as the sum of the increments of its antiderivatives, whose slopes add up to the kernel."""
    items = dict(
        (tuple(tree(m["="]) for m in key), value) for key, value in problem.records[suffix]["primitives"]["@items"]
    )
    found = items.get(case.chain, [])
    inner = [b for b in problem.breaks if case.chain.index(b) < case.chain.index("a")]
    ends = [0, *inner, "a"]
    total: Any = problem.field(case.chain).read(0)
    parts = [(tree(p["lo"]["="]), tree(p["hi"]["="]), tree(p["expr"]["="])) for p in found]
    if not all(lo in ends and hi in ends for lo, hi, _ in parts):
        message = "an antiderivative does not end at the breaks"
        raise UnknownError(message)
    place = 0
    for lo, hi, piece in zip(ends, ends[1:], problem.pieces, strict=False):
        place = case.chain.index(hi)
        field = problem.field((*case.chain[:place], "x", *case.chain[place:]))
        slope = field.slope(field.read(put(piece, {"r": "x", "A_j": 1})), "x")
        active = [p for p in parts if ends.index(p[0]) <= ends.index(lo) and ends.index(hi) <= ends.index(p[1])]
        wanted = field.read(problem.table(kernel), {"slope": slope})
        grown = field.read(0)
        if WAVE[0] in symbols(piece) and not problem.breaks and suffix == "d":
            grown = field.read(problem.table(kernel), {"slope": field.read(tree(WAVE[1]))})
            total = total + total.field.read(problem.table(WAVE[2]))
        for _, _, expr in active:
            own = field.read(expr)
            if not field.analytic(own):
                message = "an antiderivative is not shown to be analytic"
                raise UnknownError(message)
            grown = grown + field.slope(own, "x")
        problem.vanishes("the derivative of the antiderivative", grown - wanted)
        for _, _, expr in active:
            # of one that spans several pieces, the increment over this one
            total = total + end(problem, expr, (*case.chain[:place], "x", *case.chain[place:]), "x", hi, -1)
            total = total - end(problem, expr, (*case.chain[:place], "x", *case.chain[place:]), "x", lo, 1)
    field = problem.field(case.chain)
    own = field.read(case.expr)
    if "A_j" in symbols(case.expr):
        total = total * field.symbol("A_j")
    problem.vanishes("the sum of the increments", own - total)


def end(problem: Problem, expr: Tree, chain: Chain, name: str, point: Tree, side: int) -> Element:
    """The value of a formula as a symbol tends to its neighbour in the order, from above or from below."""
    face = problem.field(tuple(member for member in chain if member != name))
    try:
        return face.read(put(expr, {name: point}))
    except UnknownError:
        field = problem.field(chain)
        return Limit(field, name, point, face, side).value(field.read(expr))


def grown(problem: Problem, suffix: str) -> None:
    """A contact that grows by da adds a flat punch moved by g'(a) da; there is nothing where it begins."""
    pairs: dict[str, tuple[tuple[str, str], ...]] = {"p": (("r", "a"),), "w": (("a", "r"),)}
    unit = {"F": PUNCH["F"], "p": PUNCH["p"], "w": PUNCH["w"]}[suffix]
    integral(problem, suffix, problem.orders(*pairs.get(suffix, ()), items="r" if suffix in pairs else ""), "d", unit)


def integral(problem: Problem, suffix: str, wanted: set[Chain], base: str, unit: str, point: str = "r") -> None:
    """Shows that each case grows by `unit` times the growth of `base`, and its value where the contact begins."""
    cases = problem.places(suffix, wanted)
    for case in cases:
        field = problem.field(case.chain)
        own = field.read(case.expr)
        growth = field.slope(field.read(problem.of(base, case.chain, without=point)), "a")
        if not field.analytic(own):
            message = "the formula is not shown to be analytic"
            raise UnknownError(message)
        problem.vanishes(
            "growth with the contact radius", field.slope(own, "a") - growth * field.read(problem.table(unit))
        )
        i = case.chain.index("a")
        lower = case.chain[i - 1] if i else 0
        value = end(problem, case.expr, case.chain, "a", lower, 1)
        if lower not in (0, point, problem.floor):
            swapped = (*case.chain[: i - 1], "a", lower, *case.chain[i + 1 :])
            (other,) = (c.expr for c in cases if c.chain == swapped)
            value = value - end(problem, other, swapped, "a", lower, -1)
        problem.vanishes("the value where the contact begins", value)


def stiffness(problem: Problem, suffix: str) -> None:
    """Shows k g'(a) = F'(a) in every order."""
    (own,) = problem.places("k", {("a",)})
    for case in problem.closed("F"):
        field = problem.field(case.chain)
        force, sunk = (field.slope(field.read(problem.of(s, case.chain)), "a") for s in ("F", "d"))
        problem.vanishes("k g' = F'", field.read(own.expr) * sunk - force)


def mean(problem: Problem, suffix: str) -> None:
    """Shows pi a^2 p = F in every order."""
    for case in problem.places("pm", {case.chain for case in problem.closed("F")}):
        field = problem.field(case.chain)
        problem.show(
            "pi a^2 p = F", field, field.read(case.expr) * field.read(tree("pi*a**2")), problem.of("F", case.chain)
        )


WAYS: tuple[tuple[str, tuple[tuple[Tree, str], ...]], ...] = (
    ("a", ()),
    ("b*(1 + tangent**2)/(2*tangent)", ()),
    ("b*(1 + (q - 1/q)**2/2)**(1/2)", ((1, "q"),)),
)
"""All radii above b, as they are and in variables that make sqrt(a^2 - b^2) rational, 0 < tangent < 1 and q > 1."""


def inverse(problem: Problem, suffix: str) -> None:
    """Put into the inverse, the forward formula gives back a, or the other quantity; every case serves once."""
    inner, outer, value = {"ad": ("d", "", "d"), "aF": ("F", "", "F"), "Fd": ("d", "F", "d"), "dF": ("F", "d", "F"),
                           "aP": ("P", "", "P")}[suffix]  # fmt: skip
    forward, cases = problem.closed(inner), problem.entries[suffix]
    if len(cases) != len(forward):
        message = "its cases are not those of the formula it inverts"
        raise UnknownError(message)
    for case, own in zip(cases, forward, strict=True):
        border(problem, case, own, forward, value)
        wanted = problem.of(outer, own.chain) if outer else "a"
        for place, more in WAYS if "b" in own.chain[: own.chain.index("a")] else WAYS[:1]:
            try:
                field = problem.field(own.chain, *more)
                radius = field.read(tree(place))
                back = field.read(case.expr, {value: field.read(own.expr, {"a": radius})})
                problem.show("the inverse", field, back, field.read(wanted, {"a": radius}))
                break
            except UnknownError as error:
                reason = error
        else:
            raise reason


def border(problem: Problem, case: Case, own: Case, forward: list[Case], value: str) -> None:
    """The case begins and ends at the values of the forward formula where its own case does."""
    if len(forward) == 1:
        if case.chain:
            message = "a single case has no border"
            raise UnknownError(message)
        return
    i = own.chain.index("a")
    below, above = own.chain[:i], own.chain[i + 1 :]
    wanted = [put(other.expr, {"a": b}) for other in forward for b in (*below, *above)]
    if len(case.chain) != 2 or len(forward) != 2 or bool(below) == bool(above):
        message = "its regions are not those of the formula it inverts"
        raise UnknownError(message)
    level = case.chain[1] if above else case.chain[0]
    if case.chain[0 if above else 1] != value:
        message = "its regions are not those of the formula it inverts"
        raise UnknownError(message)
    face = problem.field(tuple(m for m in own.chain if m != "a"))
    for expr in wanted:
        try:
            problem.show("the border of two cases", face, level, face.read(expr))
        except UnknownError:
            if expr in (put(own.expr, {"a": m}) for m in (*below, *above)):
                raise


COMPACT: dict[str, Rule] = {
    "d": (depth, ()), "F": (grown, ("d",)), "p": (grown, ("d",)), "w": (grown, ("d",)), "k": (stiffness, ("F",)),
    "pm": (mean, ("F",)), "ad": (inverse, ("d",)), "aF": (inverse, ("F",)), "Fd": (inverse, ("F",)),
    "dF": (inverse, ("F",)),
}  # fmt: skip
