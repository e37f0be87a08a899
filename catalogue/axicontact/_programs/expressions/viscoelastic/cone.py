"""Formulas of axicontact.viscoelastic.cone over an array library `xp`."""

from ...._programs.expressions._runtime.physics.relaxation import creep_kelvin_voigt
from ...._programs.expressions._runtime.physics.relaxation import creep_standard_solid
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
from ...._programs.expressions.normal.cone import force_from_depth as normal_force_from_depth
from ...._programs.expressions.normal.cone import radius_from_depth as normal_radius_from_depth
from ...._programs.expressions.normal.cone import radius_from_force as normal_radius_from_force
from ...._runtime.steps import fading


def ramp_force_maxwell(xp, t, v, theta, E, tau):
    v7 = normal_force_from_depth(xp, v * t, theta, 1.0) * (E * fading(xp, t / tau, 2.0))
    return xp.where(t == 0.0, 0.0, v7)


def earlier_time_maxwell(xp, t, v, v_2, t_m, t_h, E, tau):
    return earlier(xp, t, t_m, lag_maxwell(xp, t, t_m, t_h, v_2 / v, E, tau))


def contact_time_maxwell(xp, v, v_2, t_m, t_h, E, tau):
    return end_maxwell(xp, v_2 / v, t_m, t_h, E, tau)


def retract_force_maxwell(xp, t, v, v_2, t_m, t_h, theta, E, tau):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_maxwell(xp, v2, t_m, t_h, v_2 / v, E, tau)
    v6 = earlier(xp, v2, t_m, v5)
    v14 = kept_maxwell(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 2.0, E, tau)
    v15 = normal_force_from_depth(xp, v * v6, theta, 1.0) * v14
    v18 = ramp_force_maxwell(xp, xp.where(v1, 0.5 * t_m, t), v, theta, E, tau)
    return xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), v15, 0.0), v18)


def retract_radius_maxwell(xp, t, v, v_2, t_m, t_h, theta, E, tau):
    v3 = earlier(xp, t, t_m, lag_maxwell(xp, t, t_m, t_h, v_2 / v, E, tau))
    v4 = v3 <= 0.0
    return xp.where(v4, 0.0, normal_radius_from_depth(xp, v * xp.where(v4, 1.0, v3), theta))


def step_force_maxwell(xp, t, d, theta, E, tau):
    return relaxation_maxwell(xp, t, E, tau) * normal_force_from_depth(xp, d, theta, 1.0)


def step_load_radius_maxwell(xp, t, F, theta, E, tau):
    return normal_radius_from_force(xp, F * ((1.0 + t / tau) / E), theta, 1.0)


def ramp_force_kelvin_voigt(xp, t, v, theta, E, eta):
    v7 = normal_force_from_depth(xp, v * t, theta, 1.0) * (E + eta * 2.0 / t)
    return xp.where(t == 0.0, 0.0, v7)


def earlier_time_kelvin_voigt(xp, t, v, v_2, t_m, t_h, E, eta):
    return earlier(xp, t, t_m, lag_kelvin_voigt(xp, t, t_m, t_h, v_2 / v, E, eta))


def contact_time_kelvin_voigt(xp, v, v_2, t_m, t_h, E, eta):
    return end_kelvin_voigt(xp, v_2 / v, t_m, t_h, E, eta)


def retract_force_kelvin_voigt(xp, t, v, v_2, t_m, t_h, theta, E, eta):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v6 = earlier(xp, v2, t_m, lag_kelvin_voigt(xp, v2, t_m, t_h, v_2 / v, E, eta))
    v13 = normal_force_from_depth(xp, v * v6, theta, 1.0) * (E + 0.0 * v6)
    v16 = ramp_force_kelvin_voigt(xp, xp.where(v1, 0.5 * t_m, t), v, theta, E, eta)
    return xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), v13, 0.0), v16)


def retract_radius_kelvin_voigt(xp, t, v, v_2, t_m, t_h, theta, E, eta):
    v3 = earlier(xp, t, t_m, lag_kelvin_voigt(xp, t, t_m, t_h, v_2 / v, E, eta))
    v4 = v3 <= 0.0
    return xp.where(v4, 0.0, normal_radius_from_depth(xp, v * xp.where(v4, 1.0, v3), theta))


def step_force_kelvin_voigt(xp, t, d, theta, E, eta):
    v1 = t > 0.0
    v2 = xp.where(v1, t, 1.0)
    return xp.where(v1, E, xp.inf) * normal_force_from_depth(xp, d, theta, 1.0)


def step_load_radius_kelvin_voigt(xp, t, F, theta, E, eta):
    return normal_radius_from_force(xp, F * creep_kelvin_voigt(xp, t, E, eta), theta, 1.0)


