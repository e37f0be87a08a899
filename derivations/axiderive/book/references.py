"""The works that profiles, formulas and the guide cite, by the short form used in the profile files."""

from __future__ import annotations

import unicodedata
from typing import NamedTuple


class Work(NamedTuple):
    """Authors and title; where it appeared, with volume and pages; DOI, where that is certain."""

    title: str
    place: str
    doi: str = ""


WORKS = {
    "Barber 1976": Work(
        "Barber, J. R.: Indentation of the semi-infinite elastic solid by a concave rigid punch.",
        "J. Elasticity 6, 149--159 (1976)",
    ),
    "Booker, Balaam & Davis 1985": Work(
        "Booker, J. R., Balaam, N. P., Davis, E. H.: The behaviour of an elastic non-homogeneous half-space. "
        "Part I: Line and point loads. Part II: Circular and strip footings.",
        "Int. J. Numer. Anal. Methods Geomech. 9, 353--367 and 369--381 (1985)",
    ),
    "Boussinesq 1885": Work(
        "Boussinesq, J.: Application des potentiels à l'étude de l'équilibre et du mouvement des solides élastiques.",
        "Gauthier-Villars, Paris (1885)",
    ),
    "Cattaneo 1938": Work(
        "Cattaneo, C.: Sul contatto di due corpi elastici: distribuzione locale degli sforzi.",
        "Rend. Accad. Naz. Lincei 27, 342--348, 434--436 and 474--478 (1938)",
    ),
    "Ciavarella 1998": Work(
        "Ciavarella, M.: The generalized Cattaneo partial slip plane contact problem. I: Theory.",
        "Int. J. Solids Struct. 35, 2349--2362 (1998)",
    ),
    "Ciavarella 1999": Work(
        "Ciavarella, M.: Indentation by nominally flat or conical indenters with rounded corners.",
        "Int. J. Solids Struct. 36, 4149--4181 (1999)",
    ),
    "Ciavarella, Hills & Monno 1998": Work(
        "Ciavarella, M., Hills, D. A., Monno, G.: The influence of rounded edges on indentation by flat punch.",
        "Proc. Inst. Mech. Eng. C 212, 319--328 (1998)",
    ),
    "Dimitriadis et al. 2002": Work(
        "Dimitriadis, E. K., Horkay, F., Maresca, J., Kachar, B., Chadwick, R. S.: Determination of elastic moduli of "
        "thin layers of soft material using the atomic force microscope.",
        "Biophys. J. 82, 2798--2810 (2002)",
        "10.1016/S0006-3495(02)75620-8",
    ),
    "Ejike 1981": Work(
        "Ejike, U. B. C. O.: The stress on an elastic half-space due to sectionally smooth-ended punch.",
        "J. Elasticity 11, 395--402 (1981)",
    ),
    "Föppl 1941": Work(
        "Föppl, L.: Elastische Beanspruchung des Erdbodens unter Fundamenten.",
        "Forschung auf dem Gebiete des Ingenieurwesens 12, 31--39 (1941)",
    ),
    "Galin 1946": Work(
        "Galin, L. A.: Spatial contact problems of the theory of elasticity for punches of circular shape "
        "in planar projection.",
        "Prikl. Mat. Mekh. 10, 425--448 (1946)",
    ),
    "Giannakopoulos & Suresh 1997": Work(
        "Giannakopoulos, A. E., Suresh, S.: Indentation of solids with gradients in elastic properties. "
        "Part I: Point force. Part II: Axisymmetric indentors.",
        "Int. J. Solids Struct. 34, 2357--2392 and 2393--2428 (1997)",
    ),
    "Guduru 2007": Work(
        "Guduru, P. R.: Detachment of a rigid solid from an elastic wavy surface: theory.",
        "J. Mech. Phys. Solids 55, 445--472 (2007)",
        "10.1016/j.jmps.2006.09.004",
    ),
    "Hay, Bolshakov & Pharr 1999": Work(
        "Hay, J. C., Bolshakov, A., Pharr, G. M.: A critical examination of the fundamental relations used in the "
        "analysis of nanoindentation data.",
        "J. Mater. Res. 14, 2296--2305 (1999)",
        "10.1557/JMR.1999.0306",
    ),
    "Hertz 1882": Work(
        "Hertz, H.: Über die Berührung fester elastischer Körper.",
        "J. reine angew. Math. 92, 156--171 (1882)",
        "10.1515/crll.1882.92.156",
    ),
    "Heß 2011": Work(
        "Heß, M.: Über die exakte Abbildung ausgewählter dreidimensionaler Kontakte auf Systeme mit niedrigerer "
        "räumlicher Dimension.",
        "Cuvillier, Göttingen (2011)",
    ),
    "Jäger 1995": Work(
        "Jäger, J.: Axi-symmetric bodies of equal material in contact under torsion or shift.",
        "Arch. Appl. Mech. 65, 478--487 (1995)",
    ),
    "Johnson 1985": Work(
        "Johnson, K. L.: Contact Mechanics.", "Cambridge University Press (1985)", "10.1017/CBO9781139171731"
    ),
    "Johnson & Greenwood 1997": Work(
        "Johnson, K. L., Greenwood, J. A.: An adhesion map for the contact of elastic spheres.",
        "J. Colloid Interface Sci. 192, 326--333 (1997)",
        "10.1006/jcis.1997.4984",
    ),
    "Johnson, Kendall & Roberts 1971": Work(
        "Johnson, K. L., Kendall, K., Roberts, A. D.: Surface energy and the contact of elastic solids.",
        "Proc. R. Soc. Lond. A 324, 301--313 (1971)",
        "10.1098/rspa.1971.0141",
    ),
    "Lee & Radok 1960": Work(
        "Lee, E. H., Radok, J. R. M.: The contact problem for viscoelastic bodies.",
        "J. Appl. Mech. 27, 438--444 (1960)",
        "10.1115/1.3644020",
    ),
    "Love 1939": Work(
        "Love, A. E. H.: Boussinesq's problem for a rigid cone.",
        "Quart. J. Math. 10, 161--175 (1939)",
        "10.1093/qmath/os-10.1.161",
    ),
    "Maugis 1992": Work(
        "Maugis, D.: Adhesion of spheres: the JKR--DMT transition using a Dugdale model.",
        "J. Colloid Interface Sci. 150, 243--269 (1992)",
        "10.1016/0021-9797(92)90285-T",
    ),
    "Maugis & Barquins 1983": Work(
        "Maugis, D., Barquins, M.: Adhesive contact of sectionally smooth-ended punches on elastic half-spaces: "
        "theory and experiment.",
        "J. Phys. D 16, 1843--1874 (1983)",
        "10.1088/0022-3727/16/10/010",
    ),
    "Mindlin 1949": Work(
        "Mindlin, R. D.: Compliance of elastic bodies in contact.",
        "J. Appl. Mech. 16, 259--268 (1949)",
        "10.1115/1.4009973",
    ),
    "Popov, Heß & Willert 2019": Work(
        "Popov, V. L., Heß, M., Willert, E.: Handbook of Contact Mechanics.",
        "Springer (2019); equation numbers (11.xx) refer to its chapter 11",
        "10.1007/978-3-662-58709-6",
    ),
    "Sadowsky 1928": Work(
        "Sadowsky, M.: Zweidimensionale Probleme der Elastizitätstheorie.",
        "Z. angew. Math. Mech. 8, 107--121 (1928)",
    ),
    "Schubert 1942": Work(
        "Schubert, G.: Zur Frage der Druckverteilung unter elastisch gelagerten Tragwerken.",
        "Ingenieur-Archiv 13, 132--147 (1942)",
    ),
    "Segedin 1957": Work(
        "Segedin, C. M.: The relation between load and penetration for a spherical punch.",
        "Mathematika 4, 156--161 (1957)",
    ),
    "Sneddon 1965": Work(
        "Sneddon, I. N.: The relation between load and penetration in the axisymmetric Boussinesq problem "
        "for a punch of arbitrary profile.",
        "Int. J. Eng. Sci. 3, 47--57 (1965)",
        "10.1016/0020-7225(65)90019-4",
    ),
    "Spence 1968": Work(
        "Spence, D. A.: Self similar solutions to adhesive contact problems with incremental loading.",
        "Proc. R. Soc. Lond. A 305, 55--80 (1968)",
        "10.1098/rspa.1968.0105",
    ),
    "Steuermann 1939": Work(
        "Steuermann, E.: To Hertz's theory of local deformations in compressed elastic bodies.",
        "C. R. (Dokl.) Acad. Sci. URSS 25, 359--361 (1939)",
    ),
    "Tabor 1977": Work(
        "Tabor, D.: Surface forces and surface interactions.",
        "J. Colloid Interface Sci. 58, 2--13 (1977)",
        "10.1016/0021-9797(77)90366-6",
    ),
}


def label(work: str) -> str:
    """Name of the LaTeX label of a work."""
    return "ref:" + "".join(c for c in work if c.isalnum() and c.isascii())


def sorted_as(work: str) -> str:
    """Without umlauts and signs, by which the works are put in order."""
    return unicodedata.normalize("NFD", work).encode("ascii", "ignore").decode().replace("&", "").lower()
