"""Robot kinematics from Denavit-Hartenberg tables: proven forward kinematics, all inverse solutions, exact formulas.

    import dhkin

    arm = dhkin.Robot(open("puma560.dh").read())
    pose = arm.forward([0.1, -0.7, 0.4, 1.2, 0.8, -2.0])
    for solution in arm.inverse(pose):
        print(solution.q, solution.branch)

Angles are radians, lengths are in the table's unit.
"""

from ._dhkin import (
    BatchSolutions,
    Formula,
    Joint,
    Matrix,
    Notes,
    Page,
    Plan,
    Robot,
    Solution,
    Solutions,
    TableError,
    Unreachable,
    __version__,
)

__all__ = [
    "BatchSolutions",
    "Formula",
    "Joint",
    "Matrix",
    "Notes",
    "Page",
    "Plan",
    "Robot",
    "Solution",
    "Solutions",
    "TableError",
    "Unreachable",
    "__version__",
]
