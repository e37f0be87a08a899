"""Bodies of axicontact.viscoelastic.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.physics.relaxation import creep_kelvin_voigt, creep_maxwell, creep_power_creep, creep_standard_solid, left_maxwell, left_power_creep, left_standard_solid, relaxation_kelvin_voigt, relaxation_maxwell, relaxation_power_creep, relaxation_standard_solid
from ...._programs.bodies._runtime.physics.retraction import earlier, end_power_creep, end_standard_solid, lag_kelvin_voigt, lag_maxwell, lag_power_creep, lag_standard_solid, passed
from ...._runtime.physics.single import springs
from ...._runtime.plain import MATH as np


def _pressed_maxwell(t_1, since, v, h, s, E, tau):
    a = normal._radius_from_depth(v * t_1, h, s)

    def left(x):
        pressed = t_1 - normal._depth(x, h, s) / v
        return left_maxwell(np.maximum(pressed, 0.0), since, E, tau)
    return 2.0 * v * springs(left, 0.0 * a, a)


def _ramp_force_maxwell(t, v, h, s, E, tau):
    return _pressed_maxwell(t, 0.0 * t, v, h, s, E, tau)


def _step_force_maxwell(t, d, h, s, E, tau):
    return relaxation_maxwell(t, E, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_maxwell(t, F, h, s, E, tau):
    return normal._radius_from_force(F * creep_maxwell(t, E, tau), h, s, 1.0)


def _retract_radius_maxwell(t, v, v_2, t_m, t_h, h, s, E, tau):
    t_1 = earlier(t, t_m, lag_maxwell(t, t_m, t_h, v_2 / v, E, tau))
    return 0.0 if t_1 <= 0.0 else normal._radius_from_depth(v * t_1, h, s)


def _retract_force_maxwell(t, v, v_2, t_m, t_h, h, s, E, tau):
    lag = lag_maxwell(t, t_m, t_h, v_2 / v, E, tau)
    t_1 = earlier(t, t_m, lag)
    since = passed(t, t_m, lag) if t > t_m else 0.0
    return _pressed_maxwell(t_1, since, v, h, s, E, tau) if t_1 > 0.0 else 0.0


def _ramp_force_kelvin_voigt(t, v, h, s, E, eta):
    return E * normal._force_from_depth(v * t, h, s, 1.0) + 2.0 * v * eta * normal._radius_from_depth(v * t, h, s)


def _step_force_kelvin_voigt(t, d, h, s, E, eta):
    return relaxation_kelvin_voigt(t, E, eta) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_kelvin_voigt(t, F, h, s, E, eta):
    return normal._radius_from_force(F * creep_kelvin_voigt(t, E, eta), h, s, 1.0)


def _retract_radius_kelvin_voigt(t, v, v_2, t_m, t_h, h, s, E, eta):
    t_1 = earlier(t, t_m, lag_kelvin_voigt(t, t_m, t_h, v_2 / v, E, eta))
    return 0.0 if t_1 <= 0.0 else normal._radius_from_depth(v * t_1, h, s)


def _retract_force_kelvin_voigt(t, v, v_2, t_m, t_h, h, s, E, eta):
    lag = lag_kelvin_voigt(t, t_m, t_h, v_2 / v, E, eta)
    t_1 = earlier(t, t_m, lag)
    back = normal._force_from_depth(v * t_1, h, s, 1.0) * E if (t > t_m) & (t_1 > 0.0) else 0.0
    return back if t > t_m else _ramp_force_kelvin_voigt(t, v, h, s, E, eta)


def _pressed_standard_solid(t_1, since, v, h, s, E_inf, E_1, tau):
    a = normal._radius_from_depth(v * t_1, h, s)

    def left(x):
        pressed = t_1 - normal._depth(x, h, s) / v
        return left_standard_solid(np.maximum(pressed, 0.0), since, E_inf, E_1, tau)
    return 2.0 * v * springs(left, 0.0 * a, a)


def _ramp_force_standard_solid(t, v, h, s, E_inf, E_1, tau):
    return _pressed_standard_solid(t, 0.0 * t, v, h, s, E_inf, E_1, tau)


def _step_force_standard_solid(t, d, h, s, E_inf, E_1, tau):
    return relaxation_standard_solid(t, E_inf, E_1, tau) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_standard_solid(t, F, h, s, E_inf, E_1, tau):
    return normal._radius_from_force(F * creep_standard_solid(t, E_inf, E_1, tau), h, s, 1.0)


def _earlier_time_standard_solid(t, v, v_2, t_m, t_h, E_inf, E_1, tau):
    return earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))


def _retract_radius_standard_solid(t, v, v_2, t_m, t_h, h, s, E_inf, E_1, tau):
    t_1 = earlier(t, t_m, lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau))
    return 0.0 if t_1 <= 0.0 else normal._radius_from_depth(v * t_1, h, s)


def _retract_force_standard_solid(t, v, v_2, t_m, t_h, h, s, E_inf, E_1, tau):
    lag = lag_standard_solid(t, t_m, t_h, v_2 / v, E_inf, E_1, tau)
    t_1 = earlier(t, t_m, lag)
    since = passed(t, t_m, lag) if t > t_m else 0.0
    return _pressed_standard_solid(t_1, since, v, h, s, E_inf, E_1, tau) if t_1 > 0.0 else 0.0


def _contact_time_standard_solid(v, v_2, t_m, t_h, E_inf, E_1, tau):
    return end_standard_solid(v_2 / v, t_m, t_h, E_inf, E_1, tau)


def _pressed_power_creep(t_1, since, v, h, s, E, alpha, t_0):
    a = normal._radius_from_depth(v * t_1, h, s)

    def left(x):
        pressed = t_1 - normal._depth(x, h, s) / v
        return left_power_creep(np.maximum(pressed, 0.0), since, E, alpha, t_0)
    return 2.0 * v * springs(left, 0.0 * a, a)


def _ramp_force_power_creep(t, v, h, s, E, alpha, t_0):
    return _pressed_power_creep(t, 0.0 * t, v, h, s, E, alpha, t_0)


def _step_force_power_creep(t, d, h, s, E, alpha, t_0):
    return relaxation_power_creep(t, E, alpha, t_0) * normal._force_from_depth(d, h, s, 1.0)


def _step_load_radius_power_creep(t, F, h, s, E, alpha, t_0):
    return normal._radius_from_force(F * creep_power_creep(t, E, alpha, t_0), h, s, 1.0)


def _retract_radius_power_creep(t, v, v_2, t_m, t_h, h, s, E, alpha, t_0):
    t_1 = earlier(t, t_m, lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0))
    return 0.0 if t_1 <= 0.0 else normal._radius_from_depth(v * t_1, h, s)


def _retract_force_power_creep(t, v, v_2, t_m, t_h, h, s, E, alpha, t_0):
    lag = lag_power_creep(t, t_m, t_h, v_2 / v, E, alpha, t_0)
    t_1 = earlier(t, t_m, lag)
    since = passed(t, t_m, lag) if t > t_m else 0.0
    return _pressed_power_creep(t_1, since, v, h, s, E, alpha, t_0) if t_1 > 0.0 else 0.0


def _contact_time_power_creep(v, v_2, t_m, t_h, E, alpha, t_0):
    return end_power_creep(v_2 / v, t_m, t_h, E, alpha, t_0)
