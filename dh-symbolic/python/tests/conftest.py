"""Arms from tables beside the tests, and a second opinion on their poses: plain products of 4x4 matrices in NumPy."""

from pathlib import Path

import numpy as np
import pytest

import dhkin

TABLES = Path(__file__).parent / "tables"


def table(name):
    return (TABLES / f"{name}.dh").read_text()


def turn(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    m = np.eye(4)
    m[i, i] = m[j, j] = c
    m[i, j], m[j, i] = -s, s
    return m


def shift(axis, length):
    m = np.eye(4)
    m[axis, 3] = length
    return m


class Plain:
    """An arm of revolute joints as rows (alpha, a, d, theta offset), multiplied out one by one."""

    def __init__(self, convention, rows, tool=np.eye(4)):
        self.convention, self.rows, self.tool = convention, rows, tool

    def link(self, row, q):
        alpha, a, d, offset = row
        outer = turn(0, alpha) @ shift(0, a)
        inner = shift(2, d) @ turn(2, q + offset)
        return outer @ inner if self.convention == "modified" else inner @ outer

    def frames(self, q):
        t, all = np.eye(4), []
        for row, x in zip(self.rows, q):
            t = t @ self.link(row, x)
            all.append(t)
        return np.array(all)

    def forward(self, q):
        return self.frames(q)[-1] @ self.tool

    def jacobian(self, q, h=1e-6):
        """By differences."""
        columns = []
        for k in range(len(q)):
            step = np.zeros(len(q))
            step[k] = h
            a, b = self.forward(q - step), self.forward(q + step)
            w = (b[:3, :3] - a[:3, :3]) @ self.forward(q)[:3, :3].T / (2 * h)
            columns.append([*(b[:3, 3] - a[:3, 3]) / (2 * h), w[2, 1], w[0, 2], w[1, 0]])
        return np.array(columns).T

    def newton(self, target, q, steps=40):
        """From a start to a solution, or None: damped Gauss-Newton steps on the twelve entries."""
        q, mu = np.array(q, float), 1e-3
        error = lambda q: (self.forward(q) - target)[:3].ravel()
        e = error(q)
        for _ in range(steps):
            if np.abs(e).max() < 1e-12:
                break
            h = 1e-7
            j = np.array([(error(q + h * v) - e) / h for v in np.eye(len(q))]).T
            step = np.linalg.solve(j.T @ j + mu * np.eye(len(q)), -j.T @ e)
            new = error(q + step)
            if new @ new < e @ e:
                q, e, mu = q + step, new, mu / 8
            else:
                mu *= 8
        return q if np.abs(e).max() < 1e-9 else None

    def solutions(self, target, starts, seed):
        """Different solutions found from many starts."""
        found, random = [], np.random.default_rng(seed)
        for start in random.uniform(-np.pi, np.pi, (starts, len(self.rows))):
            q = self.newton(target, start)
            if q is not None and not any(same(q, p, 1e-4) for p in found):
                found.append(q)
        return found


def same(a, b, tolerance):
    """The same angles but for whole turns?"""
    d = np.asarray(a) - np.asarray(b)
    return np.abs(d - 2 * np.pi * np.round(d / (2 * np.pi))).max() < tolerance


H = np.pi / 2
PUMA = Plain(
    "modified",
    [
        (0, 0, 0, 0),
        (-H, 0, 0, 0),
        (0, 0.4318, 0.15005, 0),
        (-H, 0.0203, 0.4318, 0),
        (H, 0, 0, 0),
        (-H, 0, 0, 0),
    ],
)
UR5 = Plain(
    "standard",
    [
        (H, 0, 0.089459, 0),
        (0, -0.425, 0, 0),
        (0, -0.39225, 0, 0),
        (H, 0, 0.10915, 0),
        (-H, 0, 0.09465, 0),
        (0, 0, 0.0823, 0),
    ],
)
PANDA = Plain(
    "modified",
    [
        (0, 0, 0.333, 0),
        (-H, 0, 0, 0),
        (H, 0, 0.316, 0),
        (H, 0.0825, 0, 0),
        (-H, -0.0825, 0.384, 0),
        (H, 0, 0, 0),
        (H, 0.088, 0.107, 0),
    ],
)
GENERAL = Plain(
    "standard",
    [
        (0.7, 0.1, 0.3, 0),
        (-1.2, 0.5, 0.1, 0),
        (1.9, 0.3, 0.2, 0),
        (0.97, 0.1, 0.4, 0),
        (-1.4, 0.2, 0.1, 0),
        (0.44, 0.1, 0.3, 0),
    ],
)
PLANAR = Plain("modified", [(0, 0, 0, 0), (0, 1.0, 0, 0)], shift(0, 0.6))

#: Name of a table, its plain product, its parameters without a value in the table.
ARMS = {
    "puma560": (PUMA, {}),
    "ur5": (UR5, {}),
    "panda": (PANDA, {}),
    "general_6r": (GENERAL, {}),
    "planar_2r": (PLANAR, {"l2": 0.6}),
}


@pytest.fixture(scope="session", params=ARMS)
def pair(request):
    """An arm and its plain product."""
    plain, parameters = ARMS[request.param]
    return dhkin.Robot(table(request.param), **parameters), plain


@pytest.fixture(scope="session")
def puma():
    return dhkin.Robot(table("puma560"))


@pytest.fixture
def random():
    return np.random.default_rng(5)
