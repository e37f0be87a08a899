"""Contact with a cohesive zone: the normal contact less what the ring takes, and the root of the ring."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import sympy as sp

from ...abel.masters import Dawson
from ...entry import COMPACT, FOUR
from ...letters import name_of
from ...notation import E_star, a, dgamma, r, sigma_0
from ...physics.cohesive import PHYSICS, cohesive
from .. import docstring
from ..function import Function
from ..text import python
from ..writer import Writer, not_above
from .adhesive import exponent

MATERIAL = ("E_star", "dgamma", "sigma_0")
LOSSES = {
    "_depth": "sunk(q, E_star, sigma_0)",
    "_force": "pull_of_zone(q, a, sigma_0)",
    "_pressure": "tension_of_zone(r, q, a, sigma_0)",
    "_displacement": "lift_of_zone(r, q, a, E_star, sigma_0)",
}
BEYOND = "whose zone would reach beyond the profile"
NOTE = f"Negative or NaN field values give NaN, as do states {BEYOND}."
PULL = "-np.pi * sigma_0 * c * c"
"""Force of a zone without contact."""
PARTED = "depth"
"""The load that is held while the surfaces part without contact."""
OPENED = "Gap of the normal contact at c, and its rate with c."
ZONE = name_of(cohesive)
ORDER = "the zone surrounds the contact; exchange a and c"


def rules(writer: Writer) -> None:
    """Adds the root of the zone, and what it takes of the normal contact."""
    needs = [*writer.geometry, *MATERIAL]
    zone = Function("_zone", ["a"], needs, []).call()
    pair = "tuple[Array, Array]"
    writer.rule("_opened", ["q", "a"], writer.geometry, _opened(writer), OPENED, returns=pair)
    opened = _bound_to_shape(writer, "_opened")
    writer.rule("_zone", ["a"], needs, _root(writer, opened), "sqrt(c**2 - a**2) of the zone.")
    work = f"work_of_zone({opened}, difference_root(c, a), a, E_star, sigma_0)"
    writer.rule("_work_of_separation", ["a", ZONE], [*writer.geometry, "E_star", "sigma_0"], [f"return {work}"])
    writer.rule("_cohesive_radius", ["a"], needs, [f"return outer_radius({zone}, a)"])
    for function, loss in LOSSES.items():
        fields = ["r", "a"] if loss.partition("(")[2].startswith("r") else ["a"]
        plain = _plain(writer, function, *fields)
        within = [*fields, "q"]
        writer.rule(f"{function}_of", within, needs, [f"return {plain} - {loss}"])
        lines = [f"return {Function(f'{function}_of', within, needs, []).call(*fields, zone)}"]
        writer.rule(function, fields, needs, lines)
    _states(writer, opened)


def _states(writer: Writer, opened: str) -> None:
    """Adds pull-off, which ends without contact under control of the depth, and the stable branches."""
    needs = [*writer.geometry, *MATERIAL]
    given = ", ".join(needs)
    writer.rule("_growth", ["a"], writer.geometry, _growth(writer), "Rate g'(a) of the depth of the normal contact.")
    first = f"first = _zone(np.zeros_like(sigma_0), {given})"
    # searches start from about there
    about = ["a = np.zeros_like(sigma_0)", *_root(writer, opened, "first = {}", "zone_like")]
    writer.rule("_radii", [], needs, [*about, *_radii(writer)], returns="Stretch")
    closing = ", ".join(filter(None, ["start, a, control, E_star, dgamma, sigma_0", _largest(writer)]))
    state = [
        f"growth = _growth(a, {', '.join(writer.geometry)})",
        f"return state_near({opened}, growth, {closing})",
    ]
    writer.rule("_state", ["a", "start"], [*needs, "control"], state, returns="State")
    searched = f"lambda a, start: _state(a, start, {given}, {{}})"
    loaded = f"lambda a, q: {{}}(a, q, {given})"
    pulled = [
        'load = _force_of if control == "force" else _depth_of',
        f"return radius_of_pull_off({searched.format('control')}, {loaded.format('load')}, _radii({given}))",
    ]
    writer.rule("_pull_off_radius", [], [*needs, "control"], pulled)
    apart = f"alone({opened}, {{}}, E_star, dgamma, sigma_0)"
    ring = f"parted({opened}, first, E_star, sigma_0)"
    if border := _border(writer):
        ring = f"parted_by({opened}, first, {border}, E_star, sigma_0)"
    writer.rule("_parted", [], needs, [first, f"return {ring}"])
    # that it is within the profile is known of a radius that was found
    ends = [f"largest = {largest}"] if (largest := _largest(writer)) else []
    zone = f"root_of_zone({opened}, a, E_star, dgamma, sigma_0{', largest' if largest else ''})"
    without = f"np.where(a == 0.0, _parted({given}), np.nan)"
    writer.rule("_pull_off_zone", ["a"], needs, [*ends, f"return either(a > 0.0, lambda: {zone}, lambda: {without})"])
    depth = f"return either(a > 0.0, lambda: _depth_of(a, q, {given}), lambda: {apart.format('q')})"
    writer.rule("_pull_off_depth", ["a", "q"], needs, [depth])
    closed = "np.where(depth <= -sunk(c, E_star, sigma_0), {}, np.nan)"
    for member, value in (("depth", "depth"), ("force", PULL)):
        lines = [f"depth = {apart.format('c')}", f"return {closed.format(value)}"]
        writer.rule(f"_without_contact_{member}", [ZONE], needs, lines)
    for inverse in PHYSICS.searched:
        (field,), load = map(name_of, inverse.arguments), COMPACT[inverse.inverts].function
        states = searched.format(f'"{load}"')
        found = f"radius_under({states}, {loaded.format(f'_{load}_of')}, {field}, _radii({given}))"
        if load == PARTED:
            held = [
                f'apart = _pull_off_radius({given}, "{load}") == 0.0',
                f"deeper = {field} >= {apart.format(f'_parted({given})')}",
                "return np.where(apart & deeper, 0.0, np.nan)",
            ]
            writer.rule("_held_apart", [field], needs, held)
            lines = [f"a = {found}", f"return np.where(np.isnan(a), _held_apart({field}, {given}), a)"]
        else:
            lines = [f"return {found}"]
        writer.rule(f"_{inverse.function}", [field], needs, lines)


def _radii(writer: Writer) -> list[str]:
    """The radii that separate the minima: by the first zone, and by a break or the end of the profile."""
    profile, end = writer.profile, _end(writer)
    if border := _border(writer):
        return [f"return radii_by(first, {border})"]
    if profile.largest is not None:
        return [f"return radii_on_bump(first, {python(profile.largest)})"]
    return ["return radii(first)" if end is None else f"return radii_up_to(first, {python(end)})"]


def _border(writer: Writer) -> str:
    """The formula of the radius at which the profile breaks, if it does."""
    profile = writer.profile
    return python(dict(profile.abbreviations).get(profile.breaks[0], profile.breaks[0])) if profile.breaks else ""


def _bound_to_shape(writer: Writer, function: str) -> str:
    return f"partial({', '.join([function, *(f'{name}={name}' for name in writer.geometry)])})"


def _plain(writer: Writer, function: str, *fields: str) -> str:
    """The normal contact, of which there is none within a flat face."""
    plain = writer.call(function, *(fields or ("a",)))
    return f"np.where(a < {writer.profile.breaks[0]}, 0.0, {plain})" if writer.profile.truncated else plain


def _largest(writer: Writer) -> str:
    """What no q is above, if the profile ends."""
    end = writer.profile.largest or _end(writer)
    return "" if end is None else f"difference_root({python(end)}, a)"


def _root(writer: Writer, opened: str, line: str = "return {}", rule: str = "root_of_zone") -> list[str]:
    """The lines of the root, the last of which is one with it."""
    given, largest = f"{opened}, a, E_star, dgamma, sigma_0", _largest(writer)
    if not largest:
        return [line.format(f"{rule}({given})")]
    return [
        f"largest = {largest}",
        f"a = zone_within({given}, largest)",
        line.format(f"np.where(np.isnan(a), np.nan, {rule}({given}, largest))"),
    ]


def _end(writer: Writer) -> sp.Expr | None:
    """The radius at which the profile ends."""
    return next((high for low, high in itertools.pairwise(writer.profile.chain) if low == a), None)


def _growth(writer: Writer) -> list[str]:
    """The lines of g'(a); next to a break at which it is infinite, not the last digits of it."""
    profile, slopes, end = writer.profile, writer.normal, _end(writer)

    def slope(name: str, root: str, at: str = "a") -> str:
        return f"normal.{name}({_with_root(slopes[name], root, at)})"

    if not profile.breaks:
        growth = slope("_slope", "" if end is None else f"difference_root({python(end)}, a)")
        return [f"return np.where(a > 0.0, {growth}, 0.0)"]
    b = str(profile.breaks[0])
    beyond = slope("_slope_beyond", "root")
    root = f"root = np.maximum(difference_root(a, {b}), CLOSEST * {b})"
    if "_slope" not in slopes:
        return [root, f"return np.where(a < {b}, 0.0, {beyond})"]
    return [
        root,
        f"tip = np.minimum(a, {b})",
        f"return np.where(a < {b}, {slope('_slope', 'np.sqrt((R - tip) * (R + tip))', 'tip')}, {beyond})",
    ]


