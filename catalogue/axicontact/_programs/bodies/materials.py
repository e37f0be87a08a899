"""Bodies of axicontact.materials over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ..._programs.bodies._runtime.functions import gamma
from ..._runtime.plain import MATH as np


def _graded_modulus(E_0, c_0, k, nu):
    return _h_N(k, nu) * E_0 / ((1.0 - nu) * (1.0 + nu) * c_0 ** k)


def _h_N(k, nu):
    beta = np.sqrt((1.0 + k) * (1.0 - nu - k * nu) / (1.0 - nu))
    gammas = gamma((3.0 + k + beta) / 2.0) * gamma((3.0 + k - beta) / 2.0)
    cosine = np.sin(np.pi * (1.0 - np.abs(k)) / 2.0)
    punch = ((1.0 + k) * gamma(1.0 + k / 2.0)) ** 2 * cosine
    return punch / (beta * np.sin(np.pi * beta / 2.0) * gammas)
