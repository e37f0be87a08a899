"""Adhesive contact: the contact without adhesion less a flat punch moved by the retraction D.

The retraction follows from the energy 2 pi a dgamma = c_N(a) D^2 of a moving
edge, hence dD/da = (1 - k) D/(2 a), and D stands for dgamma wherever the force
or the depth is stationary: what is shown there is rational in D.  A fixed edge peels
where the edge term of the pressure reaches that of the retraction.
"""

from __future__ import annotations

import sympy as sp

from ...abel.form import Chain
from ...entry import Case, Entry
from ...notation import C, F, a, a_c, d, dgamma, n
from ...physics.adhesive import CONTROLS
from ..algebra.domain import Domain, NotProvedError, require
from ..algebra.functions import normal, require_analytic, sign
from ..statement import Rule, closed, paired, require_regions, require_zero, retraction
from .compact import Compact
from .complete import Complete

PUNCH = {
    "d": lambda medium: sp.S.One,
    "F": lambda medium: medium.stiffness(),
    "p": lambda medium: medium.punch_pressure(),
    "w": lambda medium: medium.punch_displacement().expr(),
}
STABLE = {"ad": ("d", d), "aF": ("F", F)}
"""What an inverse inverts, and its symbol."""
SHARE = sp.Symbol("s_c", positive=True)
"""Retraction over the retraction at which the load is stationary; below 1 on the stable branch."""


class Adhesive:
    """The adhesive entries of one profile, above those of the contact without adhesion."""

    def __init__(self, normal: Compact, entries: dict[str, Entry]) -> None:
        self.normal, self.entries, self.medium = normal, entries, normal.medium

    def superposed(self, suffix: str) -> list[str]:
        """d, F, p or w is that of the contact without adhesion less Dl times the one of a flat punch of unit depth."""
        entry, plain, steps = self.entries[suffix], self.normal.entries[suffix], retraction(self)
        (shift,) = self.entries["Dl"].cases
        unit = PUNCH[suffix](self.medium)
        for case, own in paired(entry, plain):
            domain = self.normal.domain(case.chain)
            # integrals that both sides share are numbers here
            shared = {integral: sp.Dummy("integral") for integral in own.expr.atoms(sp.Integral)}
            gap = (case.expr - own.expr).xreplace(shared) + unit * shift.expr
            steps.append(require_zero(gap, domain, f"{suffix} = {plain.key} - flat punch of unit depth times Dl"))
        return steps

    def stable_radius(self, suffix: str) -> list[str]:
        """The radius on the stable branch, where the retraction is less than that of the stationary force or depth.

        The work of separation is written as the share s^2, 0 < s < 1, of the one that a contact of radius a can carry.
        """
        source, value = STABLE[suffix]
        require_regions(closed(self.entries[suffix]), ((),))
        ((regime, level),) = self.stationary({"F": "force", "d": "depth"}[source])
        ((inverse,), (forward,)) = self.entries[suffix].cases, self.entries[source].cases
        domain = Domain(*self.normal.domain(regime.chain).chains(), (SHARE, 1))
        work = SHARE**2 * self.medium.modulus * a**self.medium.k * level**2 / (2 * sp.pi * a)
        given = sp.expand_mul(
            sp.powdenest(sp.expand_power_base(forward.expr.subs(dgamma, work), force=True), force=True)
        )
        found = inverse.expr.subs({value: given, dgamma: work}, simultaneous=True)
        require(sign(level, domain) > 0, "{} is not shown to be the stable branch", self.entries[suffix].key)
        statement = f"{suffix}({source}(a)) = a for 2 pi a dgamma = s^2 c_N(a) Dl_c^2, s < 1"
        return [*retraction(self), require_zero(found - a, domain, statement)]

    # pull-off

    def stationary(self, control: str) -> list[tuple[Case, sp.Expr]]:
        """The retraction at which the force, or the depth, does not change with a, for every regime."""
        suffix = {"force": "F", "depth": "d"}[control]
        unit, k = PUNCH[suffix](self.medium), self.medium.k
        growth = sp.diff(unit, a) + unit * (1 - k) / (2 * a)
        return [(case, sp.diff(case.expr, a) / growth) for case in self.normal.entry(suffix).cases]

    def radius(self, control: str) -> list[str]:
        """The radius of pull-off, closed or by its equation, is where the force, or the depth, is stationary."""
        name = CONTROLS[control][0]
        entry, regimes = self.entries[name], self.stationary(control)
        if entry.status == "closed":
            require_regions(entry, ((),))
            (case,), ((regime, level),) = entry.cases, regimes
            return self._closed_radius(case, regime, level, control)
        steps = retraction(self)
        (shift,) = self.entries["Dl"].cases
        own = {_moved(regime.chain): (regime, level) for regime, level in regimes}
        require_regions(entry, tuple(own))
        for case in entry.cases:
            regime, level = own[case.chain]
            domain = self.normal.domain(regime.chain)
            sides = case.expr.subs(a_c, a)
            require_analytic(sides.lhs, domain)
            equation = sides.lhs - sides.rhs
            weight = self._number(control) / (2 * a)
            gap = equation - weight * (level - shift.expr)
            steps.append(require_zero(gap, domain, f"the equation is that of a stationary {control}"))
        return steps

    def _number(self, control: str) -> sp.Expr:
        """2 a/D times the slope of the reduced retraction: 3 + k and 1 - k."""
        k = self.medium.k
        return {"force": 3 + k, "depth": 1 - k}[control]

    def _closed_radius(self, case: Case, regime: Case, level: sp.Expr, control: str) -> list[str]:
        domain, k = self._steep(regime.chain), self.medium.k
        rise = normal(a * sp.diff(level, a) / level, domain) - (1 - k) / 2
        require(sign(level, domain) > 0 and sign(rise, domain) > 0, "the {} is not shown to have a minimum", control)
        require(sign(case.expr, domain) > 0, "{} is not shown to be positive", case.expr)
        balance = self.medium.modulus * a**self.medium.k * level**2 - 2 * sp.pi * a * dgamma
        statement = f"with the retraction at which the {control} is stationary, c_N(a) Dl^2 = 2 pi a dgamma at a = a_c"
        least = f"the {control} falls before and grows after: a d/da log(D/Dl) = {rise} > 0"
        return [*retraction(self), least, require_zero(balance.subs(a, case.expr), domain, statement)]

    def _steep(self, chain: Chain) -> Domain:
        """Where a power law has a pull-off: n > (1 - k)/2, so that a^((1+k)/2) g'(a) grows with a."""
        domain = self.normal.domain(chain)
        return Domain(*domain.chains(), ((1 - self.medium.k) / 2, n)) if n in self.normal.profile.parameters else domain

    def at_pull_off(self, control: str, suffix: str) -> list[str]:
        """Force or depth at pull-off: the adhesive entry with the retraction eliminated by the condition."""
        radius, force, depth = CONTROLS[control]
        entry = self.entries[force if suffix == "F" else depth]
        steps, unit = self.radius(control), PUNCH[suffix](self.medium)
        for case, (regime, level) in zip(entry.cases, self.stationary(control), strict=True):
            domain = self._steep(regime.chain)
            (plain,) = (own for own in self.normal.entry(suffix).cases if own.chain == regime.chain)
            reduced = plain.expr - unit * level
            if case.chain:
                require(
                    case.chain == _moved(regime.chain), "the cases of {} are not the regimes of the contact", entry.key
                )
                gap = case.expr.subs(a_c, a) - reduced
            else:
                (closed,) = self.entries[radius].cases
                gap = case.expr - reduced.subs(a, closed.expr)
            statement = f"{entry.suffix} = {suffix} at {radius}, with the retraction of a stationary {control}"
            steps.append(require_zero(gap, domain, statement))
        return steps


