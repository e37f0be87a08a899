"""Bodies of axicontact._runtime.graded.pressure over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, exp, expm1, fsum, inf, isfinite, pow, sinh

from ....._programs.bodies._runtime.graded.growth import axis_power
from ....._programs.bodies._runtime.graded.rules import nodes_for, raised, sinh_over
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.graded.growth import power_factor
from ....._runtime.graded.single import weighted
from ....._runtime.plain import integral_in_strip
from ....._runtime.plain import rule, MATH as np

_EVEN = 16
_NEAREST = 1e-09
_PANEL = 3.0
RULE_0 = rule(((inf, 64),))


def growth_beyond(slope, r, a, b, k, order=0.0):
    """The integral from max(r, b) on for a profile with a corner at b.

    `slope` takes t and sqrt(t**2 - b**2) and returns g'(t) (sqrt(t**2 - b**2)/t)**(1 - k), which is finite there
    and begins with the power `order` of the root.
    """
    within, scale, reach = _branches(r, a, b, order + 2.0 * k, r - b, a - b)

    def smooth(near, far):
        root = near if within else far
        t = np.hypot(b, root)
        return slope(t, root) * (far / t) ** k
    value = _from_branch(smooth, scale, reach, k) if reach > 0.0 else 0.0
    at = (r == b) & (reach > 0.0)
    return (growth_from_break(slope, reach if at else b, b, k, order) if at else value) if np.any(at) else value


def growth_from_break(slope, reach, b, k, order):
    """The same for r = b, of positive 2 k + `order`, up to the distance `reach`: both branch points are one."""
    above = 2.0 * k + order if 2.0 * k + order > 0.0 else 1.0

    def smooth(near, far):
        root = np.maximum(near, _NEAREST * b)
        return slope(far, root) * far ** (1.0 - k) / root ** order
    return _from_branch(smooth, b, reach, above - 1.0, above)


def _branches(r, a, b, power, near, far):
    """On which side of the break, the distance of the two branch points r and b, and of the edge to the outer one.

    `near` and `far` are r - b and a - b.

    Where r is b as far as b is known the distance is so small that nothing is left of the power of it by which the
    value differs, nor of its square; the next double is as near as 1e-8.
    """
    within = near < 0.0
    reach = np.sqrt(np.maximum(far, 0.0) * (a + b)) if within else difference_root(a, r)
    least = np.minimum(b, reach) * np.exp(-37.0 / np.minimum(np.maximum(power, 0.107), 2.0))
    return (within, least if near == 0.0 else np.sqrt(np.abs(near) * (r + b)), reach)


def _from_branch(smooth, scale, reach, k, above=None):
    """Integral of y**k smooth(y, far) dy/far from y = 0 to `reach`, with far = sqrt(scale**2 + y**2).

    `above` is 1 + k, as in the rule of the weight.
    """
    first, start = _panel(scale, reach, _PANEL)

    def weighed(v):
        return smooth(scale * np.sinh(v), scale * np.cosh(v)) * sinh_over(v) ** k
    near = weighted(weighed, first, k, nodes_for(first), above)
    rest = growth_far(lambda y, far: y ** k * smooth(y, far), start, reach, scale)
    return scale ** k * (raised(first, k) * near) + rest


def _panel(scale, reach, longest):
    v4 = asinh(reach / scale)
    v5 = v4 if v4 < longest or v4 != v4 else longest
    return (v5, scale * sinh(v5) if v5 < v4 else reach)


def growth_far(integrand, start, reach, scale):
    """Integral of integrand(y, far) dy/far from y = start on, in ln y, where both branch points are one.

    Counted from either end up to the middle: in a length that counts decades an error is one of every power of it.
    """
    long = reach > start
    if not np.any(long):
        return np.zeros_like(start)
    half = np.log(np.sqrt(reach) / np.sqrt(start if long else 1.0)) if long else 0.0

    def along(y):
        far = np.hypot(scale, y)
        return integrand(y, far) * (y / far)
    rising = integral_in_strip(lambda x: along(start * np.exp(x)), half)
    return rising + integral_in_strip(lambda x: along(reach * np.exp(-x)), half)


def power_pressure(r, a, n, k):
    """The integral for f = r**n."""
    return power_factor(n, k) * n * (a ** n / a * a ** k) * power_growth(r, a, n, k)


def rim_pressure(r, a, b, k):
    """The integral for f' = r beyond b."""

    def slope(t, root):
        return t * ((1.0 - k) / (1.0 + k) * (root / t) ** 2 + 1.0)
    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def _cornered(value, r, a, b, k):
    if (r == b and a > b) and k <= 0.0:
        return inf
    return value


