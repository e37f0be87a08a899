"""Bodies of axicontact.normal.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, pow

from ...._runtime.plain import sqrt


def _depth(a, A):
    v8 = a * a
    return 8.0 * A / 3.0 * (v8 * v8)


def _force(a, A, E_star):
    return 64.0 * E_star * A / 15.0 * pow(a, 5.0)


def _displacement(r, a, A):
    v9 = a * a
    v10 = v9 * v9
    if r > a:
        v17 = a / (r + sqrt((r - a) * (r + a)))
        v19 = v17 * v17
        return 16.0 * A / 9.42477796076938 * v10 * (a / r * (0.8 + v19 * (((((((((-4.320959889429597 * v19 + -106.53004831006083) * v19 + -683.6776777243583) * v19 + -1307.862063615897) * v19 + 1123.6903304493044) * v19 + 6598.931700123421) * v19 + 7450.127483097781) * v19 + 2696.481329529376) * v19 + 0.3809523809520408) / ((((((((-0.06548708381580395 * v19 + 10.743349921788495) * v19 + 655.5477291446655) * v19 + 5580.132341984832) * v19 + 18919.75045798054) * v19 + 30703.596314182465) * v19 + 23803.775464413437) * v19 + 7078.863490014608) * v19 + 1.0))))
    v81 = r * r
    return 8.0 * A / 3.0 * v10 - A * (v81 * v81)


def _radius_from_depth(d, A):
    return sqrt(sqrt(3.0 * d / (8.0 * A)))


def _radius_from_force(F, A, E_star):
    v8 = 15.0 * F / (64.0 * E_star * A)
    v10 = pow(v8, 0.2)
    if v8 > 0.0 and v8 < inf:
        return v10 + v10 * ((v8 / (pow(v10, 5.0) * pow(v10, 0.0)) - 1.0) / 5.0)
    return v10


def _force_from_depth(d, A, E_star):
    return 4.0 * E_star / 5.0 * d * sqrt(sqrt(6.0 * d / A))
