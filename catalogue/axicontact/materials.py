"""Elastic constants.

Effective modulus and radius of two bodies, moduli of transversely isotropic and of graded half-spaces,
numbers of adhesion.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._runtime.functions import gamma
from ._runtime.interface import Array, Result, elementwise, numbers, require, require_order

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

__all__ = [
    "effective_modulus",
    "effective_radius",
    "effective_shear_modulus",
    "graded_modulus",
    "h_N",
    "maugis_lambda",
    "tabor",
    "transversely_isotropic_modulus",
]


def __dir__() -> list[str]:
    return __all__


def effective_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective modulus E_star of two bodies; the modulus of a rigid one is infinite.

    1/E_star = (1 - nu_2**2)/E_2 + (1 - nu_1**2)/E_1

    Parameters
    ----------
    E_1 : array_like
        Young's modulus of the first body [Pa], E_1 > 0.
    nu_1 : array_like
        Poisson ratio of the first body [1], -1 < nu_1 <= 1/2.
    E_2 : array_like
        Young's modulus of the second body [Pa], E_2 > 0.
    nu_2 : array_like
        Poisson ratio of the second body [1], -1 < nu_2 <= 1/2.

    Returns
    -------
    float or ndarray
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.E_star.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.effective_modulus(1.0, 0.3, 2.0, 0.5)
    >>> round(value, 6)
    0.77821
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def transversely_isotropic_modulus(C_11: ArrayLike, C_33: ArrayLike, C_13: ArrayLike, C_44: ArrayLike) -> Result:
    """Effective modulus E_star of a half-space that is isotropic along its surface, under a rigid indenter.

    E_star = 2*sqrt(C_44)*sqrt((sqrt(C_11)*sqrt(C_33) - C_13)/(sqrt(C_11)*sqrt(C_33) + C_13 +
    2*C_44))*(sqrt(C_11)*sqrt(C_33) + C_13)/sqrt(C_11)

    Parameters
    ----------
    C_11 : array_like
        Elastic constant, along the surface [Pa], C_11 > 0.
    C_33 : array_like
        Elastic constant, into the half-space [Pa], C_33 > 0.
    C_13 : array_like
        Elastic constant of both directions, its square below C_11 C_33 [Pa].
    C_44 : array_like
        Shear modulus in planes across the surface [Pa], C_44 > 0.

    Returns
    -------
    float or ndarray
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    The axis of symmetry is normal to the surface. Normal contact holds with it as with E_star, also with
    adhesion or under a viscoelastic law; not tangential contact, stresses below the surface, or a graded
    half-space. Handbook: materials.E_ti.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.transversely_isotropic_modulus(3.0, 2.0, 1.0, 0.5)
    >>> round(value, 6)
    1.60754
    """
    _require_positive(C_11, C_33, C_13, C_44)
    return elementwise(_transversely_isotropic_modulus, C_11=C_11, C_33=C_33, C_13=C_13, C_44=C_44)


def effective_shear_modulus(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> Result:
    """Effective shear modulus G_star of two bodies; the modulus of a rigid one is infinite.

    1/G_star = (2 - nu_2)*(nu_2 + 1)/(2*E_2) + (2 - nu_1)*(nu_1 + 1)/(2*E_1)

    Parameters
    ----------
    E_1 : array_like
        Young's modulus of the first body [Pa], E_1 > 0.
    nu_1 : array_like
        Poisson ratio of the first body [1], -1 < nu_1 <= 1/2.
    E_2 : array_like
        Young's modulus of the second body [Pa], E_2 > 0.
    nu_2 : array_like
        Poisson ratio of the second body [1], -1 < nu_2 <= 1/2.

    Returns
    -------
    float or ndarray
        Effective shear modulus, 1/G_star = sum (2 - nu_i)/(4 G_i) [Pa].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.G_star.

    References
    ----------
    chapter 11, equation (11.68).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.effective_shear_modulus(1.0, 0.3, 2.0, 0.5)
    >>> round(value, 6)
    0.5997
    """
    _require_bodies(E_1, nu_1, E_2, nu_2)
    return elementwise(_effective_shear_modulus, E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)


def graded_modulus(E_0: ArrayLike, c_0: ArrayLike, k: ArrayLike, nu: ArrayLike) -> Result:
    """Foundation modulus H of a half-space of modulus E_0 (z/c_0)**k under a rigid indenter.

    H = E_0*h_N/(c_0**k*(1 - nu**2))

    Parameters
    ----------
    E_0 : array_like
        Young's modulus at the depth of reference [Pa], E_0 > 0.
    c_0 : array_like
        Depth of reference of the graded half-space [m], c_0 > 0.
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Foundation modulus of the graded half-space, c_N(x) = H |x|^k [Pa m^(-k)].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.H.

    References
    ----------
    chapter 11, equation (11.39); chapter 11, equation (11.65).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.graded_modulus(3.0, 2.0, 0.25, 0.3)
    >>> round(value, 6)
    3.294033
    """
    require(E_0=E_0, c_0=c_0, k=k, nu=nu)
    return elementwise(_graded_modulus, E_0=E_0, c_0=c_0, k=k, nu=nu)


def h_N(k: ArrayLike, nu: ArrayLike) -> Result:
    """Factor h_N of a graded half-space, 1 for k = 0.

    h_N = (k + 1)**2*cos(pi*k/2)*gamma(k/2 + 1)**2/(beta*sin(pi*beta/2)*gamma(-beta/2 + k/2 +
    3/2)*gamma(beta/2 + k/2 + 3/2)) with beta = sqrt(k + 1)*sqrt(-k*nu/(1 - nu) + 1)

    Parameters
    ----------
    k : array_like
        Exponent of grading: the modulus grows with depth as z^k; 0 is the homogeneous half-space [1], -1 < k
        < 1.
    nu : array_like
        Poisson ratio [1], -1 < nu <= 1/2.

    Returns
    -------
    float or ndarray
        Factor of the graded half-space, 1 for k = 0 [1].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Compared with a numerical solution of the equations of equilibrium of the graded half-space. Handbook:
    materials.h_N.

    References
    ----------
    chapter 11, equation (11.33).

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.h_N(0.25, 0.3)
    >>> round(value, 6)
    1.188244
    """
    require(k=k, nu=nu)
    return elementwise(_h_N, k=k, nu=nu)


def effective_radius(R_1: ArrayLike, R_2: ArrayLike) -> Result:
    """Effective radius R of two bodies; negative for a cup, infinite for a plane.

    1/R = 1/R_2 + 1/R_1

    Parameters
    ----------
    R_1 : array_like
        Radius of the first body [m], R_1 > 0.
    R_2 : array_like
        Radius of the second body, negative for a cup [m].

    Returns
    -------
    float or ndarray
        Radius of curvature [m].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.R.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.effective_radius(1.0, -3.0)
    >>> round(value, 6)
    1.5
    """
    _require_gap(R_1, R_2)
    return elementwise(_effective_radius, R_1=R_1, R_2=R_2)


def tabor(R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, z_0: ArrayLike) -> Result:
    """Tabor's number: what adhesion pulls out over the distance in which it acts.

    mu_T**3 = R*dgamma**2/(E_star**2*z_0**3)

    Parameters
    ----------
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
    z_0 : array_like
        Distance of the surfaces at which they do not attract [m], z_0 > 0.

    Returns
    -------
    float or ndarray
        Tabor's number [1].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Handbook: materials.mu_T.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.tabor(2.0, 1.0, 0.5, 0.1)
    >>> round(value, 6)
    7.937005
    """
    require(R=R, E_star=E_star, dgamma=dgamma, z_0=z_0)
    return elementwise(_tabor, R=R, E_star=E_star, dgamma=dgamma, z_0=z_0)


def maugis_lambda(R: ArrayLike, E_star: ArrayLike, dgamma: ArrayLike, sigma_0: ArrayLike) -> Result:
    """Parameter lambda of Maugis' transition, for the attraction of a constant stress sigma_0.

    lambda_M**3 = 9*R*sigma_0**3/(2*pi*E_star**2*dgamma)

    Parameters
    ----------
    R : array_like
        Radius of curvature [m], R > 0.
    E_star : array_like
        Effective (plane-strain) modulus, 1/E_star = sum (1 - nu_i^2)/E_i [Pa], E_star > 0.
    dgamma : array_like
        Work of separation per unit area [N/m], dgamma >= 0.
    sigma_0 : array_like
        Greatest stress of the attraction [Pa], sigma_0 > 0.

    Returns
    -------
    float or ndarray
        Parameter of Maugis [1].

    Raises
    ------
    ValueError
        If a parameter is outside its domain.

    Notes
    -----
    Maugis 1992 writes it by K = 4 E_star/3. With the greatest attraction 16 dgamma/(9 sqrt(3) z_0) of
    Lennard-Jones it is 1.157 times Tabor's number. Handbook: materials.lambda_M.

    Examples
    --------
    >>> from axicontact import materials
    >>> value = materials.maugis_lambda(2.0, 1.0, 0.5, 3.0)
    >>> round(value, 6)
    5.368201
    """
    require(R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)
    return elementwise(_maugis_lambda, R=R, E_star=E_star, dgamma=dgamma, sigma_0=sigma_0)


def _effective_modulus(E_1: Array, nu_1: Array, E_2: Array, nu_2: Array) -> Array:
    compliance = np.divide((1.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((1.0 - nu_2) * (1.0 + nu_2), E_2)
    return np.divide(1.0, compliance)


def _transversely_isotropic_modulus(C_11: Array, C_33: Array, C_13: Array, C_44: Array) -> Array:
    mean = C_11 * np.sqrt(C_33 / C_11)
    high, low = mean + C_13, mean - C_13
    return 2.0 * high * np.sqrt(C_44 / C_11 * (low / (high + 2.0 * C_44)))


def _effective_shear_modulus(E_1: Array, nu_1: Array, E_2: Array, nu_2: Array) -> Array:
    compliance = np.divide((2.0 - nu_1) * (1.0 + nu_1), E_1) + np.divide((2.0 - nu_2) * (1.0 + nu_2), E_2)
    return np.divide(2.0, compliance)


def _graded_modulus(E_0: Array, c_0: Array, k: Array, nu: Array) -> Array:
    return _h_N(k, nu) * E_0 / ((1.0 - nu) * (1.0 + nu) * c_0**k)


def _h_N(k: Array, nu: Array) -> Array:
    beta = np.sqrt((1.0 + k) * ((1.0 - nu) - k * nu) / (1.0 - nu))
    gammas = gamma((3.0 + k + beta) / 2.0) * gamma((3.0 + k - beta) / 2.0)
    # the cosine of pi k/2, without the rounding of pi/2 near k = 1 and k = -1
    cosine = np.sin(np.pi * (1.0 - np.abs(k)) / 2.0)
    punch = ((1.0 + k) * gamma(1.0 + k / 2.0)) ** 2 * cosine
    return punch / (beta * np.sin(np.pi * beta / 2.0) * gammas)


def _effective_radius(R_1: Array, R_2: Array) -> Array:
    # of a ball that nearly fills its cup the sum of the radii keeps the digits that the curvatures lose
    share = np.where(np.isinf(R_2), 1.0, R_2 / (R_1 + R_2))
    return np.where(np.isinf(R_1), R_2, R_1 * share)


def _tabor(R: Array, E_star: Array, dgamma: Array, z_0: Array) -> Array:
    return np.cbrt(R / z_0 * (dgamma / E_star / z_0) ** 2)


def _maugis_lambda(R: Array, E_star: Array, dgamma: Array, sigma_0: Array) -> Array:
    return np.cbrt(4.5 / np.pi * (sigma_0 / E_star) ** 2 * (R * sigma_0 / dgamma))


def _require_bodies(E_1: ArrayLike, nu_1: ArrayLike, E_2: ArrayLike, nu_2: ArrayLike) -> None:
    require(young_1=_finite("E_1", E_1), nu_1=nu_1, young_2=_finite("E_2", E_2), nu_2=nu_2)


def _finite(name: str, modulus: ArrayLike) -> Array:
    """A rigid body or a plane is allowed: its infinite modulus or radius passes as one."""
    array = numbers(name, modulus)
    return np.where(array == np.inf, 1.0, array)


def _require_positive(C_11: ArrayLike, C_33: ArrayLike, C_13: ArrayLike, C_44: ArrayLike) -> None:
    require(C_11=C_11, C_33=C_33, C_13=C_13, C_44=C_44)
    require_order(
        np.abs(C_13) < np.sqrt(C_11) * np.sqrt(C_33),
        "C_13**2 < C_11*C_33",
        "the energy of some strain would be negative; look at the order of the constants, C_11 is along the "
        "surface, and C_13 of both directions",
        C_11=C_11,
        C_33=C_33,
        C_13=C_13,
    )


def _require_gap(R_1: ArrayLike, R_2: ArrayLike) -> None:
    require(radius_1=_finite("R_1", R_1), radius_2=_finite("R_2", R_2))
    one, two = np.asarray(R_1), np.asarray(R_2)
    require_order(
        np.where(two > 0.0, np.minimum(one, two) < np.inf, two < -one),
        "1/R_1 + 1/R_2 > 0",
        "give a cup as -R_2 > R_1, wider than the ball in it, and two planes as no contact",
        R_1=R_1,
        R_2=R_2,
    )
