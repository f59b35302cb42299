"""All solutions: each reaches its target, none is missing; special poses, other tasks, refusals, batches."""

import numpy as np
import pytest

import dhkin
from conftest import GENERAL, PUMA, UR5, same, table


def choices(arm, q):
    """What is given with a target that these joint values make."""
    return {"given": q[6]} if arm.redundant else {}


def test_every_solution_reaches_its_target_and_the_joints_that_made_it_are_among_them(pair, random):
    arm, plain = pair
    for q in random.uniform(-3, 3, (30, arm.dof)):
        target = plain.forward(q)
        solutions = arm.inverse(target, **choices(arm, q))
        assert solutions and solutions.why == "solved"
        assert any(same(s.q, q, 1e-7) for s in solutions)
        for s in solutions:
            reached = plain.forward(s.q)
            rows = slice(0, 3), slice(3, 4) if arm.task == "position" else slice(0, 4)
            assert np.allclose(reached[rows], target[rows], atol=1e-9, rtol=0)
        for i, s in enumerate(solutions):
            assert not any(same(s.q, other.q, 1e-7) for other in list(solutions)[:i])


@pytest.mark.parametrize("name, plain, starts", [("puma560", PUMA, 60), ("ur5", UR5, 60), ("general_6r", GENERAL, 40)])
def test_a_search_from_many_starts_finds_no_other_solution(name, plain, starts, random):
    arm = dhkin.Robot(table(name))
    for seed, q in enumerate(random.uniform(-2.5, 2.5, (3, 6))):
        target = plain.forward(q)
        listed = arm.inverse(target)
        for other in plain.solutions(target, starts, seed):
            assert any(same(s.q, other, 1e-4) for s in listed), other


def test_at_singular_poses_a_solution_stands_for_every_joint_vector(puma, random):
    for q in random.uniform(-2, 2, (30, 6)):
        q[4] = 0  # axes 4 and 6 in one line
        solutions = puma.inverse(PUMA.forward(q))
        free = [s for s in solutions if s.free]
        assert free and set(free[0].free) == {"q4", "q6"}
        # All but the free joints agree, and the sum of the free ones does.
        part = [np.append(s.q[[0, 1, 2, 4]], s.q[3] + s.q[5]) for s in solutions]
        assert any(same(p, np.append(q[[0, 1, 2, 4]], q[3] + q[5]), 1e-6) for p in part)


def test_right_angles_have_their_solutions(random):
    """Poses at quarter turns, where other solvers come back empty."""
    for name, plain in (("puma560", PUMA), ("ur5", UR5)):
        arm = dhkin.Robot(table(name))
        for q in random.integers(-1, 3, (60, 6)) * (np.pi / 2):
            target = plain.forward(q)
            solutions = arm.inverse(target)
            assert solutions, (name, q, solutions.why)
            for s in solutions:
                assert np.allclose(plain.forward(s.q), target, atol=1e-8, rtol=0)


def test_inverse_near_continues(puma, random):
    for q in random.uniform(-1.2, 0.7, (40, 6)):
        q[4] = random.choice([0, q[4]])
        near = puma.inverse_near(PUMA.forward(q), q + random.uniform(-1e-3, 1e-3, 6))
        assert np.allclose(PUMA.forward(near.q), PUMA.forward(q), atol=1e-8, rtol=0)
        assert np.abs(near.q - q).max() < 0.05
        assert np.array_equal(np.asarray(near), near.q) and len(near) == 6 and near[0] == near.q[0]


def test_batches_are_single_calls(pair, random):
    arm, plain = pair
    q = random.uniform(-3, 3, (300, arm.dof))
    q[::10] = np.round(q[::10] / (np.pi / 2)) * (np.pi / 2)
    targets = arm.forward(q)
    given = {"given": q[:, 6:7]} if arm.redundant else {}
    targets[17, 0, 3] = np.nan
    targets[18, :3, 3] += 50
    batch = arm.inverse(targets, **given)
    assert len(batch) == 300 and batch.q.shape == (300, arm.max_solutions, arm.dof)
    assert set(batch.why) >= {17, 18} and set(batch.why) == set(np.flatnonzero(batch.count == 0))
    for threads in (1, 3):
        again = arm.inverse(targets, threads=threads, **given)
        assert np.array_equal(again.q, batch.q, equal_nan=True) and again.why == batch.why
    for i in range(0, 300, 7):
        single = arm.inverse(targets[i], **choices(arm, q[i]))
        assert len(single) == len(batch[i]) == batch.count[i]
        assert all(same(a.q, b.q, 1e-9) and a.branch == b.branch and a.free == b.free for a, b in zip(single, batch[i]))
        assert np.isnan(batch.q[i, batch.count[i] :]).all()
        assert single.why == batch[i].why
    assert isinstance(batch[-1], dhkin.Solutions) and sum(len(s) for s in batch) == batch.count.sum()


