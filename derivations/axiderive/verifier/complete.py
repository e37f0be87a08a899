"""Complete contact: the face ends at the radius a, and the depth is given."""

from __future__ import annotations

import itertools
import math

from .above import retraction, symbols_of
from .field import Element
from .limits import Substitution
from .problem import MONOMIAL, PUNCH, Case, Problem, Rule
from .reading import Tree, UnknownError, put, symbols


class Face:
    """A face c r**n that stays the same while the radius of its edge varies, by C = h/a**n where it is concave."""

    def __init__(self, problem: Problem, name: str) -> None:
        (piece,) = problem.pieces
        field = problem.field((name, "a"))
        shape = field.read(piece)
        self.flat, self.fixed = shape.num == 0, {}
        power = field.slope(shape, name) * field.symbol(name) / shape if not self.flat else field.number(1)
        if symbols_of(power) - {"n"}:
            message = "the face is no power of the radius"
            raise UnknownError(message)
        self.power = written(power)
        if "a" in symbols(piece):
            self.fixed = {"h": ("Mul", "C", ("Pow", "a", self.power))}
        self.scale = put(piece, {**self.fixed, name: 1}) if not self.flat else 0
        if self.fixed:
            self.scale = ("Mul", -1, "C")
            gap = field.read(put(piece, self.fixed)) + field.symbol("C") * field.power(field.symbol(name), power)
            problem.vanishes("the face is -C r^n", gap)

    def table(self, problem: Problem, formula: str) -> Tree:
        """c times the formula of the face r**n."""
        return ("Mul", self.scale, problem.table(formula, n=self.power))


def written(x: Element) -> Tree:
    """An element that is a number or the symbol n, as a tree."""
    return "n" if x.number is None else x.number


def edges(problem: Problem, suffix: str, face: Face) -> list[tuple[Case, bool]]:
    """The cases of complete contact; before the edge is reached, of the radius c in the place of c(d)."""
    pairs = {"p": [("r", "a")], "w": [("a", "r")]}.get(suffix, [])
    cases, items = problem.entries[suffix], "r" if pairs else ""
    if len(cases) == 1:
        problem.places(suffix, problem.orders(*pairs, items=items))
        return [(cases[0], False)]
    if face.flat or face.fixed:
        message = "such a face is in complete contact at every depth"
        raise UnknownError(message)
    out, seen = [], set()
    depth = face.table(problem, MONOMIAL)
    for case in cases:
        (current,) = {m for m in case.chain if not isinstance(m, str)}
        field = problem.field(("a",))
        if suffix == "dF":
            problem.show("the change where the force reaches the edge", field, current, before(problem, "F", face, "a"))
        else:
            problem.show(
                "the change where the contact reaches the edge",
                field,
                field.read(current, {"d": field.read(depth)}),
                "a",
            )
        chain = tuple("c" if m == current else m for m in case.chain)
        chain = tuple("c" if m == "F" else "a" if m == "c" else m for m in chain) if suffix == "dF" else chain
        first = chain.index("c") < chain.index("a")
        renamed = Case.__new__(Case)
        renamed.chain, renamed.expr = chain, case.expr
        out.append((renamed, first))
        seen.add(chain)
    inner = {"p": lambda o: o.index("r") < min(o.index("a"), o.index("c")),
             "w": lambda o: o.index("r") > min(o.index("a"), o.index("c"))}.get(suffix, lambda o: True)  # fmt: skip
    wanted = {order for order in itertools.permutations(["a", "c", *items]) if inner(order)}
    if seen != wanted or len(cases) != len(wanted):
        message = "its cases are not every place in the order once"
        raise UnknownError(message)
    return out


def before(problem: Problem, suffix: str, face: Face, radius: str) -> Tree:
    """The formula before the edge is reached, for a contact of this radius."""
    (found,) = (case.expr for case, first in edges(problem, suffix, face) if first)
    return put(found, {"d": put(face.table(problem, MONOMIAL), {"a": radius})})


def complete(problem: Problem, suffix: str) -> None:
    """Shows F, p, w, k or dF case by case, before the edge is reached and after."""
    face = Face(problem, "r")
    depth = face.table(problem, MONOMIAL)
    edge_cases = edges(problem, suffix, face)
    stored_beside(problem, suffix, face, edge_cases)
    for case, first in edge_cases:
        if first:
            partial(problem, suffix, case, face, put(depth, {"a": "c"}))
            continue
        chain = tuple(m for m in case.chain if m != "c")
        field = problem.field(chain)
        own = field.read(put(case.expr, face.fixed))
        gap = field.symbol("d") - field.read(depth)
        if suffix in ("k", "dF"):
            (force,) = (c.expr for c, earlier in edges(problem, "F", face) if not earlier)
            if suffix == "k":
                problem.show("k = dF/dd", field, case.expr, field.slope(field.read(force), "d"))
            else:
                problem.show("F at this depth", field, field.read(force, {"d": field.read(case.expr)}), "F")
            continue
        if not field.analytic(own):
            message = "the formula is not shown to be analytic"
            raise UnknownError(message)
        if suffix == "p":
            punch = field.read(problem.table(PUNCH["p"]))
            rest = own - punch * gap
            problem.vanishes(
                "growth of the pressure without its edge term",
                field.slope(rest, "a") - punch * field.slope(field.read(depth), "a"),
            )
        else:
            rest = own
            unit = {"F": "2*M*a**k", "w": "2*cos(k*pi/2)/pi*a**k*(r**2 - a**2)**(-(1 + k)/2)"}[suffix]
            problem.vanishes("growth with the radius", field.slope(own, "a") - field.read(problem.table(unit)) * gap)
        low, flat = field.face("a")
        problem.vanishes("the value where the contact begins", field.limit(rest, "a", low, flat))


