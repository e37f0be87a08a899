"""Bodies of axicontact.normal.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import lower_power, nth_root
from ...._programs.bodies._runtime.shapes.powers import power_pressure
from ...._programs.bodies._runtime.special import gamma_ratio
from ...._runtime.plain import MATH as np


def _slope(t, A, n):
    """Rate g'(t) of the indentation depth g(t)."""
    return np.sqrt(np.pi) * n * A * gamma_ratio(n / 2 + 1 / 2) * t ** n / t


def _depth(a, A, n):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return np.sqrt(np.pi) * A * a ** n * kappa


def _force(a, A, n, E_star):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    return 2 * np.sqrt(np.pi) * E_star * n * A / (n + 1) * a * a ** n * kappa


def _pressure(r, a, A, n, E_star):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    pressed = E_star * n * A / np.sqrt(np.pi) * lower_power(a, n) * power_pressure(r, a, n) * kappa
    return pressed if r < a else 0.0


def _radius_from_depth(d, A, n):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = d / (np.sqrt(np.pi) * A * kappa)
    return nth_root(ratio, n)


def _radius_from_force(F, A, n, E_star):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = (n + 1) * F / (2 * np.sqrt(np.pi) * E_star * n * A * kappa)
    return nth_root(ratio, n, 1)


def _force_from_depth(d, A, n, E_star):
    kappa = gamma_ratio(n / 2 + 1 / 2)
    ratio = d / (np.sqrt(np.pi) * A * kappa)
    return 2 * np.sqrt(np.pi) * E_star * n * A / (n + 1) * kappa * ratio * nth_root(ratio, n)
