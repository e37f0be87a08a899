"""The test that is written beside a module: it runs with plain Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from . import interface
from .check import Value
from .contact import DIGITS

if TYPE_CHECKING:
    from .request import Request

TOLERANCE = 1e-11
"""Relative; the rules of the catalogue are within 1e-13, inverses within 1e-12 of a curve of any steepness."""


def test_text(
    stem: str, request: Request, values: Sequence[Value], errors: Mapping[str, float], free: Mapping[str, float]
) -> str:
    """The test that goes with a module; it runs with plain Python."""
    rule = max([TOLERANCE, *(4.0 * e for e in errors.values() if e > TOLERANCE)])
    keyed = any(v.keywords for v in values)
    rows = [
        f'    ("{v.function}", {v.fields!r}, {f"dict({_passed(v)}), " if keyed else ""}{v.wanted!r}),' for v in values
    ]
    tolerance = repr(float(f"{rule:.1e}"))
    lines = [
        f'"""Values of {stem} from the integrals that define them, {DIGITS} digits; run it with plain Python."""',
        "",
        "import math",
        "",
        f"import {stem}",
        "",
        f"TOLERANCE = {tolerance}",
        "VALUES = [",
        *rows,
        "]",
        "",
        "",
        "def test_values():",
        f"    for name, fields, {'keywords, ' if keyed else ''}wanted in VALUES:",
        f"        got = getattr({stem}, name)(*fields{', **keywords' if keyed else ''})",
        "        assert math.isclose(got, wanted, rel_tol=TOLERANCE), (name, fields, got, wanted)",
    ]
    main = ["test_values()"]
    if interface.PULL_OFF in request.quantities:
        lines += _pull_off_test(stem, request, free)
        main.append("test_pull_off()")
    lines += ["", "", 'if __name__ == "__main__":', *(f"    {call}" for call in main)]
    lines.append('    print(f"{len(VALUES)} values agree")')
    return "\n".join([*lines, ""])


def _passed(value: Value) -> str:
    return ", ".join(f"{name}={number!r}" for name, number in value.keywords)


def _pull_off_test(stem: str, request: Request, free: Mapping[str, float]) -> list[str]:
    passed = f"**{dict(free)!r}" if free else ""
    if not {"force", "depth"} <= set(request.quantities):
        return ["", "", "def test_pull_off():", f"    assert {stem}.pull_off({passed}).radius > 0.0"]
    given = f", {passed}" if free else ""
    return [
        "",
        "",
        "def test_pull_off():",
        '    for control in ("force", "depth"):',
        f"        state = {stem}.pull_off(control{given})",
        f"        values = [getattr({stem}, control)(x * state.radius{given}) for x in (0.999, 1.0, 1.001)]",
        "        assert math.isclose(values[1], getattr(state, control), rel_tol=1e-9)",
        "        assert values[0] > values[1] < values[2] or math.isnan(values[0])",
    ]