def power_growth(r, a, n, k):
    """The integral for g'(t) = t**(n - 1), over a**(n + k - 1)."""
    if isinstance(n, int | float) and n % 2.0 == 0.0 and (n <= _EVEN):
        return _even_growth(r, a, int(n), k)
    m = axis_power(n, k)
    length = np.log1p((a - r) / r)
    length = length if np.isfinite(length) else np.log(a) - np.log(r)
    near = np.minimum(np.minimum(length, 1.0), 20.0 / np.maximum(np.abs(m), 1e-300))
    half, above = ((k - 1.0) / 2.0, (k + 1.0) / 2.0)

    def smooth(x):
        shrink = -np.expm1(-2.0 * x) / (x if x > 0.0 else 1.0) if x > 0.0 else 2.0
        return shrink ** half * np.exp(-m * (near - x))
    rest = length - near
    place = np.minimum(r / a * np.exp(near), 1.0)
    far = place ** n / place * place ** k
    first = (far if rest > 0.0 else 1.0) * near ** above
    first = first * weighted(smooth, near, half, above=above)
    total = first + (_steep(rest, near, m, half) if np.abs(m) > 20.0 else _tail(rest, near, m, half, far))
    return total if r > 0.0 else 1.0 / (m if m > 0.0 else 1.0) if m > 0.0 else np.inf