def _opened(writer: Writer) -> list[str]:
    """The lines of it, by what is known of g'."""
    profile, slopes = writer.profile, writer.normal
    tip, end, power = slopes.get("_slope"), _end(writer), exponent(profile)
    body = list[str]()
    if profile.breaks:
        b, parts = str(profile.breaks[0]), []
        if tip is not None:
            slope = f"lambda t: normal._slope({_with_root(tip, 'np.sqrt((R - t) * (R + t))')})"
            singular = "" if profile.pieces[0].expr.is_polynomial(r) else ", R"
            body.append(f"tip, tip_rate = opening_tip({slope}, q, a, {b}{singular})")
            parts.append(("tip", "tip_rate"))
        slope = f"lambda t, root: normal._slope_beyond({', '.join(['t', *slopes['_slope_beyond'][1:]])})"
        body.append(f"beyond, rate = opening_beyond({slope}, q, a, {b})")
        parts.append(("beyond", "rate"))
        body.append(f"return {', '.join(' + '.join(column) for column in zip(*parts, strict=True))}")
        return body
    assert tip is not None
    if end is not None:
        slope = f"lambda t, root: normal._slope({', '.join(['t', *tip[1:]])})"
        return [f"return opening_below({slope}, q, a, {python(end)})"]
    slope = f"lambda t: normal._slope({', '.join(['t', *tip[1:]])})"
    if writer.summed:
        # what does not change along the path stands in front of it
        terms = "terms = [(j - 1, j * depth_over_height(j) * A_j) for j, A_j in enumerate(A, 1)]"
        return [terms, "return opening(lambda t: sum(rate * t**power for power, rate in terms), q, a, ENTIRE)"]
    (depth,) = (case.expr for case in writer.plain[FOUR[0]].cases)
    if depth.is_polynomial(a) or depth.has(sp.Sum, Dawson):
        return [f"return opening({slope}, q, a, {'POLYNOMIAL' if depth.is_polynomial(a) else 'ENTIRE'})"]
    if power is not None:
        return [f"return opening_power({slope}, q, a, {python(power)})"]
    # a root of r**2 + b**2
    (beside,) = (x.base.subs(r, 0) for x in profile.pieces[0].expr.atoms(sp.Pow) if x.exp == sp.S.Half and x.has(r))
    return [f"return opening_beside({slope}, q, a, {python(sp.sqrt(beside))})"]


