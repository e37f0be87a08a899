"""Modules `axicontact.graded.adhesive.<complete contact>`: the edge stays until it peels off."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ...letters import name_of
from ...notation import H, a, dgamma, k
from .. import example
from ..physics import text
from ..physics.text import Function
from .complete import ORDER, order_of
from .module import Writer

CONTROL = 'control : {"force", "depth"}'


def module_source(entries: Mapping[str, Entry]) -> str:
    """Retraction of the edge, and the state at which it peels off."""
    profile = entries["Dl"].profile
    writer = Writer(profile, entries, entries)
    edge, symbols = [a, H, k, dgamma], [*profile.parameters, H, k, dgamma]
    keywords = [name_of(symbol) for symbol in symbols]
    named = ", ".join(f"{name}={name}" for name in keywords)
    checks = [f"require({named})", *(ORDER if "n" in keywords else [])]
    writer.add(
        entries["Dl"],
        f"Valid for {profile.validity}.",
        [
            f"require({', '.join(f'{name_of(s)}={name_of(s)}' for s in edge)})",
            f"return {writer.evaluated('graded_retraction', [], [name_of(s) for s in edge])}",
        ],
    )
    body = [
        *checks,
        "require_control(control)",
        f"depth = elementwise(_pull_off_depth, {named})",
        f"force = elementwise(_pull_off_force, {named})",
        "return PullOff(depth * 0.0 + a, force, depth)",
    ]
    writer.public.append(
        Function(
            "pull_off", [], keywords, "State at which the edge peels off, and with it the whole face.",
            _document(writer, entries, keywords), body, returns="PullOff", leading='control: str = "force"',
        )
    )  # fmt: skip
    for name, line in _rules(writer, keywords).items():
        writer.rule(name, [], keywords, [line])
    return writer.source(f"{profile.title} with adhesion on a power-law graded half-space")


def _rules(writer: Writer, keywords: list[str]) -> dict[str, str]:
    """The hollow and the retraction add up, in the depth and in the force."""
    moved = "graded_retraction(a, H, k, dgamma)"
    if "h" not in keywords:
        return {
            "_pull_off_depth": f"return -{moved}",
            "_pull_off_force": f"return -punch_stiffness(a, H, k) * {moved}",
        }
    order = order_of(writer.profile)
    hollow = f"h * power_factor({order}, k)"
    share = f"{hollow} * {order} / ({order} + 1.0 + k)"
    return {
        "_pull_off_depth": f"return -{hollow} - {moved}",
        "_pull_off_force": f"return -punch_stiffness(a, H, k) * ({share} + {moved})",
    }


def _document(writer: Writer, entries: Mapping[str, Entry], keywords: list[str]) -> list[str]:
    force, depth, shown = entries["Fc"], entries["dc"], writer.example
    symbols = {name_of(symbol): symbol for symbol in force.parameters}
    passed = ", ".join(shown.keyword(symbols[name], shown.known) for name in keywords)
    note = "A smaller contact needs a greater depth and a greater force, so that the edge does not stop."
    sources = [f"chapter 11, equation {own}" for own in depth.references] + [*writer.profile.sources, "Kendall 1971"]
    return [
        *text.formula(force), *text.formula(depth),
        "", "Parameters", "----------",
        CONTROL, "    What is held while the contact is unloaded; the state is the same.",
        *text.parameters(keywords, symbols, False),
        "", "Returns", "-------", "PullOff", "    Named tuple of radius [m], force [N] and depth [m].",
        "", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain.",
        "", "Notes", "-----", *text.wrapped(f"{note} Handbook: {force.key}, {depth.key}."),
        "", "References", "----------", *text.wrapped("; ".join(dict.fromkeys(sources)) + "."),
        "", "Examples", "--------", *shown.head(), f">>> state = {writer.profile.name}.pull_off({passed})",
        ">>> round(state.force, 6)", example.result(shown.number(force, shown.known)),
    ]  # fmt: skip
