"""Rules of superposition in print: what holds for every profile, stated with the functions of its normal contact.

g, F_N, p and w are the rows of the normal contact on the same medium, so that
a rule is read back against every profile it is printed for.
"""

from __future__ import annotations

import sympy as sp

from ..notation import a, a_c, dgamma, r, retraction, u
from ..physics import Rule, adhesive, normal
from ..physics.medium import Medium
from ..physics.systems import System
from ..print.formula import Printer

ADH = r"_{\mathrm{adh}}"
INSIDE, OUTSIDE = r"r\le a", r"r\ge a"


def _adhesive(medium: Medium) -> dict[str, Rule]:
    printer = Printer((r, a))
    force = printer(medium.stiffness() * retraction)
    pressure = printer(medium.punch_pressure() * retraction)
    surface = printer(medium.punch_displacement().expr() * retraction)
    found = {
        "Dl": Rule(rf"\Delta\ell={printer(medium.retraction())}"),
        "d": Rule(rf"d{ADH}(a)=g(a)-\Delta\ell"),
        "F": Rule(rf"F{ADH}(a)=F_{{\mathrm N}}(a)-{force}"),
        "p": Rule(rf"p{ADH}(r)=p(r)-{pressure}", where="r<a"),
        "w": Rule(rf"w{ADH}(r)=w(r)-{surface}", where=OUTSIDE),
        "ad": Rule(rf"d{ADH}(a)=d", r"for $a\ge a_{\mathrm m}$"),
        "aF": Rule(rf"F{ADH}(a)=F_{{\mathrm N}}", r"for $a\ge a_{\mathrm c}$"),
    }
    for control, xi in adhesive.pull_off_number(medium).items():
        radius, force_then, depth_then = (adhesive.QUANTITIES[suffix] for suffix in adhesive.CONTROLS[control])
        level = sp.sqrt(sp.pi * dgamma / (2 * medium.modulus)) * a_c ** (-(1 + medium.k) / 2)
        at = radius.left
        named = Printer(names={a_c: at})
        # the number stays in front of the root
        text = named(xi * level) if xi.free_symbols else (named(xi) if xi != 1 else "") + named(level)
        found |= {
            radius.suffix: Rule(f"g'({at})={text}"),
            force_then.suffix: Rule(f"{force_then.left}=F{ADH}({at})"),
            depth_then.suffix: Rule(f"{depth_then.left}=d{ADH}({at})"),
        }
    return found


def _normal(medium: Medium) -> dict[str, Rule]:
    """The fields as one regular integral each, and the mean pressure, on the graded half-space only; p at its peak."""
    if not medium.graded:
        return {"pp": Rule(r"p_{\mathrm{max}}=p(r_{\mathrm{max}})")}
    k, printer = medium.k, Printer((r, a))
    scale = printer(medium.pressure_scale / (1 + k))
    span = printer((a**2 - r**2) ** ((1 + k) / 2))
    radius = printer(sp.sqrt(r**2 + u ** (2 / (1 + k))))
    outside = printer(medium.displacement_scale)
    return {
        "pm": Rule(r"\bar p=\frac{F_{\mathrm N}(a)}{\pi a^{2}}"),
        "p": Rule(
            rf"p(r)={scale}\int_{{0}}^{{y}} \frac{{g'(t)}}{{t}}\,\mathrm{{d}}u,\qquad t={radius},\quad y={span}",
            where=INSIDE,
        ),
        "w": Rule(
            rf"w(r)={outside}\int_{{0}}^{{y}} \bigl[g(a)-g(r\sin\psi)\bigr]\tan^{{{printer(k)}}}\psi"
            rf"\,\mathrm{{d}}\psi,\qquad y={printer(sp.asin(a / r))}",
            where=OUTSIDE,
        ),
    }


RULES = {normal.PHYSICS: _normal, adhesive.PHYSICS: _adhesive}
"""Rules that are made with more than what prints an expression; those of other physics are stated in their files."""


def rule(system: System, suffix: str) -> Rule | None:
    """The rule behind a quantity of a system; None if the quantity is a formula of the profile itself."""
    own = RULES.get(system.physics)
    found = own(system.medium) if own else system.physics.rules(system.medium, Printer())
    return found.get(suffix)
