"""Formulas as SymPy expressions, and equations of SymPy as lines that `Robot.check` reads.

The compiled module hands over sums of products as plain data: a list of (coefficient, factors), a coefficient as the text of a fraction, a
factor as ("root", n), ("power", quantity, n), ("cos", angles) or ("sin", angles), where angles is a list of (whole factor, quantity). A quantity
is ("name", name), or what a drive and an offset make of joint variables: ("driven", terms, half turns, radians, named angles).
"""

import sympy


def _symbol(name):
    return sympy.Symbol(name, real=True)


def _quantity(data):
    if data[0] == "name":
        return _symbol(data[1])
    _, driven, half_turns, radians, named = data
    terms = [expression(factor) * _symbol(joint) for factor, joint in driven]
    terms += [factor * _symbol(name) for factor, name in named]
    terms += [sympy.Rational(half_turns) * sympy.pi, sympy.Rational(radians)]
    return sympy.Add(*terms)


def _angle(angles):
    return sympy.Add(*[factor * _quantity(quantity) for factor, quantity in angles])


def _factor(data):
    kind = data[0]
    if kind == "root":
        return sympy.sqrt(data[1])
    if kind == "power":
        return _quantity(data[1]) ** data[2]
    return (sympy.cos if kind == "cos" else sympy.sin)(_angle(data[1]))


def expression(data):
    """A sum of products as an expression."""
    return sympy.Add(*[sympy.Rational(k) * sympy.Mul(*map(_factor, factors)) for k, factors in data])


def matrix(data):
    """Rows of sums as a matrix."""
    return sympy.Matrix([[expression(entry) for entry in row] for row in data])


def claim(equation):
    """An equation as a line of a hand derivation."""
    if not isinstance(equation, sympy.Eq):
        raise TypeError(f"claims: expected a str or a sympy.Eq, got {type(equation)}")
    sides = [sympy.sstr(side, order="none").replace("**", "^") for side in (equation.lhs, equation.rhs)]
    return " = ".join(sides)