class Detachment:
    """Those of a profile with a fixed edge, above the complete contact without adhesion."""

    def __init__(self, normal: Complete, entries: dict[str, Entry]) -> None:
        self.normal, self.entries, self.medium = normal, entries, normal.medium

    def _expr(self, suffix: str) -> sp.Expr:
        require_regions(self.entries[suffix], ((a,),))
        return self.entries[suffix].cases[0].expr

    def depth(self) -> list[str]:
        """w1D(a) = -Dl, and a smaller radius needs a greater depth."""
        domain, shift = self.normal.domain((a,)), self._expr("Dl")
        edge = self.normal.gap.subs(C, self.normal.coefficient).subs(d, self._expr("dc"))
        steps = [*self.normal.face(), *retraction(self)]
        steps.append(require_zero(edge + shift, domain, "w1D(a) = d - g(a) = -Dl"))
        # for a fixed face: C is no function of a
        depth = d - self.normal.gap
        if depth != 0 and sign(sp.diff(depth, a), domain) >= 0:
            message = "the depth of a smaller contact is not shown to be greater"
            raise NotProvedError(message)
        return [*steps, "g(a) - Dl(a) falls with a: an edge that peels does not stop"]

    def force(self) -> list[str]:
        """Fc is the force of complete contact at the depth dc."""
        (case,) = self.normal.entries["F"].cases
        gap = self._expr("Fc") - case.expr.subs(d, self._expr("dc"))
        return [*self.depth(), require_zero(gap, self.normal.domain((a,)), "Fc = F at dc")]


def _moved(chain: Chain) -> Chain:
    """The radius at pull-off for that of the contact."""
    return tuple(length.subs(a, a_c) for length in chain)


def _pull_off_rules() -> dict[str, Rule]:
    rules: dict[str, Rule] = {}
    for control, (radius, force, depth) in CONTROLS.items():
        base = "plain.F" if control == "force" else "plain.d"
        rules[radius] = ((base,), Adhesive.radius, control)
        rules[force] = (("F", base), Adhesive.at_pull_off, control, "F")
        rules[depth] = (("d", base), Adhesive.at_pull_off, control, "d")
    return rules


RULES: dict[str, Rule] = {
    "Dl": ((), retraction),
    **{suffix: ((f"plain.{suffix}",), Adhesive.superposed, suffix) for suffix in PUNCH},
    **{suffix: ((source,), Adhesive.stable_radius, suffix) for suffix, (source, _) in STABLE.items()},
    **_pull_off_rules(),
}
PEELING: dict[str, Rule] = {
    "Dl": ((), retraction),
    "dc": ((), Detachment.depth),
    "Fc": (("dc", "plain.F"), Detachment.force),
}
