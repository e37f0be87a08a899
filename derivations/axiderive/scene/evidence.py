"""How far the emitted module is from its check values, and the test beside it that says so and runs with plain Python.

The evidence of a scene: certificates, comparisons with the definition, what the module was measured at.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from ..exits import FAILED, CommandError
from ..profiles.profile import Profile
from . import interface
from .contact import DIGITS, Contact
from .fields import GREATEST
from .linker import library
from .linker.module import TEMPLATES
from .reading import Scene
from .references import State, Value, below, detached

if TYPE_CHECKING:
    from ..expression.answer import Answer


LARGEST_ERROR = 1e-6


class RuleError(CommandError, ArithmeticError):
    """The module is off by more than any rule may be."""

    code = FAILED


@dataclass(frozen=True)
class Run:
    """What running a module says."""

    values: list[Value]
    errors: dict[str, float]
    """The worst relative deviation of every function."""
    detached: dict[str, State]
    """The states in which a contact with adhesion breaks, by what is held."""


def measured(text: str, values: Sequence[Value], free: Mapping[str, float], contact: Contact) -> Run:
    """Run the text of a module against its check values.

    Raises
    ------
    RuleError
        If a value is off by more than any rule may be.
    """
    request = contact.request
    space: dict[str, Any] = {"__name__": request.module.removesuffix(".py")}
    exec(compile(text, request.module, "exec"), space)  # text of our own making
    errors: dict[str, float] = {}
    states = _states(space, contact, free, errors) if interface.PULL_OFF in request.quantities else {}
    run = Run([], errors, states)
    for value in values:
        fields = (space[value.of](*value.fields),) if value.of else value.fields
        got, call = space[value.function](*fields, **dict(value.keywords)), f"{value.function}{value.fields}"
        if value.function in GREATEST:
            first, *place = below(contact).greatest(value.function, value.fields[0], got)
            _compare(errors, value.function, call, got.value, first)
            _compare({}, value.function, call, got[1:], tuple(place))
            value = replace(value, wanted=(first, *place))
        else:
            _compare(errors, value.function, call, got, value.wanted)
        run.values.append(value)
    return run


def _compare(errors: dict[str, float], name: str, call: str, got: Any, wanted: Any) -> None:
    pairs = [*zip(got, wanted, strict=True)] if isinstance(wanted, tuple) else [(got, wanted)]
    error = max(0.0 if x == y else abs(x - y) for x, y in pairs) / (max(abs(y) for _, y in pairs) or 1.0)
    if not error <= LARGEST_ERROR:
        message = (
            f"{call} gives {got!r} instead of {wanted!r}; nothing was written: the rules "
            "hold for pieces that are smooth in r, use whole powers in them"
        )
        raise RuleError(message)
    errors[name] = max(errors.get(name, 0.0), error)


def _states(
    space: Mapping[str, Any], contact: Contact, free: Mapping[str, float], errors: dict[str, float]
) -> dict[str, State]:
    """The states of pull-off by the definitions, next to those that the module finds."""
    found = {}
    for control in ("force", "depth"):
        state = space[interface.PULL_OFF](control, **free)
        wanted = detached(contact, control, state.radius) if state.radius > 0.0 else None
        if wanted is not None:
            found[control] = wanted
            for field, got, value in zip(state._fields, state, wanted, strict=True):
                _compare(errors, interface.PULL_OFF, f"pull_off({control!r}).{field}", got, value)
    return found


def stored(request: Scene, profile: Profile, answer: Answer | None) -> Mapping[str, Any]:
    """What the handbook prints beside the formulas: of the catalogue as it is stored, else of the answer."""
    if answer is None:
        kept = library.evidence(request.kind.system.pool.id(profile.name))
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


def record(request: Scene, profile: Profile, answer: Answer | None, run: Run) -> dict[str, Any]:
    """The evidence of a scene."""
    found: dict[str, Any] = {"format": 1, "title": request.title, "profile": profile.name}
    found["pieces"] = [
        {"below": None if p.upper is None else sp.sstr(p.upper), "f": sp.sstr(p.expr)} for p in profile.pieces
    ]
    found["frozen"] = {name: str(value) for name, value in (request.frozen | request.choices).items()}
    if answer is not None:
        found["validity"] = answer.validity.sentence
        found["entries"] = {
            s: {
                "status": answer.status(s),
                "result": [{"for": e.where(c), "is": sp.sstr(c.expr)} for c in e.cases],
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
    found["module against 20-digit quadrature"] = {name: f"{error:.1e}" for name, error in run.errors.items()}
    found["check values"] = [v.record() for v in run.values]
    return found


TOLERANCE = 1e-11
"""Relative; the rules of the catalogue are within 1e-13, inverses within 1e-12 of a curve of any steepness."""


def tolerance(run: Run) -> float:
    """How far values may be from those wanted, relative."""
    return float(f"{max([TOLERANCE, *(4.0 * e for e in run.errors.values() if e > TOLERANCE)]):.1e}")


def test_text(stem: str, run: Run, free: Mapping[str, float], origin: str) -> str:
    """The test that goes with a module; it runs with plain Python.

    It has its own name for the module, whose name may be one that it needs itself, as len or wanted.
    """
    lines = [TEMPLATES["test"].format(stem=stem, origin=origin, digits=DIGITS, rule=tolerance(run))]
    tests, count = list[str](), dict[str, str]()
    if any(isinstance(v.wanted, tuple) for v in run.values):
        tests.append("\n\n" + TEMPLATES["near"])
    for name, searched in (("values", False), ("greatest", True)):
        values = [v for v in run.values if (v.function in GREATEST) == searched]
        if not values:
            continue
        keyed = any(v.keywords for v in values)
        given = [f"dict({_passed(dict(v.keywords))}), " if keyed else "" for v in values]
        wanted = [repr(v.wanted).replace("inf", "math.inf") for v in values]
        rows = (f'("{v.function}", {_fields(v)}, {own}{w})' for v, own, w in zip(values, given, wanted, strict=True))
        lines += [f"{name.upper()} = [", *(f"    {row}," for row in rows), "]"]
        words = {"keywords": "keywords, ", "passed": ", **keywords"} if keyed else {"keywords": "", "passed": ""}
        words["close"] = "near" if any(isinstance(v.wanted, tuple) for v in values) else "math.isclose"
        tests.append("\n\n" + TEMPLATES[f"test_{name}"].format(**words))
        count[name] = f"len({name.upper()})"
    if run.detached:
        rows = (f'"{control}": {state!r}' for control, state in run.detached.items())
        lines += ["PULL_OFF = {  # radius, force and depth", *(f"    {row}," for row in rows), "}"]
        # a depth of zero, next to which the radius is what there is of a length
        least = ", abs_tol=TOLERANCE * wanted[0]" if any(0.0 in state for state in run.detached.values()) else ""
        passed = f", {_passed(free)}" if free else ""
        tests.append("\n\n" + TEMPLATES["test_pull_off"].format(passed=passed, least=least))
        count["pull_off"] = "3 * len(PULL_OFF)"
    calls = [*(f"test_{name}()" for name in count), f'print(f"{{{" + ".join(count.values())}}} values agree")']
    return "\n".join([*lines, *tests, "", "", 'if __name__ == "__main__":', *(f"    {call}" for call in calls), ""])


def _fields(value: Value) -> str:
    return f"(module.{value.of}{value.fields!r},)" if value.of else repr(value.fields)


def _passed(keywords: Mapping[str, float]) -> str:
    return ", ".join(f"{name}={number!r}" for name, number in keywords.items())
