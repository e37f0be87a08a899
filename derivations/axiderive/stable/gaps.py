"""What vanishes like the cube of a root, through the exact difference of its two lengths.

The root of x**2 - y**2 is rounded twice, its quotient by y once more, and a cube takes all of that up three times:
6 units of the last place next to x = y.  With q = (x - y)/y the gap is q sqrt(q) times a smooth function of q.
An angle atanh(y/x) takes half the time as log1p(2 y/(x - y))/2, without the root; what it exceeds its tangent by goes
with the cube of that, which is y/x.
"""

from __future__ import annotations

import sympy as sp

from .forms import EvaluationForm
from .opaque import ArctanGap, Log1p, Root, RootGap


def of_lengths(form: EvaluationForm) -> EvaluationForm:
    """The form with gaps, cubes and hyperbolic angles of its roots taken from their lengths."""
    value = form.value
    for name, root in form.steps:
        if isinstance(root, Root):
            x, y = root.args
            value = value.xreplace({ArctanGap(name / y): RootGap(x, y), name**3: name * (x**2 - y**2)})
    return angles_of_lengths(EvaluationForm(form.steps, value, form.cancels))


def angles_of_lengths(form: EvaluationForm) -> EvaluationForm:
    """The form with the hyperbolic angles alone taken from lengths, and without the roots that nothing else needs."""
    steps, value = form.steps, form.value
    for root, lengths in form.steps:
        if isinstance(lengths, Root):
            x, y = lengths.args
            angle, by_lengths = sp.asinh(y / root), Log1p(2 * y / (x - y)) / 2
            tangents = {sp.tanh(name): y / x for name, expr in steps if expr == angle}
            steps = tuple((name, expr.xreplace({angle: by_lengths})) for name, expr in steps)
            value = value.xreplace(tangents)
    used = value.free_symbols.union(*(expr.free_symbols for _, expr in steps))
    return EvaluationForm(tuple(step for step in steps if step[0] in used), value, form.cancels)
