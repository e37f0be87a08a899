"""Formulas of axicontact.cohesive.polynomial over an array library `xp`."""

from ...._programs.expressions._runtime.integrals import difference_root
from ...._programs.expressions._runtime.physics.cohesive import lift_of_zone
from ...._programs.expressions._runtime.physics.cohesive import pull_of_zone
from ...._programs.expressions._runtime.physics.cohesive import ring_of_zone
from ...._programs.expressions._runtime.physics.cohesive import tension_of_zone
from ...._programs.expressions.normal.polynomial import depth as normal_depth
from ...._programs.expressions.normal.polynomial import displacement as normal_displacement
from ...._programs.expressions.normal.polynomial import force as normal_force
from ...._programs.expressions.normal.polynomial import pressure as normal_pressure
from ...._runtime.functions import depth_over_height
from ...._runtime.steps import newton
from ...._runtime.steps import nodes_along
from ...._runtime.steps import numbered


def work_of_separation(xp, a, c, A, E_star, sigma_0):
    v5, v6 = nodes_along(xp, 1, a, c, E_star, sigma_0)
    v1 = difference_root(xp, c, a)
    v2 = xp.hypot(a, v1)
    v4 = xp.arctan2(v1, a)
    v7 = v5 * v4

    def f5(j, A_j):
        v8 = A_j > 0.0
        v12 = j * depth_over_height(j) * xp.where(v8, A_j, 1.0)
        return xp.where(v8, v12 * (v2 * xp.cos(0.0 + v7)) ** (j - 1.0), 0.0)
    v21 = 0.0 + v7
    v25 = v4 * xp.sum(v6 * (sum([f5(j, A_j) for j, A_j in numbered(A)]) * v21 * xp.sin(v21)), axis=0)
    return sigma_0 * (0.6366197723675814 * v2 * v25 + ring_of_zone(xp, v1, a, E_star, sigma_0))


def zone(xp, a, A, E_star, dgamma, sigma_0):
    v16, v17 = nodes_along(xp, 1, a, E_star, dgamma, sigma_0)
    v1 = dgamma / sigma_0
    v4 = 0.7853981633974483 * v1 * (E_star / sigma_0)
    v5 = 0.8759691969420544 * v4
    v12 = xp.minimum(v5 + xp.hypot(v5, xp.sqrt(2.0 * a) * xp.sqrt(v4)), xp.inf)
    v13 = xp.hypot(a, v12)
    v15 = xp.arctan2(v12, a)
    v18 = v16 * v15

    def f16(j, A_j):
        v19 = A_j > 0.0
        v23 = j * depth_over_height(j) * xp.where(v19, A_j, 1.0)
        return xp.where(v19, v23 * (v13 * xp.cos(0.0 + v18)) ** (j - 1.0), 0.0)
    v32 = 0.0 + v18
    v35 = sum([f16(j, A_j) for j, A_j in numbered(A)]) * v32 * xp.sin(v32)
    v37 = 0.6366197723675814 * v13 * (v15 * xp.sum(v17 * v35, axis=0))
    v38 = sigma_0 / dgamma
    v40 = v37 > 0.0
    v41 = xp.where(v40, v37, 1.0)
    v42 = v41 > 0.0
    v48 = v16 * v15

    def f48(j, A_j):
        v49 = A_j > 0.0
        v53 = j * depth_over_height(j) * xp.where(v49, A_j, 1.0)
        return xp.where(v49, v53 * (v13 * xp.cos(0.0 + v48)) ** (j - 1.0), 0.0)
    v64 = sum([f48(j, A_j) for j, A_j in numbered(A)]) * xp.cos(0.0 + v48)
    v47 = v12 / xp.where(v42, xp.where(v42, v41, 1.0), 1.0) * (v12 / v13)
    v68 = xp.where(v40, v47 * (0.6366197723675814 * (v15 * xp.sum(v17 * v64, axis=0))), 1.0)
    v70 = 1.0 + a / v13
    v72 = 0.5 * (v68 + v70)
    v79 = (v37 * v38) ** (v72 / v68) + (ring_of_zone(xp, v12, a, E_star, sigma_0) * v38) ** (v72 / v70)

    def f85(v84):
        v85 = xp.hypot(a, v84)
        v87 = xp.arctan2(v84, a)
        v88 = v16 * v87

        def f90(j, A_j):
            v89 = A_j > 0.0
            v93 = j * depth_over_height(j) * xp.where(v89, A_j, 1.0)
            return xp.where(v89, v93 * (v85 * xp.cos(0.0 + v88)) ** (j - 1.0), 0.0)
        v102 = 0.0 + v88
        v105 = sum([f90(j, A_j) for j, A_j in numbered(A)]) * v102 * xp.sin(v102)
        v109 = 1.2732395447351628 * (sigma_0 / E_star)
        v112 = v84 / (v85 + a)
        v115 = 0.6366197723675814 * v85 * (v87 * xp.sum(v17 * v105, axis=0)) + v109 * v84 * (v87 - v112)
        v116 = v84 / v85
        v118 = v16 * v87

        def f122(j, A_j):
            v119 = A_j > 0.0
            v123 = j * depth_over_height(j) * xp.where(v119, A_j, 1.0)
            return xp.where(v119, v123 * (v85 * xp.cos(0.0 + v118)) ** (j - 1.0), 0.0)
        v134 = sum([f122(j, A_j) for j, A_j in numbered(A)]) * xp.cos(0.0 + v118)
        v136 = 0.6366197723675814 * (v87 * xp.sum(v17 * v134, axis=0))
        return (v115, v84 * v116 * (v136 + v109 * (v87 / v116 - v116 * v112)) / v115)
    v144 = newton(xp, f85, v1, xp.minimum(v12 * v79 ** (-1.0 / v72), xp.inf), xp.inf, 0.5, 4.0)
    return v144


def cohesive_radius(xp, a, A, E_star, dgamma, sigma_0):
    return xp.hypot(a, zone(xp, a, A, E_star, dgamma, sigma_0))


def depth_of(xp, a, q, A, E_star, dgamma, sigma_0):
    return normal_depth(xp, a, A) - 2.0 * (sigma_0 / E_star) * q


def depth(xp, a, A, E_star, dgamma, sigma_0):
    return depth_of(xp, a, zone(xp, a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def force(xp, a, A, E_star, dgamma, sigma_0):
    v3 = pull_of_zone(xp, zone(xp, a, A, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_force(xp, a, A, E_star) - v3


def pressure(xp, r, a, A, E_star, dgamma, sigma_0):
    v3 = tension_of_zone(xp, r, zone(xp, a, A, E_star, dgamma, sigma_0), a, sigma_0)
    return normal_pressure(xp, r, a, A, E_star) - v3


def displacement(xp, r, a, A, E_star, dgamma, sigma_0):
    v3 = lift_of_zone(xp, r, zone(xp, a, A, E_star, dgamma, sigma_0), a, E_star, sigma_0)
    return normal_displacement(xp, r, a, A) - v3
