"""Quantities of the plane problem: names of functions, labels and field arguments."""

from __future__ import annotations

from dataclasses import replace

from .. import notation as nt
from ..entry import Quantity

PLANE = {
    q.suffix: q
    for q in (
        Quantity("P", "load", "Line load", nt.P, (nt.a,), summary="Line load at half-width a."),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.x, nt.a), written="p(x)", place="inside", parity="even",
                 summary="Contact pressure, positive in compression; zero outside the contact."),
        Quantity("s", "slope", "Slope outside", nt.slope, (nt.x, nt.a), written=r"\frac{\mathrm{d}w}{\mathrm{d}x}",
                 place="outside", parity="odd", summary="Slope dw/dx of the surface, inside and outside the contact."),
        Quantity("d", "depth", "Depth relative to a point at distance L", nt.d, (nt.L, nt.a),
                 summary="Indentation depth relative to the surface at the distance L."),
        Quantity("aP", "half_width_from_load", "Half-width of the contact from the load", nt.a, (nt.P,), inverts="P",
                 solves="P(a)=P", row="Half-width from load",
                 summary="Half-width of the contact under the line load P."),
    )
}  # fmt: skip

PLANE_COMPLETE = {
    q.suffix: q
    for q in (
        replace(PLANE["p"], arguments=(nt.x, nt.P)),
        replace(PLANE["s"], arguments=(nt.x, nt.P)),
        replace(
            PLANE["d"], label="Depth of the middle relative to a point at distance L", row=PLANE["d"].label,
            arguments=(nt.L, nt.P),
        ),
        Quantity("xz", "zero_distance", "Place of first zero pressure", nt.x_zero, (), threshold=True,
                 written="x_{0}", row="Zero pressure",
                 summary="Distance from the middle where the pressure first vanishes on unloading."),
        Quantity("Pmin", "minimum_load", "Least line load of complete contact", nt.P, (), threshold=True,
                 written=r"P_{\mathrm{min}}", summary="Least line load of complete contact."),
    )
}  # fmt: skip

PLANE_ECCENTRIC = {
    q.suffix: q
    for q in (
        PLANE_COMPLETE["p"],
        Quantity("phi", "tilt", "Inclination of the punch", nt.tilt, (nt.P,),
                 summary="Inclination of the punch under an eccentric load."),
        Quantity("cw", "contact_width", "Width of the contact", nt.width, (),
                 summary="Width of the contact, smaller than the punch once an edge has lifted off."),
    )
}  # fmt: skip
