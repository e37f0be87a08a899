"""Quantities of the plane problem: names of functions, labels and field arguments."""

from __future__ import annotations

from .. import notation as nt
from ..entry import Quantity

PLANE = {
    q.suffix: q
    for q in (
        Quantity("P", "load", "Line load", nt.P, (nt.a,)),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.x, nt.a)),
        Quantity("s", "slope", "Slope outside", nt.slope, (nt.x, nt.a)),
        Quantity("d", "depth", "Depth relative to a point at distance L", nt.d, (nt.L, nt.a)),
        Quantity("aP", "half_width_from_load", "Half-width of the contact from the load", nt.a, (nt.P,)),
    )
}

PLANE_COMPLETE = {
    q.suffix: q
    for q in (
        Quantity("p", "pressure", "Pressure", nt.p, (nt.x, nt.P)),
        Quantity("s", "slope", "Slope outside", nt.slope, (nt.x, nt.P)),
        Quantity("d", "depth", "Depth of the middle relative to a point at distance L", nt.d, (nt.L, nt.P)),
        Quantity("xz", "zero_distance", "Place of first zero pressure", nt.x_zero, ()),
        Quantity("Pmin", "minimum_load", "Least line load of complete contact", nt.P, ()),
    )
}

PLANE_ECCENTRIC = {
    q.suffix: q
    for q in (
        Quantity("p", "pressure", "Pressure", nt.p, (nt.x, nt.P)),
        Quantity("phi", "tilt", "Inclination of the punch", nt.tilt, (nt.P,)),
        Quantity("cw", "contact_width", "Width of the contact", nt.width, ()),
    )
}
