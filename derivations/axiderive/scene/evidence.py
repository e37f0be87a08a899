"""The evidence of a scene: certificates, comparisons with the definition, what the module was measured at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import sympy as sp

from ..profiles.profile import Profile
from . import interface, sources
from .check import Value
from .request import Request

if TYPE_CHECKING:
    from ..expression.answer import Answer


def stored(request: Request, profile: Profile, answer: Answer | None) -> Mapping[str, Any]:
    """What the handbook prints beside the formulas: of the catalogue as it is stored, else of the answer."""
    if answer is None:
        kept = sources.evidence(interface.id_of(request.physics, profile.name))
        return kept["evidence"] if kept else {}
    return {"entries": {suffix: _found(answer, suffix) for suffix in answer.entries}}


def _found(answer: Answer, suffix: str) -> dict[str, Any]:
    """Certificate and comparisons of one entry as the handbook prints them."""
    from ..expression.answer import DIGITS

    proof = answer.certificates.get(suffix)
    rows = [c for c in answer.comparisons if c.suffix == suffix]
    worst = max((c.residual for c in rows), default=0.0)
    check = {"compared": "quadrature", "outcome": "passed", "digits": DIGITS, "count": len(rows)}
    return {
        "certified": bool(proof and proof.proved),
        "certificate": {"reason": proof.reason if proof else ""},
        "checks": [{**check, "worst": f"{worst:.1e}"}] if rows and worst < 10.0**-DIGITS else [],
    }


def record(
    request: Request,
    profile: Profile,
    answer: Answer | None,
    frozen: Mapping[str, float],
    values: Sequence[Value],
    errors: Mapping[str, float],
) -> dict[str, Any]:
    """The evidence of a scene."""
    found: dict[str, Any] = {"format": 1, "title": request.title, "profile": profile.name}
    found["pieces"] = [
        {"below": None if p.upper is None else sp.sstr(p.upper), "f": sp.sstr(p.expr)} for p in profile.pieces
    ]
    found["frozen"] = {name: repr(value) for name, value in frozen.items()}
    if answer is not None:
        found["validity"] = answer.validity.sentence
        found["entries"] = {
            s: {
                "status": answer.status(s),
                "result": [{"for": " < ".join(map(sp.sstr, c.chain)), "is": sp.sstr(c.expr)} for c in e.cases],
                **(
                    {"certificate": {"proved": cert.proved, "steps": list(cert.steps), "reason": cert.reason}}
                    if (cert := answer.certificates.get(s))
                    else {}
                ),
            }
            for s, e in answer.entries.items()
        }
        found["compared with the definition"] = [
            {"formula": c.suffix, "at": c.at, "residual": f"{c.residual:.1e}"} for c in answer.comparisons
        ]
    else:
        found["evidence"] = stored(request, profile, answer)
    found["module against 20-digit quadrature"] = {name: f"{error:.1e}" for name, error in errors.items()}
    found["check values"] = [v.record() for v in values]
    return found
