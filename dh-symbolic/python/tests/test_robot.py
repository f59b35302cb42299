"""Tables, parameters, URDF, errors, pickling."""

import pickle

import numpy as np
import pytest

import dhkin
from conftest import PUMA, table

URDF = """<robot name="two">
  <link name="base"/> <link name="a"/> <link name="b"/> <link name="tip"/>
  <joint name="j1" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="j2" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0.4 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="end" type="fixed"><parent link="b"/><child link="tip"/><origin xyz="0.2 0 0"/></joint>
</robot>"""


def test_an_arm_tells_what_it_is(puma):
    assert (puma.name, puma.dof, puma.rows, puma.task, puma.unit) == ("Puma560", 6, 6, "pose", "m")
    assert [j.name for j in puma.joints] == [f"q{k}" for k in range(1, 7)]
    assert all(j.kind == "revolute" for j in puma.joints)
    assert np.allclose(puma.ranges[1], np.deg2rad([-225, 45])) and puma.ranges.shape == (6, 2)
    assert puma.within_range(np.zeros(6)) is True
    assert puma.within_range(np.array([np.zeros(6), np.full(6, 9.0)])).tolist() == [True, False]
    assert repr(puma) == "Robot(Puma560, 6 joints, task = pose)"
    assert puma.table == table("puma560")


def test_parameters_are_keywords_and_attributes():
    arm = dhkin.Robot(table("puma560"), a2=0.5)
    assert arm.parameters == {"a2": 0.5, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    assert arm.a2 == 0.5 and "a2" in dir(arm) and "forward" in dir(arm)
    before = arm.forward(np.zeros(6))
    other = arm.with_parameters(a2=0.4318)
    assert np.allclose(other.forward(np.zeros(6)), PUMA.forward(np.zeros(6)), atol=1e-15) and arm.a2 == 0.5
    arm.a2 = 0.6
    assert np.allclose(arm.forward(np.zeros(6)) - before, [[0, 0, 0, 0.1], [0] * 4, [0] * 4, [0] * 4], atol=1e-15)
    q = np.array([0.1, -0.7, 0.4, 1.2, 0.8, -2.0])
    assert len(arm.inverse(arm.forward(q))) == 8
    with pytest.raises(TypeError, match="declares no `a9`; its parameters: a2, a3, d3, d4"):
        dhkin.Robot(table("puma560"), a9=1)
    with pytest.raises(TypeError, match="a2: expected a number"):
        arm.a2 = "long"
    with pytest.raises(AttributeError):
        arm.a9 = 1
    with pytest.raises(AttributeError):
        arm.a9


def test_a_parameter_without_a_value_is_asked_for():
    arm = dhkin.Robot(table("planar_2r"))
    assert arm.parameters == {"l1": 1.0, "l2": None}
    with pytest.raises(ValueError, match="no value for l2"):
        arm.forward([0, 0])
    arm.l2 = 0.6
    assert np.allclose(arm.forward([0, 0])[:3, 3], [1.6, 0, 0])


def test_mistakes_of_a_table_are_drawn():
    with pytest.raises(dhkin.TableError) as raised:
        dhkin.Robot(table("puma560").replace("-90deg | 0  | 0  | q2", "-90    | 0  | 0  | q2"))
    error = raised.value
    assert isinstance(error, ValueError) and "^" in str(error) and "-90" in str(error)
    (line, column, message, help), *_ = error.mistakes
    assert (line, column) == (13, 12) and message and help
    with pytest.raises(dhkin.TableError):
        dhkin.Robot("")
    with pytest.raises(TypeError):
        dhkin.Robot(3)


def test_a_urdf_is_an_arm(tmp_path):
    path = tmp_path / "two.urdf"
    path.write_text(URDF)
    for source in (URDF, path, str(path)):
        arm = dhkin.Robot.from_urdf(source, chain="base..tip")
        assert arm.dof == 2 and np.allclose(arm.ranges, [[-2, 2], [-1, 1]])
        for a, b in [(0, 0), (0.3, -0.5), (-1.2, 0.8)]:
            reach = 0.4 + 0.2 * np.cos(b)
            tip = [reach * np.cos(a), reach * np.sin(a), 0.3 - 0.2 * np.sin(b)]
            assert np.allclose(arm.forward([a, b])[:3, 3], tip, atol=1e-12)
    standard = dhkin.Robot.from_urdf(URDF, convention="standard", name="Two")
    assert standard.name == "Two" and "standard" in standard.table
    assert np.allclose(standard.forward([0.3, -0.5]), arm.forward([0.3, -0.5]), atol=1e-12)
    with pytest.raises(ValueError):
        dhkin.Robot.from_urdf(URDF, chain="base..nowhere")
    with pytest.raises(ValueError, match="base_link..tool0"):
        dhkin.Robot.from_urdf(URDF, chain="base")
    with pytest.raises(FileNotFoundError):
        dhkin.Robot.from_urdf("nothing.urdf")
    with pytest.raises(TypeError):
        dhkin.Robot.from_urdf(3)


def test_arms_are_pickled(puma):
    arm = pickle.loads(pickle.dumps(puma.with_parameters(a2=0.5)))
    assert arm.parameters == {**puma.parameters, "a2": 0.5}
    assert np.array_equal(arm.forward(np.ones(6)), puma.with_parameters(a2=0.5).forward(np.ones(6)))


def test_everything_has_a_word_of_documentation():
    for name in dhkin.__all__:
        thing = getattr(dhkin, name)
        if isinstance(thing, type):
            assert thing.__doc__, name
            for member, value in vars(thing).items():
                assert member.startswith("_") or value.__doc__, f"{name}.{member}"


def test_the_stubs_name_what_there_is():
    from pathlib import Path

    stub = (Path(dhkin.__file__).parent / "__init__.pyi").read_text()
    for name in dhkin.__all__:
        thing = getattr(dhkin, name)
        if isinstance(thing, type):
            section = stub.split(f"class {name}", 1)[1].split("\nclass ", 1)[0]
            for member in vars(thing):
                assert member.startswith("__") or f"def {member}(" in section or member == "mistakes", f"{name}.{member}"
