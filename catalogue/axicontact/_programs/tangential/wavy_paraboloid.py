"""Programs of axicontact.tangential.wavy_paraboloid."""

from __future__ import annotations

from math import cos, sin, sqrt

import numpy as np

from ..._runtime.interface import largest, ordinary
from ..._programs.bodies.tangential import wavy_paraboloid as bodies

C0 = np.array(4.0)
C1 = np.array(0.0018387596444350194)
C2 = np.array(0.19066450900998982)
C3 = np.array(3.0483894754261476)
C4 = np.array(15.19102558900126)
C5 = np.array(29.808014377479484)
C6 = np.array(24.96788054397516)
C7 = np.array(8.683547237489872)
C8 = np.array(0.9999999999999999)
C9 = np.array(0.002212005671285288)
C10 = np.array(0.2001974796255756)
C11 = np.array(3.105370848058991)
C12 = np.array(15.312651459874987)
C13 = np.array(29.91423599857526)
C14 = np.array(25.005621881441563)
C15 = np.array(8.687941768739819)
C16 = np.array(1.0)
C17 = np.array(0.0004901193629942897)
C18 = np.array(0.06145984139536439)
C19 = np.array(1.0518270059695811)
C20 = np.array(5.781613266959815)
C21 = np.array(13.238613776927886)
C22 = np.array(14.03231295125601)
C23 = np.array(7.053533528650583)
C24 = np.array(1.5864409102245354)
C25 = np.array(0.12499999999999996)
C26 = np.array(0.010407794628814504)
C27 = np.array(0.6786602978701849)
C28 = np.array(9.714034412080755)
C29 = np.array(49.61872106978687)
C30 = np.array(109.72928508784756)
C31 = np.array(114.25481958955879)
C32 = np.array(56.887289819100324)
C33 = np.array(12.728148375546064)
C34 = np.array(3.141592653589793)
C35 = np.array(0.6366197723675814)
C36 = np.array(2.7669174297600505)
C37 = np.array(458.12928011151)
C38 = np.array(12339.040962954072)
C39 = np.array(116086.73672207216)
C40 = np.array(497567.64954748255)
C41 = np.array(1108277.323605407)
C42 = np.array(1381011.961852606)
C43 = np.array(1003773.8758924268)
C44 = np.array(434231.16206495283)
C45 = np.array(112030.50898197992)
C46 = np.array(16935.748731095395)
C47 = np.array(1432.2758652785926)
C48 = np.array(61.134000115506566)
C49 = np.array(0.9999999999999998)
C50 = np.array(7.180883835408781)
C51 = np.array(701.2388166510722)
C52 = np.array(15685.23245722768)
C53 = np.array(134351.15109003813)
C54 = np.array(545544.5462081418)
C55 = np.array(1175419.8654706934)
C56 = np.array(1434014.3809253315)
C57 = np.array(1028086.753929006)
C58 = np.array(440767.5736243928)
C59 = np.array(113047.1785966793)
C60 = np.array(17023.406316407476)
C61 = np.array(1436.0654902859085)
C62 = np.array(61.19650011550626)
C63 = np.array(8.828323214435029e-27)
C64 = np.array(4.6099020557240325e-24)
C65 = np.array(2.4054615951897063e-21)
C66 = np.array(1.0273396391723168e-18)
C67 = np.array(3.5707244750588535e-16)
C68 = np.array(9.847681544810048e-14)
C69 = np.array(2.088352382583283e-11)
C70 = np.array(3.266281247828758e-09)
C71 = np.array(3.554845442184243e-07)
C72 = np.array(2.4671442647474615e-05)
C73 = np.array(0.0009425048654833265)
C74 = np.array(0.014589391634279988)
C75 = np.array(0.0337536433556216)
C76 = np.array(6.283185307179586)
C77 = np.array(9.869604401089358)


