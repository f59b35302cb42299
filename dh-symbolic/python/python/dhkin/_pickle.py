"""Rebuilds robots that were pickled: from their table and their parameters."""

from ._dhkin import Robot


def rebuild(table, parameters):
    """The robot of a table with these values of its parameters."""
    return Robot(table, **parameters)
