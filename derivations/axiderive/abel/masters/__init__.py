"""The master integrals that are not functions SymPy already has.

Each class states its definition once, knows its derivatives (`fdiff`, the only
thing a certificate uses), its value where it vanishes, and how to evaluate
itself with mpmath (`numeric`, at the working precision in force).
"""

from .base import Master
from .hypergeometric import CapMoment, Hypergeometric, IncompleteBeta, Kummer, gamma_normalised
from .inverse_tangent import C0, ArctanIntegral, LegendreChi2
from .struve import Dawson, StruveH, StruveL

MASTERS: tuple[type[Master], ...] = (
    C0, LegendreChi2, ArctanIntegral, IncompleteBeta, StruveH, StruveL, Dawson, Hypergeometric, Kummer, CapMoment,
)  # fmt: skip

__all__ = [
    "C0", "MASTERS", "ArctanIntegral", "CapMoment", "Dawson", "Hypergeometric", "IncompleteBeta", "Kummer",
    "LegendreChi2", "Master", "StruveH", "StruveL", "gamma_normalised",
]  # fmt: skip
