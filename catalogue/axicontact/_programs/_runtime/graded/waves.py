"""Programs of axicontact._runtime.graded.waves."""

from __future__ import annotations

from ...._runtime.interface import ordinary
from ...._programs.bodies._runtime.graded import waves as bodies


def steepest_waves(k):
    if k.__class__ is float and k > 1e-30 and (k < 1.0):
        try:
            value = bodies.steepest_waves(k)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(k):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