def partial(problem: Problem, suffix: str, case: Case, face: Face, depth: Tree) -> None:
    """Before the edge is reached the contact is that of the unbounded face, of the radius c with d = g(c)."""
    chain = tuple(m for m in case.chain if m != "a")
    field = problem.field(chain)
    sunk = field.read(depth)
    own = field.read(case.expr, {"d": sunk})
    if suffix == "dF":
        force = field.read(before(problem, "F", face, "c"))
        problem.vanishes("the depth of this force", field.read(case.expr, {"F": force}) - sunk)
        return
    if suffix == "k":
        problem.vanishes("the stiffness of a punch", own - field.read(put(problem.table(PUNCH["F"]), {"a": "c"})))
        return
    if not field.analytic(own):
        message = "the formula is not shown to be analytic"
        raise UnknownError(message)
    unit = field.read(put(problem.table(PUNCH[suffix]), {"a": "c"}))
    problem.vanishes("growth with the contact radius", field.slope(own, "c") - unit * field.slope(sunk, "c"))
    low, flat = field.face("c")
    problem.vanishes("the value where the contact begins", field.limit(own, "c", low, flat))


def stored_beside(problem: Problem, suffix: str, face: Face, cases: list[tuple[Case, bool]]) -> None:
    """The formula stored for a fixed face is that of complete contact, the one of the unbounded face that before."""
    record = problem.records[suffix]
    coefficient = ("Mul", "h", ("Pow", "a", ("Mul", -1, face.power)))
    for own in map(Case, record["fixed_face"]):
        for case, first in cases:
            if not first:
                left = put(own.expr, {"C": coefficient})
                problem.show("the formula of the fixed face", problem.field(own.chain), left, case.expr)
    if not record["partial"]:
        return
    (own,) = map(Case, record["partial"]["cases"])
    for case, first in cases:
        if first and suffix != "dF":
            field = problem.field(tuple(m for m in case.chain if m != "a"))
            depth = field.read(put(face.table(problem, MONOMIAL), {"a": "c"}))
            left = field.read(case.expr, {"d": depth})
            problem.show("the contact before the edge", field, left, put(own.expr, {"a": "c"}))
        elif first:
            problem.show("the contact before the edge", problem.field(()), own.expr, case.expr)


def detached(problem: Problem, suffix: str) -> None:
    """The edge peels where d - g(a) = -Dl, and goes on to peel as g - Dl falls with a."""
    assert problem.plain
    face, field = Face(problem.plain, "r"), problem.field(("a",))
    (case,) = problem.places(suffix, {("a",)})
    shift, depth = field.read(problem.entries["Dl"][0].expr), field.read(face.table(problem, MONOMIAL))
    given = field.read(problem.entries["dc"][0].expr)
    if suffix == "dc":
        sunk = field.read(put(problem.entries["dc"][0].expr, face.fixed))
        problem.vanishes("d - g(a) = -Dl", sunk - depth + shift)
        if depth.num != 0 and field.sign(field.slope(depth, "a")) != -1 or field.sign(field.slope(shift, "a")) != 1:
            message = "an edge that peels is not shown to go on"
            raise UnknownError(message)
        return
    (force,) = problem.plain.closed("F")
    problem.show("F at that depth", field, case.expr, field.read(force.expr, {"d": given}))


def least(problem: Problem, suffix: str) -> None:
    """The weighted pressure at the least depth, or load, is a product of positive factors and squares, 0 at a place."""
    plane = problem.key.startswith("plane")
    load, name, place = ("P", "x", "xz") if plane else ("d", "r", "rz")
    if suffix == "Fmin":
        (case,) = problem.places("Fmin", {("a",)})
        (force,), (depth,) = problem.closed("F"), problem.closed("dmin")
        field = problem.field(("a",))
        problem.show("F at the least depth", field, case.expr, field.read(force.expr, {"d": field.read(depth.expr)}))
        return
    (ring,), (lowest,), (pressure,) = (problem.closed(s) for s in (place, "Pmin" if plane else "dmin", "p"))
    if ring.chain != ("a",) or lowest.chain != ("a",):
        message = "it holds in another order"
        raise UnknownError(message)
    field, edge = problem.field((name, "a")), problem.field(("a",))
    own, at = field.read(pressure.expr), edge.read(ring.expr)
    weight = field.read(problem.table(f"(a**2 - {name}**2)**((1 - k)/2)"))
    weighted = weight * field.read(pressure.expr, {load: field.read(lowest.expr)})
    unit, factors = weighted.num.factor()
    odd = [field.poly_sign(factor) for factor, times in factors if times % 2]
    shown = field.sign(field.slope(own, load)) == 1 and field.poly_sign(weighted.den) == 1 and all(odd)
    if not shown or (1 if unit > 0 else -1) * math.prod(sign or 0 for sign in odd) < 0:
        message = "a pressure that is nowhere negative is not shown"
        raise UnknownError(message)
    if edge.sign(at) not in (0, 1) or edge.sign(edge.symbol("a") - at) != 1:
        message = "a ring inside the contact is not shown"
        raise UnknownError(message)
    problem.vanishes("the pressure at the ring", Substitution(field, edge, {name: at}).value(weighted))


COMPLETE: dict[str, Rule] = {
    "F": (complete, ()),
    "p": (complete, ()),
    "w": (complete, ()),
    "k": (complete, ("F",)),
    "dF": (complete, ("F",)),
    "rz": (least, ("p",)),
    "dmin": (least, ("p",)),
    "Fmin": (least, ("F", "dmin")),
}
DETACHED: dict[str, Rule] = {"Dl": (retraction, ()), "dc": (detached, ("Dl",)), "Fc": (detached, ("dc", "plain.F"))}
