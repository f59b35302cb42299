"""Poses, frames and Jacobians against plain products; batches and threads against single calls."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest


def joints(random, arm, n):
    return random.uniform(-np.pi, np.pi, (n, arm.dof))


def test_poses_frames_and_jacobians_are_those_of_the_product(pair, random):
    arm, plain = pair
    for q in [*joints(random, arm, 20), np.zeros(arm.dof), np.full(arm.dof, np.pi / 2)]:
        assert np.allclose(arm.forward(q), plain.forward(q), atol=1e-14, rtol=0)
        assert np.allclose(arm.frames(q), plain.frames(q), atol=1e-14, rtol=0)
        assert np.allclose(arm.jacobian(q), plain.jacobian(q), atol=1e-8, rtol=0)


def test_batches_are_single_calls(pair, random):
    arm, _ = pair
    q = joints(random, arm, 1000)
    for function in (arm.forward, arm.frames, arm.jacobian):
        all = function(q)
        assert all.shape[0] == len(q) and all.dtype == np.float64
        assert np.array_equal(all[::97], np.array([function(x) for x in q[::97]]))
        for threads in (1, 2, 5):
            assert np.array_equal(function(q, threads=threads), all)


def test_what_is_not_a_number_spoils_its_own_pose_only(puma, random):
    q = joints(random, puma, 40)
    clean = puma.forward(q)
    q[7, 2], q[21, 0] = np.nan, np.inf
    poses = puma.forward(q)
    good = [i for i in range(40) if i not in (7, 21)]
    assert np.array_equal(poses[good], clean[good])
    assert np.isnan(poses[7]).any() and np.isnan(poses[21]).any()


def test_arrays_of_every_layout_and_lists_are_taken(puma, random):
    q = joints(random, puma, 6)
    poses = puma.forward(q)
    assert np.array_equal(puma.forward(np.asfortranarray(q)), poses)
    assert np.array_equal(puma.forward(q[::-1])[::-1], poses)
    assert np.array_equal(puma.forward(q.tolist()), poses)
    assert np.array_equal(puma.forward([0, 1, 2, 0, 1, 2]), puma.forward(np.array([0.0, 1, 2, 0, 1, 2])))
    assert np.allclose(puma.forward(q.astype(np.float32)), poses, atol=1e-5)
    assert puma.forward(np.zeros((0, 6))).shape == (0, 4, 4)


def test_threads_of_python_use_an_arm_at_once(puma, random):
    q = joints(random, puma, 400)
    wanted = puma.forward(q)
    with ThreadPoolExecutor(4) as pool:
        for poses in pool.map(lambda _: puma.forward(q), range(16)):
            assert np.array_equal(poses, wanted)


@pytest.mark.parametrize(
    "q, error, words",
    [
        (np.zeros(5), ValueError, "q: expected an array of shape (6,) or (n, 6), got shape (5,)"),
        (np.zeros((2, 3, 6)), ValueError, "got shape (2, 3, 6)"),
        (np.zeros((6, 2)), ValueError, "got shape (6, 2)"),
        (0.5, ValueError, "got shape ()"),
        ("abc", TypeError, "q: expected an array of shape (6,) or (n, 6), got str"),
        (np.zeros(6, complex), TypeError, "complex128"),
        ([[1, 2], [3]], ValueError, "q: expected an array"),
        (None, TypeError, "NoneType"),
    ],
)
def test_wrong_joint_values_are_refused_with_what_was_expected(puma, q, error, words):
    with pytest.raises(error) as raised:
        puma.forward(q) if q is not None else puma.frames(None)
    assert words in str(raised.value)