def _with_root(taken: Sequence[str], root: str, at: str = "t") -> str:
    return ", ".join([at, *(root if name == "root" else name for name in taken[1:])])


def interface(writer: Writer) -> None:
    """Adds the public functions."""
    notes = f"Valid for {writer.profile.validity}. {NOTE}"
    for entry in writer.entries.values():
        checks = writer.checks(entry.parameters)
        if cohesive in entry.arguments:
            checks += not_above("a", ZONE, ORDER)
        writer.add(entry, notes, checks)
    _without_contact(writer)
    _pull_off(writer)
    _inverses(writer)


PULLED = (
    "The least force, or depth, on unloading. At c the gap of the contact without adhesion then changes with c by",
    "4 sigma_0/(pi E_star) (phi^2/cos(phi) + 1 - cos(phi)) under control of the force, cos(phi) = a/c, and by",
    "4 sigma_0/(pi E_star) (1 - cos(phi)) under control of the depth.",
)
"""Where the loads are stationary."""
JUMP = (
    "Coming closer, the attraction begins at the depth -dgamma/sigma_0, where the surfaces jump together if f'(c) < "
    "4 sigma_0/(pi E_star) next to the axis; under control of the depth the states with a larger f'(c) are stable."
)
APART = "the radius is 0 where the depth falls until the surfaces have parted, and go on attracting each other"


