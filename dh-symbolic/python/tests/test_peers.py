"""Poses, Jacobians and solutions beside Robotics Toolbox for Python, where it can be imported."""

import numpy as np
import pytest

import dhkin
from conftest import same

toolbox = pytest.importorskip("roboticstoolbox", reason="roboticstoolbox-python is not installed or cannot be imported")


def of_toolbox(model):
    """The table of a DH model."""
    lines = [f"pub struct Model; convention = {'modified' if model.mdh else 'standard'}; ik = none;"]
    lines.append("| theta | d | a | alpha |")
    for k, link in enumerate(model.links):
        theta = f"q{k + 1}" + (f" + approx {link.offset!r}rad" if link.offset else "")
        alpha = round(link.alpha / (np.pi / 12), 9)
        alpha = f"{15 * alpha:.0f}deg" if alpha == round(alpha) else f"approx {link.alpha!r}rad"
        lines.append(f"| {theta} | {link.d!r} | {link.a!r} | {alpha} |".replace("np.float64(", "").replace(")", ""))
    return dhkin.Robot("\n".join(lines).replace("+ approx -", "- approx "))


@pytest.mark.parametrize("name", ["Puma560", "UR5", "UR10", "Panda", "IRB140"])
def test_models_of_the_toolbox_have_the_same_poses_and_jacobians(name, random):
    model = getattr(toolbox.models.DH, name)()
    arm = of_toolbox(model)
    base, tool = np.asarray(model.base.A), np.asarray(model.tool.A)
    for q in random.uniform(-2.5, 2.5, (10, model.n)):
        assert np.allclose(base @ arm.forward(q) @ tool, np.asarray(model.fkine(q).A), atol=1e-12)
        if np.allclose(base, np.eye(4)) and np.allclose(tool, np.eye(4)):
            assert np.allclose(arm.jacobian(q), model.jacob0(q), atol=1e-10)


def test_the_solution_of_the_toolbox_is_among_all(puma, random):
    del puma
    model = toolbox.models.DH.Puma560()
    text = of_toolbox(model).table.replace(" ik = none;", "")
    arm = dhkin.Robot(text)
    inner = np.linalg.inv(np.asarray(model.base.A)), np.linalg.inv(np.asarray(model.tool.A))
    for q in random.uniform(-1.2, 1.2, (10, 6)):
        pose = model.fkine(q)
        found = model.ikine_a(pose) if hasattr(model, "ikine_a") else None
        if found is None or not found.success:
            pytest.skip("this version of the toolbox has no analytic inverse of the PUMA 560")
        target = inner[0] @ np.asarray(pose.A) @ inner[1]
        assert any(same(s.q, found.q, 1e-6) for s in arm.inverse(target))
