"""Bodies of axicontact.viscoelastic.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import quartic as normal
from ...._programs.bodies._runtime.physics.relaxation import ramp_maxwell, ramp_power_creep, ramp_standard_solid
from ...._programs.bodies._runtime.physics.retraction import earlier, end_power_creep, end_standard_solid, kept_maxwell, kept_power_creep, kept_standard_solid, lag_maxwell, lag_power_creep, lag_standard_solid, passed


def _ramp_force_maxwell(t, v, A, E, tau):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_maxwell(t, 1.25, E, tau)
    return 0.0 if t == 0.0 else force


def _retract_force_maxwell(t, v, v_2, t_m, t_h, A, E, tau):
    lag = lag_maxwell(t, t_m, t_h, v_2 / v, E, tau)
    t_1 = earlier(t, t_m, lag)
    kept = kept_maxwell(t, t_1, passed(t, t_m, lag), 1.25, E, tau)
    back = normal._force_from_depth(v * t_1, A, 1.0) * kept if (t > t_m) & (t_1 > 0.0) else 0.0
    return back if t > t_m else _ramp_force_maxwell(t, v, A, E, tau)


def _ramp_force_standard_solid(t, v, A, E_inf, E_1, tau):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_standard_solid(t, 1.25, E_inf, E_1, tau)
    return 0.0 if t == 0.0 else force


def _earlier_time_standard_solid(t, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))


def _retract_radius_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
    t_1 = earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))
    return 0.0 if t_1 <= 0.0 else normal._radius_from_depth(v * t_1, A)


def _retract_force_standard_solid(t, v, v_2, t_m, t_h, A, E_inf, E_1, tau):
    lag = lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau)
    t_1 = earlier(t, t_m, lag)
    kept = kept_standard_solid(t, t_1, passed(t, t_m, lag), 1.25, E_inf, E_1, tau)
    back = normal._force_from_depth(v * t_1, A, 1.0) * kept if (t > t_m) & (t_1 > 0.0) else 0.0
    return back if t > t_m else _ramp_force_standard_solid(t, v, A, E_inf, E_1, tau)


def _contact_time_standard_solid(v, v_2, t_m, t_h, E_inf, E_1, tau):
    return end_standard_solid(v_2 / v, t_m, t_h, E_inf, E_1, tau)


def _ramp_force_power_creep(t, v, A, E, alpha, t_0):
    force = normal._force_from_depth(v * t, A, 1.0) * ramp_power_creep(t, 1.25, E, alpha, t_0)
    return 0.0 if t == 0.0 else force


def _retract_force_power_creep(t, v, v_2, t_m, t_h, A, E, alpha, t_0):
    lag = lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0)
    t_1 = earlier(t, t_m, lag)
    kept = kept_power_creep(t, t_1, passed(t, t_m, lag), 1.25, E, alpha, t_0)
    back = normal._force_from_depth(v * t_1, A, 1.0) * kept if (t > t_m) & (t_1 > 0.0) else 0.0
    return back if t > t_m else _ramp_force_power_creep(t, v, A, E, alpha, t_0)


def _contact_time_power_creep(v, v_2, t_m, t_h, E, alpha, t_0):
    return end_power_creep(v_2 / v, t_m, t_h, E, alpha, t_0)
