"""Formulas of axicontact.adhesive.concave_paraboloid over an array library `xp`."""

from ...._programs.expressions._runtime.physics.adhesion import hess_retraction as retraction
