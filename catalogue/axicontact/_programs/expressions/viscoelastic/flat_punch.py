"""Formulas of axicontact.viscoelastic.flat_punch over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import ramp_power_creep
from ...._programs.expressions._runtime.physics.relaxation import ramp_standard_solid
from ...._programs.expressions._runtime.physics.relaxation import relaxation_maxwell
from ...._programs.expressions._runtime.physics.relaxation import relaxation_power_creep
from ...._programs.expressions._runtime.physics.relaxation import relaxation_standard_solid
from ...._programs.expressions._runtime.physics.retraction import earlier
from ...._programs.expressions._runtime.physics.retraction import end_kelvin_voigt
from ...._programs.expressions._runtime.physics.retraction import end_maxwell
from ...._programs.expressions._runtime.physics.retraction import end_power_creep
from ...._programs.expressions._runtime.physics.retraction import end_standard_solid
from ...._programs.expressions._runtime.physics.retraction import kept_maxwell
from ...._programs.expressions._runtime.physics.retraction import kept_power_creep
from ...._programs.expressions._runtime.physics.retraction import kept_standard_solid
from ...._programs.expressions._runtime.physics.retraction import lag_kelvin_voigt
from ...._programs.expressions._runtime.physics.retraction import lag_maxwell
from ...._programs.expressions._runtime.physics.retraction import lag_power_creep
from ...._programs.expressions._runtime.physics.retraction import lag_standard_solid
from ...._runtime.steps import fading


def ramp_force_maxwell(xp, t, v, a, E, tau):
    return xp.where(t == 0.0, 0.0, 2.0 * (v * t) * a * (E * fading(xp, t / tau, 1.0)))


def earlier_time_maxwell(xp, t, v, v_2, t_m, t_h, E, tau):
    return earlier(xp, t, t_m, lag_maxwell(xp, t, t_m, t_h, v_2 / v, E, tau))


def contact_time_maxwell(xp, v, v_2, t_m, t_h, E, tau):
    return end_maxwell(xp, v_2 / v, t_m, t_h, E, tau)


def retract_force_maxwell(xp, t, v, v_2, t_m, t_h, a, E, tau):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_maxwell(xp, v2, t_m, t_h, v_2 / v, E, tau)
    v6 = earlier(xp, v2, t_m, v5)
    v15 = kept_maxwell(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 1.0, E, tau)
    v17 = xp.where((v2 > t_m) & (v6 > 0.0), 2.0 * (v * v6) * a * v15, 0.0)
    return xp.where(v1, v17, ramp_force_maxwell(xp, xp.where(v1, 0.5 * t_m, t), v, a, E, tau))


def step_force_maxwell(xp, t, d, a, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * (2.0 * d * a)


def ramp_force_kelvin_voigt(xp, t, v, a, E, eta):
    return xp.where(t == 0.0, 2.0 * v * a * eta, 2.0 * (v * t) * a * (E + eta / t))


def earlier_time_kelvin_voigt(xp, t, v, v_2, t_m, t_h, E, eta):
    return earlier(xp, t, t_m, lag_kelvin_voigt(xp, t, t_m, t_h, v_2 / v, E, eta))


def contact_time_kelvin_voigt(xp, v, v_2, t_m, t_h, E, eta):
    return end_kelvin_voigt(xp, v_2 / v, t_m, t_h, E, eta)


def retract_force_kelvin_voigt(xp, t, v, v_2, t_m, t_h, a, E, eta):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v6 = earlier(xp, v2, t_m, lag_kelvin_voigt(xp, v2, t_m, t_h, v_2 / v, E, eta))
    v15 = xp.where((v2 > t_m) & (v6 > 0.0), 2.0 * (v * v6) * a * (E + 0.0 * v6), 0.0)
    v18 = xp.where(v1, v15, ramp_force_kelvin_voigt(xp, xp.where(v1, 0.5 * t_m, t), v, a, E, eta))
    return v18


def step_force_kelvin_voigt(xp, t, d, a, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * (2.0 * d * a)


def ramp_force_standard_solid(xp, t, v, a, E_inf, E_1, tau):
    v6 = 2.0 * (v * t) * a * ramp_standard_solid(xp, t, 1.0, E_inf, E_1, tau)
    return xp.where(t == 0.0, 0.0, v6)


def earlier_time_standard_solid(xp, t, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return earlier(xp, t, t_m, lag_standard_solid(xp, t, t_m, t_h, v_2 / v, E_inf, E_1, tau))


def contact_time_standard_solid(xp, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return end_standard_solid(xp, v_2 / v, t_m, t_h, E_inf, E_1, tau)


def retract_force_standard_solid(xp, t, v, v_2, t_m, t_h, a, E_inf, E_1, tau):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_standard_solid(xp, v2, t_m, t_h, v_2 / v, E_inf, E_1, tau)
    v6 = earlier(xp, v2, t_m, v5)
    v15 = kept_standard_solid(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 1.0, E_inf, E_1, tau)
    v19 = ramp_force_standard_solid(xp, xp.where(v1, 0.5 * t_m, t), v, a, E_inf, E_1, tau)
    v20 = xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), 2.0 * (v * v6) * a * v15, 0.0), v19)
    return v20


def step_force_standard_solid(xp, t, d, a, E_inf, E_1, tau):
    return relaxation_standard_solid(xp, t, E_inf, E_1, tau) * (2.0 * d * a)


def ramp_force_power_creep(xp, t, v, a, E, alpha, t_0):
    v7 = xp.where(t == 0.0, 0.0, 2.0 * (v * t) * a * ramp_power_creep(xp, t, 1.0, E, alpha, t_0))
    return v7


def earlier_time_power_creep(xp, t, v, v_2, t_m, t_h, E, alpha, t_0):
    return earlier(xp, t, t_m, lag_power_creep(xp, t, t_m, t_h, v_2 / v, E, alpha, t_0))


def contact_time_power_creep(xp, v, v_2, t_m, t_h, E, alpha, t_0):
    return end_power_creep(xp, v_2 / v, t_m, t_h, E, alpha, t_0)


def retract_force_power_creep(xp, t, v, v_2, t_m, t_h, a, E, alpha, t_0):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_power_creep(xp, v2, t_m, t_h, v_2 / v, E, alpha, t_0)
    v6 = earlier(xp, v2, t_m, v5)
    v15 = kept_power_creep(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 1.0, E, alpha, t_0)
    v19 = ramp_force_power_creep(xp, xp.where(v1, 0.5 * t_m, t), v, a, E, alpha, t_0)
    v20 = xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), 2.0 * (v * v6) * a * v15, 0.0), v19)
    return v20


def step_force_power_creep(xp, t, d, a, E, alpha, t_0):
    return relaxation_power_creep(xp, t, E, alpha, t_0) * (2.0 * d * a)
