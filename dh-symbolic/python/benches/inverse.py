"""Microseconds of one call from Python, and of one pose in batches on one core: `python benches/inverse.py` (nothing else should run)."""

import sys
import timeit
from pathlib import Path

import numpy as np

import dhkin

TABLES = Path(__file__).parent.parent / "tests" / "tables"


def best(function, number):
    """The best of seven, in microseconds per call."""
    return min(timeit.repeat(function, number=number, repeat=7)) / number * 1e6


def main():
    random = np.random.default_rng(1)
    print(f"dhkin {dhkin.__version__}, Python {sys.version.split()[0]}, NumPy {np.__version__}; us")
    print(f"{'arm':>12} {'forward':>8} {'jacobian':>8} {'inverse':>8} {'near':>8} | batch: {'forward':>8} {'inverse':>8}")
    for name in ("puma560", "ur5", "panda", "general_6r"):
        arm = dhkin.Robot((TABLES / f"{name}.dh").read_text())
        q = random.uniform(-1.2, 0.7, (4000, arm.dof))
        poses = arm.forward(q)
        given = {"given": q[:, 6:7].copy()} if arm.redundant else {}
        one = {"given": q[0, 6]} if arm.redundant else {}
        numbers = [
            best(lambda: arm.forward(q[0]), 3000),
            best(lambda: arm.jacobian(q[0]), 3000),
            best(lambda: arm.inverse(poses[0], **one), 1000),
            best(lambda: arm.inverse_near(poses[0], q[1], **one), 1000),
            best(lambda: arm.forward(q, threads=1), 3) / len(q),
            best(lambda: arm.inverse(poses, threads=1, **given), 1) / len(q),
        ]
        print(f"{name:>12} {numbers[0]:8.2f} {numbers[1]:8.2f} {numbers[2]:8.2f} {numbers[3]:8.2f} |        {numbers[4]:8.3f} {numbers[5]:8.3f}")


if __name__ == "__main__":
    main()