def _sources(writer: Writer) -> list[str]:
    return docstring.sources_of(next(iter(writer.entries.values())))


def _symbols(writer: Writer) -> list[sp.Symbol]:
    return [*writer.profile.parameters, E_star, dgamma, sigma_0]


def _without_contact(writer: Writer) -> None:
    """Adds the function of the states in which the surfaces attract each other and do not touch."""
    names = [name_of(symbol) for symbol in _symbols(writer)]
    evaluated = (writer.evaluated(f"_without_contact_{member}", [ZONE], names) for member in ("depth", "force"))
    doc = docstring.document(
        "Depth and force of surfaces that attract each other up to the radius c and do not touch.",
        ["d = f(c) - dgamma/sigma_0 - 4*c*sigma_0/(pi*E_star)", "F = -pi*sigma_0*c**2"],
        docstring.parameters([cohesive], _symbols(writer)),
        ("Separated", f"Named tuple of depth [m] and force [N]; NaN where they would touch. {docstring.SHAPE}"),
        f"Valid for {writer.profile.validity}. {JUMP}",
        _sources(writer),
        [],
    )
    body = [*writer.checks(_symbols(writer)), f"return Separated({', '.join(evaluated)})"]
    writer.public.append(Function("without_contact", [ZONE], names, body, doc, "Separated"))


def _pull_off(writer: Writer) -> None:
    """Adds the function of the state of pull-off."""
    names = [name_of(symbol) for symbol in _symbols(writer)]
    named = ", ".join(f"{name}={name}" for name in names if not (writer.summed and name == "A"))
    first, fixed = ("A=A, ", "partial({}, A=A)") if writer.summed else ("", "{}")
    body = [*writer.checks(_symbols(writer)), "require_control(control)"]
    body.append(f"radius = elementwise(partial(_pull_off_radius, {first}control=control), {named})")
    # by name, as a radius of 0 is a result and not a field that may be missing
    body.append(f"zone = elementwise({fixed.format('_pull_off_zone')}, a=radius, {named})")
    for load, formula in (("force", "_force_of"), ("depth", "_pull_off_depth")):
        body.append(f"{load} = elementwise({fixed.format(formula)}, a=radius, q=zone, {named})")
    doc = docstring.of_state(
        "State at which the contact breaks on unloading.",
        docstring.wrapped(" ".join(PULLED)),
        _symbols(writer),
        ("", f"; {APART}{f'. NaN for states {BEYOND}' if _largest(writer) else ''}"),
        f"{docstring.SEVERAL.strip()} Valid for {writer.profile.validity}.",
        _sources(writer),
        [],
    )
    body.append("return PullOff(radius, force, depth)")
    writer.public.append(Function("pull_off", [], names, body, doc, "PullOff", 'control: str = "force"'))


def _inverses(writer: Writer) -> None:
    """Adds the contact radii on the stable branches."""
    names = [name_of(symbol) for symbol in _symbols(writer)]
    ended = f" and for states {BEYOND}" if _largest(writer) else ""
    for quantity in PHYSICS.searched:
        (field,) = map(name_of, quantity.arguments)
        doc = docstring.document(
            quantity.summary,
            docstring.wrapped(f"a from {field} = {field}(a), where it grows with a."),
            docstring.parameters(quantity.arguments, _symbols(writer)),
            (docstring.NUMBERS, f"Contact radius [m]. {docstring.SHAPE}"),
            f"Valid for {writer.profile.validity}. NaN below pull-off{ended}.",
            _sources(writer),
            [],
        )
        evaluated = writer.evaluated(f"_{quantity.function}", [], names, **{field: field})
        body = [*writer.checks(_symbols(writer)), f"return {evaluated}"]
        writer.public.append(Function(quantity.function, [field], names, body, doc, "Result"))
