"""Exact formulas, derivations, documents, and how a notebook shows them."""

import numpy as np
import pytest

import dhkin
from conftest import PUMA, table


def test_formulas_are_printed_differentiated_and_evaluated(puma):
    t = puma.transform(0, 6)
    px = t.entry(0, 3)
    assert str(px) == "c₁(a₂c₂ + a₃c₂₃ − d₄s₂₃) − d₃s₁"
    assert px.latex() == r"c_1(a_2c_2 + a_3c_{23} - d_4s_{23}) - d_3s_1"
    assert px.diff("q1") == -t[1, 3] and px.diff("q1") != t[1, 3]
    assert (px + px - px - px).is_zero() and px * px == px * px
    assert t.shape == (4, 4) and puma.transform(0, 2) @ puma.transform(2, 6) == t
    q = np.array([0.1, -0.7, 0.4, 1.2, 0.8, -2.0])
    values = {f"q{k + 1}": x for k, x in enumerate(q)}
    assert np.allclose(t.eval(**values), PUMA.forward(q), atol=1e-14)
    assert px.eval(**values) == pytest.approx(PUMA.forward(q)[0, 3], abs=1e-14)
    assert np.allclose(puma.jacobian().eval(**values), puma.jacobian(q), atol=1e-14)
    assert puma.transform(1, 3).transpose().determinant() == puma.transform(0, 0)[0, 0]
    with pytest.raises(ValueError, match="q1"):
        px.eval()
    with pytest.raises(KeyError, match="q9"):
        px.eval(q9=1)
    with pytest.raises(IndexError, match="4x4"):
        t.entry(4, 0)
    with pytest.raises(IndexError, match="the last frame is 6"):
        puma.transform(0, 7)
    with pytest.raises(ValueError, match="two robots"):
        px + dhkin.Robot(table("ur5")).transform(0, 1)[0, 0]


def test_derivations_are_checked(puma):
    puma.check("T(1,3).px = a2*c2")
    puma.check("T(1,3).px = a2*c2; T(1,3).py = d3")
    with pytest.raises(dhkin.TableError, match="`s2` should be `c2`"):
        puma.check("T(1,3).px = a2*s2")
    with pytest.raises(TypeError):
        puma.check(3)


def test_formulas_are_sympy_expressions(puma):
    sympy = pytest.importorskip("sympy")
    q = sympy.symbols("q1:7", real=True)
    a2, a3, d3, d4 = sympy.symbols("a2 a3 d3 d4", real=True)
    # Craig's link transforms, multiplied by SymPy.
    rows = [(0, 0, 0), (-sympy.pi / 2, 0, 0), (0, a2, d3), (-sympy.pi / 2, a3, d4), (sympy.pi / 2, 0, 0), (-sympy.pi / 2, 0, 0)]
    product = sympy.eye(4)
    for (alpha, a, d), x in zip(rows, q):
        c, s, ca, sa = sympy.cos(x), sympy.sin(x), sympy.cos(alpha), sympy.sin(alpha)
        product *= sympy.Matrix([[c, -s, 0, a], [s * ca, c * ca, -sa, -sa * d], [s * sa, c * sa, ca, ca * d], [0, 0, 0, 1]])
    t = puma.transform(0, 6).to_sympy()
    assert t.shape == (4, 4)
    difference = (t - product).applyfunc(lambda e: sympy.expand(sympy.expand_trig(e)))
    assert difference == sympy.zeros(4)
    assert puma.transform(0, 6)[0, 3].to_sympy().free_symbols == {*q[:3], a2, a3, d3, d4}
    # And back: an equation of SymPy is a line of a derivation.
    px = puma.transform(0, 6)[0, 3].to_sympy()
    puma.check(sympy.Eq(sympy.diff(px, q[0]), sympy.expand(-t[1, 3]), evaluate=False))
    with pytest.raises(dhkin.TableError):
        puma.check(sympy.Eq(px, t[1, 3], evaluate=False))


def test_coupled_and_shifted_joints_are_sympy_expressions():
    sympy = pytest.importorskip("sympy")
    arm = dhkin.Robot(
        """pub struct Geared; convention = standard; ik = none; let k: length = 0.1m;
        | theta          | d | a   | alpha |
        | q1 + 40deg     | 0 | 0.3 | 90deg |
        | q2 - q1        | 0 | 0.2 | 0     |
        | approx 1.1rad  | k*q3 | 0 | 0 |"""
    )
    values = {"q1": 0.3, "q2": -0.8, "q3": 1.7}
    expression = arm.pose().to_sympy()
    symbols = {sympy.Symbol(name, real=True): x for name, x in {**values, **arm.parameters}.items()}
    numbers = expression.subs(symbols).evalf()
    numeric = arm.forward([0.3, -0.8, 1.7])
    assert np.allclose(arm.pose().eval(**values), numeric, atol=1e-14)
    names = {s.name for s in expression.free_symbols}
    assert {"q1", "q2", "q3"} <= names
    left = {s: arm.transform(0, 1)[0, 3].eval(q1=0) for s in numbers.free_symbols}
    if not left:
        assert np.allclose(np.array(numbers.tolist(), float), numeric, atol=1e-12)


def test_a_notebook_shows_what_there_is_to_see(puma):
    t = puma.transform(0, 3)
    assert t._repr_latex_().startswith("$") and r"\begin{bmatrix}" in t._repr_latex_() and t._repr_latex_().endswith("$")
    assert t[0, 3]._repr_latex_() == "$" + t[0, 3].latex() + "$"
    page = puma.page(height=500)
    shown = page._repr_html_()
    assert shown.startswith("<iframe srcdoc=\"") and "height: 500px" in shown and shown.count('"') % 2 == 0
    assert str(page) == page.html and "<script" in page.html and 'src="http' not in page.html
    notes = puma.notes("markdown", parts="table,links")
    assert notes._repr_markdown_() == notes.text == str(notes) and notes._repr_html_() is None and "$" in notes
    assert puma.notes("html")._repr_html_().startswith("<iframe")
    assert puma.notes("latex").text.startswith(r"\documentclass") and puma.notes("latex")._repr_markdown_() is None
    plan = puma.plan()
    assert plan.max_solutions == 8 and len(plan) == 6 and "law of cosines" in str(plan)
    assert "law of cosines" in plan._repr_markdown_() and plan.mermaid


def test_notes_take_the_options_of_the_command(puma, tmp_path):
    chinese = puma.notes("latex", lang="zh", parts="table,inverse", digits=3)
    assert any("一" <= c <= "鿿" for c in str(chinese))
    chinese.save(tmp_path / "notes.tex")
    assert (tmp_path / "notes.tex").read_text(encoding="utf-8") == str(chinese)
    puma.page().save(tmp_path / "page.html")
    with pytest.raises(ValueError, match="format: expected one of"):
        puma.notes("pdf")
    with pytest.raises(TypeError, match="no option `colour`"):
        puma.notes(colour="red")
    with pytest.raises(ValueError):
        puma.notes(lang="fr")
