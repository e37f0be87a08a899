"""Adhesive complete contact, on either half-space: the edge stays until it peels off, and only pull-off is left."""

from __future__ import annotations

from ...letters import name_of
from ...notation import a, dgamma, h
from ...physics import complete
from ...stable.forms import evaluation_form
from ...stable.signs import facts_of
from .. import docstring
from ..function import Function
from ..graded.complete import order_of, required_face
from ..text import python
from ..writer import Writer, required
from . import separation

CONTROL = 'control: str = "force"'


def interface(writer: Writer) -> None:
    """Adds the retraction of the edge, and the state at which it peels off."""
    medium, profile, entry = writer.system.medium, writer.profile, writer.entries["Dl"]
    edge = [a, *medium.moduli, dgamma]
    moved = "graded_retraction" if medium.graded else "hess_retraction"
    evaluated = writer.evaluated(moved, [], [name_of(symbol) for symbol in edge])
    writer.add(entry, f"Valid for {profile.validity}.", [required(edge)], evaluated)
    symbols = [*profile.parameters, *medium.moduli, dgamma]
    named = ", ".join(f"{name_of(symbol)}={name_of(symbol)}" for symbol in symbols)
    body = [
        *(required_face(symbols) if medium.graded else writer.checks(symbols)),
        "require_control(control)",
        f"depth = elementwise(_pull_off_depth, {named})",
        f"force = elementwise(_pull_off_force, {named})",
        "return PullOff(depth * 0.0 + a, force, depth)",
    ]
    force, depth = writer.entries["Fc"], writer.entries["dc"]
    note = "A smaller contact needs a greater depth and a greater force, so that the edge does not stop."
    doc = docstring.of_state(
        "State at which the edge peels off, and with it the whole face.",
        [*docstring.stated(force), *docstring.stated(depth)],
        symbols,
        ("; the state is the same", ""),
        f"{note} Handbook: {force.key}, {depth.key}.",
        [*docstring.sources_of(depth), "Kendall 1971"],
        writer.example.state("Fc"),
    )
    writer.public.append(Function("pull_off", [], [name_of(s) for s in symbols], body, doc, "PullOff", CONTROL))
    separation.interface(writer)


def rules(writer: Writer) -> None:
    """Adds the depth and the force at which the edge peels off."""
    medium = writer.system.medium
    needs = [name_of(symbol) for symbol in (*writer.profile.parameters, *medium.moduli, dgamma)]
    for name, lines in (_graded(writer) if medium.graded else _homogeneous(writer)).items():
        writer.rule(name, [], needs, lines)
    separation.rules(writer)


def _homogeneous(writer: Writer) -> dict[str, list[str]]:
    form = evaluation_form(complete.edge_depth(writer.profile), facts_of((a,)))
    level = "" if form.value == 0 else f"{python(form.value)} "
    moved = f"{level}-{' ' if level else ''}hess_retraction(a, E_star, dgamma)"
    # at a depth where the normal contact without adhesion is not complete, so that its force is not at hand
    force = evaluation_form(writer.entries["Fc"].cases[0].expr, facts_of((a,)))
    return {
        "_pull_off_depth": [*(f"{name} = {python(expr)}" for name, expr in form.steps), f"return {moved}"],
        "_pull_off_force": [
            *(f"{name} = {python(expr)}" for name, expr in force.steps), f"return {python(force.value)}",
        ],
    }  # fmt: skip


def _graded(writer: Writer) -> dict[str, list[str]]:
    """The hollow and the retraction add up, in the depth and in the force."""
    moved = "graded_retraction(a, H, k, dgamma)"
    if h not in writer.profile.parameters:
        return {
            "_pull_off_depth": [f"return -{moved}"],
            "_pull_off_force": [f"return -punch_stiffness(a, H, k) * {moved}"],
        }
    order = order_of(writer.profile)
    hollow = f"h * power_factor({order}, k)"
    share = f"{hollow} * {order} / ({order} + 1.0 + k)"
    return {
        "_pull_off_depth": [f"return -{hollow} - {moved}"],
        "_pull_off_force": [f"return -punch_stiffness(a, H, k) * ({share} + {moved})"],
    }
