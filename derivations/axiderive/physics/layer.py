"""Contact with an elastic layer on a rigid base: springs that feel each other (Lebedev, Ufliand).

A wave of pressure moves the surface of a layer by the share L of a half-space.  Reduced to springs as the half-space
is, the contact is one Fredholm equation of the second kind for what each spring is pressed in,

    q(t) = d - g(t) + int_0^a K(t, s) q(s) ds,     K(t, s) = wave(t + s) + wave(t - s),

with wave(x) = 1/(pi h) int_0^oo (1 - L(u)) cos(u x/h) du.  The depth g without the layer goes in as it is.  The last
spring carries nothing; adhesion draws it out by the retraction of the half-space, since the layer adds no singularity.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import sympy as sp

from ..entry import COMPACT, COMPLETE, Case, Entry, Quantity
from ..notation import LENGTH, NUMBER, Dimension, E_star, F, a, d, define, dgamma, nu, p, r, s, t, u
from ..profiles.profile import Profile
from . import DEPTH, FORCE, Physics, Wording, normal
from .medium import HOMOGENEOUS, Medium

GROUP = "lay"
thickness = define("thickness", "h_0", LENGTH, "m", "thickness > 0", "thickness of the layer")
define("q", "q", LENGTH, "m", "", "how far the spring of a radius is pressed in, on a layer")
define("K", "K", Dimension.of(-1, 0), "1/m", "", "what one spring of a layer takes off another")
L = define("sinking", "L", NUMBER, "1", "", "how far a wave moves the surface of a layer, over a half-space")
m_0 = define("m_0", "m_0", NUMBER, "1", "", "sum over the waves of a layer")
m_2 = define("m_2", "m_2", NUMBER, "1", "", "the same, weighted by the squares of the wave numbers")
SPRING, KERNEL = sp.Function("q"), sp.Function("K")
"""The solution of the equation, of a radius, and its kernel, of two."""
EQUATION = d - DEPTH(t) + sp.Integral(KERNEL(t, s) * SPRING(s), (s, 0, a))
"""What the spring at t is pressed in."""
_wave = sp.cos(u * t / thickness) * sp.cos(u * s / thickness)
SUMMED = 2 / (sp.pi * thickness) * sp.Integral((1 - L) * _wave, (u, 0, sp.oo))
"""The kernel by waves u = k thickness."""
MOMENTS = {m_0: sp.Integral(1 - L, (u, 0, sp.oo)), m_2: sp.Integral(u**2 * (1 - L), (u, 0, sp.oo))}
BASES = {"bonded": slice(0, 2), "frictionless": slice(1, 3)}
"""How the layer lies on what is below it, and what of U, W, shear and stress vanishes there."""
EXPANDED = {
    q.suffix: q
    for q in (
        Quantity("d1", "depth_first_order", "Indentation depth, first order", d, (a,),
                 summary="Indentation depth on a thick layer to the first order, under the force of the half-space."),
        Quantity("F2", "force_second_order", "Normal force, second order", F, (a,),
                 summary="Normal force on a thick layer to the second order."),
        Quantity("d2", "depth_second_order", "Indentation depth, second order", d, (a,),
                 summary="Indentation depth on a thick layer to the second order."),
    )
}  # fmt: skip
"""At a contact radius."""
ADHESIVE = {
    q.suffix: q
    for q in (
        Quantity("dadh", "adhesive_depth", "Indentation depth with adhesion", d, (a,),
                 summary="Indentation depth at contact radius a with short-ranged adhesion (JKR)."),
        Quantity("Fadh", "adhesive_force", "Normal force with adhesion", F, (a,),
                 summary="Normal force at contact radius a with short-ranged adhesion (JKR)."),
        Quantity("padh", "adhesive_pressure", "Pressure with adhesion", p, (r, a), written="p(r)", place="inside",
                 summary="Contact pressure with short-ranged adhesion (JKR); infinite at the edge, zero outside."),
    )
}  # fmt: skip
"""At a contact radius, stable or not, where the last spring is drawn out by the retraction of the half-space."""
PUNCH = {suffix: COMPLETE[suffix] for suffix in ("F", "p", "dF")}
CURVED = {suffix: COMPACT[suffix] for suffix in ("d", "F", "p", "ad", "aF", "Fd", "dF")} | EXPANDED | ADHESIVE


@cache
def sinking(u: sp.Expr, base: str) -> sp.Expr:
    """L(u), u = k h: how far a pressure cos(k x) moves the surface of the layer, over the same of a half-space."""
    sine, cosine = sp.symbols("sine cosine", positive=True)
    # Navier's equations into the layer, of U sin x, W cos x, shear and stress over the shear modulus
    rates = sp.Matrix(
        [
            [0, 1, 1, 0],
            [-nu / (1 - nu), 0, 0, (1 - 2 * nu) / (2 * (1 - nu))],
            [2 / (1 - nu), 0, 0, nu / (1 - nu)],
            [0, 0, -1, 0],
        ]
    )
    # the square of rates**2 - 1 vanishes: exp(u rates) is linear in it
    more = (rates**2 - sp.eye(4)).applyfunc(sp.cancel)
    even = cosine * sp.eye(4) + u * sine / 2 * more
    below = even + rates * (sine * sp.eye(4) + (u * cosine - sine) / 2 * more)
    held = below[BASES[base], :]
    pressed = held[0, 0] * held[1, 3] - held[1, 0] * held[0, 3]
    share = sp.fraction(sp.cancel(pressed / (held[:, :2].det() * (1 - nu))))
    above, under = (sp.reduced(own, [cosine**2 - sine**2 - 1], cosine)[1] for own in share)
    return sp.cancel(above / under).subs({sine: sp.sinh(u), cosine: sp.cosh(u)})


@cache
def expanded() -> dict[str, sp.Expr]:
    """Force and, by it, depth of a contact that is small against the thickness, to the fourth power of their quotient.

    Without m_2 they are those of the first order, to the second power.
    """
    even = sp.series(_wave, u, 0, 4).removeO()
    kernel = sum(2 / (sp.pi * thickness) * even.coeff(u, i) * m for i, m in ((0, m_0), (2, m_2)))
    # the last spring carries nothing: what the kernel at t adds to that at a is of the third power
    beside = sp.integrate(kernel - kernel.subs(t, a), (t, 0, a))
    edge = sp.expand(kernel.subs({t: a, s: t}, simultaneous=True))
    scale, squares = sp.factor(edge.coeff(m_2)).as_independent(t)
    short = sp.Integral(squares * (DEPTH(a) - DEPTH(t)), (t, 0, a))
    force = FORCE(a) * (1 + sp.expand(beside))
    return {"F": force, "d": DEPTH(a) - edge.coeff(m_0) * m_0 * F / (2 * E_star) - scale * m_2 * short}


def order(expansion: sp.Expr) -> int:
    """The power of a/thickness, over the leading term, with which what an expansion leaves out begins."""
    return 5 if expansion.has(m_2) else 3


def _expansions(profile: Profile) -> dict[str, sp.Expr]:
    """Of a profile, by g and F of the radius; the depth to the second order where one power has its moment closed."""
    force, depth = expanded().values()
    found = {"d1": depth.subs({m_2: 0, F: FORCE(a)}).doit(), "F2": force}
    base, n = profile.pieces[0].expr.as_independent(r, as_Add=False)[1].as_base_exp()
    if len(profile.pieces) > 1 or base != r:
        return found
    # g(a) - g(t) is g(a) (1 - (t/a)**n)
    (short,) = depth.atoms(sp.Integral)
    weight = sp.Poly(short.function.subs(DEPTH(t), 0) / DEPTH(a), t)
    moment = sum(c * a ** (i + 1) * n / ((i + 1) * (i + 1 + n)) for (i,), c in weight.terms())
    return found | {"d2": depth.subs({short: DEPTH(a) * sp.factor(moment), F: force})}


def _letters(profile: Profile, definition: sp.Expr, *, adhesive: bool) -> str:
    """What the letters of a definition stand for, in text."""
    sinks = {L: sp.Function("L")(u)}
    if not definition.has(SPRING):
        sums = (f"{m} = {sp.sstr(whole.subs(sinks))}" for m, whole in MOMENTS.items() if definition.has(m))
        return (
            f"g and F are those of the half-space, {', '.join(sums)}, L how far a wave moves a layer, over a half-space"
        )
    ends = f"-{sp.sstr(HOMOGENEOUS.retraction())} at t = a" if adhesive else "zero at t = a"
    ends = "zero beyond t = a" if profile.complete else ends
    kernel = f"K(t, s) = {sp.sstr(SUMMED.subs(sinks))}, L how far a wave moves a layer, over a half-space"
    return f"the springs below the surface are pressed in by q(t) = {sp.sstr(EQUATION)}, {ends}; {kernel}"


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no entries on a layer; empty if it has."""
    if profile.compact or profile.pieces[0].expr == 0:
        return ""
    return f"{profile.name} has a face that is not flat, which no function on a layer knows: use flat_punch"