def test_inverse_near_of_many_targets(puma, random):
    q = random.uniform(-1.2, 0.7, (200, 6))
    targets = puma.forward(q)
    targets[3, :3, 3] *= 9
    near = puma.inverse_near(targets, q + 1e-4)
    assert near.q.shape == (200, 6) and list(near.why) == [3] and np.isnan(near.q[3]).all()
    assert np.allclose(np.delete(near.q, 3, 0), np.delete(q, 3, 0), atol=1e-2)
    assert near.q.tobytes() == puma.inverse_near(targets, q + 1e-4, threads=1).q.tobytes()
    from_one = puma.inverse_near(targets[:2], q[0])
    assert same(from_one.q[0], q[0], 1e-9) and len(from_one[0]) == 1


def test_a_target_out_of_reach_says_why(puma):
    target = np.eye(4)
    target[:3, 3] = 3, 0, 0
    solutions = puma.inverse(target)
    assert not solutions and len(solutions) == 0 and solutions.q.shape == (0, 6)
    assert "elbow q3: distance" in solutions.why and "exceeds" in solutions.why
    assert solutions.toward(np.zeros(6)) is None and solutions.closest_to(np.zeros(6)) is None
    with pytest.raises(dhkin.Unreachable, match="elbow q3: distance"):
        puma.inverse_near(target, np.zeros(6))


def test_choosing_among_solutions(puma):
    q = np.array([0.1, -0.7, 0.4, 1.2, 0.8, -2.0])
    solutions = puma.inverse(puma.forward(q))
    assert len(solutions) == 8 == puma.max_solutions
    assert {s.shoulder for s in solutions} == {"left", "right"}
    assert {s.elbow for s in solutions} == {"up", "down"}
    assert {s.wrist for s in solutions} == {"flip", "no flip"}
    inside = solutions.within_range()
    assert 0 < len(inside) < 8 and all(s.within_range for s in inside)
    assert all(puma.within_range(s.q) for s in inside)
    assert same(solutions.closest_to(q + 0.01).q, q, 1e-9)
    far = solutions.toward(q + np.array([0, 0, 0, 0, 0, 2 * np.pi]))
    assert np.abs(puma.forward(far.q) - puma.forward(q)).max() < 1e-9
    with pytest.raises(IndexError):
        solutions[8]
    assert "Solution([" in repr(solutions) and np.array_equal(solutions[-1].q, solutions.q[-1])


def test_tasks_take_positions_or_poses():
    arm = dhkin.Robot(table("planar_2r"), l2=0.6)
    assert arm.task == "position"
    q = np.array([0.3, 0.9])
    pose = arm.forward(q)
    assert np.array_equal(arm.inverse(pose).q, arm.inverse(pose[:3, 3]).q)
    assert arm.inverse(np.tile(pose[:3, 3], (5, 1))).count.tolist() == [2] * 5
    with pytest.raises(ValueError, match="expected positions of shape"):
        arm.inverse([1.0, 2.0])


def test_values_of_redundant_joints_are_asked_for():
    panda = dhkin.Robot(table("panda"))
    assert panda.redundant == ["q7"]
    q = np.array([0.1, 0.4, -0.3, -1.8, 0.2, 1.9, 0.7])
    target = panda.forward(q)
    assert any(same(s.q, q, 1e-8) for s in panda.inverse(target, 0.7))
    assert any(same(s.q, q, 1e-8) for s in panda.inverse(target, given=[0.7]))
    with pytest.raises(TypeError, match="leaves q7 to the caller"):
        panda.inverse(target)
    with pytest.raises(ValueError, match="given: expected values of q7"):
        panda.inverse(target, [0.7, 0.8])
    with pytest.raises(ValueError, match="given: expected values of q7"):
        panda.inverse(np.array([target, target]), [[0.7]] * 3)
    assert not panda.inverse(target, np.nan)


@pytest.mark.parametrize(
    "target, error, words",
    [
        (np.eye(3), ValueError, "target: expected a pose of shape (4, 4), or poses of shape (n, 4, 4), got shape (3, 3)"),
        (np.zeros(3), ValueError, "got shape (3,)"),
        ([["a"] * 4] * 4, TypeError, "target: expected a pose"),
        (np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0.3, 0.2, 0.1, 1.0]]), ValueError, "is the matrix transposed?"),
    ],
)
def test_wrong_targets_are_refused_with_what_was_expected(puma, target, error, words):
    with pytest.raises(error) as raised:
        puma.inverse(target)
    assert words in str(raised.value)


def test_what_is_no_rotation_is_told(puma):
    assert "not a rotation" in puma.inverse(np.diag([1, 1, -1, 1.0])).why
    bad = np.eye(4)
    bad[0, 0] = np.inf
    assert "not finite" in puma.inverse(bad).why
    with pytest.raises(dhkin.Unreachable, match="not finite"):
        puma.inverse_near(puma.forward(np.zeros(6)), [np.nan] * 6)


def test_an_arm_without_an_inverse_has_all_the_rest():
    text = table("puma560").replace("convention = modified;", "convention = modified; ik = none;")
    arm = dhkin.Robot(text)
    assert arm.max_solutions == 0 and np.allclose(arm.forward(np.zeros(6)), PUMA.forward(np.zeros(6)))
    with pytest.raises(ValueError, match="ik = none"):
        arm.inverse(np.eye(4))
    seven = dhkin.Robot(table("panda").replace("redundant = q7;", ""))
    assert seven.forward(np.zeros(7)).shape == (4, 4)
    with pytest.raises(dhkin.TableError, match="redundant"):
        seven.inverse(np.eye(4))
