"""Formulas of axicontact.graded.normal.wavy_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.displacement import power_displacement
from ....._programs.expressions._runtime.graded.displacement import waves_displacement
from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.growth import power_rate
from ....._programs.expressions._runtime.graded.pressure import power_pressure
from ....._programs.expressions._runtime.graded.pressure import waves_pressure
from ....._programs.expressions._runtime.graded.punch import punch_depth
from ....._programs.expressions._runtime.graded.punch import punch_force
from ....._programs.expressions._runtime.graded.punch import punch_stiffness
from ....._programs.expressions._runtime.graded.waves import waves_depth
from ....._programs.expressions._runtime.graded.waves import waves_force
from ....._programs.expressions._runtime.graded.waves import waves_rate
from ....._programs.expressions.normal.wavy_paraboloid import profile
from ....._runtime.steps import newton


def depth(xp, a, R, h, wavelength, k):
    v8 = h * waves_depth(xp, a, 6.283185307179586 / wavelength, k)
    return power_factor(xp, 2.0, k) * a ** 2.0 / (2.0 * R) + v8


def force(xp, a, R, h, wavelength, H, k):
    v9 = h * waves_force(xp, a, 6.283185307179586 / wavelength, k)
    return 2.0 * H / (1.0 + k) * (power_force(xp, a, 2.0, k) / (2.0 * R) + v9)


def pressure(xp, r, a, R, h, wavelength, H, k):
    v1 = r < a
    v4 = xp.minimum(xp.where(v1, r, 0.5 * a), a)
    v10 = h * waves_pressure(xp, v4, a, 6.283185307179586 / wavelength, k)
    v13 = xp.where(v1, 2.0 * a, r)
    v12 = H / 3.141592653589793 * (power_pressure(xp, v4, a, 2.0, k) / (2.0 * R) + v10)
    return xp.where(v1, v12, 0.0)


def displacement(xp, r, a, R, h, wavelength, k):
    v6 = h * waves_displacement(xp, r, a, 6.283185307179586 / wavelength, k)
    return power_displacement(xp, r, a, 2.0, k) / (2.0 * R) + v6


def rate(xp, a, R, h, wavelength, k):
    v6 = h * waves_rate(xp, a, 6.283185307179586 / wavelength, k)
    return power_rate(xp, a, 2.0, k) / (2.0 * R) + v6


def stiffness(xp, a, H, k):
    return punch_stiffness(xp, a, H, k)


def mean_pressure(xp, a, R, h, wavelength, H, k):
    v1 = a > 0.0
    v2 = xp.where(v1, a, 1.0)
    v7 = xp.where(v1, force(xp, v2, R, h, wavelength, H, k) / (3.141592653589793 * v2 * v2), 0.0)
    return v7


def radius_from_depth(xp, d, R, h, wavelength, k):

    def f3(v4):
        v5 = depth(xp, v4, R, h, wavelength, k)
        return (v5, v4 * rate(xp, v4, R, h, wavelength, k) / v5)
    return newton(xp, f3, d + 0.0, 1.5 * wavelength + 0.0, xp.inf, 1e-06, xp.inf)


def radius_from_force(xp, F, R, h, wavelength, H, k):

    def f3(v4):
        v5 = force(xp, v4, R, h, wavelength, H, k)
        return (v5, v4 * (punch_stiffness(xp, v4, H, k) * rate(xp, v4, R, h, wavelength, k)) / v5)
    return newton(xp, f3, F + 0.0, 1.5 * wavelength + 0.0, xp.inf, 1e-06, xp.inf)


def force_from_depth(xp, d, R, h, wavelength, H, k):
    v1 = radius_from_depth(xp, d, R, h, wavelength, k)
    v5 = punch_force(xp, d - depth(xp, v1, R, h, wavelength, k), v1, H, k)
    return force(xp, v1, R, h, wavelength, H, k) + v5


def depth_from_force(xp, F, R, h, wavelength, H, k):
    v1 = radius_from_force(xp, F, R, h, wavelength, H, k)
    v5 = punch_depth(xp, F - force(xp, v1, R, h, wavelength, H, k), v1, H, k)
    return depth(xp, v1, R, h, wavelength, k) + v5
