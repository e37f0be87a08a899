"""Plane contact: the load by antiderivatives, fields by their growth with the half-width, the eccentric strip."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from .compact import abel, end, integral, inverse
from .complete import Face, least
from .field import Element, Field
from .problem import Problem, Rule
from .reading import Tree, UnknownError, put, tree

STRIP = {"p": "1/(pi*(a**2 - x**2)**(1/2))", "s": "-2/(pi*E_star*(x**2 - a**2)**(1/2))"}
"""A level strip of half-width a under a unit line load."""
STRIP_LOAD = "E_star*n*a**n*pi**(1/2)*gamma((n + 1)/2)/(2*gamma(n/2 + 1))"
"""Line load under the face x**n."""


def plane_load(problem: Problem, suffix: str) -> None:
    """Shows the load by antiderivatives of E* x f'(x)/sqrt(a^2 - x^2)."""
    for case in problem.places("P", problem.orders()):
        abel(problem, case, "P", "E_star*x*slope*(a**2 - x**2)**(-1/2)")


def plane_field(problem: Problem, suffix: str) -> None:
    """Shows p or s by its growth with the half-width, for complete contact without the edge term."""
    pair = ("x", "a") if suffix == "p" else ("a", "x")
    if problem.profile["contact"] == "compact":
        integral(problem, suffix, problem.orders(pair, items="x"), "P", STRIP[suffix], "x")
        return
    face = Face(problem, "x")
    (case,) = problem.places(suffix, {pair})
    field = problem.field(pair)
    strip, load = field.read(tree(STRIP[suffix])), field.read(face.table(problem, STRIP_LOAD))
    own = field.read(put(case.expr, face.fixed))
    rest = own - strip * (field.symbol("P") - load)
    if not field.analytic(own):
        message = "the formula is not shown to be analytic"
        raise UnknownError(message)
    problem.vanishes("growth without the edge term", field.slope(rest, "a") - strip * field.slope(load, "a"))
    low, flat = field.face("a")
    problem.vanishes("the value where the contact begins", field.limit(rest, "a", low, flat))


def plane_depth(problem: Problem, suffix: str) -> None:
    """The depth is f at the edge and the descent of the surface from there to L."""
    cases = problem.places("d", {tuple("L" if m == "x" else m for m in case.chain) for case in problem.closed("s")})
    for case in cases:
        field = problem.field(case.chain)
        own = field.read(case.expr)
        slope = field.read(put(problem.of("s", tuple("x" if m == "L" else m for m in case.chain)), {"x": "L"}))
        if not field.analytic(own):
            message = "the formula is not shown to be analytic"
            raise UnknownError(message)
        problem.vanishes("dd/dL = -s(L)", field.slope(own, "L") + slope)
        i = case.chain.index("L")
        lower = case.chain[i - 1]
        value = end(problem, case.expr, case.chain, "L", lower, 1)
        if lower == "a":
            piece = problem.pieces[sum(b in case.chain[: case.chain.index("a")] for b in problem.breaks)]
            value = value - value.field.read(put(piece, {"x": "a", "r": "a"}))
        else:
            swapped = (*case.chain[: i - 1], "L", lower, *case.chain[i + 1 :])
            (other,) = (c.expr for c in cases if c.chain == swapped)
            value = value - end(problem, other, swapped, "L", lower, -1)
        problem.vanishes("the depth at the edge", value)


def half_width(problem: Problem, suffix: str) -> None:
    """Shows a closed half-width as the inverse of P(a), or that its equation is P(a) = P with P' > 0."""
    if problem.records[suffix]["status"] == "closed":
        inverse(problem, suffix)
        return
    loads = problem.closed("P")
    for case in problem.places("aP", {case.chain for case in loads}):
        field = problem.field(case.chain)
        if not (isinstance(case.expr, tuple) and case.expr[0] == "Equality" and case.expr[2] == "P"):
            message = "it is no equation for the load"
            raise UnknownError(message)
        load = field.read(problem.of("P", case.chain))
        problem.show("the equation is P(a) = P", field, case.expr[1], load)
        if field.sign(field.slope(load, "a")) != 1:
            message = "a load that grows with the half-width is not shown"
            raise UnknownError(message)


PLANE: dict[str, Rule] = {
    "P": (plane_load, ()),
    "p": (plane_field, ("P",)),
    "s": (plane_field, ("P",)),
    "d": (plane_depth, ("s",)),
    "aP": (half_width, ("P",)),
}
PLANE_COMPLETE: dict[str, Rule] = {
    "p": (plane_field, ()), "s": (plane_field, ()), "d": (plane_depth, ("s",)), "xz": (least, ("p",)),
    "Pmin": (least, ("p",)),
}  # fmt: skip


