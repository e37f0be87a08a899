"""Formulas of axicontact.graded.adhesive.flat_punch over an array library `xp`."""

from ....._programs.expressions._runtime.graded.punch import graded_retraction as retraction
