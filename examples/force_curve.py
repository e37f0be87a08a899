"""A force curve of an AFM, fitted: modulus, contact point and radius of the tip, then the work of adhesion.

Run `python examples/force_curve.py`; it prints a table and writes force_curve.svg. Beside axicontact it needs SciPy and
matplotlib: pip install 'axicontact[examples]'.

Lengths are in um and moduli in kPa, hence forces in nN and works of adhesion in mN/m. Any units will do that belong
together, as the formulas hold in all of them.
"""

from __future__ import annotations

import argparse

import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import curve_fit

from axicontact.adhesive import sphere_tipped_cone as adhesive
from axicontact.normal import sphere_tipped_cone as tip

# makers of tips give the half-angle between axis and flank, formulas the inclination between flank and surface;
# so steep a flank is beyond the theory of flat surfaces, and is fitted with it all the same
INCLINATION = np.radians(90.0 - 35.0)
TRUE = {"E_star": 6.0, "z_0": 0.8, "R": 0.9}
ADHESION, NOISE = 0.5, 0.2


def approach(z, E_star, z_0, R):
    """Force on the way in. Without contact it is zero; the function says NaN to a depth below zero."""
    return tip.force_from_depth(np.maximum(z - z_0, 0.0), R=R, theta=INCLINATION, E_star=E_star)


def retract(z, E_star, z_0, R, dgamma):
    """Force on the way out, with adhesion; NaN where the contact has broken, and there is no force."""
    a = adhesive.radius_from_depth(z - z_0, R=R, theta=INCLINATION, E_star=E_star, dgamma=dgamma)
    return np.nan_to_num(adhesive.force(a, R=R, theta=INCLINATION, E_star=E_star, dgamma=dgamma))


def measured(points, seed):
    """What stands here for a file of the instrument: places of the tip and the forces of both ways, with noise."""
    rng = np.random.default_rng(seed)
    z = np.linspace(0.0, 4.0, points)
    noise = NOISE * rng.standard_normal((2, points))
    return z, approach(z, **TRUE) + noise[0], retract(z, **TRUE, dgamma=ADHESION) + noise[1]


def fitted(z, inward, outward):
    """Values and standard deviations of E_star, z_0, R and dgamma, the last with the others as they were found."""
    start = [1.0, z[np.argmax(inward > 5 * np.std(inward[:20]))], 1.0]
    contact, spread = curve_fit(approach, z, inward, p0=start, bounds=([1e-3, z[0], 1e-3], [np.inf, z[-1], np.inf]))
    # where the tip is below the surface the contact with adhesion is stable, and its curve smooth
    below = z > contact[1]
    adhesion, own = curve_fit(
        lambda z, dgamma: retract(z, *contact, dgamma), z[below], outward[below], p0=[0.1], bounds=(0.0, np.inf)
    )
    return np.array([*contact, *adhesion]), np.sqrt([*np.diag(spread), own[0, 0]])


def drawn(z, inward, outward, values, path):
    """The picture: both ways as measured and as fitted, and what the fits leave over."""
    figure = Figure(figsize=(7, 6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    for name, force, fit, colour in (
        ("approach", inward, approach(z, *values[:3]), "tab:blue"),
        ("retract", outward, retract(z, *values), "tab:red"),
    ):
        above.plot(z, force, ".", ms=2, alpha=0.4, color=colour)
        above.plot(z, fit, color=colour, label=f"{name}, fitted")
        below.plot(z, force - fit, ".", ms=2, color=colour)
    above.axvline(values[1], color="grey", lw=0.8, ls=":", label="contact point")
    above.set_ylabel("force [nN]")
    above.legend()
    below.set(xlabel="place of the tip [um]", ylabel="left over [nN]")
    figure.savefig(path)


def main():
    """The table, and the picture."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--points", type=int, default=600, help="of each half of the curve")
    parser.add_argument("--seed", type=int, default=3)
    parser.add_argument("--out", default="force_curve.svg")
    arguments = parser.parse_args()
    z, inward, outward = measured(arguments.points, arguments.seed)
    values, deviations = fitted(z, inward, outward)
    print("            true     fitted   +-")
    units = ("kPa", "um", "um", "mN/m")
    for name, unit, value, deviation in zip((*TRUE, "dgamma"), units, values, deviations, strict=True):
        print(f"{name:7s}  {(TRUE | {'dgamma': ADHESION})[name]:7.3f}    {value:7.3f}   {deviation:.3f} {unit}")
    E_star, _, R, dgamma = values
    force = adhesive.pull_off(R=R, theta=INCLINATION, E_star=E_star, dgamma=dgamma).force
    print(f"E = {E_star * (1 - 0.5**2):.2f} kPa for nu = 0.5 and a rigid tip")
    print(f"greatest adhesive force {force:.2f} nN by the fit, least force measured {outward.min():.2f} nN")
    drawn(z, inward, outward, values, arguments.out)
    print(f"wrote {arguments.out}")


if __name__ == "__main__":
    main()