def _even_growth(r, a, n, k):
    """By parts in t**2 - r**2: every step adds what is positive."""
    half, square = ((1.0 + k) / 2.0, (r / a) ** 2)
    total = 0.5 / half
    for j in range(1, n // 2):
        total = (0.5 + j * square * total) / (j + half)
    share = (a - r) / a * ((a + r) / a)
    return np.sqrt(share) * share ** (k / 2.0) * total


def _tail(rest, near, m, half, far):
    v7 = rest if isfinite(rest) else 0.0
    v10 = m - 0.0
    v11 = v10 == 0.0
    if v11:
        v19 = v7
    else:
        v12 = abs(v10)
        v19 = -expm1(-v12 * v7) / (1.0 if v11 else v12)
    v21 = near + v7
    v31 = 0.0 - half
    v33 = m - 2.0
    v34 = v33 == 0.0
    if v34:
        v42 = v7
    else:
        v35 = abs(v33)
        v42 = -expm1(-v35 * v7) / (1.0 if v34 else v35)
    v56 = v31 * (1.0 - half) / 2.0
    v58 = m - 4.0
    v59 = v58 == 0.0
    if v59:
        v67 = v7
    else:
        v60 = abs(v58)
        v67 = -expm1(-v60 * v7) / (1.0 if v59 else v60)
    v82 = v56 * (2.0 - half) / 3.0
    v84 = m - 6.0
    v85 = v84 == 0.0
    if v85:
        v93 = v7
    else:
        v86 = abs(v84)
        v93 = -expm1(-v86 * v7) / (1.0 if v85 else v86)
    v107 = v82 * (3.0 - half) / 4.0
    v109 = m - 8.0
    v110 = v109 == 0.0
    if v110:
        v118 = v7
    else:
        v111 = abs(v109)
        v118 = -expm1(-v111 * v7) / (1.0 if v110 else v111)
    v133 = v107 * (4.0 - half) / 5.0
    v135 = m - 10.0
    v136 = v135 == 0.0
    if v136:
        v144 = v7
    else:
        v137 = abs(v135)
        v144 = -expm1(-v137 * v7) / (1.0 if v136 else v137)
    v158 = v133 * (5.0 - half) / 6.0
    v160 = m - 12.0
    v161 = v160 == 0.0
    if v161:
        v169 = v7
    else:
        v162 = abs(v160)
        v169 = -expm1(-v162 * v7) / (1.0 if v161 else v162)
    v184 = v158 * (6.0 - half) / 7.0
    v186 = m - 14.0
    v187 = v186 == 0.0
    if v187:
        v195 = v7
    else:
        v188 = abs(v186)
        v195 = -expm1(-v188 * v7) / (1.0 if v187 else v188)
    v209 = v184 * (7.0 - half) / 8.0
    v211 = m - 16.0
    v212 = v211 == 0.0
    if v212:
        v220 = v7
    else:
        v213 = abs(v211)
        v220 = -expm1(-v213 * v7) / (1.0 if v212 else v213)
    v235 = v209 * (8.0 - half) / 9.0
    v237 = m - 18.0
    v238 = v237 == 0.0
    if v238:
        v246 = v7
    else:
        v239 = abs(v237)
        v246 = -expm1(-v239 * v7) / (1.0 if v238 else v239)
    v260 = v235 * (9.0 - half) / 10.0
    v262 = m - 20.0
    v263 = v262 == 0.0
    if v263:
        v271 = v7
    else:
        v264 = abs(v262)
        v271 = -expm1(-v264 * v7) / (1.0 if v263 else v264)
    v286 = v260 * (10.0 - half) / 11.0
    v288 = m - 22.0
    v289 = v288 == 0.0
    if v289:
        v297 = v7
    else:
        v290 = abs(v288)
        v297 = -expm1(-v290 * v7) / (1.0 if v289 else v290)
    v311 = v286 * (11.0 - half) / 12.0
    v313 = m - 24.0
    v314 = v313 == 0.0
    if v314:
        v322 = v7
    else:
        v315 = abs(v313)
        v322 = -expm1(-v315 * v7) / (1.0 if v314 else v315)
    v337 = v311 * (12.0 - half) / 13.0
    v339 = m - 26.0
    v340 = v339 == 0.0
    if v340:
        v348 = v7
    else:
        v341 = abs(v339)
        v348 = -expm1(-v341 * v7) / (1.0 if v340 else v341)
    v362 = v337 * (13.0 - half) / 14.0
    v364 = m - 28.0
    v365 = v364 == 0.0
    if v365:
        v373 = v7
    else:
        v366 = abs(v364)
        v373 = -expm1(-v366 * v7) / (1.0 if v365 else v366)
    v388 = v362 * (14.0 - half) / 15.0
    v390 = m - 30.0
    v391 = v390 == 0.0
    if v391:
        v399 = v7
    else:
        v392 = abs(v390)
        v399 = -expm1(-v392 * v7) / (1.0 if v391 else v392)
    v413 = v388 * (15.0 - half) / 16.0
    v415 = m - 32.0
    v416 = v415 == 0.0
    if v416:
        v424 = v7
    else:
        v417 = abs(v415)
        v424 = -expm1(-v417 * v7) / (1.0 if v416 else v417)
    v439 = v413 * (16.0 - half) / 17.0
    v441 = m - 34.0
    v442 = v441 == 0.0
    if v442:
        v450 = v7
    else:
        v443 = abs(v441)
        v450 = -expm1(-v443 * v7) / (1.0 if v442 else v443)
    v464 = v439 * (17.0 - half) / 18.0
    v466 = m - 36.0
    v467 = v466 == 0.0
    if v467:
        v475 = v7
    else:
        v468 = abs(v466)
        v475 = -expm1(-v468 * v7) / (1.0 if v467 else v468)
    v490 = v464 * (18.0 - half) / 19.0
    v492 = m - 38.0
    v493 = v492 == 0.0
    if v493:
        v501 = v7
    else:
        v494 = abs(v492)
        v501 = -expm1(-v494 * v7) / (1.0 if v493 else v494)
    v512 = 0.0 + v19 * (exp(-0.0 * v21) if v10 > 0.0 else exp(-0.0 * near) * far) + v31 * v42 * (exp(-2.0 * v21) if v33 > 0.0 else exp(-2.0 * near) * far) + v56 * v67 * (exp(-4.0 * v21) if v58 > 0.0 else exp(-4.0 * near) * far) + v82 * v93 * (exp(-6.0 * v21) if v84 > 0.0 else exp(-6.0 * near) * far) + v107 * v118 * (exp(-8.0 * v21) if v109 > 0.0 else exp(-8.0 * near) * far) + v133 * v144 * (exp(-10.0 * v21) if v135 > 0.0 else exp(-10.0 * near) * far) + v158 * v169 * (exp(-12.0 * v21) if v160 > 0.0 else exp(-12.0 * near) * far) + v184 * v195 * (exp(-14.0 * v21) if v186 > 0.0 else exp(-14.0 * near) * far) + v209 * v220 * (exp(-16.0 * v21) if v211 > 0.0 else exp(-16.0 * near) * far) + v235 * v246 * (exp(-18.0 * v21) if v237 > 0.0 else exp(-18.0 * near) * far) + v260 * v271 * (exp(-20.0 * v21) if v262 > 0.0 else exp(-20.0 * near) * far) + v286 * v297 * (exp(-22.0 * v21) if v288 > 0.0 else exp(-22.0 * near) * far) + v311 * v322 * (exp(-24.0 * v21) if v313 > 0.0 else exp(-24.0 * near) * far) + v337 * v348 * (exp(-26.0 * v21) if v339 > 0.0 else exp(-26.0 * near) * far) + v362 * v373 * (exp(-28.0 * v21) if v364 > 0.0 else exp(-28.0 * near) * far) + v388 * v399 * (exp(-30.0 * v21) if v390 > 0.0 else exp(-30.0 * near) * far) + v413 * v424 * (exp(-32.0 * v21) if v415 > 0.0 else exp(-32.0 * near) * far) + v439 * v450 * (exp(-34.0 * v21) if v441 > 0.0 else exp(-34.0 * near) * far) + v464 * v475 * (exp(-36.0 * v21) if v466 > 0.0 else exp(-36.0 * near) * far) + v490 * v501 * (exp(-38.0 * v21) if v492 > 0.0 else exp(-38.0 * near) * far)
    v515 = v490 * (19.0 - half) / 20.0
    v517 = m - 40.0
    v518 = v517 == 0.0
    if v518:
        v526 = v7
    else:
        v519 = abs(v517)
        v526 = -expm1(-v519 * v7) / (1.0 if v518 else v519)
    v543 = m - 42.0
    v544 = v543 == 0.0
    if v544:
        v552 = v7
    else:
        v545 = abs(v543)
        v552 = -expm1(-v545 * v7) / (1.0 if v544 else v545)
    return v512 + v515 * v526 * (exp(-40.0 * v21) if v517 > 0.0 else exp(-40.0 * near) * far) + v515 * (20.0 - half) / 21.0 * v552 * (exp(-42.0 * v21) if v543 > 0.0 else exp(-42.0 * near) * far)


def _steep(rest, near, m, half):
    v6 = rest if isfinite(rest) else inf
    v7 = abs(m)
    v11 = 42.0 / (v7 if v7 > 20.0 or v7 != v7 else 20.0)
    v12 = v6 if v6 < v11 or v6 != v6 else v11
    v15 = -m
    v26 = []
    for node, weight in RULE_0(v12 / 1.0):
        v14 = node * v12
        v25 = exp(v15 * v14) * pow(-expm1(-2.0 * (near + (v6 - v14))), half)
        v26.append(weight * v25)
    v26 = fsum(v26) * v12
    return v26
