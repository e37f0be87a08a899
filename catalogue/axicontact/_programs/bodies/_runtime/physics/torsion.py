"""Bodies of axicontact._runtime.physics.torsion over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.physics.circle import elliptic
from ....._runtime.plain import integral, integral_in_strip
from ....._runtime.plain import log, sqrt, MATH as np

LEAST = 1e-09
NEAR = 0.14
NODES = 32


def turned(a, c):
    v2 = c / a
    v4 = v2 < 1e-08
    if v4:
        v132 = log(4.0 / v2) - 1.0
    else:
        v11 = 1.0 if v4 else v2
        v15 = v11 if v11 > 1e-09 or v11 != v11 else 1e-09
        v16 = 1.0 + v15
        v18 = 2.0 * v16
        v20 = 2.0 * sqrt(v15)
        v23 = 2.0 + v18 / v16
        v26 = 2.0 * (v18 + 2.0 * v20)
        v27 = v20 + v16
        v29 = 2.0 * sqrt(v20 * v16)
        v32 = v23 + v26 / v27
        v35 = 2.0 * (v26 + v23 * v29)
        v36 = v29 + v27
        v38 = 2.0 * sqrt(v29 * v27)
        v41 = v32 + v35 / v36
        v44 = 2.0 * (v35 + v32 * v38)
        v45 = v38 + v36
        v47 = 2.0 * sqrt(v38 * v36)
        v50 = v41 + v44 / v45
        v53 = 2.0 * (v44 + v41 * v47)
        v54 = v47 + v45
        v56 = 2.0 * sqrt(v47 * v45)
        v59 = v50 + v53 / v54
        v62 = 2.0 * (v53 + v50 * v56)
        v63 = v56 + v54
        v65 = 2.0 * sqrt(v56 * v54)
        v68 = v59 + v62 / v63
        v71 = 2.0 * (v62 + v59 * v65)
        v72 = v65 + v63
        v74 = 2.0 * sqrt(v65 * v63)
        v81 = v74 + v72
        v84 = v81 * v81
        v88 = 2.0 * (0.0 + v15)
        v90 = 1.0 + v88 / v16
        v92 = 2.0 * (v88 + v20)
        v94 = v90 + v92 / v27
        v97 = 2.0 * (v92 + v90 * v29)
        v99 = v94 + v97 / v36
        v102 = 2.0 * (v97 + v94 * v38)
        v104 = v99 + v102 / v45
        v107 = 2.0 * (v102 + v99 * v47)
        v109 = v104 + v107 / v54
        v112 = 2.0 * (v107 + v104 * v56)
        v114 = v109 + v112 / v63
        v117 = 2.0 * (v112 + v109 * v65)
        v132 = 0.7853981633974483 * ((a - c) / a * ((a + c) / a)) * ((2.0 * (v71 + v68 * v74) + (v68 + v71 / v72) * v81) / v84 - (2.0 * (v117 + v114 * v74) + (v114 + v117 / v72) * v81) / v84)
    return a * v132


def slipping_traction(r, a, c):
    """Traction over mu E_star/R: in the zone of stick that of all rings from c to a."""
    inside = r < c
    root = difference_root(c, r if inside else 0.0)
    outer = difference_root(a, r if inside else 0.0)
    stop = np.log1p((a - c) / (c + root) * (1.0 + (a + c) / (outer + root))) if inside else 0.0

    def integrand(v):
        s = c * np.cosh(v) + root * np.sinh(v)
        kc = np.minimum(s / a, 1.0)
        return a / s * elliptic(kc, kc * kc)
    held = r / np.pi * integral_in_strip(integrand, stop)
    return held if inside else 2.0 / np.pi * difference_root(a, np.minimum(r, a))


def slipping_torque(a, c):
    """Torque over mu E_star/R: of the disc that turns, and of the ring, inside and outside of half its area."""
    c = np.maximum(c, LEAST * a)
    length = difference_root(a, c)
    ratio = length / c
    half = np.sqrt(0.5)

    def arm(sine, radius):
        return 0.5 * radius * np.arctan(ratio * sine) + 0.5 * c * length * sine / radius

    def inner(v):
        sine, radius = (np.sinh(v) / ratio, c * np.cosh(v))
        return np.sqrt(1.0 - sine * sine) * sine * arm(sine, radius) * radius / length

    def outer(angle):
        sine, cosine = (np.cos(angle), np.sin(angle))
        return cosine * cosine * sine * arm(sine, np.sqrt(c * c + (length * sine) ** 2))
    stop = np.arcsinh(half * ratio)
    ring = integral_in_strip(inner, stop, NEAR * np.clip(ratio, LEAST, 1.0))
    ring = ring + integral(outer, np.full_like(stop, np.pi / 4.0), NODES)
    return 16.0 / np.pi * (c ** 3 / 3.0 * turned(a, c) + length ** 3 * (ring if a > c else 0.0))
