"""Adhesive complete contact: the edge peels where the edge term of the pressure reaches that of the retraction."""

from __future__ import annotations

import sympy as sp

from ...entry import Entry
from ...notation import C, a, d
from ..algebra.domain import NotProvedError
from ..algebra.functions import sign
from ..statement import Rule, require_regions, require_zero, retraction
from .complete import Complete


class Detachment:
    """The adhesive entries of one profile, above the complete contact without adhesion."""

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


RULES: dict[str, Rule] = {
    "Dl": ((), retraction),
    "dc": ((), Detachment.depth),
    "Fc": (("dc", "plain.F"), Detachment.force),
}