def definitions(profile: Profile, medium: Medium = HOMOGENEOUS) -> dict[str, sp.Expr]:
    """By the springs, of a contact that grows and of a flat punch; then where the layer is thick."""
    carried = 2 * E_star * sp.Integral(SPRING(t), (t, 0, a))
    rate = sp.Integral(sp.Derivative(SPRING(t), t) / sp.sqrt(t**2 - r**2), (t, r, a))
    ending = E_star / sp.pi * (SPRING(a) / sp.sqrt(a**2 - r**2) - rate)
    if profile.complete:
        return {"F": carried, "p": ending, "dF": sp.Eq(carried, F)}
    depth = DEPTH(a) - sp.Integral(KERNEL(a, t) * SPRING(t), (t, 0, a))
    given = {"ad": sp.Eq(depth, d), "aF": sp.Eq(carried, F), "Fd": carried, "dF": depth}
    pulled = {"dadh": depth - medium.retraction(), "Fadh": carried, "padh": ending}
    return {"d": depth, "F": carried, "p": -E_star / sp.pi * rate, **given, **_expansions(profile), **pulled}


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """All entries of a profile on a layer, keyed by suffix.

    Raises
    ------
    ValueError
        If the profile has none.
    """
    if message := refusal(profile):
        raise ValueError(message)
    quantities, found = PHYSICS.table(profile), dict[str, Entry]()
    for suffix, definition in definitions(profile, medium).items():
        quantity = quantities[suffix]
        material = (E_star, nu, thickness) if quantity.elastic else (nu, thickness)
        material = PHYSICS.parameters(medium) if suffix in ADHESIVE else material
        found[suffix] = Entry(
            key=medium.key(profile.name, medium.group, GROUP, suffix),
            profile=profile,
            quantity=quantity,
            status="expansion" if suffix in EXPANDED else "equation",
            cases=(Case(((r, a) if quantity.place else (a,)), definition),),
            definition=definition,
            parameters=(*profile.parameters, *material),
            note=_letters(profile, definition, adhesive=suffix in ADHESIVE),
        )
    return found


PHYSICS = Physics(
    "layer",
    {
        HOMOGENEOUS: Wording(
            place=14,
            title="Layer on a rigid base",
            package="Contact with an elastic layer that is bonded to a rigid base, or slides on it",
            searched="layer thin film coating substrate bonded thickness Dimitriadis Garcia Lebedev Ufliand",
        )
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    refusal=refusal,
    material=(nu, thickness, dgamma),
    choices={"base": ("how the layer lies on what is below it", tuple(BASES))},
    contact="on a layer",
    runtime=("physics.layer", "physics.adhesion"),
    quantities={"layer": CURVED, "layer below a punch": PUNCH},
    assumed="the indenter and the base are rigid, E_star = E/(1 - nu^2) is that of the layer",
    definitions=definitions,
    compared="collocation of the displacement of the surface",
    proofs=lambda *_: {},
    shown={nu: "3/10", thickness: "2", dgamma: "1/100"},
    wanted=("depth", "force", "pressure"),
    printed=False,
)
