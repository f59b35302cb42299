"""A reachability map over Dask: where the PUMA 560 reaches a grid of points, and in how many of some orientations.

    python examples/reachability_dask.py [--step 0.1] [--orientations 50] [--workers 2] [--out map.npz]

The map is made of slices, which a Dask cluster computes; a robot is sent to its workers like any other Python object. Here the cluster is
local; `Client("tcp://scheduler:8786")` in its place uses one that is there already.
"""

import argparse
from pathlib import Path

import numpy as np
from dask.distributed import Client, LocalCluster, progress

import dhkin

TABLE = Path(__file__).parent.parent / "tests" / "tables" / "puma560.dh"


def orientations(n):
    """Rotations spread evenly: random unit quaternions, always the same."""
    w, x, y, z = np.random.default_rng(7).normal(size=(4, n))
    size = np.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / size, x / size, y / size, z / size
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    ).transpose(2, 0, 1)


def slice_of_map(arm, axis, z, rotations, threads=1):
    """At height z, for points (x, y): in how many orientations a solution within the ranges reaches the point."""
    x, y = np.meshgrid(axis, axis, indexing="ij")
    poses = np.tile(np.eye(4), (*x.shape, len(rotations), 1, 1))
    poses[..., :3, :3] = rotations
    poses[..., 0, 3], poses[..., 1, 3], poses[..., 2, 3] = x[..., None], y[..., None], z
    q = arm.inverse(poses.reshape(-1, 4, 4), threads=threads).q
    least, greatest = arm.ranges.T
    inside = ((q >= least - 1e-9) & (q <= greatest + 1e-9)).all(axis=2).any(axis=1)
    return inside.reshape(*x.shape, -1).sum(axis=2)


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--step", type=float, default=0.1, help="of the grid, in metres")
    options.add_argument("--orientations", type=int, default=50)
    options.add_argument("--workers", type=int, default=2)
    options.add_argument("--out", type=Path, help="an .npz file for the map")
    options.add_argument("--compare", action="store_true", help="with the same map from one process")
    options = options.parse_args()

    arm, rotations = dhkin.Robot(TABLE.read_text()), orientations(options.orientations)
    axis = np.arange(-0.9, 0.9 + options.step / 2, options.step)
    cluster = LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None)
    with cluster, Client(cluster) as client:
        slices = client.map(lambda z: slice_of_map(arm, axis, z, rotations), axis)
        progress(slices)
        reached = np.stack(client.gather(slices), axis=2)
    poses = reached.size * len(rotations)
    print(f"\n{poses} poses at {reached.size} points: {reached.sum() / poses:.1%} reached within the ranges")
    if options.compare:
        alone = np.stack([slice_of_map(arm, axis, z, rotations, None) for z in axis], axis=2)
        assert np.array_equal(alone, reached), "the cluster's map is another one"
        print("one process makes the same map")
    if options.out:
        np.savez_compressed(options.out, axis=axis, reached=reached, orientations=len(rotations))


if __name__ == "__main__":
    main()
