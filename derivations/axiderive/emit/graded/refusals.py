"""Complete contacts beside the normal contact: one function, or a module that says why there is none."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...contact.adhesive import hess_rule
from ...contact.medium import GRADED
from ...entry import Entry
from ...notation import H, a, d, dgamma, k
from ...profiles.profile import Profile
from .. import example
from ..physics import text
from ..physics.refusals import REFUSAL
from ..physics.text import Function, name_of
from .module import Writer

REASONS = {
    "tangential": (
        "{title} is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F,"
        " with F from axicontact.graded.normal.{name}.force"
    ),
    "adhesive": (
        "{title} is a complete contact whose edge does not move: adhesion does not change its solution,"
        " use axicontact.graded.normal.{name}; the pull-off of a flat face is"
        " axicontact.graded.adhesive.flat_punch.pull_off"
    ),
}


def module_source(profile: Profile, group: str) -> str:
    """A module whose functions do not exist, and which says why."""
    lines = text.wrapped(REASONS[group].format(title=profile.title, name=profile.name))
    literal = "\n".join(f'    "{line}{" " if line is not lines[-1] else ""}"' for line in lines)
    return REFUSAL.format(title=profile.title, group=group, wrapped="\n".join(lines) + ".", literal=literal)


def punch_source(entries: Mapping[str, Entry]) -> str:
    """The flat punch: it breaks off as a whole, raised by the retraction of its edge."""
    profile = entries["F"].profile
    writer = Writer(profile, entries, "adhesive", entries)
    symbols = [a, H, k, dgamma]
    keywords = [name_of(symbol) for symbol in symbols]
    named = ", ".join(f"{name}={name}" for name in keywords)
    shown, shift = writer.example, hess_rule(GRADED)
    passed = ", ".join(shown.keyword(symbol, shown.known) for symbol in symbols)
    force = entries["F"].cases[0].expr.subs(d, -shift)
    body = [
        *writer.checks(symbols),
        "require_control(control)",
        f"depth = elementwise(_depth, {named})",
        f"force = elementwise(_force, {named})",
        "return PullOff(depth * 0.0 + a, force, depth)",
    ]
    document = [
        *text.wrapped(f"d = {sp.sstr(-shift)}"), *text.wrapped(f"F = {sp.sstr(force)}"), "",
        "Parameters", "----------",
        'control : {"force", "depth"}', "    What is held while the contact is unloaded; the state is the same.",
        *text.parameters(keywords, {}, False),
        "", "Returns", "-------", "PullOff", "    Named tuple of radius [m], force [N] and depth [m].",
        "", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain.",
        "", "Notes", "-----",
        *text.wrapped(f"The force {entries['F'].key} at the depth of the retraction."),
        "", "References", "----------", "chapter 11, equation (11.64); chapter 11, equation (11.66).",
        "", "Examples", "--------", *shown.head(), f">>> state = flat_punch.pull_off({passed})",
        ">>> round(state.force, 6)", example.result(example.number(force, shown.known)),
    ]  # fmt: skip
    writer.public.append(
        Function(
            "pull_off", [], keywords, "State at which the punch breaks off.", document, body,
            returns="PullOff", leading='control: str = "force"',
        )
    )  # fmt: skip
    writer.rule("_depth", [], keywords, ["return -graded_retraction(a, H, k, dgamma)"])
    writer.rule("_force", [], keywords, ["return punch_stiffness(a, H, k) * _depth(a, H, k, dgamma)"])
    return writer.source(f"{profile.title} with adhesion on a power-law graded half space")
