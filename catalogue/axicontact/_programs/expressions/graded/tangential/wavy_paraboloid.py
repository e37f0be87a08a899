"""Formulas of axicontact.graded.tangential.wavy_paraboloid over an array library `xp`."""

from ....._programs.expressions._runtime.graded.growth import power_factor
from ....._programs.expressions._runtime.graded.growth import power_force
from ....._programs.expressions._runtime.graded.pressure import waves_pressure
from ....._programs.expressions._runtime.graded.slip import power_growth
from ....._programs.expressions._runtime.graded.waves import waves_depth
from ....._programs.expressions._runtime.graded.waves import waves_force
from ....._programs.expressions._runtime.graded.waves import waves_rate
from ....._programs.expressions._runtime.integrals import difference_root
from ....._programs.expressions._runtime.physics.slip import gained_share
from ....._programs.expressions._runtime.physics.slip import stick_force
from ....._programs.expressions.graded.normal.wavy_paraboloid import depth as graded_normal_depth
from ....._programs.expressions.graded.normal.wavy_paraboloid import force as graded_normal_force
from ....._programs.expressions.graded.normal.wavy_paraboloid import pressure as graded_normal_pressure
from ....._programs.expressions.graded.normal.wavy_paraboloid import radius_from_force as graded_normal_radius_from_force
from ....._runtime.steps import nodes_along


def tangential_force(xp, a, c, R, h, wavelength, H, k, mu):
    v33, v34 = nodes_along(xp, 4, a, c, R, h, wavelength, H, k, mu)
    v2 = 1.0 + k
    v11 = difference_root(xp, c, 0.0)
    v15 = a > c
    v16 = xp.where(v15, a, 2.0 * c)
    v23 = xp.where(v15, 0.5 * c, a)
    v24 = xp.where(v15, (v16 - c) * (v16 + c) / (v11 + difference_root(xp, v16, 0.0)), 0.0)
    v25 = 6.283185307179586 / wavelength
    v26 = 6.283185307179586 / v25
    v29 = (v11 >= 0.25 * difference_root(xp, a, 0.0)) & (v24 < 256.0 * v26)
    v30 = xp.where(v29, v24, 0.0)
    v31 = xp.minimum(v30, v26)
    v32 = v30 - v31
    v37 = v11 + v31 + v33 * v32
    v40 = xp.sqrt(0.0 + v37 * v37)
    v49 = xp.log1p(v31 / v11)
    v52 = v11 * xp.exp(v33 * v49)
    v55 = xp.sqrt(0.0 + v52 * v52)
    v62 = v52 * (waves_rate(xp, v55, v25, k) * (v55 * v55 ** k) * (v52 / v55))
    v47 = v32 * xp.sum(v34 * (waves_rate(xp, v40, v25, k) * (v40 * v40 ** k) * (v37 / v40)), axis=0)
    v67 = waves_force(xp, a, v25, k) - waves_force(xp, c, v25, k)
    v10 = power_force(xp, a, 2.0, k) * gained_share(xp, c, a, 2.0 + v2) / (2.0 * R)
    v70 = v10 + h * xp.where(v29, v47 + v49 * xp.sum(v34 * v62, axis=0), v67)
    return mu * (2.0 * H / v2) * v70