def ramp_force_standard_solid(xp, t, v, theta, E_inf, E_1, tau):
    v4 = ramp_standard_solid(xp, t, 2.0, E_inf, E_1, tau)
    return xp.where(t == 0.0, 0.0, normal_force_from_depth(xp, v * t, theta, 1.0) * v4)


def earlier_time_standard_solid(xp, t, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return earlier(xp, t, t_m, lag_standard_solid(xp, t, t_m, t_h, v_2 / v, E_inf, E_1, tau))


def contact_time_standard_solid(xp, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return end_standard_solid(xp, v_2 / v, t_m, t_h, E_inf, E_1, tau)


def retract_force_standard_solid(xp, t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_standard_solid(xp, v2, t_m, t_h, v_2 / v, E_inf, E_1, tau)
    v6 = earlier(xp, v2, t_m, v5)
    v14 = kept_standard_solid(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 2.0, E_inf, E_1, tau)
    v15 = normal_force_from_depth(xp, v * v6, theta, 1.0) * v14
    v18 = ramp_force_standard_solid(xp, xp.where(v1, 0.5 * t_m, t), v, theta, E_inf, E_1, tau)
    return xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), v15, 0.0), v18)


def retract_radius_standard_solid(xp, t, v, v_2, t_m, t_h, theta, E_inf, E_1, tau):
    v3 = earlier(xp, t, t_m, lag_standard_solid(xp, t, t_m, t_h, v_2 / v, E_inf, E_1, tau))
    v4 = v3 <= 0.0
    return xp.where(v4, 0.0, normal_radius_from_depth(xp, v * xp.where(v4, 1.0, v3), theta))


def step_force_standard_solid(xp, t, d, theta, E_inf, E_1, tau):
    v3 = relaxation_standard_solid(xp, t, E_inf, E_1, tau) * normal_force_from_depth(xp, d, theta, 1.0)
    return v3


def step_load_radius_standard_solid(xp, t, F, theta, E_inf, E_1, tau):
    v3 = normal_radius_from_force(xp, F * creep_standard_solid(xp, t, E_inf, E_1, tau), theta, 1.0)
    return v3


def ramp_force_power_creep(xp, t, v, theta, E, alpha, t_0):
    v5 = normal_force_from_depth(xp, v * t, theta, 1.0) * ramp_power_creep(xp, t, 2.0, E, alpha, t_0)
    return xp.where(t == 0.0, 0.0, v5)


def earlier_time_power_creep(xp, t, v, v_2, t_m, t_h, E, alpha, t_0):
    return earlier(xp, t, t_m, lag_power_creep(xp, t, t_m, t_h, v_2 / v, E, alpha, t_0))


def contact_time_power_creep(xp, v, v_2, t_m, t_h, E, alpha, t_0):
    return end_power_creep(xp, v_2 / v, t_m, t_h, E, alpha, t_0)


def retract_force_power_creep(xp, t, v, v_2, t_m, t_h, theta, E, alpha, t_0):
    v1 = t > t_m
    v2 = xp.where(v1, t, 2.0 * t_m)
    v5 = lag_power_creep(xp, v2, t_m, t_h, v_2 / v, E, alpha, t_0)
    v6 = earlier(xp, v2, t_m, v5)
    v14 = kept_power_creep(xp, v2, v6, xp.maximum(v2 - t_m, 0.0) + v5, 2.0, E, alpha, t_0)
    v15 = normal_force_from_depth(xp, v * v6, theta, 1.0) * v14
    v18 = ramp_force_power_creep(xp, xp.where(v1, 0.5 * t_m, t), v, theta, E, alpha, t_0)
    return xp.where(v1, xp.where((v2 > t_m) & (v6 > 0.0), v15, 0.0), v18)


def retract_radius_power_creep(xp, t, v, v_2, t_m, t_h, theta, E, alpha, t_0):
    v3 = earlier(xp, t, t_m, lag_power_creep(xp, t, t_m, t_h, v_2 / v, E, alpha, t_0))
    v4 = v3 <= 0.0
    return xp.where(v4, 0.0, normal_radius_from_depth(xp, v * xp.where(v4, 1.0, v3), theta))


def step_force_power_creep(xp, t, d, theta, E, alpha, t_0):
    v3 = relaxation_power_creep(xp, t, E, alpha, t_0) * normal_force_from_depth(xp, d, theta, 1.0)
    return v3


def step_load_radius_power_creep(xp, t, F, theta, E, alpha, t_0):
    return normal_radius_from_force(xp, F * ((t / t_0) ** alpha / E), theta, 1.0)
