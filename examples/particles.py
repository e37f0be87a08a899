"""The contact law of a particle code in C: written for one bead, compiled, and called by SciPy without Python between.

Run `python examples/particles.py`; it writes particles.c by way of `axicontact emit`, compiles it with `cc`, integrates
the force over the depth of an impact, and says what that costs.  It needs a C compiler and SciPy:
pip install 'axicontact[derive,examples]'.  Where Numba is installed, a loop that it compiles calls the same pointer.
"""

from __future__ import annotations

import argparse
import ctypes
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from scipy import LowLevelCallable
from scipy.integrate import quad

from axicontact.materials import effective_modulus
from axicontact.normal import paraboloid

SCENE = Path(__file__).with_suffix(".toml")
R, E_STAR = 0.5e-3, effective_modulus(E_1=63e9, nu_1=0.23, E_2=float("inf"), nu_2=0.3)
MASS, SPEED = 1.3e-6, 0.5


def library(folder):
    """The functions of the scene, compiled; the test that is written beside them has been run."""
    emit = [sys.executable, "-m", "axiderive.cli", "emit", SCENE, "--out", folder]
    subprocess.run(emit, check=True)
    subprocess.run(["cc", "-std=c99", "-O2", "test_particles.c", "-o", "test", "-lm"], cwd=folder, check=True)
    subprocess.run([folder / "test"], check=True)
    made = ["cc", "-std=c99", "-O2", "-shared", "-fPIC", "particles.c", "-o", "particles.so", "-lm"]
    subprocess.run(made, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "particles.so"))


def called(function, depth):
    """Work of the force up to a depth, and the seconds that the integral takes."""
    start = time.perf_counter()
    for _ in range(200):
        work, _ = quad(function, 0.0, depth)
    return work, (time.perf_counter() - start) / 200


def looped(force, depths):
    """The sum of many forces in a loop that Numba compiles, which calls the function of C; None without Numba."""
    try:
        from numba import njit
    except ModuleNotFoundError:
        return None

    @njit
    def total(depths):
        found = 0.0
        for depth in depths:
            found += force(depth)
        return found

    return total(depths)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folder", type=Path, default=Path("particles"), help="where the module in C is written")
    folder = parser.parse_args().folder.resolve()
    force = library(folder).force_from_depth
    force.argtypes, force.restype = [ctypes.c_double], ctypes.c_double

    # where the work is the energy of the impact
    depth = (15 / 16 * MASS * SPEED**2 / E_STAR / R**0.5) ** 0.4
    in_c, quick = called(LowLevelCallable(force), depth)
    in_python, slow = called(lambda d: paraboloid.force_from_depth(d, R=R, E_star=E_STAR), depth)
    print(f"greatest depth {1e6 * depth:.3f} um, force {force(depth):.3f} N, work {1e6 * in_c:.4f} uJ")
    print(f"energy of the impact {1e6 * MASS * SPEED**2 / 2:.4f} uJ, work by Python {1e6 * in_python:.4f} uJ")
    print(f"the integral takes {1e6 * quick:.0f} us, and {slow / quick:.1f} times that with the function of Python")
    depths = np.linspace(0.0, depth, 1001)
    if (total := looped(force, depths)) is not None:
        wanted = paraboloid.force_from_depth(depths, R=R, E_star=E_STAR).sum()
        print(f"sum of {depths.size} forces in a loop of Numba {total:.6f} N, by NumPy {wanted:.6f} N")


if __name__ == "__main__":
    main()
