"""A map of 100 000 force curves, fitted by one matrix product: modulus and contact point of each, with deviations.

Run `python examples/force_map.py`; it prints a table and writes force_map.png. With `--workers 2` the blocks of the map
are fitted on a local Dask cluster, and the results are compared bit by bit. Beside axicontact it needs SciPy and
matplotlib, and Dask for the cluster: pip install 'axicontact[examples]'.

The force is linear in the modulus and in the offset of the instrument. Only the contact point is not, but it lies in a
known range: the curve of the tip is computed once for every point of a grid in that range, and what the measured curves
have in common with each of them is one matrix product. Between grid points the sum of squares is a smooth curve, whose
minimum is found from the five points about the best one. The estimates are those of least squares one by one.

Lengths in um, moduli in kPa, forces in nN.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import time

# one core, and the same order of summation wherever a block is fitted
for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import curve_fit

from axicontact.normal import sphere_tipped_cone as tip

TIP = {"R": 0.9, "theta": np.radians(90.0 - 35.0)}
Z = np.linspace(0.0, 4.0, 256)
CONTACTS = np.linspace(0.2, 2.2, 401)
"""Where the contact may begin: the grid, a third of the step of the measurement apart."""
NOISE = 0.2
BLOCK = 1000
"""Curves of a block; its size is fixed, as the order in which a product is summed may depend on it."""


def unit(z):
    """Force of the tip at depths z for a modulus of 1, zero before contact."""
    return tip.force_from_depth(np.maximum(z, 0.0), **TIP, E_star=1.0)


def basis():
    """The curves of the grid less their means, and the sums of squares and products with their derivatives."""
    curves = unit(Z - CONTACTS[:, None])
    curves -= curves.mean(axis=1, keepdims=True)
    slopes = np.gradient(curves, CONTACTS, axis=0)
    return curves, np.sum(curves**2, axis=1), np.sum(curves * slopes, axis=1), np.sum(slopes**2, axis=1)


NEAR = np.arange(-2, 3)
LAGRANGE = np.linalg.inv(np.vander(NEAR, increasing=True)).T
"""Coefficients of the polynomial through five neighbours."""


def fitted(forces, curves, squares, mixed, steep):
    """E_star, z_0 and their standard deviations, for forces (curves, points): an array (curves, 4)."""
    forces = forces - forces.mean(axis=1, keepdims=True)
    shared = forces @ curves.T
    gain = np.where(shared > 0, shared, 0) ** 2 / squares
    best = np.clip(np.argmax(gain, axis=1), 2, len(CONTACTS) - 3)
    at = best[:, None] + NEAR
    c = np.take_along_axis(gain, at, axis=1) @ LAGRANGE
    x = np.zeros(len(best))
    for _ in range(4):  # Newton's steps to the maximum of the polynomial
        rate = c[:, 1] + x * (2 * c[:, 2] + x * (3 * c[:, 3] + x * 4 * c[:, 4]))
        bend = 2 * c[:, 2] + x * (6 * c[:, 3] + x * 12 * c[:, 4])
        x = np.clip(x - rate / np.where(bend < 0, bend, -np.inf), -1, 1)
    powers = x[:, None] ** np.arange(5)

    def between(values):
        return np.sum((values @ LAGRANGE) * powers, axis=1)

    n, m, s = (between(values[at]) for values in (squares, mixed, steep))
    modulus = between(np.take_along_axis(shared, at, axis=1)) / n
    z_0 = CONTACTS[best] + x * (CONTACTS[1] - CONTACTS[0])
    left = (np.sum(forces**2, axis=1) - modulus**2 * n) / (len(Z) - 3)
    # of the normal equations for the modulus and the contact point
    spread = left / (n * s - m**2)
    return np.stack([modulus, z_0, np.sqrt(spread * s), np.sqrt(spread * n) / modulus], axis=1)


TABLE = np.linspace(0.0, Z[-1], 20001)


def measured(block, count, columns):
    """What stands here for a file: forces of a block of curves with noise, and their true moduli and contact points."""
    rng = np.random.default_rng([11, block])
    row, column = np.divmod(block * BLOCK + np.arange(count), columns)
    modulus = 6.0 + 3.0 * np.sin(row / 40) * np.cos(column / 60) + 2.0 * ((row - 90) ** 2 + (column - 250) ** 2 < 2500)
    z_0 = 1.0 + 0.3 * np.cos((row + column) / 80) + 0.1 * rng.random(count)
    forces = np.interp(Z - z_0[:, None], TABLE, unit(TABLE)) * modulus[:, None]
    offset = 0.5 * rng.standard_normal((count, 1))
    return forces + offset + NOISE * rng.standard_normal(forces.shape), modulus, z_0


def sizes(curves):
    """The number of curves of every block."""
    return [min(BLOCK, curves - start) for start in range(0, curves, BLOCK)]


def fitted_block(block, count, columns, own_basis):
    """The fits of a block."""
    return fitted(measured(block, count, columns)[0], *own_basis)


def one_by_one(forces):
    """The same of one curve after the other by SciPy, for comparison."""

    def model(z, E_star, z_0, offset):
        return E_star * unit(z - z_0) + offset

    found = []
    for force in forces:
        start = [5.0, Z[np.argmax(force - force[:20].mean() > 5 * force[:20].std())], force[:20].mean()]
        values, covariance = curve_fit(model, Z, force, p0=start, xtol=1e-10, ftol=1e-12)
        found.append([*values[:2], *np.sqrt(np.diag(covariance)[:2])])
    return np.array(found)


def on_cluster(curves, columns, workers, own_basis):
    """The fits by a local Dask cluster, in the order of the blocks."""
    from distributed import Client, LocalCluster

    cluster = LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None)
    with cluster, Client(cluster) as client:
        everywhere = client.scatter(own_basis, broadcast=True)
        counts = sizes(curves)
        done = client.map(fitted_block, range(len(counts)), counts, columns=columns, own_basis=everywhere)
        return np.concatenate(client.gather(done))


def drawn(found, true, columns, path):
    """The picture: the map of the moduli, and the errors of the fits over their standard deviations."""
    whole = len(found) // columns * columns
    figure = Figure(figsize=(10, 4), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=[3, 2])
    image = left.imshow(found[:whole, 0].reshape(-1, columns), cmap="viridis")
    figure.colorbar(image, label="E* [kPa]")
    x = np.linspace(-4, 4, 81)
    for k, name in enumerate(("E*", "contact point")):
        right.hist((found[:, k] - true[:, k]) / found[:, k + 2], bins=x, density=True, histtype="step", label=name)
    right.plot(x, np.exp(-(x**2) / 2) / np.sqrt(2 * np.pi), "k:", label="normal")
    right.set(xlabel="error over its standard deviation", yticks=[])
    right.legend()
    figure.savefig(path)


def main():
    """The table, and the picture."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--curves", type=int, default=100_000)
    parser.add_argument("--columns", type=int, default=400, help="of the map")
    parser.add_argument("--compared", type=int, default=100, help="curves that are fitted one by one too")
    parser.add_argument("--workers", type=int, default=0, help="of a local Dask cluster that repeats the fits")
    parser.add_argument("--out", default="force_map.png")
    own = parser.parse_args()
    found, true, spent = [], [], 0.0
    start = time.process_time()
    own_basis = basis()
    spent += time.process_time() - start
    for block, count in enumerate(sizes(own.curves)):
        forces, *values = measured(block, count, own.columns)
        start = time.process_time()
        found.append(fitted(forces, *own_basis))
        spent += time.process_time() - start
        true.append(np.stack(values, axis=1))
    found, true = np.concatenate(found), np.concatenate(true)
    few = min(own.compared, own.curves, BLOCK)
    forces = measured(0, sizes(own.curves)[0], own.columns)[0][:few]
    start = time.process_time()
    single = one_by_one(forces)
    slow = (time.process_time() - start) / few
    print(f"{own.curves} curves in {spent:.2f} s of one core, {1e3 * spent / own.curves:.3f} ms a curve")
    print(f"one by one {1e3 * slow:.2f} ms a curve, {slow * own.curves / spent:.0f} times as long")
    print("                    E* [kPa]  contact point [um]")

    def rms(values):
        return np.sqrt(np.mean(values**2, axis=0))

    apart = np.abs(found[:few] - single)[:, :2] / single[:, 2:]
    print("rms error           {:8.4f}  {:8.5f}".format(*rms(found[:, :2] - true)))
    print("as deviations say   {:8.4f}  {:8.5f}".format(*rms(found[:, 2:])))
    print("error one by one    {:8.4f}  {:8.5f}".format(*rms(single[:, :2] - true[:few])))
    print("of the same curves  {:8.4f}  {:8.5f}".format(*rms(found[:few, :2] - true[:few])))
    print("most apart          {:8.4f}  {:8.5f}   of a standard deviation".format(*apart.max(axis=0)))
    if own.workers:
        again = on_cluster(own.curves, own.columns, own.workers, own_basis)
        same = hashlib.sha256(again.tobytes()).digest() == hashlib.sha256(found.tobytes()).digest()
        print(f"{own.workers} workers: {'the same bits' if same else 'OTHER BITS'}")
    drawn(found, true, own.columns, own.out)
    print(f"wrote {own.out}")


if __name__ == "__main__":
    main()
