"""The works that profiles and formulas cite, by the short form used in the profile files."""

from __future__ import annotations

WORKS = {
    "Barber 1976": (
        "Barber, J. R.: Indentation of the semi-infinite elastic solid by a concave rigid punch.",
        "J. Elasticity 6 (1976)",
    ),
    "Boussinesq 1885": (
        "Boussinesq, J.: Application des potentiels à l'étude de l'équilibre et du mouvement des solides élastiques.",
        "Gauthier-Villars, Paris (1885)",
    ),
    "Ciavarella 1999": (
        "Ciavarella, M.: Indentation by nominally flat or conical indenters with rounded corners.",
        "Int. J. Solids Struct. 36 (1999)",
    ),
    "Ciavarella, Hills & Monno 1998": (
        "Ciavarella, M., Hills, D. A., Monno, G.: The influence of rounded edges on indentation by a flat punch.",
        "Proc. Inst. Mech. Eng. C 212 (1998)",
    ),
    "Ejike 1981": (
        "Ejike, U. B. C. O.: The stress on an elastic half-space due to sectionally smooth-ended punch.",
        "J. Elasticity 11 (1981)",
    ),
    "Föppl 1941": (
        "Föppl, L.: Elastische Beanspruchung des Erdbodens unter Fundamenten.",
        "Forschung auf dem Gebiete des Ingenieurwesens 12 (1941)",
    ),
    "Galin 1946": (
        "Galin, L. A.: Spatial contact problems of the theory of elasticity for punches of circular shape "
        "in planar projection.",
        "Prikl. Mat. Mekh. 10 (1946)",
    ),
    "Guduru 2007": (
        "Guduru, P. R.: Detachment of a rigid solid from an elastic wavy surface: theory.",
        "J. Mech. Phys. Solids 55 (2007)",
    ),
    "Hertz 1882": (
        "Hertz, H.: Über die Berührung fester elastischer Körper.",
        "J. reine angew. Math. 92, 156--171 (1882)",
    ),
    "Johnson 1985": ("Johnson, K. L.: Contact Mechanics.", "Cambridge University Press (1985)"),
    "Love 1939": ("Love, A. E. H.: Boussinesq's problem for a rigid cone.", "Quart. J. Math. 10 (1939)"),
    "Maugis & Barquins 1983": (
        "Maugis, D., Barquins, M.: Adhesive contact of sectionally smooth-ended punches on elastic half-spaces: "
        "theory and experiment.",
        "J. Phys. D 16 (1983)",
    ),
    "Popov, Heß & Willert 2019": (
        "Popov, V. L., Heß, M., Willert, E.: Handbook of Contact Mechanics.",
        "Springer (2019); equation numbers (11.xx) refer to its chapter 11",
    ),
    "Sadowsky 1928": (
        "Sadowsky, M.: Zweidimensionale Probleme der Elastizitätstheorie.",
        "Z. angew. Math. Mech. 8 (1928)",
    ),
    "Schubert 1942": (
        "Schubert, G.: Zur Frage der Druckverteilung unter elastisch gelagerten Tragwerken.",
        "Ingenieur-Archiv 13 (1942)",
    ),
    "Segedin 1957": (
        "Segedin, C. M.: The relation between load and penetration for a spherical punch.",
        "Mathematika 4 (1957)",
    ),
    "Sneddon 1965": (
        "Sneddon, I. N.: The relation between load and penetration in the axisymmetric Boussinesq problem "
        "for a punch of arbitrary profile.",
        "Int. J. Eng. Sci. 3 (1965)",
    ),
    "Steuermann 1939": (
        "Steuermann, E.: To Hertz's theory of local deformations in compressed elastic bodies.",
        "C. R. (Dokl.) Acad. Sci. URSS 25 (1939)",
    ),
}


def label(work: str) -> str:
    """Name of the LaTeX label of a work."""
    return "ref:" + "".join(c for c in work if c.isalnum() and c.isascii())