def traction(xp, r, a, c, R, h, wavelength, H, k, mu):
    v33, v34 = nodes_along(xp, 4, r, a, c, R, h, wavelength, H, k, mu)
    v1 = r < c
    v6 = xp.minimum(xp.where(v1, r, 0.5 * c), c)
    v11 = difference_root(xp, c, v6)
    v15 = a > c
    v16 = xp.where(v15, a, 2.0 * c)
    v23 = xp.where(v15, 0.5 * c, a)
    v24 = xp.where(v15, (v16 - c) * (v16 + c) / (v11 + difference_root(xp, v16, v6)), 0.0)
    v25 = 6.283185307179586 / wavelength
    v26 = 6.283185307179586 / v25
    v29 = (v11 >= 0.25 * difference_root(xp, a, v6)) & (v24 < 256.0 * v26)
    v30 = xp.where(v29, v24, 0.0)
    v31 = xp.minimum(v30, v26)
    v32 = v30 - v31
    v38 = v11 + v31 + v33 * v32
    v41 = xp.sqrt(v6 * v6 + v38 * v38)
    v50 = xp.log1p(v31 / v11)
    v53 = v11 * xp.exp(v33 * v50)
    v57 = xp.sqrt(v6 * v6 + v53 * v53)
    v64 = v53 * (waves_rate(xp, v57, v25, k) * (v53 ** k / v53) * (v53 / v57))
    v48 = v32 * xp.sum(v34 * (waves_rate(xp, v41, v25, k) * (v38 ** k / v38) * (v38 / v41)), axis=0)
    v69 = waves_pressure(xp, v6, a, v25, k) - waves_pressure(xp, v6, c, v25, k)
    v10 = power_factor(xp, 2.0, k) * 2.0 * power_growth(xp, v6, c, a, 2.0, k) / (2.0 * R)
    v72 = v10 + h * xp.where(v29, v48 + v50 * xp.sum(v34 * v64, axis=0), v69)
    v75 = graded_normal_pressure(xp, xp.where(v1, 2.0 * c, r), a, R, h, wavelength, H, k)
    return mu * xp.where(v1, H / 3.141592653589793 * v72, v75)


def tangential_displacement(xp, a, c, R, h, wavelength, H, H_x, k, mu):
    v32, v33 = nodes_along(xp, 4, a, c, R, h, wavelength, H, H_x, k, mu)
    v10 = difference_root(xp, c, 0.0)
    v14 = a > c
    v15 = xp.where(v14, a, 2.0 * c)
    v22 = xp.where(v14, 0.5 * c, a)
    v23 = xp.where(v14, (v15 - c) * (v15 + c) / (v10 + difference_root(xp, v15, 0.0)), 0.0)
    v24 = 6.283185307179586 / wavelength
    v25 = 6.283185307179586 / v24
    v28 = (v10 >= 0.25 * difference_root(xp, a, 0.0)) & (v23 < 256.0 * v25)
    v29 = xp.where(v28, v23, 0.0)
    v30 = xp.minimum(v29, v25)
    v31 = v29 - v30
    v36 = v10 + v30 + v32 * v31
    v39 = xp.sqrt(0.0 + v36 * v36)
    v45 = xp.log1p(v30 / v10)
    v48 = v10 * xp.exp(v32 * v45)
    v51 = xp.sqrt(0.0 + v48 * v48)
    v56 = v45 * xp.sum(v33 * (v48 * (waves_rate(xp, v51, v24, k) * (v48 / v51))), axis=0)
    v57 = v31 * xp.sum(v33 * (waves_rate(xp, v39, v24, k) * (v36 / v39)), axis=0) + v56
    v62 = h * xp.where(v28, v57, waves_depth(xp, a, v24, k) - waves_depth(xp, c, v24, k))
    v63 = power_factor(xp, 2.0, k) * a ** 2.0 * gained_share(xp, c, a, 2.0) / (2.0 * R) + v62
    return mu * (H / H_x) * v63


def stick_radius(xp, F_x, a, R, h, wavelength, H, k, mu):
    v5 = stick_force(xp, graded_normal_force(xp, a, R, h, wavelength, H, k), F_x, mu)
    v6 = graded_normal_radius_from_force(xp, v5, R, h, wavelength, H, k)
    return xp.where((F_x == 0.0) & (a >= 0.0), a, v6)


def full_slip_displacement(xp, a, R, h, wavelength, H, H_x, k, mu):
    return mu * (H / H_x) * graded_normal_depth(xp, a, R, h, wavelength, k)