def tilted(problem: Problem, suffix: str) -> None:
    """An eccentric load on a strip: p = (alpha + beta x)/sqrt(c^2 - x^2), x from the middle of the contact, |x| < c.

    Its load is pi alpha and its moment pi beta c^2/2; the inclination is 2 beta/E_star.  Touching all over, c = a and
    e < a/2; lifted, the pressure vanishes at the lifted edge and the middle of the contact is at a - c.
    """
    wanted = [(("Abs", "e"), tree("a/2")), (tree("a/2"), ("Abs", "e"))]
    cases = problem.entries[suffix]
    if [
        (low, put_half(high)) if low == ("Abs", "e") else (put_half(low), high)
        for low, high in (c.chain for c in cases)
    ] != wanted:
        message = "its cases do not change at |e| = a/2"
        raise UnknownError(message)
    for i, (eccentric, half, middle) in enumerate((("a**2/(2*(a + t))", "a", "0"), ("a - c/2", "c", "a - c"))):
        order = [(tree("y/2"), half), *([("c", "a")] if i else [])]
        field = problem.field((), *order)
        e, c, m = (field.read(tree(text)) for text in (eccentric, half, middle))
        x = field.symbol("y") - c

        if not i:
            # on both sides of e = 0 the formula is one and the same, and finite between them
            whole = problem.entries[suffix][0].expr
            field.read(whole, {"e": field.number(0), "x": x})

        def value(name: str, sign: int, at: Element, i: int = i, e: Element = e, field: Field = field) -> Element:
            formula = signed(problem.entries[name][i].expr, sign)
            return signed_read(field, formula, {"e": e * sign, "x": at * sign})

        one, other = value(suffix, 1, x + m), value(suffix, -1, x + m)
        problem.vanishes("the mirror image for e < 0", one - other * (-1 if suffix == "phi" else 1))
        weighted = value("p", 1, x + m) * field.power(c * c - x * x, field.number("1/2"))
        beta = field.slope(weighted, "y")
        alpha = weighted - beta * x
        problem.vanishes("the pressure is linear over the root", field.slope(beta, "y"))
        pi, load = field.symbol("pi"), field.symbol("P")
        if suffix == "p":
            problem.vanishes("the load", pi * alpha - load)
            problem.vanishes("the moment", pi * beta * c * c / 2 + m * load - e * load)
            lifted = alpha - beta * c
            if i:
                problem.vanishes("the pressure at the lifted edge", lifted)
                apart(problem)
            elif field.sign(lifted) != 1:
                message = "a pressure at both edges is not shown"
                raise UnknownError(message)
        elif suffix == "phi":
            problem.vanishes("the inclination", one - beta * 2 / field.symbol("E_star"))
        else:
            problem.vanishes("the width", one - c * 2)


def apart(problem: Problem) -> None:
    """Where the strip is lifted the pressure is 0: for e > 0 at x = a - 2 c - y > -a."""
    field = problem.field((), (tree("c + y/2"), "a"))
    for sign in (1, -1):
        values = {"e": field.read(tree("a - c/2")) * sign, "x": field.read(tree("a - 2*c - y")) * sign}
        problem.vanishes("the lifted part", signed_read(field, signed(problem.entries["p"][1].expr, sign), values))


def put_half(formula: Tree) -> Tree:
    """a/2 as the tables write it."""
    return tree("a/2") if formula in (("Mul", Fraction(1, 2), "a"), ("Mul", "a", Fraction(1, 2))) else formula


def signed(formula: Tree, sign: int) -> Tree:
    """A formula with the absolute value and the sign of e for a known sign; other heads stay unknown."""
    if formula == ("Abs", "e"):
        return ("Mul", sign, "e")
    if formula == ("sign", "e"):
        return sign
    return (formula[0], *(signed(part, sign) for part in formula[1:])) if isinstance(formula, tuple) else formula


def signed_read(field: Field, formula: Tree, values: Mapping[str, Element]) -> Element:
    """A formula with Max(0, x), where x has one sign on the whole domain."""
    if isinstance(formula, tuple) and formula[0] == "Max" and formula[1] == 0 and len(formula) == 3:
        inner = signed_read(field, formula[2], values)
        if not field.sign(inner):
            message = "the larger of two numbers is not shown"
            raise UnknownError(message)
        return inner if field.sign(inner) == 1 else field.number(0)
    if isinstance(formula, tuple):
        names = {f"part{i}": signed_read(field, part, values) for i, part in enumerate(formula[1:])}
        return field.read((formula[0], *names), names)
    return field.read(formula, values)


TILTED: dict[str, Rule] = {"p": (tilted, ()), "phi": (tilted, ("p",)), "cw": (tilted, ("p",))}
