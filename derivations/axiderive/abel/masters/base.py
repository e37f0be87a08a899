"""What every master integral has in common."""

from __future__ import annotations

from typing import Any, TypeAlias

import mpmath as mp
import sympy as sp

Number: TypeAlias = mp.mpf


class Master(sp.Function):
    """Common part: evaluation through `numeric`, inside the requested precision."""

    @staticmethod
    def numeric(*args: Any, **options: Any) -> Number:
        message = "a master integral must say how it is evaluated"
        raise TypeError(message)

    def _eval_evalf(self, prec: int) -> sp.Float:
        with mp.workprec(prec + 20):
            # an integer would come as int, whose powers and quotients are floats
            values = [mp.mpf(arg._to_mpmath(prec + 20)) for arg in self.args]
            # the Float must be made from the raw number: sp.Float(value) would fall back to 53 bits
            return sp.Float._new(mp.mpf(self.numeric(*values))._mpf_, prec)
