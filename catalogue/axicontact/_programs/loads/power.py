"""Programs of axicontact.loads.power."""

from __future__ import annotations

from ..._runtime.interface import ordinary
from ..._programs.bodies.loads import power as bodies


def displacement(r, a, p_0, s, E_star):
    if r.__class__ is a.__class__ is p_0.__class__ is s.__class__ is E_star.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (p_0 > 1e-30) and (p_0 < 1e+30) and (s > 1e-30) and (s < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30):
        try:
            value = bodies._displacement(r, a, p_0, s, E_star)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, p_0, s, E_star):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None
