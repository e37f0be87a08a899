"""The special functions of the printed formulas as a first script has them, from SciPy."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from scipy import integrate, special

Array = Any


@np.vectorize(otypes=[float])
def _c0(b: float, r: float, a: float) -> float:
    """The master integral C0 has no function of SciPy: its definition by quad."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what its estimate warns of is what the study measures
        value, _ = integrate.quad(lambda t: np.arccos(b / t) / np.sqrt(t * t - r * r), max(b, r), a)
    return float(value)


def _chi2(x: Array) -> Array:
    return (special.spence(1 - x) - special.spence(1 + x)) / 2


def _arctan_integral(x: Array) -> Array:
    """Ti2(x), the imaginary part of the dilogarithm of ix."""
    return special.spence(1 - 1j * x).imag


def _beta(z: Array, p: Array, q: Array) -> Array:
    return z**p / p * special.hyp2f1(p, 1 - q, p + 1, z)


def _cap_moment(k: float, b: float, R: float, a: Array) -> Array:
    """For a < R; the difference of an antiderivative between the tip and the break."""
    gap, power = (R - a) * (R + a), (k + 1) / 2

    def primitive(v: Array) -> Array:
        return v**power / (k + 1) / np.sqrt(gap) * special.hyp2f1(0.5, power, power + 1, -v / gap)

    return primitive(a * a) - primitive((a - b) * (a + b))


FUNCTIONS: dict[str, Any] = {
    "C0": _c0,
    "LegendreChi2": _chi2,
    "ArctanIntegral": _arctan_integral,
    "IncompleteBeta": _beta,
    "Dawson": special.dawsn,
    "StruveH": special.struve,
    "elliptic_f": special.ellipkinc,
    "elliptic_e": special.ellipeinc,
    "Hypergeometric": special.hyp2f1,
    "Kummer": special.hyp1f1,
    "CapMoment": _cap_moment,
    "gamma": special.gamma,
}
"""By the names that SymPy prints."""
