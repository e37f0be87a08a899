"""Bodies of axicontact.cohesive.power_law over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cosh, exp, expm1, fsum, hypot, inf, isfinite, pow, sinh

from ...._programs.bodies.normal import power_law as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.power_law import partial
from ...._runtime.plain import log, log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_1 = rule(((16.0, 64), (inf, 128)))


def _opened(q, a, A, n):
    v4 = hypot(a, q)
    v6 = a > 0.0
    v12 = asinh(q / (a if v6 else 1.0) if v6 else inf)
    v16 = 40.0 / (n if n < 1.2 or n != n else 1.2)
    v18 = asinh(v12 if v12 < v16 or v12 != v12 else v16)
    v30 = n / 2.0 + 0.5
    v32 = v30 + 1.75
    v36 = (v30 + 0.5) * (v30 + 1.5)
    v49 = 1.0 / (v32 * v32)
    v91 = 1.7724538509055159 * n * A * ((v30 * (v30 + 1.0) / v36 if v30 < 1.0 else 1.0 - (v30 + 0.75) / v36) * sqrt(v32) * (1.0 + v49 * (((((((0.01524698625788054 * v49 + 0.5334320651111477) * v49 + 2.250488865813539) * v49 + 2.8612106440066865) * v49 + 1.3794681629043655) * v49 + 0.2596058532893223) * v49 + 0.015624999999999823) / ((((((3.278794792785737 * v49 + 49.328555418276075) * v49 + 167.28648538571198) * v49 + 195.37226190335065) * v49 + 90.69722535867314) * v49 + 16.763212110504565) * v49 + 1.0))))
    v103 = []
    v104 = []
    if abs(v18) > 0.0:
        for node, weight in RULE_0(v18 / 1.0):
            v19 = node * v18
            v20 = sinh(v19)
            v21 = sinh(v20)
            v22 = cosh(v20)
            v23 = v4 / v22
            v97 = v91 * pow(v23, n) / v23 / v22 * cosh(v19)
            v101 = v97 * atan(v21) * (v21 / v22)
            v102 = v97 / v22
            v103.append(weight * v101)
            v104.append(weight * v102)
    v103 = fsum(v103) * v18
    v104 = fsum(v104) * v18
    return (0.6366197723675814 * v4 * v103, 0.6366197723675814 * v104)


def _zone(a, A, n, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A, n=n), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, A, n, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, A, n, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, A, n, E_star, dgamma, sigma_0):
    v10 = n / 2.0 + 0.5
    v12 = v10 + 1.75
    v16 = (v10 + 0.5) * (v10 + 1.5)
    v30 = 1.0 / (v12 * v12)
    return 1.7724538509055159 * A * pow(a, n) * ((v10 * (v10 + 1.0) / v16 if v10 < 1.0 else 1.0 - (v10 + 0.75) / v16) * sqrt(v12) * (1.0 + v30 * (((((((0.01524698625788054 * v30 + 0.5334320651111477) * v30 + 2.250488865813539) * v30 + 2.8612106440066865) * v30 + 1.3794681629043655) * v30 + 0.2596058532893223) * v30 + 0.015624999999999823) / ((((((3.278794792785737 * v30 + 49.328555418276075) * v30 + 167.28648538571198) * v30 + 195.37226190335065) * v30 + 90.69722535867314) * v30 + 16.763212110504565) * v30 + 1.0)))) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, A, n, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)


def _force_of(a, q, A, n, E_star, dgamma, sigma_0):
    v10 = n / 2.0 + 0.5
    v12 = v10 + 1.75
    v16 = (v10 + 0.5) * (v10 + 1.5)
    v30 = 1.0 / (v12 * v12)
    v82 = hypot(a, q)
    return 3.5449077018110318 * E_star * n * A / (n + 1.0) * a * pow(a, n) * ((v10 * (v10 + 1.0) / v16 if v10 < 1.0 else 1.0 - (v10 + 0.75) / v16) * sqrt(v12) * (1.0 + v30 * (((((((0.01524698625788054 * v30 + 0.5334320651111477) * v30 + 2.250488865813539) * v30 + 2.8612106440066865) * v30 + 1.3794681629043655) * v30 + 0.2596058532893223) * v30 + 0.015624999999999823) / ((((((3.278794792785737 * v30 + 49.328555418276075) * v30 + 167.28648538571198) * v30 + 195.37226190335065) * v30 + 90.69722535867314) * v30 + 16.763212110504565) * v30 + 1.0)))) - 2.0 * sigma_0 * (v82 * v82 * atan2(q, a) + a * q)


def _force(a, A, n, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, A, n, E_star, dgamma, sigma_0):
    v96 = a - r
    v144 = r < a
    if v144:
        v11 = n / 2.0 + 0.5
        v13 = v11 + 1.75
        v17 = (v11 + 0.5) * (v11 + 1.5)
        v31 = 1.0 / (v13 * v13)
        v81 = n - 1.0
        v85 = n > 1.0
        v86 = abs(v81)
        if r > 0.0:
            v97 = v96 / r
            v103 = log1p(v97) if isfinite(v97) else log(a) - log(r)
            if v103 > 0.0:
                v108 = v103 - 42.0 / (v86 if v86 > 0.001 or v86 != v86 else 0.001)
                v109 = v108 if v108 > 0.0 or v108 != v108 else 0.0
                v110 = sqrt(v103)
                v115 = v110 - sqrt(v109) if v85 else sqrt(v103 - v109)
                v118 = 2.0 * v110
                v123 = -v86
                v138 = []
                for node, weight in RULE_1(v115 / 1.0):
                    v117 = node * v115
                    if v85:
                        v126 = v110 - v117
                        v128 = v126 if v126 > 0.0 or v126 != v126 else 0.0
                    else:
                        v128 = v117
                    v137 = exp(v123 * (v117 * (v118 - v117) if v85 else v117 * v117)) * (2.0 * v128 / sqrt(-expm1(-2.0 * v128 * v128)))
                    v138.append(weight * v137)
                v138 = fsum(v138) * v115
                v139 = v138
            else:
                v139 = 0.0
            v141 = (1.0 if v85 else pow(r / a, n) * (a / r)) * v139
        else:
            v141 = 1.0 / v86 if v85 else inf
        v145 = E_star * n * A / 1.7724538509055159 * (pow(a, n) / a if a > 0.0 else pow(a, v81)) * v141 * ((v11 * (v11 + 1.0) / v17 if v11 < 1.0 else 1.0 - (v11 + 0.75) / v17) * sqrt(v13) * (1.0 + v31 * (((((((0.01524698625788054 * v31 + 0.5334320651111477) * v31 + 2.250488865813539) * v31 + 2.8612106440066865) * v31 + 1.3794681629043655) * v31 + 0.2596058532893223) * v31 + 0.015624999999999823) / ((((((3.278794792785737 * v31 + 49.328555418276075) * v31 + 167.28648538571198) * v31 + 195.37226190335065) * v31 + 90.69722535867314) * v31 + 16.763212110504565) * v31 + 1.0))))
    else:
        v145 = 0.0
    return v145 - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v96 if v96 > 0.0 or v96 != v96 else 0.0) * (a + r))) if v144 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, A, n, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, A, n, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, A, n) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, A, n, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, A, n, E_star, dgamma, sigma_0), A, n, E_star, dgamma, sigma_0)


def _growth(a, A, n):
    if a > 0.0:
        v11 = n / 2.0 + 0.5
        v13 = v11 + 1.75
        v17 = (v11 + 0.5) * (v11 + 1.5)
        v31 = 1.0 / (v13 * v13)
        return 1.7724538509055159 * n * A * ((v11 * (v11 + 1.0) / v17 if v11 < 1.0 else 1.0 - (v11 + 0.75) / v17) * sqrt(v13) * (1.0 + v31 * (((((((0.01524698625788054 * v31 + 0.5334320651111477) * v31 + 2.250488865813539) * v31 + 2.8612106440066865) * v31 + 1.3794681629043655) * v31 + 0.2596058532893223) * v31 + 0.015624999999999823) / ((((((3.278794792785737 * v31 + 49.328555418276075) * v31 + 167.28648538571198) * v31 + 195.37226190335065) * v31 + 90.69722535867314) * v31 + 16.763212110504565) * v31 + 1.0)))) * pow(a, n) / a
    return 0.0


def _radii(A, n, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, A=A, n=n), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, A, n, E_star, dgamma, sigma_0, control):
    growth = _growth(a, A, n)
    return state_near(partial(_opened, A=A, n=n), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(A, n, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, A, n, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, A, n, E_star, dgamma, sigma_0), _radii(A, n, E_star, dgamma, sigma_0))


def _parted(A, n, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), A, n, E_star, dgamma, sigma_0)
    return parted(partial(_opened, A=A, n=n), first, E_star, sigma_0)


def _pull_off_zone(a, A, n, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, A=A, n=n), a, E_star, dgamma, sigma_0), lambda: _parted(A, n, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, A, n, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, A, n, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, A=A, n=n), q, E_star, dgamma, sigma_0))


def _held_apart(d, A, n, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(A, n, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, A=A, n=n), _parted(A, n, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, A, n, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, A, n, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, A, n, E_star, dgamma, sigma_0), d, _radii(A, n, E_star, dgamma, sigma_0))
    return _held_apart(d, A, n, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, A, n, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, A, n, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, A, n, E_star, dgamma, sigma_0), F, _radii(A, n, E_star, dgamma, sigma_0))
