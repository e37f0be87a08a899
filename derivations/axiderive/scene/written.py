"""The test that is written beside a module: it runs with plain Python."""

from __future__ import annotations

from collections.abc import Mapping

from .check import Value
from .contact import DIGITS
from .measured import Run

TOLERANCE = 1e-11
"""Relative; the rules of the catalogue are within 1e-13, inverses within 1e-12 of a curve of any steepness."""


def test_text(stem: str, run: Run, free: Mapping[str, float], origin: str) -> str:
    """The test that goes with a module; it runs with plain Python."""
    values = run.values
    rule = max([TOLERANCE, *(4.0 * e for e in run.errors.values() if e > TOLERANCE)])
    keyed = any(v.keywords for v in values)
    rows = [
        f'    ("{v.function}", {v.fields!r}, {f"dict({_passed(v)}), " if keyed else ""}{v.wanted!r}),' for v in values
    ]
    lines = [
        f'"""Values of {stem} from {origin}, {DIGITS} digits; run it with plain Python."""',
        "",
        "import math",
        "",
        # the name of the module may be one that the test needs itself, as len or wanted
        f"import {stem} as module",
        "",
        f"TOLERANCE = {float(f'{rule:.1e}')!r}",
        *(["VALUES = [", *rows, "]"] if rows else []),
        *(["PULL_OFF = {  # radius, force and depth", *_states(run), "}"] if run.detached else []),
    ]
    calls, count = [], []
    if rows:
        calls, count = ["test_values()"], ["len(VALUES)"]
        lines += [
            "",
            "",
            "def test_values():",
            f"    for name, fields, {'keywords, ' if keyed else ''}wanted in VALUES:",
            f"        got = getattr(module, name)(*fields{', **keywords' if keyed else ''})",
            "        assert math.isclose(got, wanted, rel_tol=TOLERANCE), (name, fields, got, wanted)",
        ]
    if run.detached:
        calls.append("test_pull_off()")
        count.append("3 * len(PULL_OFF)")
        # a depth of zero, next to which the radius is what there is of a length
        least = ", abs_tol=TOLERANCE * wanted[0]" if any(0.0 in state for state in run.detached.values()) else ""
        passed = "".join(f", {name}={number!r}" for name, number in free.items())
        lines += [
            "",
            "",
            "def test_pull_off():",
            "    for control, wanted in PULL_OFF.items():",
            f"        state = module.pull_off(control{passed})",
            "        for got, value in zip(state, wanted):",
            f"            assert math.isclose(got, value, rel_tol=TOLERANCE{least}), (control, state, wanted)",
        ]
    lines += ["", "", 'if __name__ == "__main__":', *(f"    {call}" for call in calls)]
    return "\n".join([*lines, f'    print(f"{{{" + ".join(count)}}} values agree")', ""])


def _states(run: Run) -> list[str]:
    return [f'    "{control}": {state!r},' for control, state in run.detached.items()]


def _passed(value: Value) -> str:
    return ", ".join(f"{name}={number!r}" for name, number in value.keywords)
