"""Adhesion, friction and viscoelasticity: what follows from the normal contact."""

from __future__ import annotations

from .compact import WAYS
from .field import Element, Field
from .limits import Substitution
from .problem import PUNCH, Case, Chain, Problem, Rule
from .reading import Tree, UnknownError, put, tree


def retraction(problem: Problem, suffix: str) -> None:
    """Shows Dl > 0 and c_N(a) Dl^2 = 2 pi a dgamma, or raises `UnknownError`."""
    (case,) = problem.places("Dl", {("a",)})
    field = problem.field(("a",))
    own = field.read(case.expr)
    problem.vanishes(
        "c_N(a) Dl^2 = 2 pi a dgamma",
        own * own * field.read(problem.table("M*a**k")) - field.read(tree("2*pi*a*dgamma")),
    )
    if field.sign(own) != 1:
        message = "the retraction is not shown to be positive"
        raise UnknownError(message)


def same_places(problem: Problem, suffix: str, source: str) -> list[tuple[Case, Tree]]:
    """The cases, each with the formula of the contact below in the same order; `UnknownError` if the orders differ."""
    assert problem.plain
    wanted = {case.chain for case in problem.plain.closed(source)}
    return [(case, problem.plain.of(source, case.chain)) for case in problem.places(suffix, wanted)]


def superposed(problem: Problem, suffix: str) -> None:
    """Shows d, F, p or w as that of the contact without adhesion less Dl times that of a flat punch moved by 1."""
    (shift,) = problem.entries["Dl"]
    for case, plain in same_places(problem, suffix, suffix):
        field = problem.field(case.chain)
        moved = field.read(problem.table(PUNCH[suffix])) * field.read(shift.expr)
        problem.show("the contact without adhesion less a flat punch", field, field.read(case.expr) + moved, plain)


def stationary(problem: Problem, control: str, field: Field, chain: Chain) -> Element:
    """The retraction at which the force, or the depth, does not change with a: dDl/da = (1 - k) Dl/(2 a)."""
    assert problem.plain
    punch = field.read(problem.table(PUNCH[control]))
    growth = field.slope(punch, "a") + punch * field.read(problem.table("(1 - k)/(2*a)"))
    return field.slope(field.read(problem.plain.of(control, chain)), "a") / growth


PULL_OFF = {"ac": "F", "Fc": "F", "dc": "F", "am": "d", "Fm": "d", "dm": "d"}


def steep(problem: Problem) -> list[tuple[Tree, str]]:
    """A power law needs n > (1 - k)/2 for a pull-off."""
    return (
        [(problem.table("(1 - k)/2"), "n")] if "n" in map(tree, (p["="] for p in problem.profile["parameters"])) else []
    )


def pull_off(problem: Problem, suffix: str) -> None:
    """With the stationary retraction Dl, c_N Dl^2 = 2 pi a dgamma at the radius; force and depth follow."""
    assert problem.plain
    control = PULL_OFF[suffix]
    radius = "ac" if control == "F" else "am"
    entry, source = problem.entries[suffix], suffix[0]
    regimes = [case.chain for case in problem.plain.closed(control)]
    closed = problem.records[radius]["status"] == "closed"
    if any(case.chain for case in entry):
        problem.places(suffix, {tuple("a_c" if m == "a" else m for m in chain) for chain in regimes})
    elif len(entry) != 1 or len(regimes) != 1 or not closed:
        message = "its cases are not those of the contact"
        raise UnknownError(message)
    for case in entry:
        chain = tuple("a" if m == "a_c" else m for m in case.chain) or regimes[0]
        field = problem.field(chain, *steep(problem))
        level = stationary(problem, control, field, chain)
        if suffix == radius:
            at_pull_off(problem, case, field, level, control)
            continue
        unit = field.read(problem.table(PUNCH[source]))
        wanted = field.read(problem.plain.of(source, chain)) - unit * level
        if case.chain:
            problem.show("the value at pull-off", field, put(case.expr, {"a_c": "a"}), wanted)
        else:
            flat = problem.field((), *steep(problem))
            problem.show(
                "the value at pull-off",
                flat,
                case.expr,
                moved(wanted, flat, flat.read(problem.entries[radius][0].expr)),
            )


def stable(problem: Problem, suffix: str) -> None:
    """The radius where the retraction is a share below 1 of the stationary one, which gives the work of separation."""
    source, value = {"ad": ("d", "d"), "aF": ("F", "F")}[suffix]
    (own,), (forward,) = problem.places(suffix, {()}), problem.closed(source)
    field = problem.field(forward.chain)
    level = stationary(problem, source, field, forward.chain)
    if field.sign(level) != 1:
        message = "a stable branch is not shown"
        raise UnknownError(message)
    work = level * level * field.read(problem.table("share**2*M*a**k/(2*pi*a)"))
    given = field.read(forward.expr, {"dgamma": work})
    back = field.read(own.expr, {"dgamma": work, value: given})
    problem.show("the inverse on the stable branch", field, back, "a")


