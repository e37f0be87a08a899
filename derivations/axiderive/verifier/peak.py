"""The greatest pressure of a compact contact: its radius, which is the only one, and its value."""

from __future__ import annotations

from .compact import end
from .limits import Limit, Substitution
from .problem import PUNCH, Case, Problem, Rule
from .reading import Tree, UnknownError, put, tree

POWERS = range(4)
"""Powers of r^2 by which the slope is divided until it is seen to fall."""


def radius(problem: Problem, suffix: str) -> None:
    """Shows that a closed radius is the only zero of dp/dr inside the contact; an equation is left to `balance`."""
    (case,) = problem.places("rp", problem.orders())
    if problem.records["rp"]["status"] == "root":
        balance(problem, case)
        return
    (pressure,) = problem.closed("p")
    field, edge = problem.field(("r", "a")), problem.field(("a",))
    slope = field.slope(field.read(pressure.expr), "r") * field.read(tree("(a**2 - r**2)**(1/2)/r"))
    falls = (field.sign(field.slope(slope * field.read(tree(f"r**(-{2 * j})")), "r")) == -1 for j in POWERS)
    at = edge.read(case.expr)
    if not any(falls) or edge.sign(at) != 1 or edge.sign(edge.symbol("a") - at) != 1:
        message = "one zero of the slope inside the contact is not shown"
        raise UnknownError(message)
    problem.vanishes("the slope of the pressure", Substitution(field, edge, {"r": at}).value(slope))


def balance(problem: Problem, case: Case) -> None:
    """The sides of the equation, over one factor, are the two parts of dp/dr, of which one is that of the edge."""
    b, regime = case.chain[0], problem.field(case.chain)
    chain = (b, "r", "a")
    field = problem.field(chain)
    head, left, right = put(case.expr, {"r_peak": "r"})
    sunk = problem.of("d", case.chain)
    rate = field.slope(field.read(sunk), "a")
    added = field.read(problem.table(PUNCH["p"])) * rate
    rim = added * field.symbol("r") / field.symbol("a")
    one, other = field.read(left), field.read(right)
    factor = other / rim
    problem.vanishes("growth of the factor", field.slope(factor, "a"))
    if head not in ("Equality", "Eq") or field.sign(factor) != 1 or not field.analytic(one):
        message = "an equation of dp/dr is not shown"
        raise UnknownError(message)
    inner = field.slope(added, "r") + field.slope(rim, "a")
    problem.vanishes("growth of the slope of the pressure", field.slope(one, "a") - factor * inner)
    problem.vanishes("its value where the contact begins", end(problem, left, chain, "a", "r", 1))
    # in place of pi/2 less an arcsine, whose limit is seen
    grown = regime.slope(regime.read(by_tangent(sunk)), "a") / regime.symbol("a")
    steep = regime.slope(grown, "a")
    face = problem.field(tuple(m for m in case.chain if m != "a"))
    floor = Limit(regime, "a", b, face, 1)
    problem.vanishes("growth of the depth at the break", floor.value(grown))
    pole = floor.value(steep * regime.read(tree(f"(a**2 - {b}**2)**(1/2)")))
    falls = regime.sign(regime.slope(steep / regime.symbol("a"), "a")) == -1
    if regime.sign(steep) != 1 or not falls or face.sign(pole) != 1:
        message = "a slope that falls from above zero to below is not shown"
        raise UnknownError(message)


def by_tangent(formula: Tree) -> Tree:
    """With acos(x) as atan(sqrt(1 - x^2)/x), for 0 < x < 1."""
    if not isinstance(formula, tuple):
        return formula
    if formula[0] == "acos":
        return put(tree("atan((1 - x**2)**(1/2)/x)"), {"x": formula[1]})
    return (formula[0], *map(by_tangent, formula[1:]))


def pressure(problem: Problem, suffix: str) -> None:
    """Shows the greatest pressure as the pressure at its radius; for a closed radius by their squares."""
    (case,), (own,) = problem.entries["rp"], problem.places("pp", problem.orders())
    if problem.records["rp"]["status"] == "root":
        chain = (case.chain[0], "r", "a")
        field = problem.field(chain)
        (value,) = (other.expr for other in problem.closed("p") if other.chain == chain)
        problem.show("the pressure there", field, put(own.expr, {"r_peak": "r"}), value)
        return
    (whole,) = problem.closed("p")
    field, edge = problem.field(("r", "a")), problem.field(("a",))
    value, greatest = field.read(whole.expr), edge.read(own.expr)
    if field.sign(value) != 1 or edge.sign(greatest) != 1:
        message = "a positive pressure is not shown"
        raise UnknownError(message)
    # the squares, in which the roots of a - r and a + r are gone
    at = Substitution(field, edge, {"r": edge.read(case.expr)})
    problem.vanishes("the square of the pressure there", greatest * greatest - at.value(value * value))


PEAK: dict[str, Rule] = {"rp": (radius, ("p",)), "pp": (pressure, ("p", "rp"))}