def full_slip_displacement(a, R, h, wavelength, E_star, G_star, mu):
    if a.__class__ is R.__class__ is h.__class__ is wavelength.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (h > 1e-30) and (h < 1e+30) and (wavelength > 1e-30) and (wavelength < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            v11 = 6.283185307179586 / wavelength * a
            if v11 >= 4.0:
                v17 = v11 if v11 > 4.0 or v11 != v11 else 4.0
                v18 = 4.0 / v17
                v19 = v18 * v18
                v64 = (((((((0.0018387596444350194 * v19 + 0.19066450900998982) * v19 + 3.0483894754261476) * v19 + 15.19102558900126) * v19 + 29.808014377479484) * v19 + 24.96788054397516) * v19 + 8.683547237489872) * v19 + 0.9999999999999999) / (((((((0.002212005671285288 * v19 + 0.2001974796255756) * v19 + 3.105370848058991) * v19 + 15.312651459874987) * v19 + 29.91423599857526) * v19 + 25.005621881441563) * v19 + 8.687941768739819) * v19 + 1.0)
                v116 = -(((((((((0.0004901193629942897 * v19 + 0.06145984139536439) * v19 + 1.0518270059695811) * v19 + 5.781613266959815) * v19 + 13.238613776927886) * v19 + 14.03231295125601) * v19 + 7.053533528650583) * v19 + 1.5864409102245354) * v19 + 0.12499999999999996) / ((((((((0.010407794628814504 * v19 + 0.6786602978701849) * v19 + 9.714034412080755) * v19 + 49.61872106978687) * v19 + 109.72928508784756) * v19 + 114.25481958955879) * v19 + 56.887289819100324) * v19 + 12.728148375546064) * v19 + 1.0)) / v17
                v167 = ((((((((((((2.7669174297600505 * v19 + 458.12928011151) * v19 + 12339.040962954072) * v19 + 116086.73672207216) * v19 + 497567.64954748255) * v19 + 1108277.323605407) * v19 + 1381011.961852606) * v19 + 1003773.8758924268) * v19 + 434231.16206495283) * v19 + 112030.50898197992) * v19 + 16935.748731095395) * v19 + 1432.2758652785926) * v19 + 61.134000115506566) * v19
                v207 = ((((((((((((7.180883835408781 * v19 + 701.2388166510722) * v19 + 15685.23245722768) * v19 + 134351.15109003813) * v19 + 545544.5462081418) * v19 + 1175419.8654706934) * v19 + 1434014.3809253315) * v19 + 1028086.753929006) * v19 + 440767.5736243928) * v19 + 113047.1785966793) * v19 + 17023.406316407476) * v19 + 1436.0654902859085) * v19 + 61.19650011550626) * v19
                v254 = ((v64 + v116) * sin(v17) + (v116 - v64) * cos(v17)) / sqrt(3.141592653589793 * v17) + 0.6366197723675814 / v17 * ((v167 + 0.9999999999999998) / (v207 + 1.0))
            else:
                v212 = v11 if v11 < 4.0 or v11 != v11 else 4.0
                v215 = (4.0 - v212) * (4.0 + v212)
                v253 = v212 * ((((((((((((8.828323214435029e-27 * v215 + 4.6099020557240325e-24) * v215 + 2.4054615951897063e-21) * v215 + 1.0273396391723168e-18) * v215 + 3.5707244750588535e-16) * v215 + 9.847681544810048e-14) * v215 + 2.088352382583283e-11) * v215 + 3.266281247828758e-09) * v215 + 3.554845442184243e-07) * v215 + 2.4671442647474615e-05) * v215 + 0.0009425048654833265) * v215 + 0.014589391634279988) * v215 + 0.0337536433556216)
                v254 = v253
            value = mu * (E_star / G_star) * (a * (9.869604401089358 * h / wavelength * v254 + a / R))
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            return None
        except (ArithmeticError, ValueError):
            pass
    return None


def prepare_full_slip_displacement_a(R, h, wavelength, E_star, G_star, mu):
    v7 = E_star / G_star
    v8 = mu * v7
    v10 = (6.283185307179586) / wavelength
    v13 = (9.869604401089358) * h
    v14 = v13 / wavelength
    return (R, v8, v10, v14)


def block_full_slip_displacement_a(out, a, R, v8, v10, v14, t0, t1, t2, t3, t4, m0, f0):
    size = out.size
    np.multiply(v10, a, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.greater_equal(out, C0, m0)
    some254 = np.count_nonzero(m0)
    if some254:
        np.maximum(out, f0, out=t0)
        np.divide(C0, t0, t1)
        np.multiply(t1, t1, t1)
        np.multiply(C1, t1, t2)
        np.add(t2, C2, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C3, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C4, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C5, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C6, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C7, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C8, t2)
        np.multiply(C9, t1, t3)
        np.add(t3, C10, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C11, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C12, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C13, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C14, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C15, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C16, t3)
        np.divide(t2, t3, t3)
        np.multiply(C17, t1, t2)
        np.add(t2, C18, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C19, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C20, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C21, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C22, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C23, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C24, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C25, t2)
        np.multiply(C26, t1, t4)
        np.add(t4, C27, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C28, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C29, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C30, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C31, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C32, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C33, t4)
        np.multiply(t4, t1, t4)
        np.add(t4, C16, t4)
        np.divide(t2, t4, t4)
        np.negative(t4, t4)
        np.divide(t4, t0, t4)
        np.add(t3, t4, t2)
        np.subtract(t4, t3, t3)
        np.sin(t0, t4)
        np.multiply(t2, t4, t4)
        np.cos(t0, t2)
        np.multiply(t3, t2, t2)
        np.add(t4, t2, t2)
        np.multiply(C34, t0, t4)
        np.sqrt(t4, t4)
        np.divide(t2, t4, t4)
        np.divide(C35, t0, t0)
        np.multiply(C36, t1, t2)
        np.add(t2, C37, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C38, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C39, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C40, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C41, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C42, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C43, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C44, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C45, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C46, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C47, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C48, t2)
        np.multiply(t2, t1, t2)
        np.add(t2, C49, t2)
        np.multiply(C50, t1, t3)
        np.add(t3, C51, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C52, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C53, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C54, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C55, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C56, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C57, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C58, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C59, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C60, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C61, t3)
        np.multiply(t3, t1, t3)
        np.add(t3, C62, t3)
        np.multiply(t3, t1, t1)
        np.add(t1, C16, t1)
        np.divide(t2, t1, t1)
        np.multiply(t0, t1, t1)
        np.add(t4, t1, t0)
    if some254 != size:
        other254 = t1 if some254 else t0
        np.minimum(out, f0, out=other254)
        np.subtract(C0, other254, t4)
        np.add(C0, other254, t2)
        np.multiply(t4, t2, t2)
        np.multiply(C63, t2, t4)
        np.add(t4, C64, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C65, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C66, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C67, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C68, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C69, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C70, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C71, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C72, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C73, t4)
        np.multiply(t4, t2, t4)
        np.add(t4, C74, t4)
        np.multiply(t4, t2, t2)
        np.add(t2, C75, t2)
        np.multiply(other254, t2, other254)
        if some254:
            np.copyto(t0, other254, where=~m0)
    np.multiply(v14, t0, t0)
    np.divide(a, R, out)
    np.add(t0, out, out)
    np.multiply(a, out, out)
    np.multiply(v8, out, out)


def prepare_full_slip_displacement_all():
    return ()


def block_full_slip_displacement_all(out, a, R, h, wavelength, E_star, G_star, mu, t0, t1, t2, t3, t4, t5, t6, m0, f0):
    size = out.size
    np.divide(E_star, G_star, out)
    largest_a = largest(a)
    if largest_a == np.inf:
        raise FloatingPointError
    np.multiply(mu, out, out)
    np.divide(C76, wavelength, t0)
    np.multiply(t0, a, t0)
    np.multiply(C77, h, t1)
    np.divide(t1, wavelength, t1)
    np.greater_equal(t0, C0, m0)
    some254 = np.count_nonzero(m0)
    if some254:
        np.maximum(t0, f0, out=t2)
        np.divide(C0, t2, t3)
        np.multiply(t3, t3, t3)
        np.multiply(C1, t3, t4)
        np.add(t4, C2, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C3, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C4, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C5, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C6, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C7, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C8, t4)
        np.multiply(C9, t3, t5)
        np.add(t5, C10, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C11, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C12, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C13, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C14, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C15, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C16, t5)
        np.divide(t4, t5, t5)
        np.multiply(C17, t3, t4)
        np.add(t4, C18, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C19, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C20, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C21, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C22, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C23, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C24, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C25, t4)
        np.multiply(C26, t3, t6)
        np.add(t6, C27, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C28, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C29, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C30, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C31, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C32, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C33, t6)
        np.multiply(t6, t3, t6)
        np.add(t6, C16, t6)
        np.divide(t4, t6, t6)
        np.negative(t6, t6)
        np.divide(t6, t2, t6)
        np.add(t5, t6, t4)
        np.subtract(t6, t5, t5)
        np.sin(t2, t6)
        np.multiply(t4, t6, t6)
        np.cos(t2, t4)
        np.multiply(t5, t4, t4)
        np.add(t6, t4, t4)
        np.multiply(C34, t2, t6)
        np.sqrt(t6, t6)
        np.divide(t4, t6, t6)
        np.divide(C35, t2, t2)
        np.multiply(C36, t3, t4)
        np.add(t4, C37, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C38, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C39, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C40, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C41, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C42, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C43, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C44, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C45, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C46, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C47, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C48, t4)
        np.multiply(t4, t3, t4)
        np.add(t4, C49, t4)
        np.multiply(C50, t3, t5)
        np.add(t5, C51, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C52, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C53, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C54, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C55, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C56, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C57, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C58, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C59, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C60, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C61, t5)
        np.multiply(t5, t3, t5)
        np.add(t5, C62, t5)
        np.multiply(t5, t3, t3)
        np.add(t3, C16, t3)
        np.divide(t4, t3, t3)
        np.multiply(t2, t3, t3)
        np.add(t6, t3, t2)
    if some254 != size:
        other254 = t3 if some254 else t2
        np.minimum(t0, f0, out=other254)
        np.subtract(C0, other254, t6)
        np.add(C0, other254, t4)
        np.multiply(t6, t4, t4)
        np.multiply(C63, t4, t6)
        np.add(t6, C64, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C65, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C66, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C67, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C68, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C69, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C70, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C71, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C72, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C73, t6)
        np.multiply(t6, t4, t6)
        np.add(t6, C74, t6)
        np.multiply(t6, t4, t4)
        np.add(t4, C75, t4)
        np.multiply(other254, t4, other254)
        if some254:
            np.copyto(t2, other254, where=~m0)
    np.multiply(t1, t2, t2)
    np.divide(a, R, t1)
    np.add(t2, t1, t1)
    np.multiply(a, t1, t1)
    np.multiply(out, t1, out)


def stick_radius(F_x, a, R, h, wavelength, E_star, mu):
    if F_x.__class__ is a.__class__ is R.__class__ is h.__class__ is wavelength.__class__ is E_star.__class__ is mu.__class__ is float and F_x > 1e-30 and (F_x < 1e+30) and (a > 1e-30) and (a < 1e+30) and (R > 1e-30) and (R < 1e+30) and (h > 1e-30) and (h < 1e+30) and (wavelength > 1e-30) and (wavelength < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._stick_radius(F_x, a, R, h, wavelength, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(F_x, a, R, h, wavelength, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_displacement(a, c, R, h, wavelength, E_star, G_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is h.__class__ is wavelength.__class__ is E_star.__class__ is G_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (h > 1e-30) and (h < 1e+30) and (wavelength > 1e-30) and (wavelength < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (G_star > 1e-30) and (G_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._tangential_displacement(a, c, R, h, wavelength, E_star, G_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, h, wavelength, E_star, G_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def tangential_force(a, c, R, h, wavelength, E_star, mu):
    if a.__class__ is c.__class__ is R.__class__ is h.__class__ is wavelength.__class__ is E_star.__class__ is mu.__class__ is float and a > 1e-30 and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (h > 1e-30) and (h < 1e+30) and (wavelength > 1e-30) and (wavelength < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._tangential_force(a, c, R, h, wavelength, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if value != value and ordinary(a, c, R, h, wavelength, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


def traction(r, a, c, R, h, wavelength, E_star, mu):
    if r.__class__ is a.__class__ is c.__class__ is R.__class__ is h.__class__ is wavelength.__class__ is E_star.__class__ is mu.__class__ is float and r > 1e-30 and (r < 1e+30) and (a > 1e-30) and (a < 1e+30) and (c > 1e-30) and (c < 1e+30) and (R > 1e-30) and (R < 1e+30) and (h > 1e-30) and (h < 1e+30) and (wavelength > 1e-30) and (wavelength < 1e+30) and (E_star > 1e-30) and (E_star < 1e+30) and (mu > 1e-30) and (mu < 1e+30):
        try:
            value = bodies._traction(r, a, c, R, h, wavelength, E_star, mu)
            if value > 1e-200 and value < 1e+200 or 1e-200 < -value < 1e+200:
                return value
            if (value != value or (value == 0.0 and r > a)) and ordinary(r, a, c, R, h, wavelength, E_star, mu):
                return value
        except (ArithmeticError, ValueError):
            pass
    return None


BLOCKS = {
    ('_full_slip_displacement', 1, 'a', 'R', 'h', 'wavelength', 'E_star', 'G_star', 'mu'): {
        ('a',): (('a',), prepare_full_slip_displacement_a, block_full_slip_displacement_a, 5, 1, (4.0,), False),
        ('a', 'R', 'h', 'wavelength', 'E_star', 'G_star', 'mu'): (('a', 'R', 'h', 'wavelength', 'E_star', 'G_star', 'mu'), prepare_full_slip_displacement_all, block_full_slip_displacement_all, 7, 1, (4.0,), False),
    },
}
