"""Methods that have nothing to run for a quantity, with the reason."""

from __future__ import annotations

from . import bem
from .naive import printed
from .subject import Subject


def skipped(subject: Subject, suffix: str) -> list[dict[str, str]]:
    """One record for each; of a problem that is measured beside a few ways, among these."""
    reasons = (
        _of_few(subject, suffix) if subject.few else _on_grids(subject, suffix) | _boundary_elements(subject, suffix)
    )
    key = f"{subject.name}.{suffix}"
    return [{"key": key, "method": method, "reason": reason} for method, reason in reasons.items()]


def _of_few(subject: Subject, suffix: str) -> dict[str, str]:
    if printed(subject.printed(suffix)):
        return {}
    return {"lambdify": "no closed form in standard functions was found"}


def _on_grids(subject: Subject, suffix: str) -> dict[str, str]:
    if subject.graded:
        closed = {"generated rule": "depth and force are closed: no rule is generated"} if suffix == "Fd" else {}
        return closed | dict.fromkeys(
            ("trapezoid MDR", "FFT MDR"), "their weights are those of the homogeneous half-space"
        )
    if suffix == "ad":
        return {"FFT MDR": "a convolution gives fields, not a(d)"}
    if suffix == "Fd":
        closed = {"generated rule": "depth and force are closed: no rule is generated"}
        return closed | {"FFT MDR": "a convolution gives fields, not F(d)"}
    return {}


def _boundary_elements(subject: Subject, suffix: str) -> dict[str, str]:
    if subject.graded:
        return {"BEM": "its half-space is homogeneous"}
    if suffix != "p":
        return {"BEM": "its pressures are compared"}
    return {"BEM": bem.missing()} if bem.missing() else {}