def at_pull_off(problem: Problem, case: Case, field: Field, level: Element, control: str) -> None:
    """Shows a closed radius by the energy and the minimum there, or that an equation is that of pull-off."""
    if not case.chain:
        unit = problem.table("(1 - k)/2")
        rise = field.slope(level, "a") * field.read("a") / level - field.read(unit)
        if field.sign(level) != 1 or field.sign(rise) != 1:
            message = "a minimum at pull-off is not shown"
            raise UnknownError(message)
        flat = problem.field((), *steep(problem))
        place = flat.read(case.expr)
        if flat.sign(place) != 1:
            message = "a positive radius is not shown"
            raise UnknownError(message)
        energy = level * level * field.read(problem.table("M*a**k")) - field.read(tree("2*pi*a*dgamma"))
        problem.vanishes("the energy at pull-off", moved(energy, flat, place))
        return
    if not (isinstance(case.expr, tuple) and case.expr[0] == "Equality"):
        message = "it is no equation"
        raise UnknownError(message)
    _, left, right = put(case.expr, {"a_c": "a"})
    weight = problem.table("(3 + k)/(2*a)" if control == "F" else "(1 - k)/(2*a)")
    gap = field.read(weight) * (level - field.read(problem.entries["Dl"][0].expr))
    problem.vanishes("the equation of pull-off", field.read(left) - field.read(right) - gap)


def stick(problem: Problem, chain: Chain) -> tuple[Chain, Chain]:
    """The orders of the whole contact and of one whose radius is that of the stick zone."""
    return tuple(m for m in chain if m != "c"), tuple("a" if m == "c" else m for m in chain if m != "a")


def slip(problem: Problem, suffix: str) -> None:
    """mu times the difference of two contacts of radii a and c; where the surface slips, mu p."""
    assert problem.plain
    source, unit = {"F": ("F", "mu"), "tau": ("p", "mu"), "u": ("d", "mu*M/T")}[suffix]
    pairs = [("c", "a"), *([("r", "a")] if suffix == "tau" else []), *([(problem.floor, "c")] if problem.floor else [])]
    wanted = problem.orders(*pairs, items=["c", "r"] if suffix == "tau" else ["c"])
    regimes = {case.chain for case in problem.plain.closed(source)}
    wanted = {chain for chain in wanted if stick(problem, chain)[0] in regimes}
    for case in problem.places(suffix, wanted):
        field, (outer, inner) = problem.field(case.chain), stick(problem, case.chain)
        value = field.read(problem.plain.of(source, outer))
        if "r" not in case.chain or case.chain.index("r") < case.chain.index("c"):
            value = value - field.read(put(problem.plain.of(source, inner), {"a": "c"}))
        problem.show(
            "mu times a difference of normal contacts", field, case.expr, value * field.read(problem.table(unit))
        )


def full_slip(problem: Problem, suffix: str) -> None:
    """Shows the displacement at full slip as mu M/T times the depth of the normal contact."""
    assert problem.plain
    for case, plain in same_places(problem, suffix, "d"):
        field = problem.field(case.chain)
        problem.show(
            "the displacement at full slip", field, case.expr, field.read(plain) * field.read(problem.table("mu*M/T"))
        )


def stick_radius(problem: Problem, suffix: str) -> None:
    """Shows that c at the force mu (F(a) - F(c)) is c, in the first of `WAYS` that can; else `UnknownError`."""
    assert problem.plain
    (force,) = problem.plain.closed("F")
    chain = (problem.floor, "c", "a") if problem.floor else ("c", "a")
    (case,) = problem.places("c", {chain})
    for place, more in WAYS if problem.floor else WAYS[:1]:
        try:
            field = problem.field(chain if place == "a" else (problem.floor, "a"), *more)
            inner = field.read(tree(place), {"a": field.symbol("c")})
            lost = (field.read(force.expr) - field.read(force.expr, {"a": inner})) * field.read("mu")
            problem.show("c at the force that leaves it", field, field.read(case.expr, {"F_x": lost}), inner)
            return
        except UnknownError as error:
            reason = error
    raise reason


LAWS = {
    "mx": ("E*exp(-time/relaxation)", "(1 + time/relaxation)/E", "E*Kummer(1, 1 + m, -time/relaxation)"),
    "kv": ("E", "(1 - exp(-E*time/eta))/E", "E + eta*m/time"),
    "sls": ("E_inf + E_1*exp(-time/relaxation)",
            "(1 - E_1/(E_inf + E_1)*exp(-time*E_inf/(relaxation*(E_inf + E_1))))/E_inf",
            "E_inf + E_1*Kummer(1, 1 + m, -time/relaxation)"),
    "pc": ("E*(t_0/time)**alpha/(gamma(1 + alpha)*gamma(1 - alpha))", "(time/t_0)**alpha/E",
           "E*(t_0/time)**alpha*gamma(1 + m)/(gamma(1 + alpha)*gamma(1 + m - alpha))"),
}  # fmt: skip
"""Relaxation E(t), creep J(t) and the factor int_0^1 m x^(m-1) E(t (1 - x)) dx of a ramp of a force as d^m."""


