"""The greatest pressure of a compact contact: its radius, which is the only one, and its value."""

from __future__ import annotations

from .compact import end
from .field import Element
from .limits import Limit, Substitution
from .problem import PUNCH, Case, Problem, Rule
from .reading import Tree, UnknownError, put, symbols, tree

POWERS = range(4)
"""Powers of r^2 by which the slope is divided until it is seen to fall."""


def radius(problem: Problem, suffix: str) -> None:
    """Shows that a closed radius is the only zero of dp/dr inside the contact; an equation is left to those below."""
    if any("n" in symbols(piece) for piece in problem.pieces):
        of_power(problem)
        return
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


TAIL = "(n - 2)*r**(n - 2)/(2*a**(n - 1))"
"""What the slope of the pressure under r**n is to the gap of the equation, times E* g'(a)/pi."""


class Power:
    """Pressure, its slope and E* g'(a)/pi under r**n, for any n, n = 2 + q, n = 2, or n = 2 - 1/q with q > 1."""

    def __init__(self, problem: Problem, more: tuple[tuple[Tree, str], ...] = (), n: str = "n") -> None:
        self.field = field = problem.field(("r", "a"), *more)
        self.values = {"n": field.read(tree(n))}
        ((whole,), (sunk,)) = problem.closed("p"), problem.closed("d")
        self.pressure = self.read(whole.expr)
        self.slope = field.slope(self.pressure, "r")
        self.scale = self.read(problem.table("M/pi")) * field.slope(self.read(sunk.expr), "a")

    def read(self, formula: Tree) -> Element:
        """The formula for this n."""
        return self.field.read(formula, self.values)

    def equation(self, left: Tree, right: Tree) -> tuple[Element, Element, Element]:
        """The factor of the gap in the slope of the pressure, and the sides."""
        return self.read(tree(TAIL)) * self.scale, self.read(left), self.read(right)


def of_power(problem: Problem) -> None:
    """Up to n = 2 the pressure falls; beyond, its slope is a positive multiple of a gap that falls through zero."""
    cases = {case.chain: case.expr for case in problem.places("rp", {(1, "n", 2), (2, "n")})}
    head, left, right = put(cases[2, "n"], {"r_peak": "r"})
    beyond, below = Power(problem, n="2 + q"), Power(problem, ((1, "q"),), "2 - 1/q")
    for own in (beyond, below):
        factor, one, other = own.equation(left, right)
        problem.vanishes("the slope of the pressure", own.slope - factor * (one - other))
    paraboloid = Power(problem, n="2")
    below_zero = below.field.sign(factor * (one - other)) == -1 and paraboloid.field.sign(paraboloid.slope) == -1
    factor, one, other = beyond.equation(left, right)
    field, gap, weight = beyond.field, one - other, beyond.read(tree("r**(n - 2)"))
    positive = all(field.sign(part) == 1 for part in (factor, one, other)) and field.analytic(one)
    falls = field.sign(field.slope(gap, "r")) == -1
    if head not in ("Equality", "Eq") or cases[1, "n", 2] != 0 or not (below_zero and positive and falls):
        message = "a slope that changes its sign at one radius, or for n <= 2 at none, is not shown"
        raise UnknownError(message)
    # were the gap below zero up to some radius, the left side would grow faster than the right one towards the axis
    risen = field.slope(weight * one, "r") - beyond.read(tree("(n - 2)*r**(n - 3)")) * gap
    problem.vanishes("growth of the left side", risen)
    problem.vanishes("the right side at the axis", Limit(field, "r", 0, problem.field(("a",)), 1).value(weight * other))
    problem.vanishes("the left side at the edge", end(problem, left, ("r", "a"), "a", "r", 1))


def pressure_of_power(problem: Problem) -> None:
    """r dp/dr = (n - 1) (p - p_max), which is zero at the ring; for n <= 2 the pressure goes to p_max on the axis."""
    (own,) = problem.places("pp", {(1, "n")})
    there = put(own.expr, {"r_peak": "r"})
    every, flatter = Power(problem, ((1, "n"),)), (Power(problem, n="2"), Power(problem, ((1, "q"),), "2 - 1/q"))
    for power in (every, *flatter):
        gap = power.pressure - power.read(there)
        problem.vanishes("the pressure at the ring", power.slope * power.read("r") - power.read(tree("n - 1")) * gap)
    tail = tree(f"r*{TAIL}/(n - 1)*IncompleteBeta(1 - r**2/a**2, 1/2, (3 - n)/2)")
    for power in flatter:
        rest = power.pressure - power.read(there) * power.read(tree("1 - r**2/a**2")) - power.read(tail) * power.scale
        problem.vanishes("the pressure next to the axis", rest)


def by_tangent(formula: Tree) -> Tree:
    """With acos(x) as atan(sqrt(1 - x^2)/x), for 0 < x < 1."""
    if not isinstance(formula, tuple):
        return formula
    if formula[0] == "acos":
        return put(tree("atan((1 - x**2)**(1/2)/x)"), {"x": formula[1]})
    return (formula[0], *map(by_tangent, formula[1:]))


def pressure(problem: Problem, suffix: str) -> None:
    """Shows the greatest pressure as the pressure at its radius; for a closed radius by their squares."""
    if any("n" in symbols(piece) for piece in problem.pieces):
        pressure_of_power(problem)
        return
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