def viscous(problem: Problem, suffix: str) -> None:
    """The elastic force with E(t) for its modulus, the elastic radius with 1/J(t), the factor of a ramp."""
    assert problem.plain
    kind, law = suffix.split("_")
    relaxed, creep, ramp = map(tree, LAWS[law])
    source = "aF" if kind == "load" else elastic_force(problem, suffix)
    plain = problem.plain.closed(source)
    cases = problem.entries[suffix]
    if [case.chain for case in cases] != [() if kind == "ramp" else case.chain for case in plain]:
        message = "its cases are not those of the elastic contact"
        raise UnknownError(message)
    for i, (case, elastic) in enumerate(zip(cases, plain, strict=True)):
        if source == "Fd" and len(plain) > 1:
            regimes(problem, case, elastic, problem.plain.closed("d")[i], relaxed)
            continue
        field = problem.field(tuple(m for m in elastic.chain if isinstance(m, str)))
        own, given = case.expr, field.read(elastic.expr)
        if kind == "load":
            problem.show(
                "the radius under 1/J(t)",
                field,
                own,
                field.read(elastic.expr, {"E_star": field.read(("Pow", creep, -1))}),
            )
            continue
        modulus = field.symbol("E_star")
        problem.vanishes("the force is proportional to the modulus", field.slope(given, "E_star") * modulus - given)
        if problem.records[suffix]["status"] == "root":
            if not (isinstance(own, tuple) and own[0] == "Equality" and own[1] == "F"):
                message = "it is no equation for the force"
                raise UnknownError(message)
            own = own[2]
        if kind == "step":
            problem.show("the force with E(t) for its modulus", field, own, given / modulus * field.read(relaxed))
            continue
        power = field.slope(given, "d") * field.symbol("d") / given
        if symbols_of(power) - {"n"} or field.sign(power) != 1:
            message = "the force is no power of the depth"
            raise UnknownError(message)
        sunk = field.read(elastic.expr, {"d": field.read(tree("v*time"))})
        problem.show("the force of a ramp", field, own, sunk / modulus * field.read(ramp, {"m": power}))


def regimes(problem: Problem, case: Case, elastic: Case, depth: Case, relaxed: Tree) -> None:
    """A step of depth in one of several regimes, where roots are known for the depth of a radius only."""
    for place, more in WAYS if depth.chain[0] != "a" else WAYS[:1]:
        try:
            field = problem.field(depth.chain, *more)
            sunk = field.read(depth.expr, {"a": field.read(tree(place))})
            force = field.read(elastic.expr, {"d": sunk})
            modulus = field.symbol("E_star")
            problem.vanishes("the force is proportional to the modulus", field.slope(force, "E_star") * modulus - force)
            wanted = force / modulus * field.read(relaxed)
            problem.vanishes("the force with E(t) for its modulus", field.read(case.expr, {"d": sunk}) - wanted)
            return
        except UnknownError as error:
            reason = error
    raise reason


def symbols_of(x: Element) -> set[str]:
    """Names of the symbols of an element, "?" for a root or a function."""
    return {
        name
        for poly in (x.num, x.den)
        for i, m in enumerate(poly.degrees())
        if m
        for name in [x.field.kind[i][1] if x.field.kind[i][0] == "symbol" else "?"]
    }


def elastic_force(problem: Problem, suffix: str) -> str:
    """The quantity of the contact below: "Fd" where there is one and the entry is no equation, else "F"."""
    assert problem.plain
    if problem.records[suffix]["status"] == "root" or "Fd" not in problem.plain.entries:
        return "F"
    return "Fd"


def moved(x: Element, field: Field, place: Element) -> Element:
    """The element at another place in a field without the symbol a."""
    return Substitution(x.field, field, {"a": place}).value(x)


ADHESIVE: dict[str, Rule] = {
    "Dl": (retraction, ()),
    **{suffix: (superposed, ("Dl", f"plain.{suffix}")) for suffix in ("d", "F", "p", "w")},
    "ad": (stable, ("d", "plain.d")),
    "aF": (stable, ("F", "plain.F")),
    "ac": (pull_off, ("Dl", "plain.F")),
    "Fc": (pull_off, ("ac", "plain.F")),
    "dc": (pull_off, ("ac", "plain.F", "plain.d")),
    "am": (pull_off, ("Dl", "plain.d")),
    "Fm": (pull_off, ("am", "plain.d", "plain.F")),
    "dm": (pull_off, ("am", "plain.d")),
}
TANGENTIAL: dict[str, Rule] = {
    "F": (slip, ("plain.F",)), "tau": (slip, ("plain.p",)), "u": (slip, ("plain.d",)), "us": (full_slip, ("plain.d",)),
    "c": (stick_radius, ("plain.F",)),
}  # fmt: skip
